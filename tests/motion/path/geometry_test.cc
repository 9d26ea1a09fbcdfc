// Evaluation along the path: unit speed, derivatives, exact ends, derivatives by time.
#include "motion/path/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/path/arc_length.h"
#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

using std::numbers::pi;

constexpr PathMetric five_axes{5, 0b111};

Point random_point(Random& random, double size) {
  Point point{};
  for (std::size_t k = 0; k < 5; ++k) point[k] = random.between(-size, size);
  return point;
}

Segment random_line(Random& random) {
  return segment_of(line(five_axes, random_point(random, 200.0), random_point(random, 200.0)));
}

// Helix whose end is rounded to `rounding`, so that its radius changes a little.
Segment random_arc(Random& random, double rounding) {
  const Point start = random_point(random, 100.0);
  const std::array<double, 2> centre{random.between(-100.0, 100.0), random.between(-100.0, 100.0)};
  PathBlock block =
      arc_to(start, centre, random.between(-4.0 * pi, 4.0 * pi), random_point(random, 100.0));
  if (rounding > 0.0) {
    block.end[0] = std::round(block.end[0] / rounding) * rounding;
    block.end[1] = std::round(block.end[1] / rounding) * rounding;
  }
  return segment_of(arc(five_axes, start, block));
}

// A blend between two random directions and curvatures, as they come at corners up to 160 deg.
Segment random_quintic(Random& random) {
  const double reach = std::pow(10.0, random.between(-3.0, 1.5));
  const double turn = random.between(0.0, 160.0) * pi / 180.0;
  const double heading = random.between(0.0, 2.0 * pi);
  const Point corner = random_point(random, 100.0);
  Contact from;
  Contact to;
  const double bend = random.between(-0.1, 0.1) / reach;
  from.tangent = {std::cos(heading), std::sin(heading), 0.0, random.between(-9.0, 9.0), 0.5};
  to.tangent = {std::cos(heading + turn), std::sin(heading + turn), 0.0, random.between(-9.0, 9.0),
                0.1};
  from.curvature = {-bend * from.tangent[1], bend * from.tangent[0], 0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 5; ++k) {
    from.position[k] = corner[k] - reach * from.tangent[k];
    to.position[k] = corner[k] + reach * to.tangent[k];
  }
  return segment_of(blend_curve(five_axes, from, to, reach));
}

Segment random_segment(Random& random, int kind) {
  switch (kind) {
    case 0:
      return random_line(random);
    case 1:
      return random_arc(random, 0.0);
    case 2:
      return random_arc(random, 0.001);
    default:
      return random_quintic(random);
  }
}

class EveryKind : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(LineArcRoundedArcQuintic, EveryKind, ::testing::Range(0, 4));

TEST_P(EveryKind, TravelsAtUnitSpeedToRounding) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Segment segment = random_segment(random, GetParam());
    for (int n = 0; n <= 40; ++n) {
      JetPoint p;
      evaluate(segment, segment.length * n / 40.0, p);
      EXPECT_NEAR(xyz_norm(p[0].first, p[1].first, p[2].first), 1.0, 4e-15);
      // |q'| = 1 throughout makes q'' normal to q' and q' q''' = -|q''|^2.
      const double turn = xyz_norm(p[0].second, p[1].second, p[2].second);
      double along = 0.0;
      double third = turn * turn;
      for (std::size_t k = 0; k < 3; ++k) {
        along += p[k].first * p[k].second;
        third += p[k].first * p[k].third;
      }
      EXPECT_NEAR(along, 0.0, 1e-13 * (1.0 / segment.length + turn));
      EXPECT_NEAR(third, 0.0, 1e-11 * (1.0 / (segment.length * segment.length) + turn * turn));
    }
  }
}

TEST_P(EveryKind, ReturnsStoredEndsToTheBit) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Segment segment = random_segment(random, GetParam());
    JetPoint p;
    evaluate(segment, 0.0, p);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(p[k].value, segment.geometry.start[k]);
    evaluate(segment, segment.length, p);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(p[k].value, segment.geometry.end[k]);
    // The curve itself arrives there: no jump to the stored value.
    JetPoint shortly_before;
    evaluate(segment, std::nextafter(segment.length, 0.0), shortly_before);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(shortly_before[k].value, segment.geometry.end[k], 2e-12);
    }
  }
}

