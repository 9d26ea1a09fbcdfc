// Rounding for the real-time cycle: what libm offers, with names that say which way.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"

namespace stanok {

// The nearest integer, halves away from zero; |value| < 2^62.
[[nodiscard]] constexpr std::int64_t nearest_integer(double value) RT_SAFE {
  const auto whole = static_cast<std::int64_t>(value);
  const double rest = value - static_cast<double>(whole);
  if (rest >= 0.5) return whole + 1;
  if (rest <= -0.5) return whole - 1;
  return whole;
}

// The smallest integer not below `value`; |value| < 2^62.
[[nodiscard]] constexpr std::int64_t ceiling(double value) RT_SAFE {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) < value ? whole + 1 : whole;
}

}  // namespace stanok
