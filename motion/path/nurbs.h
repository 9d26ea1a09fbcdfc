// NURBS curves in a plane, as stretches of degree 5 that the path can hold.
//
// A stretch has position and first two derivatives of the curve at both ends. Curves of degree up
// to 5 with equal weights are reproduced; others deviate by less than asked for, since stretches
// are halved until they do: the deviation falls with the sixth power of their length. Where the
// curve has no direction, or turns back within some nm, stretches meet at a corner.
#pragma once

#include <array>
#include <vector>

namespace stanok::motion {

// Knots are uniform and clamped at both ends (L. Piegl, W. Tiller, The NURBS Book, 2.2 and 4.2).
struct PlanarNurbs {
  int degree = 3;
  std::vector<std::array<double, 2>> points;  // control points, the start first; more than `degree`
  std::vector<double> weights;                // of the points; empty: all 1
};

struct CurveStretch {
  double end = 1.0;  // of the curve's parameter, 0 to 1; it starts where the one before ends
  // Coefficients of u^0..u^5 of both coordinates over its own parameter u, 0 to 1.
  std::array<std::array<double, 6>, 2> coefficients{};
};

// Empty when all control points are the same.
[[nodiscard]] std::vector<CurveStretch> stretches_of(const PlanarNurbs& curve, double deviation);

}  // namespace stanok::motion
