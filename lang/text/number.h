// Numbers of ISO words: [+|-] digits [. digits], correctly rounded to binary64, no exponent.
#pragma once

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lang/text/source.h"

namespace stanok::lang {

// Every power of ten that a binary64 holds exactly.
inline constexpr double exact_powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Reads a number at `at`, which is left behind its last character; `whole` tells that it had no
// decimal point. False (and `at` where it was) when no number stands there, or
// one that is too large.
//
// Up to 15 digits both the digits as an integer and the power of ten are exact, so that one
// division rounds correctly (W. D. Clinger, "How to read floating point numbers accurately", 1990);
// longer numbers go to fast_float.
//
// Plain lines spend half of their time here: left to itself the compiler calls it or not as other
// sources of its unit happen to use it, which is 7 % of a load.
[[gnu::always_inline]] inline bool read_number(const char*& at, const char* end, double& value,
                                               bool& whole) {
  const char* cursor = at;
  const bool negative = cursor != end && *cursor == '-';
  if (cursor != end && (*cursor == '-' || *cursor == '+')) ++cursor;
  const char* const first = cursor;
  std::uint64_t digits = 0;
  for (; cursor != end && is_digit(*cursor); ++cursor) {
    digits = digits * 10 + static_cast<std::uint64_t>(*cursor - '0');
  }
  auto digit_count = cursor - first;
  std::ptrdiff_t decimals = 0;
  whole = cursor == end || *cursor != '.';
  if (!whole) {
    const char* const point = cursor++;
    for (; cursor != end && is_digit(*cursor); ++cursor) {
      digits = digits * 10 + static_cast<std::uint64_t>(*cursor - '0');
    }
    decimals = cursor - point - 1;
    digit_count += decimals;
  }
  if (digit_count == 0) return false;
  if (digit_count <= 15) {
    value = static_cast<double>(digits) / exact_powers_of_ten[decimals];
  } else {
    fast_float::from_chars(first, cursor, value, fast_float::chars_format::fixed);
    if (std::isinf(value)) return false;
  }
  if (negative) value = 0.0 - value;  // -0 is 0
  at = cursor;
  return true;
}

// The integer a value stands for: within 1e-9 of one, and small enough to be an id or a count.
[[nodiscard]] inline bool is_integer(double value) {
  return std::abs(value) <= 2e9 && std::abs(value - std::round(value)) <= 1e-9;
}

// The count or place from 0 that such a value stands for; it must not be negative.
[[nodiscard]] inline std::size_t whole_number(double value) {
  return static_cast<std::size_t>(std::lround(value));
}

}  // namespace stanok::lang
