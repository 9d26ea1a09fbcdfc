// Sums, differences and lengths of points and of derivatives.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/path/path.h"

namespace stanok::motion {

[[nodiscard]] inline Point difference(const Point& a, const Point& b) {
  Point d;
  for (std::size_t k = 0; k < axes_max; ++k) d[k] = a[k] - b[k];
  return d;
}

// a for part 0, b for part 1.
[[nodiscard]] inline Point between(const Point& a, const Point& b, double part) {
  Point point;
  for (std::size_t k = 0; k < axes_max; ++k) point[k] = a[k] + (b[k] - a[k]) * part;
  return point;
}

[[nodiscard]] inline double metric_product(const PathMetric& metric, const Point& a,
                                           const Point& b) {
  double sum = 0.0;
  for (int k = 0; k < metric.axis_count; ++k) {
    if (metric.counts(k)) sum += a[k] * b[k];
  }
  return sum;
}

[[nodiscard]] inline bool is_geometry_axis(const MotionConfig& config, int axis) {
  return std::ranges::find(config.geometry, axis) != config.geometry.end();
}

// Euclidean length over the geometry axes.
[[nodiscard]] inline double geometry_norm(const MotionConfig& config, const Point& v) {
  double squared = 0.0;
  for (const int axis : config.geometry) {
    if (axis < 0) continue;
    squared += v[axis] * v[axis];
  }
  return std::sqrt(squared);
}

}  // namespace stanok::motion
