// The words `@` and `^` of a block: distance from zero and angle of a point in the plane XY.
#pragma once

#include <string_view>

namespace stanok::lang {

inline constexpr std::string_view polar_distance_word = "@";
inline constexpr std::string_view polar_angle_word = "^";

[[nodiscard]] constexpr bool is_polar_word(std::string_view name) {
  return name == polar_distance_word || name == polar_angle_word;
}

}  // namespace stanok::lang