// Central differences of one order less: error h^2/6 times the derivative two orders above, plus
// rounding; h is a thousandth of the segment's own scale.
TEST_P(EveryKind, DerivativesAgreeWithDifferences) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Segment segment = random_segment(random, GetParam());
    const double s = segment.length * random.between(0.1, 0.9);
    JetPoint p;
    evaluate(segment, s, p);
    const double scale =
        1.0 / (1.0 / segment.length + xyz_norm(p[0].second, p[1].second, p[2].second));
    const double h = 1e-4 * scale;
    JetPoint before;
    JetPoint after;
    evaluate(segment, s - h, before);
    evaluate(segment, s + h, after);
    for (std::size_t k = 0; k < 5; ++k) {
      const double size = 20.0 + std::abs(p[k].first);
      EXPECT_NEAR((after[k].value - before[k].value) / (2.0 * h), p[k].first,
                  1e-6 * size + 1e-12 / h);
      EXPECT_NEAR((after[k].first - before[k].first) / (2.0 * h), p[k].second, 1e-5 * size / scale);
      EXPECT_NEAR((after[k].second - before[k].second) / (2.0 * h), p[k].third,
                  1e-4 * size / (scale * scale));
    }
  }
}

// Arc length from 0 to u in long double, by Simpson's rule with many steps.
long double reference_length(const Geometry& g, double u) {
  constexpr int steps = 4000;
  const auto speed = [&g](long double x) {
    long double squared = 0.0L;
    for (std::size_t k = 0; k < 3; ++k) {
      long double slope = 0.0L;
      for (std::size_t n = 5; n >= 1; --n) {
        slope = slope * x + static_cast<long double>(n) * g.coefficients[k][n];
      }
      squared += slope * slope;
    }
    return std::sqrt(squared);
  };
  const long double h = static_cast<long double>(u) / steps;
  long double sum = speed(0.0L) + speed(u);
  for (int n = 1; n < steps; ++n) sum += speed(h * n) * (n % 2 == 1 ? 4.0L : 2.0L);
  return sum * h / 3.0L;
}

TEST(Quintic, ParameterBelongsToTheArcLength) {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const Segment segment = random_quintic(random);
    EXPECT_NEAR(static_cast<double>(reference_length(segment.geometry, 1.0)), segment.length,
                1e-11 * segment.length);
    for (int n = 1; n < 8; ++n) {
      const double s = segment.length * random.between(0.0, 1.0);
      const double u = parameter_at(segment.geometry, s, segment.length);
      EXPECT_NEAR(static_cast<double>(reference_length(segment.geometry, u)), s,
                  1e-11 * segment.length);
    }
  }
}

TEST(Quintic, LeavesAndEntersWithGivenTangentAndCurvature) {
  const double reach = 2.0;
  Contact from;
  Contact to;
  from.tangent = {1.0, 0.0, 0.0, 3.0};
  from.curvature = {0.0, 0.2, 0.0, -0.1};
  to.position = {3.0, 2.0, 0.0, 7.0};
  to.tangent = {0.0, 1.0, 0.0, 5.0};
  to.curvature = {0.1, 0.0, 0.0, 0.3};
  const Segment segment = segment_of(blend_curve(five_axes, from, to, reach));
  JetPoint start;
  JetPoint end;
  evaluate(segment, 0.0, start);
  evaluate(segment, segment.length, end);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(start[k].first, from.tangent[k], 1e-14);
    EXPECT_NEAR(start[k].second, from.curvature[k], 1e-13);
    EXPECT_NEAR(end[k].first, to.tangent[k], 1e-13);
    EXPECT_NEAR(end[k].second, to.curvature[k], 1e-12);
  }
}

TEST(Arc, IsTheCircleOfTheFormula) {
  const Point start{10.0, 0.0, 0.0};
  const Segment segment =
      segment_of(arc(five_axes, start, arc_to(start, {0.0, 0.0}, 2.0 * pi, {})));
  EXPECT_NEAR(segment.length, 20.0 * pi, 1e-13);
  for (int n = 0; n < 100; ++n) {
    const double s = segment.length * n / 100.0;
    JetPoint p;
    evaluate(segment, s, p);
    EXPECT_NEAR(p[0].value, 10.0 * std::cos(s / 10.0), 1e-13);
    EXPECT_NEAR(p[1].value, 10.0 * std::sin(s / 10.0), 1e-13);
    EXPECT_NEAR(p[0].third, 0.01 * std::sin(s / 10.0), 1e-16);
  }
}

