// The places where the middle of a tool may be in a pocket, as closed lines around them.
//
// Lines and arcs come in, polygons go out; they stay inside of what is exact. Arcs become chords
// that leave at most `chord_deviation_mm` of the material and take none: on the side of a wall that
// bends away from the tool they lie inside the arc, around an island outside of it. Offsets of
// polygons and what lies inside of a line that crosses itself are those of the Clipper library
// (docs/developer/adr/0040-clipper-for-pockets.md); its coordinates are whole steps of
// `clipper_step_mm`. Plane coordinates, mm; not for the real-time cycle.
#pragma once

#include <vector>

#include "lang/elements/plane_element.h"

namespace stanok::lang {

inline constexpr double chord_deviation_mm = 2e-3;
inline constexpr double clipper_step_mm = 1e-6;
// Coordinates beyond are no pocket.
inline constexpr double pocket_reach_mm = 1e5;

// A closed polygon: the last point is connected to the first one.
using ClosedLine = std::vector<PlanePoint>;

// Closed lines, the material of the region on their left: around it counter-clockwise, around
// islands clockwise. The first one is the one around it.
struct RegionPart {
  std::vector<ClosedLine> lines;
};
using Region = std::vector<RegionPart>;  // parts that are not connected

// What lies to the left of a closed chain of elements; it may touch and cross itself, as the bridge
// to an island does. Empty: nothing does.
[[nodiscard]] Region region_inside(const std::vector<PlaneElement>& outline);

// What is at least `distance` (>= 0) away from the edge of a region.
[[nodiscard]] Region shrunk(const Region& region, double distance_mm);

[[nodiscard]] bool contains(const Region& region, PlanePoint point);
[[nodiscard]] bool contains(const RegionPart& part, PlanePoint point);

// The nearest point of some closed lines.
struct NearestPoint {
  double distance = 0.0;
  std::size_t line = 0;
  std::size_t edge = 0;  // from this point of the line to the next one
  PlanePoint point;
};
// Of a part that has lines.
[[nodiscard]] NearestPoint nearest_point(const std::vector<ClosedLine>& lines, PlanePoint to);

// Points of an element between its ends, at most `step` apart along it (mm); at least one.
[[nodiscard]] std::vector<PlanePoint> points_along(const PlaneElement& element, double step_mm);

}  // namespace stanok::lang
