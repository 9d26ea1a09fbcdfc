// A NURBS curve with knots of its own, as the Bezier curves of which it consists.
//
// The pieces are the curve itself, not near to it: the control points of a piece are values of the
// polar form of the curve, computed in homogeneous coordinates. Source: L. Piegl and W. Tiller,
// The NURBS Book, 2nd edition, 1997, 5.2; L. Ramshaw, Blossoms are polar forms, Computer Aided
// Geometric Design 6 (1989). Plane coordinates as in lang/elements/plane_element.h, mm.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stanok::lang {

struct KnottedCurve {
  std::size_t order = 0;                      // degree + 1
  std::vector<std::array<double, 2>> points;  // at least `order`
  std::vector<double> weights;                // > 0, one for each point
  std::vector<double> knots;                  // points + order, none less than the one before
};

// `order` points with their weights.
struct BezierPiece {
  std::vector<std::array<double, 2>> points;
  std::vector<double> weights;
};

// In the order of travel, from the knot `order` - 1 to the last but `order`; empty when these two
// are the same. A knot may stand in the curve at most `order` - 1 times between both.
[[nodiscard]] std::vector<BezierPiece> bezier_pieces(const KnottedCurve& curve);

}  // namespace stanok::lang
