// Two machines that kinematics/ does not know, derived from Scheme here: what a new type takes.
//
// BeltGantry: a CoreXY gantry, two motors drive the carriage through one crossed belt, and its
// bridge leans out of square. LinearDelta: three vertical carriages carry the platform on struts of
// equal length. Both go through the same property tests as the types of the project.
#pragma once

#include <cmath>
#include <numbers>

#include "kinematics/formula_scheme.h"
#include "kinematics/linear_axes.h"
#include "tests/kinematics/reference.h"

namespace stanok::kinematics {

// A scheme whose map of X, Y, Z is `Type::motors(nose)` and `Type::nose(motors)`; other axes pass.
template <class Type>
class MotorScheme : public FormulaScheme<MotorScheme<Type>> {
 public:
  template <class Scalar>
  void to_axes(PointMode, const ToolVector& tool, const AxisVector<Scalar>& point_B,
               AxisVector<Scalar>& axes_M) const RT_SAFE {
    const LinearAxes xyz({0, 1, 2});
    axes_M = point_B;
    xyz.set<Scalar>(Type::motors(Vector3<Scalar>(xyz.of(axes_M) - tool.nose_to_tip_mm)), axes_M);
  }
  void forward(PointMode, const ToolVector& tool, const AxisVector<double>& axes_M,
               AxisVector<double>& point_B) const RT_SAFE override {
    const LinearAxes xyz({0, 1, 2});
    point_B = axes_M;
    xyz.set<double>(Type::nose(xyz.of(axes_M)) + tool.nose_to_tip_mm, point_B);
  }
  [[nodiscard]] bool is_affine(PointMode) const RT_SAFE override { return false; }

 private:
  friend Type;
  explicit MotorScheme(const SchemeConfig& config) : FormulaScheme<MotorScheme>(config) {}
};

// The bridge, along which the carriage is at v, leans by the skew towards +X: x = u + v sin(skew),
// y = v cos(skew). The motors of the crossed belt turn by u + v and u - v.
class BeltGantry final : public MotorScheme<BeltGantry> {
 public:
  static constexpr double skew = 0.01;  // rad

  explicit BeltGantry(const SchemeConfig& config) : MotorScheme(config) {}

  template <class Scalar>
  static Vector3<Scalar> motors(const Vector3<Scalar>& nose) RT_SAFE {
    const Scalar v = (1.0 / std::cos(skew)) * nose[1];
    const Scalar u = nose[0] - std::sin(skew) * v;
    return {u + v, u - v, nose[2]};
  }
  static Vector3<double> nose(const Vector3<double>& motors) RT_SAFE {
    const double u = (motors[0] + motors[1]) / 2.0;
    const double v = (motors[0] - motors[1]) / 2.0;
    return {u + v * std::sin(skew), v * std::cos(skew), motors[2]};
  }
};

// Carriage k runs at the height q_k on a column at the angle 120 deg k, column_radius from the
// centre; its strut reaches down to the nose: |nose - (column_k, q_k)| = strut.
class LinearDelta final : public MotorScheme<LinearDelta> {
 public:
  static constexpr double strut = 1000.0;         // mm
  static constexpr double column_radius = 400.0;  // mm

  explicit LinearDelta(const SchemeConfig& config) : MotorScheme(config) {}

  static std::array<double, 2> column(int k) RT_SAFE {
    const double angle = 2.0 * std::numbers::pi / 3.0 * static_cast<double>(k);
    return {column_radius * std::cos(angle), column_radius * std::sin(angle)};
  }

  template <class Scalar>
  static Vector3<Scalar> motors(const Vector3<Scalar>& nose) RT_SAFE {
    Vector3<Scalar> heights;
    for (int k = 0; k < 3; ++k) {
      const auto [column_x, column_y] = column(k);
      const Scalar x = nose[0] - column_x;
      const Scalar y = nose[1] - column_y;
      heights[k] = nose[2] + root(strut * strut - (x * x + y * y));
    }
    return heights;
  }

  // The differences of the spheres about the carriages are two planes; they give x and y as linear
  // functions of z, and the first sphere then z, of which the lower value is below the carriages.
  static Vector3<double> nose(const Vector3<double>& q) RT_SAFE {
    const auto [x1, y1] = column(0);
    const auto [x2, y2] = column(1);
    const auto [x3, y3] = column(2);
    // All columns are equally far from the centre, so their squares drop out of the differences.
    const double c2 = (q[0] * q[0] - q[1] * q[1]) / 2.0;
    const double c3 = (q[0] * q[0] - q[2] * q[2]) / 2.0;
    const double determinant = (x1 - x2) * (y1 - y3) - (x1 - x3) * (y1 - y2);
    const auto solved = [&](double a, double b) RT_SAFE {
      return std::array{(a * (y1 - y3) - b * (y1 - y2)) / determinant,
                        ((x1 - x2) * b - (x1 - x3) * a) / determinant};
    };
    const auto at_0 = solved(c2, c3);
    const auto per_z = solved(q[1] - q[0], q[2] - q[0]);
    const double dx = at_0[0] - x1;
    const double dy = at_0[1] - y1;
    const double a = per_z[0] * per_z[0] + per_z[1] * per_z[1] + 1.0;
    const double half_b = dx * per_z[0] + dy * per_z[1] - q[0];
    const double c = dx * dx + dy * dy + q[0] * q[0] - strut * strut;
    const double z = (-half_b - std::sqrt(half_b * half_b - a * c)) / a;
    return {at_0[0] + per_z[0] * z, at_0[1] + per_z[1] * z, z};
  }

 private:
  static double root(double x) RT_SAFE { return std::sqrt(x); }
  static Jet root(const Jet& x) RT_SAFE {
    const double r = std::sqrt(x.value);
    return compose(x, r, 0.5 / r, -0.25 / (r * x.value), 0.375 / (r * x.value * x.value));
  }
};

namespace reference {

// Skewed coordinates by Cramer's rule: u e_x + v (sin, cos) = (x, y).
inline Axes belt_gantry(const SchemeConfig&, const Axes& point, const Vector& nose_to_tip) {
  const Real x = point[0] - nose_to_tip[0];
  const Real y = point[1] - nose_to_tip[1];
  const Real s = std::sin(static_cast<Real>(BeltGantry::skew));
  const Real c = std::cos(static_cast<Real>(BeltGantry::skew));
  const Real u = (x * c - y * s) / c;
  const Real v = y / c;
  Axes axes = point;
  axes[0] = u + v;
  axes[1] = u - v;
  axes[2] = point[2] - nose_to_tip[2];
  return axes;
}

// The strut leans by the angle whose sine is its horizontal reach over its length.
inline Axes linear_delta(const SchemeConfig&, const Axes& point, const Vector& nose_to_tip) {
  Axes axes = point;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::complex<Real> column =
        std::polar<Real>(LinearDelta::column_radius, 2 * pi * static_cast<Real>(k) / 3);
    const std::complex<Real> nose(point[0] - nose_to_tip[0], point[1] - nose_to_tip[1]);
    const Real lean = std::asin(std::abs(nose - column) / LinearDelta::strut);
    axes[k] = point[2] - nose_to_tip[2] + LinearDelta::strut * std::cos(lean);
  }
  return axes;
}

}  // namespace reference

}  // namespace stanok::kinematics
