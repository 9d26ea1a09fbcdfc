#include "lang/elements/plane_element.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stanok::lang {
namespace {

// Directions closer than this (rad) are the same: the arc is a full circle.
constexpr double same_direction = 1e-12;

// A cut may be negative by this much (mm or rad): rounding of an intersection.
constexpr double cut_noise = 1e-9;

// Parallels of corners up to this angle that leave the contour on the tool's side are extended to
// their intersection: an arc there would be a block of a few hundredths of a millimetre.
constexpr double shallow_turn = 10.0 * std::numbers::pi / 180.0;

// A corner whose intersection lies closer than this (mm) to the arc about it is tangential.
constexpr double tangential_overshoot = 1e-10;

// Within this of half a turn the path turns back: there is an outside on both sides of it, unless
// an arc bends away there.
constexpr double turn_back = 1e-6;

double direction(PlanePoint p) {
  return std::atan2(p.second, p.first);
}

// Tangent at `point` of an arc.
PlanePoint tangent_at(const PlaneElement& arc, PlanePoint point) {
  const PlanePoint radial = point - arc.centre;
  const PlanePoint tangent = arc.counter_clockwise ? left_of(radial) : -1.0 * left_of(radial);
  return (1.0 / norm(tangent)) * tangent;
}

double parallel_radius(const PlaneElement& arc, double radius, double offset) {
  return arc.counter_clockwise ? radius - offset : radius + offset;
}

// Positive to the left, 1/mm.
double curvature(const PlaneElement& element) {
  if (!element.arc) return 0.0;
  const double value = 1.0 / norm(element.start - element.centre);
  return element.counter_clockwise ? value : -value;
}

// Where the path turns back: whether what goes away from the corner bends, seen from what came, to
// the side of the tool, so that the tool stands between both.
bool encloses_tool(const PlaneElement& before, const PlaneElement& after, double offset) {
  return (curvature(before) + curvature(after)) * offset < 0.0;
}

// Angle travelled on `arc` from the direction of `from` to that of `to`, (-pi, pi].
double travelled(const PlaneElement& arc, PlanePoint from, PlanePoint to) {
  const PlanePoint a = from - arc.centre;
  const PlanePoint b = to - arc.centre;
  const double angle = std::atan2(cross(a, b), dot(a, b));
  return arc.counter_clockwise ? angle : -angle;
}

// Which end of a parallel.
enum class ParallelEnd { start, end };

// What a parallel whose `which` end is `point` loses against one that goes to the
// corner.
double cut_at(const PlaneElement& element, PlanePoint point, double offset, ParallelEnd which) {
  const bool at_end = which == ParallelEnd::end;
  if (element.arc) {
    return at_end ? travelled(element, point, element.end)
                  : travelled(element, element.start, point);
  }
  const PlanePoint tangent = start_tangent(element);
  const PlanePoint corner = (at_end ? element.end : element.start) + offset * left_of(tangent);
  return at_end ? dot(corner - point, tangent) : dot(point - corner, tangent);
}

// Cut by an intersection that must lie on the element: an arc may be cut by more than half a turn.
double cut_on(const PlaneElement& element, PlanePoint point, double offset, ParallelEnd which) {
  const double cut = cut_at(element, point, offset, which);
  return element.arc && cut < -cut_noise ? cut + full_turn : cut;
}

struct Points {
  std::array<PlanePoint, 2> at{};
  std::size_t count = 0;
};

// Line through `origin` along the unit vector `along`, and the circle. A distance that exceeds the
// radius by rounding alone is taken as contact.
Points line_and_circle(PlanePoint origin, PlanePoint along, PlanePoint centre, double radius) {
  const double foot = dot(centre - origin, along);
  const double distance = cross(along, centre - origin);
  const double square = (radius - distance) * (radius + distance);
  if (square < -1e-9 * (1.0 + radius)) return {};
  const double half = std::sqrt(std::max(square, 0.0));
  return {{origin + (foot - half) * along, origin + (foot + half) * along}, 2};
}

Points two_circles(PlanePoint c0, double r0, PlanePoint c1, double r1) {
  const PlanePoint between = c1 - c0;
  const double distance = norm(between);
  if (distance == 0.0) return {};
  const PlanePoint along = (1.0 / distance) * between;
  const double foot = (distance + (r0 - r1) * (r0 + r1) / distance) / 2.0;
  const double square = (r0 - foot) * (r0 + foot);
  if (square < -1e-9 * (1.0 + r0)) return {};
  const double half = std::sqrt(std::max(square, 0.0));
  const PlanePoint middle = c0 + foot * along;
  return {{middle - half * left_of(along), middle + half * left_of(along)}, 2};
}

Points intersections(const PlaneElement& before, const PlaneElement& after, double offset) {
  const double radius_before = before.arc ? parallel_end_radius(before, offset) : 0.0;
  const double radius_after = after.arc ? parallel_start_radius(after, offset) : 0.0;
  if (before.arc && after.arc) {
    return two_circles(before.centre, radius_before, after.centre, radius_after);
  }
  const PlaneElement& line = before.arc ? after : before;
  const PlaneElement& arc = before.arc ? before : after;
  const PlanePoint tangent = start_tangent(line);
  return line_and_circle(line.start + offset * left_of(tangent), tangent, arc.centre,
                         before.arc ? radius_before : radius_after);
}

// The intersection that takes the least from both elements: the first one the tool comes to. Of two
// as far from the corner, where the path turns back, the one on the programmed parts of the arcs.
Corner inner_corner(const PlaneElement& before, const PlaneElement& after, double offset,
                    Corner corner) {
  corner.kind = CornerKind::none;
  const Points points = intersections(before, after, offset);
  double least = 0.0;
  for (std::size_t i = 0; i < points.count; ++i) {
    const PlanePoint point = points.at[i];
    const double cut_before = cut_on(before, point, offset, ParallelEnd::end);
    const double cut_after = cut_on(after, point, offset, ParallelEnd::start);
    if (cut_before < -cut_noise || cut_after < -cut_noise) continue;
    const PlanePoint away = point - before.end;
    const double removed = dot(away, away);
    const bool as_far = std::abs(removed - least) <= same_point * (1.0 + least);
    const bool worse =
        as_far ? cut_before + cut_after >= corner.cut_before + corner.cut_after : removed > least;
    if (corner.kind == CornerKind::joint && worse) continue;
    least = removed;
    corner.kind = CornerKind::joint;
    corner.end_before = point;
    corner.start_after = point;
    corner.cut_before = cut_before;
    corner.cut_after = cut_after;
  }
  return corner;
}

// Both parallels meet on the bisector, |offset| / cos(turn / 2) from the corner.
Corner bisector_corner(const PlaneElement& before, const PlaneElement& after, double offset,
                       Corner corner) {
  const PlanePoint sum = left_of(end_tangent(before)) + left_of(start_tangent(after));
  const PlanePoint point = before.end + (2.0 * offset / dot(sum, sum)) * sum;
  corner.kind = CornerKind::joint;
  corner.end_before = point;
  corner.start_after = point;
  corner.cut_before = cut_at(before, point, offset, ParallelEnd::end);
  corner.cut_after = cut_at(after, point, offset, ParallelEnd::start);
  return corner;
}

}  // namespace

