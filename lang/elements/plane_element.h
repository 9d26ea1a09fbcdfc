// A contour element in its plane: a line or an arc, its parallel, and the corner between the
// parallels of two elements that follow each other.
//
// Plane coordinates are (first, second) as in Move: XY, ZX, YZ; left is counter-clockwise of the
// direction of travel. `offset` is the signed distance of the parallel, positive to the left; mm,
// angles rad. Cuts are measured along the element, in mm on a line and in rad on an arc, positive
// where the parallel becomes shorter.
#pragma once

#include <numbers>
#include <optional>

namespace stanok::lang {

struct PlanePoint {
  double first = 0.0;
  double second = 0.0;
};

// Coordinates closer than this (mm) are the same: far below any resolution, far above rounding.
inline constexpr double same_point = 1e-9;

// Angles in rad.
inline constexpr double full_turn = 2.0 * std::numbers::pi;
inline constexpr double quarter_turn = std::numbers::pi / 2.0;

[[nodiscard]] constexpr PlanePoint operator+(PlanePoint a, PlanePoint b) {
  return {a.first + b.first, a.second + b.second};
}
[[nodiscard]] constexpr PlanePoint operator-(PlanePoint a, PlanePoint b) {
  return {a.first - b.first, a.second - b.second};
}
[[nodiscard]] constexpr PlanePoint operator*(double factor, PlanePoint a) {
  return {factor * a.first, factor * a.second};
}
[[nodiscard]] constexpr double dot(PlanePoint a, PlanePoint b) {
  return a.first * b.first + a.second * b.second;
}
[[nodiscard]] constexpr double cross(PlanePoint a, PlanePoint b) {
  return a.first * b.second - a.second * b.first;
}
// `a` turned by a quarter turn counter-clockwise.
[[nodiscard]] constexpr PlanePoint left_of(PlanePoint a) {
  return {-a.second, a.first};
}
[[nodiscard]] double norm(PlanePoint a);

struct PlaneElement {
  PlanePoint start;
  PlanePoint end;
  bool arc = false;
  PlanePoint centre;  // arc
  bool counter_clockwise = false;
  double sweep = 0.0;  // arc: in the direction of travel, > 0, full turns included
};

// An arc with its sweep, which follows from the rest; `turns` as in Move.
[[nodiscard]] PlaneElement with_sweep(PlaneElement arc, int turns);

// Length of a line in mm, sweep of an arc in rad.
[[nodiscard]] double extent(const PlaneElement& element);
[[nodiscard]] PlanePoint start_tangent(const PlaneElement& element);
[[nodiscard]] PlanePoint end_tangent(const PlaneElement& element);
// Radius of an arc's parallel at its start and end; below zero when the arc is too small for it.
[[nodiscard]] double parallel_start_radius(const PlaneElement& arc, double offset);
[[nodiscard]] double parallel_end_radius(const PlaneElement& arc, double offset);

enum class CornerKind {
  joint,  // one common point
  round,  // an arc about the programmed corner lies between the parallels
  none,   // the parallels do not meet: the tool cannot reach the corner
};

struct Corner {
  CornerKind kind = CornerKind::joint;
  PlanePoint end_before;  // of the parallel of the element before
  PlanePoint start_after;
  double cut_before = 0.0;
  double cut_after = 0.0;
  double turn = 0.0;  // change of direction, positive to the left, (-pi, pi]
};

[[nodiscard]] Corner corner_between(const PlaneElement& before, const PlaneElement& after,
                                    double offset);

}  // namespace stanok::lang
