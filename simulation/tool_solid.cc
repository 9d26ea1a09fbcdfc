// Symbols as in the header: a height over the tip, ρ distance from the axis of the tool.
#include "simulation/tool_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/quadratic_stretch.h"

namespace stanok::simulation {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double point_angle_default = 118.0;  // deg, of twist drills for steel (DIN 1414, type N)
constexpr double flute_default = 8.0;          // radii, where the table gives no length at all
constexpr double stylus_default = 0.6;  // of the radius of the ball, where the table says nothing

ProfileSegment cylinder(double from, double to, double radius) {
  return {from, to, radius * radius, 0.0, 0.0};
}

ProfileSegment cone(double from, double to, double radius_from, double radius_to) {
  const double slope = (radius_to - radius_from) / (to - from);
  const double apex = radius_from - slope * from;  // radius at the height of the tip
  return {from, to, apex * apex, 2.0 * apex * slope, slope * slope};
}

ProfileSegment sphere(double from, double to, double centre, double radius) {
  return {from, to, radius * radius - centre * centre, 2.0 * centre, -1.0};
}

// A part of a torus as cones between its points: from the face at `inner` on, over `angle_to`.
void add_rounding(std::vector<ProfileSegment>& segments, double bottom, double inner, double radius,
                  double angle_to, double deviation) {
  const double chord = 2.0 * std::acos(std::max(0.5, 1.0 - deviation / radius));
  const int count = std::max(2, static_cast<int>(std::ceil(angle_to / chord)));
  const auto height = [&](int i) {
    return bottom + radius * (1.0 - std::cos(angle_to * i / count));
  };
  const auto out = [&](int i) { return inner + radius * std::sin(angle_to * i / count); };
  for (int i = 0; i < count; ++i)
    segments.push_back(cone(height(i), height(i + 1), out(i), out(i + 1)));
}

// What there is of the tool above its cutting part.
struct Heights {
  double flute = 0.0;
  double shank = 0.0;
  double holder = 0.0;
};

Heights heights_of(const ToolShape& tool) {
  Heights heights;
  const bool has_holder = tool.holder_diameter > 0.0 && tool.holder_length > 0.0;
  double overhang = tool.overhang;
  if (overhang <= 0.0) overhang = tool.length - (has_holder ? tool.holder_length : 0.0);
  heights.flute = tool.kind == ToolKind::probe ? 2.0 * tool.radius : tool.flute_length;
  if (heights.flute <= 0.0) heights.flute = overhang > 0.0 ? overhang : flute_default * tool.radius;
  heights.shank = std::max(overhang, heights.flute);
  heights.holder = heights.shank + (has_holder ? tool.holder_length : 0.0);
  return heights;
}

std::vector<ProfileSegment> taper(const ToolShape& tool, double top, double deviation) {
  std::vector<ProfileSegment> segments;
  const double angle = tool.taper_angle * rad_per_deg;
  const double corner = std::min(tool.corner_radius, tool.radius);
  double bottom = 0.0;
  double radius = tool.radius;
  if (corner > 0.0) {
    const double turn = std::numbers::pi / 2.0 - angle;
    add_rounding(segments, 0.0, tool.radius - corner, corner, turn, deviation);
    bottom = segments.back().to;
    radius = tool.radius - corner + corner * std::sin(turn);
  }
  if (top > bottom)
    segments.push_back(cone(bottom, top, radius, radius + (top - bottom) * std::tan(angle)));
  return segments;
}

std::vector<ProfileSegment> cutting_profile(const ToolShape& tool, double top, double deviation) {
  std::vector<ProfileSegment> segments;
  const double r = tool.radius;
  double bottom = 0.0;
  if (tool.kind == ToolKind::probe) return {sphere(0.0, 2.0 * r, r, r)};
  const bool is_ball = tool.kind == ToolKind::ball ||
                       (tool.kind == ToolKind::bull && tool.corner_radius >= tool.radius);
  if (is_ball) {
    bottom = std::min(r, top);
    segments.push_back(sphere(0.0, bottom, r, r));
  } else if (tool.kind == ToolKind::bull && tool.corner_radius > 0.0) {
    add_rounding(segments, 0.0, r - tool.corner_radius, tool.corner_radius, std::numbers::pi / 2.0,
                 deviation);
    bottom = tool.corner_radius;
  } else if (tool.kind == ToolKind::drill) {
    const double point = tool.point_angle > 0.0 ? tool.point_angle : point_angle_default;
    bottom = r / std::tan(point / 2.0 * rad_per_deg);
    if (bottom > 0.0) segments.push_back(cone(0.0, bottom, 0.0, r));
  } else if (tool.kind == ToolKind::taper) {
    return taper(tool, top, deviation);
  }
  if (top > bottom) segments.push_back(cylinder(bottom, top, r));
  return segments;
}

double shank_radius(const ToolShape& tool, double cutter_radius) {
  if (tool.shank_diameter > 0.0) return tool.shank_diameter / 2.0;
  return tool.kind == ToolKind::probe ? stylus_default * tool.radius : cutter_radius;
}

double radius_max(const ProfileSegment& segment) {
  if (segment.c2 < 0.0) return segment.sphere_radius();
  return std::max(segment.radius_at(segment.from), segment.radius_at(segment.to));
}

// A ball stays a ball about the same centre.
ProfileSegment shrunk_sphere(const ProfileSegment& segment, double bottom, double by) {
  const double centre = segment.c1 / 2.0;
  return sphere(bottom, segment.to, centre, std::sqrt(segment.c0 + centre * centre) - by);
}

// Set back by `by`: thinner all over, and shorter at both ends.
std::vector<ProfileSegment> shrunk_profile(const std::vector<ProfileSegment>& segments, double by) {
  const double bottom = segments.front().from + by;
  const double top = segments.back().to - by;
  std::vector<ProfileSegment> shrunk;
  for (const ProfileSegment& segment : segments) {
    const double from = std::max(segment.from, bottom);
    const double to = std::min(segment.to, top);
    const double radius_from = segment.radius_at(from - by) - by;
    const double radius_to = segment.radius_at(to - by) - by;
    if (to - from <= parallel) continue;
    if (segment.c2 < 0.0 && radius_max(segment) > by) {
      shrunk.push_back(shrunk_sphere(segment, from, by));
    } else if (radius_to > 0.0) {
      shrunk.push_back(cone(from, to, std::max(0.0, radius_from), radius_to));
    }
  }
  return shrunk;
}

void add_body(ToolSolid& solid, Part part, std::vector<ProfileSegment> segments, double shrunk) {
  if (shrunk > 0.0 && !segments.empty()) segments = shrunk_profile(segments, shrunk);
  solid.bodies.push_back({part, std::move(segments)});
}

}  // namespace

