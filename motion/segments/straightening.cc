#include "motion/segments/straightening.h"

#include <algorithm>
#include <cmath>

#include "motion/path/point_algebra.h"
#include "motion/path/shape.h"

namespace stanok::motion {
namespace {

constexpr std::size_t left_out_max = 64;  // corners of a line: each is looked at again as it grows

}  // namespace

std::optional<Tolerance> Straightening::extend(Segment& line, const Segment& next,
                                               const Tolerance& allowed) {
  if (left_out_.size() >= left_out_max) return std::nullopt;
  const Geometry& before = line.geometry;
  left_out_.push_back(before.end);
  const auto off = deviation(before.metric, before.start, next.geometry.end);
  if (!off || off->mm > allowed.mm || off->deg > allowed.deg) {
    left_out_.pop_back();
    return std::nullopt;
  }
  const Shape shape = motion::line(before.metric, before.start, next.geometry.end);
  const double path_start = line.process.path_start;
  line = next;
  line.geometry = shape.geometry;
  line.length = shape.length;
  line.process.path_start = path_start;
  return off;
}

// Of the points left out from the line between two points; none: the path turns back on that line.
std::optional<Tolerance> Straightening::deviation(const PathMetric& metric, const Point& from,
                                                  const Point& to) const {
  const Point along = difference(to, from);
  const double squared = metric_product(metric, along, along);
  if (!(squared > 0.0)) return std::nullopt;
  Tolerance off;
  double before = 0.0;
  for (const Point& point : left_out_) {
    const double part = metric_product(metric, difference(point, from), along) / squared;
    if (!(part >= before && part <= 1.0)) return std::nullopt;
    before = part;
    const Point away = difference(point, between(from, to, part));
    off.mm = std::max(off.mm, geometry_norm(config_, away));
    for (int axis = 0; axis < config_.axis_count; ++axis) {
      double& worst = config_.axes[axis].linear ? off.mm : off.deg;
      worst = std::max(worst, std::abs(away[axis]));
    }
  }
  return off;
}

}  // namespace stanok::motion
