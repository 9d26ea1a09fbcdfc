// Range of the machine axes over a segment against their soft limits
// (motion/bounds/segment_bounds.h).
#include <array>
#include <cmath>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/geometry.h"
#include "motion/path/sampling.h"

namespace stanok::motion {
namespace {

constexpr double position_rounding = 1e-9;  // mm or deg
constexpr int search_steps = 60;  // golden section: the interval shrinks below 1e-12 of itself

Point axes_at(const Segment& segment, double u) {
  JetPoint point_s;
  evaluate_at_parameter(segment, u, point_s);
  Point point_W;
  for (std::size_t k = 0; k < axes_max; ++k) point_W[k] = point_s[k].value;
  Point axes_M;
  to_machine(segment, point_W, axes_M);
  return axes_M;
}

// Keeps the farthest excess seen.
class Watch {
 public:
  explicit Watch(const MotionConfig& config) : config_(config) {}

  void look(int axis, double position) {
    const AxisLimits& limits = config_.axes[axis];
    if (std::isnan(position)) {
      farthest_ = unlimited;
      excess_ = Excess{axis, position, limits.position_max};
      return;
    }
    keep(axis, position, limits.position_max, position - limits.position_max);
    keep(axis, position, limits.position_min, limits.position_min - position);
  }
  void look(const Point& axes_M) {
    for (int axis = 0; axis < config_.axis_count; ++axis) {
      look(axis, axes_M[axis]);
    }
  }
  [[nodiscard]] const std::optional<Excess>& excess() const { return excess_; }

 private:
  void keep(int axis, double position, double limit, double distance) {
    if (!(distance > farthest_)) return;
    farthest_ = distance;
    excess_ = Excess{axis, position, limit};
  }

  const MotionConfig& config_;
  double farthest_ = position_rounding;
  std::optional<Excess> excess_;
};

// Extreme of one axis between two parameters: largest of sign * q, q having one extreme there.
double extreme(const Segment& segment, int axis, double sign, double from, double to) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  const auto value = [&](double u) { return sign * axes_at(segment, u)[axis]; };
  double left = to - ratio * (to - from);
  double right = from + ratio * (to - from);
  double value_left = value(left);
  double value_right = value(right);
  for (int i = 0; i < search_steps; ++i) {
    if (value_left > value_right) {
      to = right;
      right = left;
      value_right = value_left;
      left = to - ratio * (to - from);
      value_left = value(left);
    } else {
      from = left;
      left = right;
      value_left = value_right;
      right = from + ratio * (to - from);
      value_right = value(right);
    }
  }
  return sign * std::max(value_left, value_right);
}

// Looks between samples where an extreme there might pass a limit.
void look_between(const Segment& segment, const MotionConfig& config, double from, double to,
                  const std::array<Point, 3>& samples, Watch& watch) {
  for (int k = 0; k < config.axis_count; ++k) {
    const double before = samples[0][k];
    const double here = samples[1][k];
    const double after = samples[2][k];
    const double margin = between_samples * std::abs(after - 2.0 * here + before);
    const auto& limits = config.axes[k];
    if (std::max({before, here, after}) + margin > limits.position_max) {
      watch.look(k, extreme(segment, k, 1.0, from, to));
    }
    if (std::min({before, here, after}) - margin < limits.position_min) {
      watch.look(k, extreme(segment, k, -1.0, from, to));
    }
  }
}

}  // namespace

std::optional<Excess> soft_limit_excess(const Segment& segment, const MotionConfig& config) {
  Watch watch(config);
  if (is_affine(segment) && segment.geometry.kind == SegmentKind::line) {
    watch.look(axes_at(segment, 0.0));
    watch.look(axes_at(segment, 1.0));
    return watch.excess();
  }
  const int intervals = sampling_intervals(segment, config);
  const double step = 1.0 / intervals;
  std::array<Point, 3> samples;
  for (int i = 0; i <= intervals; ++i) {
    samples[0] = samples[1];
    samples[1] = samples[2];
    samples[2] = axes_at(segment, i * step);
    watch.look(samples[2]);
    if (i >= 2) look_between(segment, config, (i - 2) * step, i * step, samples, watch);
  }
  return watch.excess();
}

}  // namespace stanok::motion