double ProfileSegment::radius_at(double height) const {
  const double a = std::clamp(height, from, to);
  return std::sqrt(std::max(0.0, c0 + a * (c1 + a * c2)));
}

double ProfileSegment::sphere_radius() const {
  return std::sqrt(c0 + c1 * c1 / 4.0);
}

ToolSolid solid_of(const ToolShape& tool, double deviation, double shrunk) {
  const Heights heights = heights_of(tool);
  ToolSolid solid;
  std::vector<ProfileSegment> cutting = cutting_profile(tool, heights.flute, deviation);
  for (const ProfileSegment& segment : cutting)
    solid.radius =
        std::max({solid.radius, segment.radius_at(segment.from), segment.radius_at(segment.to)});
  if (tool.kind == ToolKind::probe) solid.radius = tool.radius;
  if (tool.kind == ToolKind::ball) solid.edge_radius = tool.radius;
  if (tool.kind == ToolKind::bull) solid.edge_radius = std::min(tool.corner_radius, tool.radius);
  add_body(solid, Part::cutting, std::move(cutting), shrunk);
  const double shank = shank_radius(tool, solid.radius);
  if (heights.shank > heights.flute)
    add_body(solid, Part::shank, {cylinder(heights.flute, heights.shank, shank)}, shrunk);
  if (heights.holder > heights.shank) {
    add_body(solid, Part::holder,
             {cylinder(heights.shank, heights.holder, tool.holder_diameter / 2.0)}, shrunk);
  }
  return solid;
}

ToolSolid widened_probe(const ToolSolid& probe, double by) {
  ToolSolid widened = probe;
  widened.radius += by;
  for (Body& body : widened.bodies) {
    for (ProfileSegment& segment : body.segments) {
      const double radius = radius_max(segment) + by;
      segment = segment.c2 < 0.0
                    ? sphere(segment.from - by, segment.to + by, segment.c1 / 2.0, radius)
                    : cylinder(segment.from - by, segment.to + by, radius);
    }
  }
  return widened;
}

