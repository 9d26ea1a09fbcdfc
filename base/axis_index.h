// AxisIndex: the place of an axis among the axes of its channel, or none; AxisArray: a value for
// each.
//
// Files, messages and programs number axes by int, -1 for none; an AxisIndex comes from such a
// number without a cast, and an AxisArray takes it where a value is wanted. Both are plain data.
#pragma once

#include <array>
#include <cstddef>

#include "base/rt_safe.h"

namespace stanok {

inline constexpr int axes_max = 8;  // of a channel

class AxisIndex {
 public:
  constexpr AxisIndex() = default;                      // none
  constexpr AxisIndex(int number) : number_(number) {}  // NOLINT: numbers of axes are indices

  [[nodiscard]] constexpr bool exists() const RT_SAFE { return number_ >= 0; }
  [[nodiscard]] constexpr int number() const RT_SAFE { return number_; }
  // In an array; there is none for an axis that does not exist.
  [[nodiscard]] constexpr std::size_t place() const RT_SAFE {
    return static_cast<std::size_t>(number_);
  }
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
};

}  // namespace stanok
