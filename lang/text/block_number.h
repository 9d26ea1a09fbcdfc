// The block number of a line: what stands behind N at its beginning.
#pragma once

#include <optional>
#include <string_view>

#include "lang/text/source.h"

namespace stanok::lang {

[[nodiscard]] inline std::optional<int> block_number(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && is_blank(line[at])) ++at;
  if (at == line.size() || upper_case(line[at]) != 'N') return std::nullopt;
  int number = 0;
  bool any = false;
  for (++at; at < line.size() && is_digit(line[at]) && number < 100000000; ++at) {
    number = 10 * number + (line[at] - '0');
    any = true;
  }
  return any ? std::optional(number) : std::nullopt;
}

}  // namespace stanok::lang
