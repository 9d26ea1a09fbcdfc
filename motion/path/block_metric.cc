#include "motion/path/block_metric.h"

#include <algorithm>
#include <cmath>

#include "motion/path/point_algebra.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

double travel(const PathBlock& block, const Point& start, int axis) {
  return at(block.end, axis) - at(start, axis);
}

PathMetric of_geometry(const MotionConfig& config) {
  PathMetric metric{config.axis_count, 0};
  for (const int axis : config.geometry) {
    if (axis >= 0) metric.axes |= 1U << static_cast<unsigned>(axis);
  }
  return metric;
}

// In its plane.
double length_of_arc(const PathBlock& block, const Point& start) {
  const double radius = std::hypot(at(start, block.plane[0]) - block.centre[0],
                                   at(start, block.plane[1]) - block.centre[1]);
  return radius * std::abs(block.sweep_rad);
}

// No point of a polynomial over [0, 1] is farther from its first one.
double largest_way(const std::array<double, 6>& coefficients) {
  double sum = 0.0;
  for (std::size_t k = 1; k < coefficients.size(); ++k) sum += std::abs(coefficients[k]);
  return sum;
}

}  // namespace

bool is_point_like(const PathBlock& block, const Point& start) {
  switch (block.kind) {
    case BlockKind::arc:
      return length_of_arc(block, start) <= standstill;
    case BlockKind::curve:
      return std::max(largest_way(block.curve[0]), largest_way(block.curve[1])) <= standstill;
    case BlockKind::line:
      break;
  }
  return false;
}

BlockTravel travel_of(const PathBlock& block, const Point& start, const MotionConfig& config) {
  if (block.kind != BlockKind::line && !is_point_like(block, start)) return BlockTravel::geometry;
  BlockTravel moved = BlockTravel::none;
  for (int axis = 0; axis < config.axis_count; ++axis) {
    if (std::abs(travel(block, start, axis)) <= standstill) continue;
    if (is_geometry_axis(config, axis)) return BlockTravel::geometry;
    moved = BlockTravel::others;
  }
  return moved;
}

PathMetric metric_of(BlockTravel travel, const MotionConfig& config) {
  PathMetric metric = of_geometry(config);
  if (travel != BlockTravel::geometry)
    metric.axes = ((1U << static_cast<unsigned>(config.axis_count)) - 1U) & ~metric.axes;
  return metric;
}

double length_of(const PathBlock& block, const Point& start, const MotionConfig& config) {
  const BlockTravel moved = travel_of(block, start, config);
  if (moved == BlockTravel::none) return 0.0;
  const PathMetric metric = metric_of(moved, config);
  const bool is_curved = block.kind != BlockKind::line && !is_point_like(block, start);
  if (is_curved && block.kind == BlockKind::curve) return curve(metric, start, block).length;
  double squared = 0.0;
  for (int axis = 0; axis < config.axis_count; ++axis) {
    const bool in_plane = is_curved && (axis == block.plane[0] || axis == block.plane[1]);
    if (in_plane || !metric.counts(axis)) continue;
    squared += travel(block, start, axis) * travel(block, start, axis);
  }
  return is_curved ? std::hypot(length_of_arc(block, start), std::sqrt(squared))
                   : std::sqrt(squared);
}

}  // namespace stanok::motion
