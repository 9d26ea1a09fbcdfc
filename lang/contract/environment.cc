#include "lang/contract/environment.h"

namespace stanok::lang {
namespace {

// In whole MiB, rounded up.
std::string mebibytes(std::size_t bytes) {
  constexpr std::size_t mebibyte = 1UL << 20;
  return std::to_string((bytes + mebibyte - 1) / mebibyte) + " MiB";
}

}  // namespace

Diagnostic too_large(std::string_view name, std::size_t bytes, std::size_t bytes_max) {
  Diagnostic diagnostic;
  diagnostic.code = "E8004";
  diagnostic.message = std::string(name) + " makes the program " + mebibytes(bytes) +
                       " large, and " + mebibytes(bytes_max) + " is the limit";
  diagnostic.help = {
      "split it into programs that run one after another, or raise `program_size_max` in [machine] "
      "of the machine file"};
  return diagnostic;
}

}  // namespace stanok::lang
