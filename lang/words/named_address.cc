#include "lang/words/named_address.h"

#include <array>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr auto addresses =
    std::to_array<std::string_view>({"S_n", "S_k", "dS", "dl", "Smin", "Smax", "n_s", "L_A", "L_B",
                                     "n_n", "n_k", "dn", "v_n", "v_k", "dv", "SPOS"});

}  // namespace

std::span<const std::string_view> named_addresses() {
  return addresses;
}

std::string_view find_named_address(std::string_view name) {
  for (const std::string_view known : addresses) {
    if (folded(known) == folded(name)) return known;
  }
  return {};
}

std::optional<int> spindle_of_indexed_speed(const NamedWord& word) {
  if (word.name.size() < 2 || upper_case(word.name[0]) != 'S') return std::nullopt;
  int spindle = 0;
  for (const char digit : std::string_view(word.name).substr(1)) {
    if (!is_digit(digit)) return std::nullopt;
    spindle = 10 * spindle + (digit - '0');
  }
  return spindle;
}

}  // namespace stanok::lang
