// NumberedArray, NumberedList, NumberedSpan: std::array, std::vector and std::span of what files,
// messages and programs number from 0 by int: signals, channels, axes of a machine. A number comes
// without a cast; that it is one of theirs was checked where it came from.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/place.h"
#include "base/rt_safe.h"

namespace stanok {

// An aggregate and plain data.
template <class Value, std::size_t count>
struct NumberedArray : std::array<Value, count> {
  using std::array<Value, count>::operator[];

  [[nodiscard]] constexpr Value& operator[](int number) RT_SAFE {
    return (*this)[place_of(number)];
  }
  [[nodiscard]] constexpr const Value& operator[](int number) const RT_SAFE {
    return (*this)[place_of(number)];
  }
};

template <class Value>
struct NumberedList : std::vector<Value> {
  using std::vector<Value>::vector;
  using std::vector<Value>::operator[];

  [[nodiscard]] Value& operator[](int number) { return (*this)[place_of(number)]; }
  [[nodiscard]] const Value& operator[](int number) const { return (*this)[place_of(number)]; }
};

// What of either, or of any other place, is looked at.
template <class Value>
struct NumberedSpan : std::span<Value> {
  using std::span<Value>::span;
  using std::span<Value>::operator[];
  constexpr NumberedSpan(std::span<Value> values) RT_SAFE  // NOLINT: as one span from another
      : std::span<Value>(values) {}

  [[nodiscard]] constexpr Value& operator[](int number) const RT_SAFE {
    return (*this)[place_of(number)];
  }
};

}  // namespace stanok