double norm(PlanePoint a) {
  return std::hypot(a.first, a.second);
}

PlaneElement with_sweep(PlaneElement arc, int turns) {
  double sweep = direction(arc.end - arc.centre) - direction(arc.start - arc.centre);
  if (!arc.counter_clockwise) sweep = -sweep;
  while (sweep <= same_direction) sweep += full_turn;
  arc.sweep = sweep + full_turn * (turns - 1);
  return arc;
}

double extent(const PlaneElement& element) {
  return element.arc ? element.sweep : norm(element.end - element.start);
}

PlanePoint start_tangent(const PlaneElement& element) {
  if (element.arc) return tangent_at(element, element.start);
  const PlanePoint along = element.end - element.start;
  return (1.0 / norm(along)) * along;
}

PlanePoint end_tangent(const PlaneElement& element) {
  return element.arc ? tangent_at(element, element.end) : start_tangent(element);
}

double parallel_start_radius(const PlaneElement& arc, double offset) {
  return parallel_radius(arc, norm(arc.start - arc.centre), offset);
}

double parallel_end_radius(const PlaneElement& arc, double offset) {
  return parallel_radius(arc, norm(arc.end - arc.centre), offset);
}

Corner corner_between(const PlaneElement& before, const PlaneElement& after, double offset) {
  const PlanePoint incoming = end_tangent(before);
  const PlanePoint outgoing = start_tangent(after);
  Corner corner;
  corner.end_before = before.end;
  corner.start_after = before.end;
  if (offset == 0.0) return corner;
  corner.end_before = before.end + offset * left_of(incoming);
  corner.start_after = before.end + offset * left_of(outgoing);
  corner.turn = std::atan2(cross(incoming, outgoing), dot(incoming, outgoing));
  const bool back = std::abs(corner.turn) > std::numbers::pi - turn_back;
  if (back) {
    const bool inwards = encloses_tool(before, after, offset);
    corner.turn = (offset > 0.0) == inwards ? std::numbers::pi : -std::numbers::pi;
  }
  const bool outside = corner.turn * offset <= 0.0;
  const bool lines = !before.arc && !after.arc;
  const double overshoot =
      back ? 2.0 : std::abs(offset) * (1.0 / std::cos(corner.turn / 2.0) - 1.0);
  const bool tangential = overshoot < tangential_overshoot;
  const bool extended = lines && (!outside || std::abs(corner.turn) <= shallow_turn);
  if (tangential || extended) return bisector_corner(before, after, offset, corner);
  if (!outside) return inner_corner(before, after, offset, corner);
  corner.kind = CornerKind::round;
  return corner;
}

}  // namespace stanok::lang
