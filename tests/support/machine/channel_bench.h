// A channel of X, Y and a spindle that becomes C, made by hand, for tests of the parts of its
// cycle.
#pragma once

#include <map>
#include <memory>

#include "channels/axes/channel_constants.h"
#include "kinematics/scheme.h"
#include "motion/path/path.h"

namespace stanok::testing {

inline constexpr int bench_x = 0;
inline constexpr int bench_y = 1;
inline constexpr int bench_c = 2;  // of the spindle with the id 1
inline constexpr double bench_cycle_s = 0.001;
inline constexpr double bench_velocity_max = 100.0;  // mm/s or deg/s
inline constexpr double bench_resolution = 0.001;    // mm or deg

// Channel 4; its axes are the machine's axes 1, 0 and 2. X and Y start at 10 and 20.
[[nodiscard]] channels::ChannelConstants bench_constants();
[[nodiscard]] motion::MotionConfig bench_motion();

// Scheme 0 has X and Y, scheme 1 X alone and parks Y at 0.
using BenchSchemes = std::map<int, std::unique_ptr<const kinematics::Scheme>>;
[[nodiscard]] BenchSchemes bench_schemes();

// Feedback of the machine's axes: drives that hold their axes at these positions of X, Y and C.
[[nodiscard]] std::vector<channels::AxisFeedback> bench_feedback(double x, double y, double c);
// Where the channel's axis stands in it.
[[nodiscard]] channels::AxisFeedback& of_axis(std::vector<channels::AxisFeedback>& feedback,
                                              int axis);

}  // namespace stanok::testing
