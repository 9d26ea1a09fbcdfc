// Tolerance: how far the path may leave the programmed one.
#pragma once

#include <algorithm>

#include "motion/path/path.h"

namespace stanok::motion {

// mm for linear axes (Euclidean over X, Y, Z), deg for every rotary axis against its synchronous
// linear course.
struct Tolerance {
  double mm = 0.0;
  double deg = 0.0;
};

[[nodiscard]] inline Tolerance lower_of(const Tolerance& one, const Tolerance& other) {
  return {std::min(one.mm, other.mm), std::min(one.deg, other.deg)};
}

[[nodiscard]] inline double axis_tolerance(const MotionConfig& config, int axis,
                                           const Tolerance& tolerance) {
  return config.axes[axis].linear ? tolerance.mm : tolerance.deg;
}

}  // namespace stanok::motion
