// Machines, blocks and random numbers shared by the tests of path geometry.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "kinematics/scheme.h"
#include "motion/path/geometry.h"
#include "motion/path/shape.h"
#include "motion/segments/path_builder.h"

namespace stanok::motion {

// X, Y, Z and then rotary axes up to `axis_count`, with the limits of a middling mill.
inline MotionConfig mill(int axis_count) {
  MotionConfig config;
  config.axis_count = axis_count;
  config.geometry = {0, 1, 2};
  for (std::size_t k = 0; k < static_cast<std::size_t>(axis_count); ++k) {
    const bool linear = k < 3;
    config.axes[k] = {.linear = linear,
                      .velocity_max = linear ? 400.0 : 120.0,
                      .acceleration_max = linear ? 4000.0 : 900.0,
                      .jerk_max = linear ? 100000.0 : 20000.0,
                      .rapid_max = linear ? 350.0 : 110.0};
  }
  return config;
}

// B on the spindle, C under the workpiece.
inline std::unique_ptr<const kinematics::Scheme> head_table() {
  kinematics::SchemeConfig config;
  config.type = "head_table";
  config.axes = {0, 1, 2, 3, 4};
  config.linear = {0, 1, 2};
  config.geometry = kinematics::HeadTable::Geometry{.head_axis = 3,
                                                    .table_axis = 4,
                                                    .pivot_to_spindle = {0.0, 0.0, -120.0},
                                                    .table_centre = {10.0, -5.0, 0.0}};
  return kinematics::make_scheme(config);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }

 private:
  std::mt19937_64 engine_;
};

inline PathBlock line_to(const Point& end, double feed = 50.0) {
  PathBlock block;
  block.end = end;
  block.feed_per_s = feed;
  block.tolerance_mm = 0.01;
  block.tolerance_deg = 0.05;
  return block;
}

// Counter-clockwise for sweep > 0, in the plane XY; other axes of `end` linearly.
inline PathBlock arc_to(const Point& start, const std::array<double, 2>& centre, double sweep,
                        Point end, double feed = 50.0) {
  const double x = start[0] - centre[0];
  const double y = start[1] - centre[1];
  end[0] = centre[0] + x * std::cos(sweep) - y * std::sin(sweep);
  end[1] = centre[1] + x * std::sin(sweep) + y * std::cos(sweep);
  PathBlock block = line_to(end, feed);
  block.kind = BlockKind::arc;
  block.centre = centre;
  block.sweep_rad = sweep;
  return block;
}

// A programmed block over its own parameter, 0 to 1, by its own closed form, independently of the
// geometry under test.
struct Course {
  Point start{};
  const PathBlock* block = nullptr;

  [[nodiscard]] Point at(double u) const {
    Point p;
    for (std::size_t k = 0; k < axes_max; ++k) p[k] = start[k] + u * (block->end[k] - start[k]);
    if (block->kind == BlockKind::arc) {
      const double angle = u * block->sweep_rad;
      const double x = start[0] - block->centre[0];
      const double y = start[1] - block->centre[1];
      p[0] = block->centre[0] + x * std::cos(angle) - y * std::sin(angle);
      p[1] = block->centre[1] + x * std::sin(angle) + y * std::cos(angle);
    }
    if (block->kind == BlockKind::curve) {
      for (std::size_t c = 0; c < 2; ++c) {
        p[c] = 0.0;
        for (std::size_t n = block->curve[c].size(); n > 0; --n)
          p[c] = p[c] * u + block->curve[c][n - 1];
      }
    }
    return p;
  }
};

inline Segment segment_of(const Shape& shape) {
  Segment segment;
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  return segment;
}

inline double xyz_norm(double x, double y, double z) {
  return std::hypot(x, y, z);
}

}  // namespace stanok::motion
