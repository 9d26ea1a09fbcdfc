#include "lang/elements/corner_cut.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace stanok::lang {
namespace {

constexpr double smooth_turn = std::numbers::pi / 180.0;

// On an element so much, mm or rad, from one of its ends.
struct PlaceOnElement {
  PlanePoint point;
  double cut = 0.0;
};

PlanePoint turned_about(PlanePoint centre, PlanePoint point, double angle) {
  const PlanePoint radius = point - centre;
  return centre + std::cos(angle) * radius + std::sin(angle) * left_of(radius);
}

// `forth`: 1 on the element behind the corner, -1 on the one before it.
std::optional<PlaceOnElement> place_at(const PlaneElement& element, PlanePoint corner, double forth,
                                       double chord) {
  if (!element.arc) {
    return PlaceOnElement{corner + forth * chord * start_tangent(element), chord};
  }
  const double diameter = 2.0 * norm(corner - element.centre);
  if (chord > diameter) return std::nullopt;
  const double angle = 2.0 * std::asin(chord / diameter);
  const double sense = element.counter_clockwise ? forth : -forth;
  return PlaceOnElement{turned_about(element.centre, corner, sense * angle), angle};
}

bool is_within(const PlaneElement& element, double cut) {
  return cut >= -same_point && cut <= extent(element) + same_point;
}

CornerCut chamfer(const PlaneElement& before, const PlaneElement& after, double size) {
  const auto from = place_at(before, before.end, -1.0, size);
  const auto to = place_at(after, before.end, 1.0, size);
  if (!from || !to) return {.fit = CornerCut::Fit::too_large};
  CornerCut cut;
  cut.end_before = from->point;
  cut.start_after = to->point;
  cut.cut_before = from->cut;
  cut.cut_after = to->cut;
  return cut;
}

// Where the circle of radius |offset| about `centre` touches the element.
PlanePoint contact_with(const PlaneElement& element, PlanePoint centre, double offset) {
  if (!element.arc) return centre - offset * left_of(start_tangent(element));
  const PlanePoint out = centre - element.centre;
  return element.centre + (norm(element.start - element.centre) / norm(out)) * out;
}

CornerCut rounding(const PlaneElement& before, const PlaneElement& after, double offset) {
  const auto is_too_tight = [offset](const PlaneElement& element) {
    return element.arc && parallel_start_radius(element, offset) <= same_point;
  };
  if (is_too_tight(before) || is_too_tight(after)) return {.fit = CornerCut::Fit::too_large};
  const Corner corner = corner_between(before, after, offset);
  if (corner.kind != CornerKind::joint) return {.fit = CornerCut::Fit::too_large};
  CornerCut cut;
  cut.centre = corner.end_before;
  cut.end_before = contact_with(before, cut.centre, offset);
  cut.start_after = contact_with(after, cut.centre, offset);
  cut.cut_before = corner.cut_before;
  cut.cut_after = corner.cut_after;
  cut.counter_clockwise = offset > 0.0;
  return cut;
}

}  // namespace

CornerCut cut_corner(const PlaneElement& before, const PlaneElement& after,
                     const CornerRequest& request) {
  const PlanePoint incoming = end_tangent(before);
  const PlanePoint outgoing = start_tangent(after);
  const double turn = std::atan2(cross(incoming, outgoing), dot(incoming, outgoing));
  if (std::abs(turn) < smooth_turn) return {.fit = CornerCut::Fit::is_smooth};
  if (std::abs(turn) > std::numbers::pi - smooth_turn) return {.fit = CornerCut::Fit::too_large};
  CornerCut cut = request.kind == CornerRequest::Kind::chamfer
                      ? chamfer(before, after, request.size_mm)
                      : rounding(before, after, std::copysign(request.size_mm, turn));
  const bool fits = cut.fit == CornerCut::Fit::fits && is_within(before, cut.cut_before) &&
                    is_within(after, cut.cut_after);
  if (!fits) cut.fit = CornerCut::Fit::too_large;
  return cut;
}

}  // namespace stanok::lang
