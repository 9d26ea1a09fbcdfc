// EnumArray: a value for each value of an enumeration, read by it.
//
//   EnumArray<Plane, double> gain{1.0, 2.0, 3.0};  // an aggregate, in the order of the enumeration
//   gain[Plane::zx]
//
// The enumeration counts from 0 without gaps; how many values it has is asked of the compiler, so
// that one more makes the array longer. Plain data.
#pragma once

#include <array>
#include <cstddef>

#include "base/enum_names.h"
#include "base/rt_safe.h"

namespace stanok {

// Number of values from 0 on.
template <class Enum, int from = 0>
[[nodiscard]] consteval std::size_t enum_count() {
  if constexpr (detail::is_enumerator<static_cast<Enum>(from)>()) {
    return enum_count<Enum, from + 1>();
  } else {
    return from;
  }
}

// All values in their order, or the first `count`.
template <class Enum, std::size_t count = enum_count<Enum>()>
[[nodiscard]] consteval std::array<Enum, count> enum_values() {
  std::array<Enum, count> values{};
  for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Enum>(k);
  return values;
}

template <class Enum, class Value, std::size_t count = enum_count<Enum>()>
struct EnumArray : std::array<Value, count> {
  [[nodiscard]] constexpr Value& operator[](Enum value) RT_SAFE {
    return std::array<Value, count>::operator[](place_of(value));
  }
  [[nodiscard]] constexpr const Value& operator[](Enum value) const RT_SAFE {
    return std::array<Value, count>::operator[](place_of(value));
  }
};

}  // namespace stanok
