// Stretches of a line that a quadratic leaves: A x² + 2 B x + C <= 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stanok::simulation {

// Below it a direction counts as square to another one, and a quadratic as linear.
inline constexpr double parallel = 1e-9;
inline constexpr double infinite = 1e30;

// Empty where low >= high.
struct Stretch {
  double low = -infinite;
  double high = infinite;
};

// Leaves of the stretch what has A x² + 2 B x + C <= 0; false when that is nothing. `inverse_A` is
// 1 / A, or 0 where A is none. Where A < 0 the stretch lies on one side of what is cut out (inside
// of both nappes of a cone the heights have left one of them).
[[nodiscard]] inline bool narrow(Stretch& stretch, double A, double inverse_A, double B, double C) {
  if (inverse_A == 0.0) {
    if (std::abs(B) < parallel) return C <= 0.0;
    const double root = -C / (2.0 * B);
    if (B > 0.0) {
      stretch.high = std::min(stretch.high, root);
    } else {
      stretch.low = std::max(stretch.low, root);
    }
    return stretch.low < stretch.high;
  }
  const double discriminant = B * B - A * C;
  if (discriminant <= 0.0) return A < 0.0 && stretch.low < stretch.high;
  const double root = std::sqrt(discriminant);
  const double one = (-B - root) * inverse_A;
  const double other = (-B + root) * inverse_A;
  if (A > 0.0) {
    stretch.low = std::max(stretch.low, one);
    stretch.high = std::min(stretch.high, other);
  } else if (stretch.low < other) {
    stretch.high = std::min(stretch.high, other);
  } else {
    stretch.low = std::max(stretch.low, one);
  }
  return stretch.low < stretch.high;
}

[[nodiscard]] inline bool narrow(Stretch& stretch, double A, double B, double C) {
  return narrow(stretch, A, std::abs(A) > parallel ? 1.0 / A : 0.0, B, C);
}

// Both roots of A x² + 2 B x + C, or numbers that are none.
[[nodiscard]] inline std::array<double, 2> roots_of(double A, double B, double C) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (std::abs(A) < parallel) return {std::abs(B) < parallel ? none : -C / (2.0 * B), none};
  const double discriminant = B * B - A * C;
  if (discriminant < 0.0) return {none, none};
  const double root = std::sqrt(discriminant);
  return {(-B - root) / A, (-B + root) / A};
}

}  // namespace stanok::simulation
