// The modal groups of G and M codes: one code of a group is in force at a time.
#pragma once

#include <cstdint>

#include "base/enum_array.h"

namespace stanok::lang {

// Modal groups in the order of their numbers (docs/reference/language.md, "G and M codes"):
// `motion` is 1, `polar` 17. One code of a group at a time; non-modal codes have no group.
enum class Group : std::uint8_t {
  motion,
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  radius_compensation,
  length,
  transformation,
  return_level,
  scaling,
  work_offset,
  path_mode,
  spindle_mode,
  diameter,
  rotation,
  polar,
  mirror,
  stop,
  tool,
  spindle,
  spindle_axis,
  mist,
  flood,
  override_control,
  input_output,
  state,
  subprogram,
  none,
};

// The letter that the codes of a group begin with.
[[nodiscard]] constexpr char letter_of(Group group) {
  return group < Group::stop ? 'G' : 'M';
}
// All groups that codes can have, and a value for each.
inline constexpr auto all_groups = enum_values<Group, place_of(Group::none)>();
template <class Value>
using GroupArray = EnumArray<Group, Value, place_of(Group::none)>;

using GroupSet = std::uint32_t;
[[nodiscard]] constexpr GroupSet group_bit(Group group) {
  return group == Group::none ? 0 : GroupSet{1} << static_cast<unsigned>(group);
}

}  // namespace stanok::lang
