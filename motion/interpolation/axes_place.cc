#include "motion/interpolation/axes_place.h"

#include <cmath>

#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

void derivatives_to_zero(JetPoint& point, const Point& values) RT_SAFE {
  for (std::size_t k = 0; k < values.size(); ++k) point[k] = kinematics::Jet(values[k]);
}

}  // namespace

void AxesPlace::to_axes(const kinematics::Transform* transform, const JetPoint& point,
                        JetPoint& axes) const RT_SAFE {
  if (transform == nullptr) {
    axes = point;
  } else if (is_changed(*transform)) {
    kinematics::inverse(kinematics::with_changes(*transform, *lengths_), point, axes);
  } else {
    kinematics::inverse(*transform, point, axes);
  }
}

void AxesPlace::stand_at(const Point& axes_M, const kinematics::Transform& transform) RT_SAFE {
  standing_axes_ = axes_M;
  last_axes_ = axes_M;
  if (is_changed(transform)) {
    kinematics::forward(kinematics::with_changes(transform, *lengths_), axes_M, standing_point_);
  } else {
    kinematics::forward(transform, axes_M, standing_point_);
  }
}

void AxesPlace::stand_on(const Segment& segment, double s) RT_SAFE {
  JetPoint point;
  JetPoint axes;
  evaluate(segment, s, point);
  for (std::size_t k = 0; k < point.size(); ++k) standing_point_[k] = point[k].value;
  derivatives_to_zero(point, standing_point_);
  to_axes(segment.transform, point, axes);
  unwind(segment.transform, axes);
  for (std::size_t k = 0; k < axes.size(); ++k) standing_axes_[k] = axes[k].value;
  tag_ = segment.tag;
  process_ = segment.process;
}

void AxesPlace::follow(const Segment& segment, const JetPoint& point, JetPoint& axes) RT_SAFE {
  to_axes(segment.transform, point, axes);
  unwind(segment.transform, axes);
  for (std::size_t k = 0; k < axes.size(); ++k) last_axes_[k] = axes[k].value;
}

void AxesPlace::standing(JetPoint& point, JetPoint& axes) const RT_SAFE {
  derivatives_to_zero(point, standing_point_);
  derivatives_to_zero(axes, standing_axes_);
}

void AxesPlace::unwind(const kinematics::Transform* transform, JetPoint& axes) const RT_SAFE {
  if (transform == nullptr || transform->scheme == nullptr) return;
  constexpr double turn = 360.0;
  const unsigned winding = transform->scheme->winding_axes();
  for (std::size_t k = 0; winding >> k != 0; ++k) {
    if ((winding >> k & 1U) == 0) continue;
    axes[k].value += turn * std::round((last_axes_[k] - axes[k].value) / turn);
  }
}

}  // namespace stanok::motion
