// The numbers of G and M codes, and how they are written.
#pragma once

#include <cstdint>
#include <string>

namespace stanok::lang {

// Number of a G or M code in tenths: G1 = 10, G43.4 = 434.
using CodeNumber = std::int16_t;

// The number of a code as people write it: g(96) is G96, g(7, 1) is G7.1, m(30) is M30.
[[nodiscard]] constexpr CodeNumber g(int whole, int tenths = 0) {
  return static_cast<CodeNumber>(whole * 10 + tenths);
}
[[nodiscard]] constexpr CodeNumber m(int whole, int tenths = 0) {
  return g(whole, tenths);
}

// "G43.4" of ('G', 434).
[[nodiscard]] std::string code_text(char letter, int number);

}  // namespace stanok::lang
