// How densely a segment is sampled over its parameter, and what lies between samples.
//
// Between three neighbouring samples a smooth function exceeds the largest of them by at most
// |second difference| / 8, to second order; half as much again covers the higher orders once the
// margin itself is small. docs/developer/motion.md#bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "motion/path/path.h"

namespace stanok::motion {

inline constexpr double between_samples = 1.5 / 8.0;

// The largest magnitude of a smooth function, between its samples too.
[[nodiscard]] inline double largest_with_margin(std::span<const double> samples) {
  double largest = 0.0;
  double bulge = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    largest = std::max(largest, std::abs(samples[k]));
    if (k > 1)
      bulge = std::max(bulge, std::abs(samples[k - 2] - 2.0 * samples[k - 1] + samples[k]));
  }
  return largest + between_samples * bulge;
}

// The transform only shifts and turns: it is affine, lines stay lines.
[[nodiscard]] inline bool is_affine(const Segment& segment) {
  return segment.transform == nullptr || segment.transform->scheme == nullptr ||
         segment.transform->scheme->is_affine(segment.transform->mode);
}

// Intervals to begin with: 1/16 turn of an arc, and 10 deg of any rotary axis that a transform
// leads the tip through.
[[nodiscard]] inline int sampling_intervals(const Segment& segment, const MotionConfig& config) {
  const Geometry& g = segment.geometry;
  double turns = 0.0;  // of 1/16
  if (g.kind == SegmentKind::arc) turns = std::abs(g.sweep) * 8.0 / std::numbers::pi;
  if (!is_affine(segment)) {
    for (int k = 0; k < config.axis_count; ++k) {
      if (!config.axes[k].linear) turns = std::max(turns, std::abs(g.end[k] - g.start[k]) / 10.0);
    }
  }
  const int least = g.kind == SegmentKind::quintic || g.kind == SegmentKind::even ? 8 : 4;
  return static_cast<int>(std::clamp(std::ceil(turns), static_cast<double>(least), 4096.0));
}

// Whether the scheme has places where an axis would have to jump; and how far a point is from them,
// mm.
[[nodiscard]] inline bool has_singularity(const Segment& segment) {
  return segment.transform != nullptr && segment.transform->scheme != nullptr &&
         segment.transform->scheme->winding_axes() != 0;
}

[[nodiscard]] inline double distance_to_singularity(const Segment& segment, const Point& point_W) {
  const kinematics::Transform& transform = *segment.transform;
  return transform.scheme->distance_to_singularity(
      kinematics::base_from_workpiece(transform.frame, point_W));
}

template <class Scalar>
void to_machine(const Segment& segment, const kinematics::AxisVector<Scalar>& point_W,
                kinematics::AxisVector<Scalar>& axes_M) RT_SAFE {
  if (segment.transform == nullptr) {
    axes_M = point_W;
  } else {
    kinematics::inverse(*segment.transform, point_W, axes_M);
  }
}

}  // namespace stanok::motion