TEST(Arc, KeepsWholeTurnsOfTheSweep) {
  const Point start{5.0, 0.0, 0.0};
  Point end{0.0, 0.0, 12.0};
  const Segment segment =
      segment_of(arc(five_axes, start, arc_to(start, {0.0, 0.0}, -6.5 * pi, end)));
  EXPECT_NEAR(segment.length, std::hypot(5.0 * 6.5 * pi, 12.0), 1e-12);
  JetPoint p;
  evaluate(segment, segment.length / 2.0, p);
  EXPECT_NEAR(p[2].value, 6.0, 1e-13);
  EXPECT_NEAR(p[0].value, 5.0 * std::cos(-3.25 * pi), 1e-12);
}

TEST(Time, CircleAtConstantSpeedHasCentripetalAcceleration) {
  const Point start{10.0, 0.0, 0.0};
  const Segment segment = segment_of(arc(five_axes, start, arc_to(start, {0.0, 0.0}, pi, {})));
  JetPoint s;
  JetPoint t;
  evaluate(segment, 0.0, s);
  along_time(s, 30.0, 0.0, 0.0, 5, t);
  EXPECT_NEAR(t[1].first, 30.0, 1e-13);
  EXPECT_NEAR(t[0].second, -30.0 * 30.0 / 10.0, 1e-11);
  EXPECT_NEAR(t[1].third, -30.0 * 30.0 * 30.0 / 100.0, 1e-10);
}

TEST(Time, FollowsTheChainRule) {
  // q(s) = s^3 at s = 2 with s(t): v 3, a 5, j 7. q''' = 6 v^3 + 3 * 6 s v a + 3 s^2 j.
  JetPoint s{};
  s[0] = {8.0, 12.0, 12.0, 6.0};
  JetPoint t;
  along_time(s, 3.0, 5.0, 7.0, 1, t);
  EXPECT_DOUBLE_EQ(t[0].first, 36.0);
  EXPECT_DOUBLE_EQ(t[0].second, 12.0 * 9.0 + 12.0 * 5.0);
  EXPECT_DOUBLE_EQ(t[0].third, 6.0 * 27.0 + 3.0 * 12.0 * 15.0 + 12.0 * 7.0);
}

TEST(SegmentLimits, LeaveRoomForTangentialAccelerationAndJerk) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const auto magnitude = [&](double low, double high) {
      return random.chance(0.1) ? 0.0 : std::pow(10.0, random.between(low, high));
    };
    const SegmentBounds b{magnitude(-4, 0), magnitude(-5, -1), magnitude(-7, -2),
                          magnitude(-6, 2), magnitude(-8, 2),  magnitude(-7, 4)};
    const double feed = random.chance(0.3) ? unlimited : std::pow(10.0, random.between(-2, 3));
    const SegmentLimits limits = segment_limits(b, feed);
    ASSERT_GT(limits.v, 0.0);
    ASSERT_GT(limits.a, 0.0);
    ASSERT_GT(limits.j, 0.0);
    ASSERT_TRUE(std::isfinite(limits.v) && std::isfinite(limits.a) && std::isfinite(limits.j));
    ASSERT_LE(limits.v, feed);
    for (const double v : {limits.v, 0.5 * limits.v, 0.0}) {
      EXPECT_LE(v * b.velocity, 1.0 + 1e-15);
      EXPECT_LE(v * v * b.curvature + limits.a * b.tangent, 1.0 + 1e-12);
      EXPECT_LE(v * v * v * b.aberrancy + 3.0 * v * limits.a * b.bend + limits.j * b.thrust,
                1.0 + 1e-12);
    }
  }
}

TEST(SegmentLimits, LeaveNearlyEverythingWhenTheFeedBinds) {
  const SegmentBounds b{.velocity = 1.0 / 400.0,
                        .tangent = 1.0 / 4000.0,
                        .thrust = 1e-5,
                        .curvature = 0.1 / 4000.0,
                        .bend = 1e-6,
                        .aberrancy = 1e-7};
  const SegmentLimits limits = segment_limits(b, 2.0);
  EXPECT_EQ(limits.v, 2.0);
  EXPECT_GT(limits.a, 0.99 * 4000.0);
  EXPECT_GT(limits.j, 0.97 * 1e5);
}

}  // namespace
}  // namespace stanok::motion
