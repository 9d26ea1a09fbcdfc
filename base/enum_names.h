// EnumNames: the names of the values of an enumeration, one row each, read in both directions.
//
//   constexpr auto plane_names = enum_names<Plane>({{Plane::xy, "XY"}, {Plane::zx, "ZX"}});
//   plane_names[plane]             the name
//   plane_names.value("XY")        the value, or nothing
//
// As with a switch, a value without a row does not compile: the rows must fill a range of numbers,
// and the compiler is asked whether the numbers beside it are values too.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

#include "base/place.h"

namespace stanok {

namespace detail {

// GCC and Clang print a value as "stanok::Plane::xy", and a number that is none as
// "(stanok::Plane)7".
template <auto value>
consteval bool is_enumerator() {
  constexpr std::string_view signature = __PRETTY_FUNCTION__;
  constexpr std::string_view before = "value = ";
  return signature[signature.find(before) + before.size()] != '(';
}

}  // namespace detail

template <class Enum>
struct EnumRow {
  Enum value;
  std::string_view name;
};

template <class Enum, std::size_t count>
class EnumNames {
 public:
  using Number = std::underlying_type_t<Enum>;

  // Does not compile when a value has two rows, or a number between the first and the last has
  // none.
  consteval explicit EnumNames(const EnumRow<Enum> (&rows)[count])
      : first_(static_cast<Number>(rows[0].value)) {
    for (const EnumRow<Enum>& row : rows) {
      if (static_cast<Number>(row.value) < first_) first_ = static_cast<Number>(row.value);
    }
    std::array<bool, count> has_row{};
    for (const EnumRow<Enum>& row : rows) {
      if (has_row.at(index(row.value))) throw "a value has two rows";
      has_row[index(row.value)] = true;
      names_[index(row.value)] = row.name;
    }
  }

  // Empty for a number that is no value.
  [[nodiscard]] constexpr std::string_view operator[](Enum value) const {
    return index(value) < count ? names_[index(value)] : std::string_view{};
  }
  [[nodiscard]] constexpr std::optional<Enum> value(std::string_view name) const {
    for (std::size_t k = 0; k < count; ++k) {
      if (names_[k] == name) return static_cast<Enum>(first_ + static_cast<Number>(k));
    }
    return std::nullopt;
  }

  // Whether the enumeration has no values but those of the table. Their first number is a
  // parameter because it must be known to the compiler.
  template <int first>
  [[nodiscard]] static consteval bool is_complete() {
    return !detail::is_enumerator<static_cast<Enum>(first + static_cast<int>(count))>();
  }

 private:
  [[nodiscard]] constexpr std::size_t index(Enum value) const {
    return place_of(value) - place_of(static_cast<Enum>(first_));
  }

  Number first_;
  std::array<std::string_view, count> names_{};
};

// The rows of all values; `first` is the number of the first one.
template <class Enum, int first = 0, std::size_t count>
[[nodiscard]] consteval EnumNames<Enum, count> enum_names(const EnumRow<Enum> (&rows)[count]) {
  static_assert(EnumNames<Enum, count>::template is_complete<first>(),
                "a value of the enumeration has no row");
  return EnumNames<Enum, count>(rows);
}

}  // namespace stanok
