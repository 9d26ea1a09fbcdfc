// The keys that a type of scheme has in a scheme file, and where their values go.
//
// The geometry of a type lists its keys by a function:
//
//   std::vector<SchemeKey> HeadTable::Geometry::keys() {
//     return {{"head_axis", AxisName{head_axis, "B"}, "rotary axis that carries the spindle"},
//             {"head_vector", Direction{head_vector}, "direction of head_axis"},
//             {"table_centre", Place{table_centre}, "position of ...", KeyPresence::required}};
//   }
//
// The values of a new geometry are the defaults. config/ reads files and makes the tables of
// docs/reference/configuration.md from these rows and knows no type by its name. Keys refer to the
// members of the geometry that listed them.
#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <variant>
#include <vector>

#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

// A rotary axis, by the channel's word or the machine's name; `usual` is the name when the file has
// none, "": none. The member is the index in the channel.
struct AxisName {
  std::reference_wrapper<int> axis;
  std::string_view usual{};
};

// A unit vector; a file may give it in any length but 0.
struct Direction {
  std::reference_wrapper<Vector3<double>> vector;
};

// A place or a distance in X, Y, Z, mm.
struct Place {
  std::reference_wrapper<Vector3<double>> vector;
};

// A number in the range from `min` to `max`.
struct Number {
  std::reference_wrapper<double> value;
  std::string_view unit;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

// One of some names; enumerator k of the member has the name k.
struct Choice {
  template <class Enum>
  Choice(Enum& value, std::vector<std::string_view> all)
      : names(std::move(all)),
        chosen(static_cast<std::size_t>(value)),
        choose([&value](std::size_t index) { value = static_cast<Enum>(index); }) {}

  std::vector<std::string_view> names;
  std::size_t chosen;  // before it is read
  std::function<void(std::size_t)> choose;
};

enum class KeyPresence : unsigned char { optional, required };

struct SchemeKey {
  std::string_view name;
  std::variant<AxisName, Direction, Place, Number, Choice> value;
  std::string_view meaning;
  KeyPresence presence = KeyPresence::optional;
};

}  // namespace stanok::kinematics
