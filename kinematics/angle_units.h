// Factors between deg, the unit of rotary axes, and rad, the unit of sine and cosine.
#pragma once

#include <numbers>

namespace stanok::kinematics {

inline constexpr double rad_per_deg = std::numbers::pi / 180.0;
inline constexpr double deg_per_rad = 180.0 / std::numbers::pi;

}  // namespace stanok::kinematics
