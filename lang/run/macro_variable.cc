#include "lang/run/macro_variable.h"

#include <array>

#include "lang/words/code_system.h"

namespace stanok::lang {
namespace {

// First numbers of the blocks with one variable per axis.
constexpr int block_end_first = 5001;
constexpr int skip_first = 5061;
constexpr int skip_step = 0;
constexpr int modal_first = 4001;

}  // namespace

std::optional<double> system_variable(int, const ParameterView&, const TextRules&) {
  static_cast<void>(block_end_first);
  static_cast<void>(skip_first);
  static_cast<void>(skip_step);
  static_cast<void>(modal_first);
  return std::nullopt;
}

}  // namespace stanok::lang
