#include "channels/preparation/skipped_height.h"

#include <algorithm>
#include <cmath>

namespace stanok::channels {
namespace {

// Which of X, Y and Z the two axes of a plane are.
std::array<std::size_t, 2> axes_of(lang::Plane plane) {
  switch (plane) {
    case lang::Plane::zx:
      return {2, 0};
    case lang::Plane::yz:
      return {1, 2};
    default:
      return {0, 1};
  }
}

}  // namespace

void SkippedHeight::pass(const motion::Point& point_B, const std::array<int, 3>& geometry) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (geometry[k] < 0) continue;
    box_[k].low = std::min(box_[k].low, point_B[geometry[k]]);
    box_[k].high = std::max(box_[k].high, point_B[geometry[k]]);
  }
}

void SkippedHeight::pass(const lang::Move& arc, const motion::Point& start_W,
                         const kinematics::Frame& frame, const std::array<int, 3>& geometry) {
  const auto plane = axes_of(arc.plane);
  const int first = geometry[plane[0]];
  const int second = geometry[plane[1]];
  if (first < 0 || second < 0) return;
  const double radius = std::hypot(start_W[first] - arc.centre[0], start_W[second] - arc.centre[1]);
  for (const double u : {-radius, radius}) {
    for (const double v : {-radius, radius}) {
      motion::Point corner = start_W;
      corner[first] = arc.centre[0] + u;
      corner[second] = arc.centre[1] + v;
      pass(kinematics::base_from_workpiece(frame, corner), geometry);
    }
  }
}

// A curve lies within the hull of its points.
void SkippedHeight::pass(const lang::SplineMove& curve, const motion::Point& start_W,
                         const kinematics::Frame& frame, const std::array<int, 3>& geometry) {
  const auto plane = axes_of(curve.base.plane);
  const int first = geometry[plane[0]];
  const int second = geometry[plane[1]];
  if (first < 0 || second < 0) return;
  for (const auto& point : curve.points) {
    motion::Point corner = start_W;
    corner[first] = point[0];
    corner[second] = point[1];
    pass(kinematics::base_from_workpiece(frame, corner), geometry);
  }
}

// p_B = n p_W + o along that coordinate.
std::optional<double> SkippedHeight::along(int infeed, const kinematics::Frame& frame,
                                           const std::array<int, 3>& geometry) const {
  if (infeed < 0 || box_[0].low > box_[0].high) return std::nullopt;
  motion::Point unit{};
  const motion::Point origin = kinematics::base_from_workpiece(frame, unit);
  unit[infeed] = 1.0;
  const motion::Point tip = kinematics::base_from_workpiece(frame, unit);
  double height = 0.0;
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (geometry[k] < 0) continue;
    const double along = tip[geometry[k]] - origin[geometry[k]];
    const double far = along > 0.0 ? box_[k].high : box_[k].low;
    height += along * (far - origin[geometry[k]]);
    length += along * along;
  }
  if (length == 0.0) return std::nullopt;
  return height / length;
}

}  // namespace stanok::channels
