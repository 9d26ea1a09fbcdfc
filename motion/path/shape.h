// Shapes: lines, arcs and quintics as geometry with their length, made once in preparation.
//
// All axes move together: those outside an arc's plane linearly with the sweep.
#pragma once

#include "motion/path/path.h"

namespace stanok::motion {

struct Shape {
  Geometry geometry;
  double length = 0.0;  // in s
};

[[nodiscard]] Shape line(const PathMetric& metric, const Point& start, const Point& end);

// The arc of `block` from `start`. The end of the sweep is laid on the programmed end point: the
// direction and the distance from the centre to `end` replace the programmed sweep where they
// differ by rounding.
[[nodiscard]] Shape arc(const PathMetric& metric, const Point& start, const PathBlock& block);

// Position and first two derivatives by s at one end of a curve to be made.
struct Contact {
  Point position{};
  Point tangent{};    // q'
  Point curvature{};  // q''
};
[[nodiscard]] Contact contact(const JetPoint& point_s);
// At the path length `s` of a segment.
[[nodiscard]] Contact contact_at(const Segment& segment, double s);

// The quintic that leaves `from` and enters `to` with their tangents and curvatures. `reach` is the
// distance L from the corner at which both lie; control points stand at L, beta L and gamma L
// (docs/developer/motion.md#blends).
[[nodiscard]] Shape blend_curve(const PathMetric& metric, const Contact& from, const Contact& to,
                                double reach);

// The curve of `block` from `start`: its coefficients in the plane, other axes linearly with u.
[[nodiscard]] Shape curve(const PathMetric& metric, const Point& start, const PathBlock& block);

// Coefficients of u^0..u^5 from value, first and second derivative by u at u = 0 and u = 1.
[[nodiscard]] std::array<double, 6> quintic_between(double p0, double v0, double a0, double p1,
                                                    double v1, double a1);

// The part of a segment between two path lengths; `start` and `end` are its points there, so
// that neighbours share them to the bit.
[[nodiscard]] Shape part(const Segment& whole, double s_start, const Point& start, double s_end,
                         const Point& end);

}  // namespace stanok::motion
