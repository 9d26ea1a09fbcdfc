#include "lang/elements/knotted_curve.h"

#include <cstddef>
#include <utility>

namespace stanok::lang {
namespace {

// x and y times the weight, and the weight.
using Homogeneous = std::array<double, 3>;

Homogeneous between(const Homogeneous& a, const Homogeneous& b, double share) {
  Homogeneous point{};
  for (std::size_t k = 0; k < 3; ++k) point[k] = (1.0 - share) * a[k] + share * b[k];
  return point;
}

// The polar form of the curve in the span behind the knot `span`: `at_end` of its arguments are the
// end of the span, the others its start.
Homogeneous polar_value(const KnottedCurve& curve, std::size_t span, std::size_t at_end) {
  const std::size_t degree = curve.order - 1;
  std::vector<Homogeneous> values;
  values.reserve(degree + 1);
  for (std::size_t k = span - degree; k <= span; ++k) {
    const double weight = curve.weights[k];
    values.push_back({weight * curve.points[k][0], weight * curve.points[k][1], weight});
  }
  for (std::size_t level = 1; level <= degree; ++level) {
    const double argument = curve.knots[level <= at_end ? span + 1 : span];
    for (std::size_t k = degree; k >= level; --k) {
      const double low = curve.knots[span - degree + k];
      const double high = curve.knots[span + k - level + 1];
      values[k] = between(values[k - 1], values[k], (argument - low) / (high - low));
    }
  }
  return values.back();
}

}  // namespace

std::vector<BezierPiece> bezier_pieces(const KnottedCurve& curve) {
  const std::size_t order = curve.order;
  std::vector<BezierPiece> pieces;
  for (std::size_t span = order - 1; span < curve.points.size(); ++span) {
    if (curve.knots[span] == curve.knots[span + 1]) continue;
    BezierPiece piece;
    for (std::size_t at_end = 0; at_end < order; ++at_end) {
      const Homogeneous value = polar_value(curve, span, at_end);
      piece.points.push_back({value[0] / value[2], value[1] / value[2]});
      piece.weights.push_back(value[2]);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace stanok::lang
