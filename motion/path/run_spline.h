// RunSpline: the cubic quasi-interpolant of a polyline over knots of any distance.
//
// Span i lies between the knots i and i + 1. The control point around knot m belongs to the knots
// m - 1 to m + 1, whose mean is its Greville abscissa; its correction needs the control points
// around m - 1 and m + 1. So span i, with the control points around the knots i - 1 to i + 2,
// depends on the knots i - 3 to i + 4. docs/developer/motion.md#runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "motion/path/polyline.h"

namespace stanok::motion {

class RunSpline {
 public:
  static constexpr std::size_t order = 4;
  static constexpr std::size_t support = 4;  // a span depends on so many knots behind it

  using ControlPoints = std::array<Point, order>;

  Polyline way;
  std::vector<double> knots;

  [[nodiscard]] double width(std::size_t span) const { return knots[span + 1] - knots[span]; }
  // All that the span depends on lies on one block: it is that block.
  [[nodiscard]] bool is_straight(std::size_t span) const;
  [[nodiscard]] ControlPoints control_points(std::size_t span) const;
  // Bezier points of the spline between a and b within a span.
  [[nodiscard]] ControlPoints bezier(std::size_t span, const ControlPoints& control, double a,
                                     double b) const;

  // The parts of a span that belong to one block each: visit(leg, a, b).
  template <class Visit>
  void for_each_stretch(std::size_t span, Visit visit) const {
    double a = knots[span];
    for (std::size_t index = way.index_at(a); a < knots[span + 1]; ++index) {
      const Leg& leg = way.leg(index);
      const double b = std::min(leg.t_end, knots[span + 1]);
      visit(leg, a, b);
      a = b;
    }
  }

 private:
  // The path is averaged over so much on either side of that.
  [[nodiscard]] double half_window(std::size_t middle) const;
  // The abscissa of the control point around knot `middle`.
  [[nodiscard]] double greville(std::size_t middle) const;
};

}  // namespace stanok::motion
