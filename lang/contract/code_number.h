// The numbers of G and M codes, and how they are written.
#pragma once

#include <cstdint>
#include <string>

namespace stanok::lang {

// Number of a G or M code in tenths: G1 = 10, G43.4 = 434.
using CodeNumber = std::int16_t;

// "G43.4" of ('G', 434).
[[nodiscard]] std::string code_text(char letter, int number);

}  // namespace stanok::lang
