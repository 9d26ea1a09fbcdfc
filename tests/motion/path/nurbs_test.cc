// NURBS: circles, Bezier curves by Bernstein's formula, continuity at knots.
#include "motion/path/nurbs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

std::array<double, 2> at(const CurveStretch& stretch, double u) {
  std::array<double, 2> point{};
  for (std::size_t c = 0; c < 2; ++c) {
    double power = 1.0;
    for (const double coefficient : stretch.coefficients[c]) {
      point[c] += coefficient * power;
      power *= u;
    }
  }
  return point;
}

// The point of all stretches together at the curve's parameter.
std::array<double, 2> at(const std::vector<CurveStretch>& stretches, double u) {
  double start = 0.0;
  for (const CurveStretch& stretch : stretches) {
    if (u <= stretch.end) return at(stretch, (u - start) / (stretch.end - start));
    start = stretch.end;
  }
  return {};
}

// The first and second derivative of coordinate c at the curve's parameter.
double derivative(const CurveStretch& stretch, double width, std::size_t c, double u, int n) {
  const auto& k = stretch.coefficients[c];
  const double first = k[1] + u * (2 * k[2] + u * (3 * k[3] + u * (4 * k[4] + u * 5 * k[5])));
  const double second = 2 * k[2] + u * (6 * k[3] + u * (12 * k[4] + u * 20 * k[5]));
  return n == 1 ? first / width : second / (width * width);
}

TEST(Nurbs, QuarterCircleOfDegreeTwoIsRoundWithinTheDeviation) {
  const double w = std::numbers::sqrt2 / 2.0;
  const PlanarNurbs circle{2, {{25.0, 0.0}, {25.0, 25.0}, {0.0, 25.0}}, {1.0, w, 1.0}};
  const auto stretches = stretches_of(circle, 1e-8);
  ASSERT_FALSE(stretches.empty());
  for (const auto& stretch : stretches) {
    for (int i = 0; i <= 20; ++i) {
      const auto point = at(stretch, i / 20.0);
      EXPECT_NEAR(std::hypot(point[0], point[1]), 25.0, 2e-8);
    }
  }
  EXPECT_EQ(stretches.back().end, 1.0);
}

TEST(Nurbs, CubicBezierFollowsBernstein) {
  Random random(3);
  for (int n = 0; n < 50; ++n) {
    PlanarNurbs curve;
    for (int k = 0; k < 4; ++k) {
      curve.points.push_back({random.between(-30.0, 30.0), random.between(-30.0, 30.0)});
    }
    const auto stretches = stretches_of(curve, 1e-7);
    ASSERT_FALSE(stretches.empty());
    for (int i = 0; i <= 10; ++i) {
      const double u = i / 10.0;
      const double v = 1.0 - u;
      const auto point = at(stretches, u);
      for (std::size_t c = 0; c < 2; ++c) {
        const double expected = v * v * v * curve.points[0][c] +
                                3 * u * v * v * curve.points[1][c] +
                                3 * u * u * v * curve.points[2][c] + u * u * u * curve.points[3][c];
        EXPECT_NEAR(point[c], expected, 1e-12 * 30);
      }
    }
  }
}

// A B-spline of degree p has p - 1 continuous derivatives at simple knots.
TEST(Nurbs, DerivativesContinueAcrossKnots) {
  Random random(4);
  for (int n = 0; n < 30; ++n) {
    PlanarNurbs curve;
    curve.degree = n % 2 == 0 ? 3 : 5;
    for (int k = 0; k < 9; ++k) {
      curve.points.push_back({10.0 * k + random.between(-8.0, 8.0), random.between(-30.0, 30.0)});
      curve.weights.push_back(n % 3 == 0 ? 1.0 : random.between(0.5, 2.0));
    }
    const auto stretches = stretches_of(curve, 1e-7);
    double start = 0.0;
    for (std::size_t k = 0; k + 1 < stretches.size(); ++k) {
      const double width = stretches[k].end - start;
      const double next = stretches[k + 1].end - stretches[k].end;
      for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(at(stretches[k], 1.0)[c], at(stretches[k + 1], 0.0)[c], 1e-10);
        for (const int order : {1, 2}) {
          const double before = derivative(stretches[k], width, c, 1.0, order);
          const double after = derivative(stretches[k + 1], next, c, 0.0, order);
          EXPECT_NEAR(before, after, 1e-9 * std::pow(1.0 / width, order) * 100.0);
        }
      }
      start = stretches[k].end;
    }
  }
}

