#include "simulation/swept_section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stanok::simulation {
namespace {

constexpr double on_the_flank = 1e-7;  // mm², of ρ² less the square of the radius

Vector seen_along(int axis, const Vector& vector) {
  return {vector[axis], vector[(axis + 1) % 3], vector[(axis + 2) % 3]};
}

ToolPlace moved(const ToolPlace& place, const Vector& way) {
  return {place.tip + way, place.axis};
}

bool is_between(double value, double low, double high) {
  return value >= low && value <= high;
}

// Where at_zero + slope * x is within [0, length].
Stretch within(double at_zero, double slope, double length) {
  if (std::abs(slope) < parallel)
    return is_between(at_zero, 0.0, length) ? Stretch{} : Stretch{1.0, 0.0};
  const double one = -at_zero / slope;
  const double other = (length - at_zero) / slope;
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace

// The places that were found, counted from the tip at the begin of the way.
struct SweptSection::Hull {
  double from = infinite;
  double to = -infinite;

  void add(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

SweptSection::SweptSection(const Body& body, const ToolPlace& place, const Vector& way, int axis)
    : begin_(body, place, axis),
      tip_(seen_along(axis, place.tip)),
      axis_(seen_along(axis, place.axis)),
      length_(way.norm()),
      radius_(radius_of(body)),
      bottom_(body.bottom()),
      top_(body.top()) {
  if (length_ <= 0.0) return;
  end_.emplace(body, moved(place, way), axis);
  way_ = seen_along(axis, way) / length_;
  way_along_axis_ = way_.dot(axis_);
  bound_across();
  const double slope = axis_.x();
  for (const ProfileSegment& segment : body.segments) {
    const double k = 1.0 + segment.c2;
    cuts_.push_back({segment, k, 1.0 - k * slope * slope, k * slope * way_along_axis_ - way_.x(),
                     1.0 - k * way_along_axis_ * way_along_axis_});
  }
}

void SweptSection::bound_across() {
  const double across = std::hypot(way_.y(), way_.z());
  if (across < parallel) return;
  across_y_ = -way_.z() / across;
  across_z_ = way_.y() / across;
  const double slope = across_y_ * axis_.y() + across_z_ * axis_.z();
  const double tip = across_y_ * tip_.y() + across_z_ * tip_.z();
  across_low_ = tip + std::min(slope * bottom_, slope * top_) - radius_;
  across_high_ = tip + std::max(slope * bottom_, slope * top_) + radius_;
}

bool SweptSection::row(double second, double& first_from, double& first_to) const {
  if (!end_) return begin_.row(second, first_from, first_to);
  // The part of the way on which the row may be met at all, whatever the height.
  const double along = std::abs(axis_.z()) * std::max(std::abs(bottom_), std::abs(top_)) + radius_;
  Stretch part{0.0, length_};
  if (std::abs(way_.z()) > parallel) {
    const double one = (second - tip_.z() - along) / way_.z();
    const double other = (second - tip_.z() + along) / way_.z();
    part = {std::max(0.0, std::min(one, other)), std::min(length_, std::max(one, other))};
  } else if (std::abs(second - tip_.z()) > along) {
    return false;
  }
  if (part.low > part.high) return false;
  const double low_way = std::min(part.low * way_.y(), part.high * way_.y());
  const double high_way = std::max(part.low * way_.y(), part.high * way_.y());
  const double low_axis = std::min(bottom_ * axis_.y(), top_ * axis_.y());
  const double high_axis = std::max(bottom_ * axis_.y(), top_ * axis_.y());
  first_from = tip_.y() + low_way + low_axis - radius_;
  first_to = tip_.y() + high_way + high_axis + radius_;
  return true;
}

bool SweptSection::meet(double first, double second, double& from, double& to) const {
  if (!end_) return begin_.meet(first, second, from, to);
  const double across = across_y_ * first + across_z_ * second;
  if (!is_between(across, across_low_, across_high_)) return false;
  Hull hull;
  for (const BodySection* end : {&begin_, &*end_}) {
    if (!end->meet(first, second, from, to)) continue;
    hull.add(from - tip_.x());
    hull.add(to - tip_.x());
  }
  const Vector point(0.0, first - tip_.y(), second - tip_.z());
  const double p0 = point.squaredNorm();
  const double along_way = point.dot(way_);
  Line line{.a0 = point.dot(axis_)};
  for (const Cut& cut : cuts_) {
    line.B = -cut.k * line.a0 * axis_.x() - cut.segment.c1 * axis_.x() / 2.0;
    line.C = p0 - cut.k * line.a0 * line.a0 - cut.segment.c1 * line.a0 - cut.segment.c0;
    line.E = cut.k * line.a0 * way_along_axis_ + cut.segment.c1 * way_along_axis_ / 2.0 - along_way;
    add_flank(cut, line, hull);
    add_rim(cut, line, cut.segment.from, hull);
    add_rim(cut, line, cut.segment.to, hull);
  }
  if (hull.from >= hull.to) return false;
  from = hull.from + tip_.x();
  to = hull.to + tip_.x();
  return true;
}

// Where Q = 0 and ∂Q/∂s = D x + E + F s = 0.
void SweptSection::add_flank(const Cut& cut, const Line& line, Hull& hull) const {
  if (std::abs(cut.F) < parallel) return;
  const double share = cut.D / cut.F;
  const double A = cut.A - share * cut.D;
  const double B = line.B - share * line.E;
  const double C = line.C - line.E * line.E / cut.F;
  for (const double x : roots_of(A, B, C)) {
    const double s = -(line.E + cut.D * x) / cut.F;
    const double height = line.a0 + x * axis_.x() - s * way_along_axis_;
    if (!is_between(s, 0.0, length_) || !is_between(height, cut.segment.from, cut.segment.to))
      continue;
    // A root of nearly nothing may be far from the flank.
    const double Q =
        (cut.A * x + 2.0 * (line.B + cut.D * s)) * x + line.C + (2.0 * line.E + cut.F * s) * s;
    if (std::abs(Q) < on_the_flank) hull.add(x);
  }
}

// Where the rim of an end face, a + x a1 - s w = height, is inside.
void SweptSection::add_rim(const Cut& cut, const Line& line, double height, Hull& hull) const {
  const double slope = axis_.x();
  if (std::abs(slope) < parallel && std::abs(way_along_axis_) < parallel) return;
  if (std::abs(slope) >= std::abs(way_along_axis_)) {
    // By s: x = x0 + s g.
    const double x0 = (height - line.a0) / slope;
    const double g = way_along_axis_ / slope;
    Stretch s{0.0, length_};
    if (!narrow(s, cut.A * g * g + 2.0 * cut.D * g + cut.F,
                (cut.A * x0 + line.B) * g + cut.D * x0 + line.E,
                (cut.A * x0 + 2.0 * line.B) * x0 + line.C))
      return;
    hull.add(x0 + s.low * g);
    hull.add(x0 + s.high * g);
    return;
  }
  // By x: s = s0 + x g.
  const double s0 = (line.a0 - height) / way_along_axis_;
  const double g = slope / way_along_axis_;
  Stretch x = within(s0, g, length_);
  if (!narrow(x, cut.A + 2.0 * cut.D * g + cut.F * g * g,
              line.B + cut.D * s0 + (line.E + cut.F * s0) * g,
              line.C + (2.0 * line.E + cut.F * s0) * s0))
    return;
  hull.add(x.low);
  hull.add(x.high);
}

}  // namespace stanok::simulation