bool touches(const ToolSolid& tool, const ToolPlace& place, const Disc& disc) {
  if (place.axis.z() < 1.0 - parallel) return false;
  const double depth = disc.top.z() - place.tip.z();
  const double beside = (place.tip - disc.top).head<2>().norm();
  for (const Body& body : tool.bodies) {
    if (depth < body.bottom() || depth - disc.height > body.top()) continue;
    double widest = 0.0;
    for (const ProfileSegment& segment : body.segments) {
      const double from = std::max(segment.from, depth - disc.height);
      const double to = std::min(segment.to, depth);
      if (from > to) continue;
      widest = std::max({widest, segment.radius_at(from), segment.radius_at(to)});
      const double middle = segment.c1 / 2.0;  // of a sphere
      if (segment.c2 < 0.0 && from < middle && middle < to)
        widest = std::max(widest, segment.sphere_radius());
    }
    if (beside <= disc.radius + widest) return true;
  }
  return false;
}

double radius_of(const Body& body) {
  double radius = 0.0;
  for (const ProfileSegment& segment : body.segments)
    radius = std::max(radius, radius_max(segment));
  return radius;
}

Bounds bounds_of(const Body& body, const ToolPlace& place) {
  Bounds bounds{Vector::Constant(1e300), Vector::Constant(-1e300)};
  const Vector across = (Vector::Ones() - place.axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  for (const ProfileSegment& segment : body.segments) {
    const double radius = radius_max(segment);
    for (const double height : {segment.from, segment.to}) {
      const Vector centre = place.at(height);
      bounds.low = bounds.low.cwiseMin(centre - radius * across);
      bounds.high = bounds.high.cwiseMax(centre + radius * across);
    }
  }
  return bounds;
}

BodySection::BodySection(const Body& body, const ToolPlace& place, int axis)
    : radius_(radius_of(body)), bottom_(body.bottom()), top_(body.top()) {
  for (int k = 0; k < 3; ++k) {
    tip_[k] = place.tip[(axis + k) % 3];
    axis_[k] = place.axis[(axis + k) % 3];
  }
  const double slope = axis_.x();
  if (std::abs(slope) > parallel) inverse_slope_ = 1.0 / slope;
  cuts_.reserve(body.segments.size());
  for (const ProfileSegment& segment : body.segments) {
    const double k = 1.0 + segment.c2;
    const double A = 1.0 - k * slope * slope;
    cuts_.push_back({segment, k, A, std::abs(A) > parallel ? 1.0 / A : 0.0});
  }
}

// The shadow of the body along the line lies in that of its axis, thickened by the radius.
bool BodySection::row(double second, double& first_from, double& first_to) const {
  double from = bottom_;
  double to = top_;
  double half = radius_;
  if (std::abs(axis_.z()) > parallel) {
    const double one = (second - tip_.z() - radius_) / axis_.z();
    const double other = (second - tip_.z() + radius_) / axis_.z();
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    if (from > to) return false;
  } else {
    const double beside = second - tip_.z();
    half = std::sqrt(std::max(0.0, radius_ * radius_ - beside * beside));
  }
  const double at_from = tip_.y() + from * axis_.y();
  const double at_to = tip_.y() + to * axis_.y();
  first_from = std::min(at_from, at_to) - half;
  first_to = std::max(at_from, at_to) + half;
  return true;
}

// On the line p(x) = (x, first, second): a = a0 + x a1 with x counted from the tip, and
// ρ² - c0 - c1 a - c2 a² = A x² + 2 B x + C.
bool BodySection::meet(double first, double second, double& from, double& to) const {
  const double y = first - tip_.y();
  const double z = second - tip_.z();
  const double a1 = axis_.x();
  const double a0 = y * axis_.y() + z * axis_.z();
  const double p0 = y * y + z * z;
  bool met = false;
  for (const Cut& cut : cuts_) {
    const ProfileSegment& segment = cut.segment;
    Stretch stretch;
    auto& [low, high] = stretch;
    if (inverse_slope_ != 0.0) {
      low = (segment.from - a0) * inverse_slope_;
      high = (segment.to - a0) * inverse_slope_;
      if (low > high) std::swap(low, high);
    } else if (a0 < segment.from || a0 > segment.to) {
      continue;
    }
    const double B = -cut.k * a0 * a1 - segment.c1 * a1 / 2.0;
    const double C = p0 - cut.k * a0 * a0 - segment.c1 * a0 - segment.c0;
    if (!narrow(stretch, cut.A, cut.inverse_A, B, C)) continue;
    from = met ? std::min(from, low) : low;
    to = met ? std::max(to, high) : high;
    met = true;
  }
  if (!met) return false;
  from += tip_.x();
  to += tip_.x();
  return true;
}

}  // namespace stanok::simulation
