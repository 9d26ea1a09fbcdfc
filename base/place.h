// Numbers as containers count: place_of for the operators of arrays that are read by an enumeration
// or a number of their own, checked_size for numbers from elsewhere.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "base/assert.h"
#include "base/rt_safe.h"

namespace stanok {

// As it is: who has such a number knows that it is a place.
template <class Number>
[[nodiscard]] constexpr std::size_t place_of(Number number) RT_SAFE {
  return static_cast<std::size_t>(number);
}

// What a file says, a system call gave or two places are apart; it must not be negative.
template <std::integral Number>
[[nodiscard]] constexpr std::size_t checked_size(Number number) {
  STANOK_ASSERT(number >= 0);
  return place_of(number);
}

// The whole part.
[[nodiscard]] constexpr std::size_t checked_size(double number) {
  return checked_size(static_cast<std::int64_t>(number));
}

}  // namespace stanok