TEST(Nurbs, EndsAreTheEndControlPoints) {
  const PlanarNurbs curve{3, {{0, 0}, {1, 5}, {4, 4}, {6, -2}, {9, 1}}, {}};
  const auto stretches = stretches_of(curve, 1e-7);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_NEAR(at(stretches.front(), 0.0)[1], 0.0, 1e-15);
  EXPECT_NEAR(at(stretches.back(), 1.0)[0], 9.0, 1e-14);
  EXPECT_NEAR(at(stretches.back(), 1.0)[1], 1.0, 1e-14);
}

// Control points (0, 0), (4, 0), (3, 4 + e), (3, e): both components of the derivative vanish at
// u = 2/3, there the curve turns back. Stretches grow shorter towards the cusp, so that what limits
// the path there holds for next to nothing of it.
TEST(Nurbs, ACuspIsAloneInItsStretch) {
  for (const double size : {1e-3, 1.0, 30.0}) {
    PlanarNurbs curve{3, {{0, 0}, {4, 0}, {3, 4.001}, {3, 0.001}}, {}};
    for (auto& point : curve.points) point = {size * point[0], size * point[1]};
    const auto stretches = stretches_of(curve, 1e-7);
    double start = 0.0;
    for (const CurveStretch& stretch : stretches) {
      if (start <= 2.0 / 3.0 && 2.0 / 3.0 <= stretch.end) {
        EXPECT_LT(stretch.end - start, 0.002);
      }
      start = stretch.end;
    }
    EXPECT_GT(stretches.size(), 8U);
  }
}

// Both components of the derivative vanish at u = 1/2 of (0, 0), (10, 10), (0, 10), (10, 0), and at
// the ends of the others: the stretches meet at a corner there, and are one curve all the same.
TEST(Nurbs, WhereItHasNoDirectionIsACorner) {
  const PlanarNurbs curves[] = {{3, {{0, 0}, {10, 10}, {0, 10}, {10, 0}}, {}},
                                {3, {{0, 0}, {0, 0}, {5, 5}, {9, 0}}, {}},
                                {3, {{0, 0}, {5, 5}, {9, 0}, {9, 0}}, {}},
                                {3, {{0, 0}, {0, 0}, {9, 1}, {9, 1}}, {}},
                                {3, {{0, 0}, {0, 0}, {0, 0}, {9, 1}}, {}},
                                {5, {{0, 0}, {0, 0}, {0, 0}, {4, 4}, {4, 4}, {9, 1}, {9, 1}}, {}}};
  for (const PlanarNurbs& curve : curves) {
    const auto stretches = stretches_of(curve, 1e-7);
    ASSERT_FALSE(stretches.empty());
    EXPECT_LT(stretches.size(), 100U);
    std::array<double, 2> end = curve.points.front();
    for (const CurveStretch& stretch : stretches) {
      EXPECT_NEAR(std::hypot(at(stretch, 0.0)[0] - end[0], at(stretch, 0.0)[1] - end[1]), 0.0,
                  1e-12);
      end = at(stretch, 1.0);
      const double begun = std::hypot(stretch.coefficients[0][1], stretch.coefficients[1][1]);
      EXPECT_GT(begun, 0.0);
    }
    EXPECT_NEAR(std::hypot(end[0] - curve.points.back()[0], end[1] - curve.points.back()[1]), 0.0,
                1e-12);
    EXPECT_EQ(stretches.back().end, 1.0);
  }
}

TEST(Nurbs, APointIsNoCurve) {
  EXPECT_TRUE(stretches_of({3, {{1, 2}, {1, 2}, {1, 2}, {1, 2}}, {}}, 1e-7).empty());
}

}  // namespace
}  // namespace stanok::motion
