// AxisIndex: the place of an axis among the axes of its channel, or none; AxisArray: a value for
// each of as many axes as a channel can have, AxisList: one for each that it has.
//
// Files, messages and programs number axes by int, -1 for none; an AxisIndex comes from such a
// number without a cast, and an AxisArray or AxisList takes either where a value is wanted.
// AxisIndex and AxisArray are plain data.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/place.h"
#include "base/rt_safe.h"

namespace stanok {

inline constexpr int axes_max = 8;  // of a channel

class AxisIndex {
 public:
  constexpr AxisIndex() = default;                      // none
  constexpr AxisIndex(int number) : number_(number) {}  // NOLINT: numbers of axes are indices
  constexpr AxisIndex(std::size_t place)                // NOLINT: and so are places in arrays
      : number_(static_cast<int>(place)) {}

  [[nodiscard]] constexpr bool exists() const RT_SAFE { return number_ >= 0; }
  [[nodiscard]] constexpr int number() const RT_SAFE { return number_; }
  // In an array; there is none for an axis that does not exist.
  [[nodiscard]] constexpr std::size_t place() const RT_SAFE { return place_of(number_); }
  // In a set of axes; 0 for an axis that does not exist.
  [[nodiscard]] constexpr unsigned bit() const RT_SAFE { return exists() ? 1U << number_ : 0U; }

  [[nodiscard]] constexpr bool operator==(const AxisIndex&) const = default;

 private:
  int number_ = -1;
};

// An aggregate: AxisArray<double>{1.0, 2.0} has zeros behind the 2.
template <class Value>
struct AxisArray : std::array<Value, axes_max> {
  using std::array<Value, axes_max>::operator[];

  [[nodiscard]] constexpr Value& operator[](AxisIndex axis) RT_SAFE {
    return (*this)[axis.place()];
  }
  [[nodiscard]] constexpr const Value& operator[](AxisIndex axis) const RT_SAFE {
    return (*this)[axis.place()];
  }
  [[nodiscard]] constexpr Value& operator[](int axis) RT_SAFE { return (*this)[AxisIndex(axis)]; }
  [[nodiscard]] constexpr const Value& operator[](int axis) const RT_SAFE {
    return (*this)[AxisIndex(axis)];
  }
};

// Read as an AxisArray is.
template <class Value>
struct AxisList : std::vector<Value> {
  using std::vector<Value>::vector;
  using std::vector<Value>::operator[];

  [[nodiscard]] Value& operator[](AxisIndex axis) { return (*this)[axis.place()]; }
  [[nodiscard]] const Value& operator[](AxisIndex axis) const { return (*this)[axis.place()]; }
  [[nodiscard]] Value& operator[](int axis) { return (*this)[AxisIndex(axis)]; }
  [[nodiscard]] const Value& operator[](int axis) const { return (*this)[AxisIndex(axis)]; }
};

}  // namespace stanok
