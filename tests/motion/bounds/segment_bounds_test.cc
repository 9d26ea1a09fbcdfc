// Bounds of segments: every machine axis keeps its limits for any motion the bounds allow.
#include "motion/bounds/segment_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

using std::numbers::pi;

struct AxisUse {
  double v = 0.0;
  double a = 0.0;
  double j = 0.0;
};

// Largest share of the limits that the machine axes use at dense samples of the segment.
AxisUse use_of(const Segment& segment, const MotionConfig& config, double v, double a, double j) {
  AxisUse use;
  constexpr int samples = 500;
  for (int i = 0; i <= samples; ++i) {
    JetPoint s;
    JetPoint t{};
    JetPoint axes;
    evaluate(segment, segment.length * i / samples, s);
    along_time(s, v, a, j, config.axis_count, t);
    kinematics::inverse(*segment.transform, t, axes);
    for (std::size_t k = 0; k < static_cast<std::size_t>(config.axis_count); ++k) {
      use.v = std::max(use.v, std::abs(axes[k].first) / config.axes[k].velocity_max);
      use.a = std::max(use.a, std::abs(axes[k].second) / config.axes[k].acceleration_max);
      use.j = std::max(use.j, std::abs(axes[k].third) / config.axes[k].jerk_max);
    }
  }
  return use;
}

void expect_limits_kept(const Segment& segment, const MotionConfig& config, Random& random) {
  const double feed = std::pow(10.0, random.between(-1.0, 3.0));
  const SegmentLimits limits = segment_limits(segment.bounds, feed);
  for (const double share : {1.0, random.between(0.0, 1.0)}) {
    for (const double sign_a : {-1.0, 1.0}) {
      for (const double sign_j : {-1.0, 1.0}) {
        const AxisUse use =
            use_of(segment, config, share * limits.v, sign_a * limits.a, sign_j * limits.j);
        EXPECT_LE(use.v, 1.0 + 1e-9);
        EXPECT_LE(use.a, 1.0 + 1e-9);
        EXPECT_LE(use.j, 1.0 + 1e-9);
      }
    }
  }
}

std::vector<PathBuilder::Built> random_segments(Random& random, const MotionConfig& config,
                                                const kinematics::Transform& transform) {
  PathBuilder builder(config);
  Point at{40.0, 10.0, 5.0, 20.0, 10.0};
  builder.restart(at);
  double heading = 0.0;
  for (int n = 0; n < 12; ++n) {
    const double size = std::pow(10.0, random.between(-1.0, 1.3));
    heading += random.between(-1.5, 1.5);
    Point end = at;
    end[2] += size * random.between(-0.3, 0.3);
    end[3] += size * random.between(-0.5, 0.5);
    end[4] += size * random.between(-1.0, 1.0);
    PathBlock block;
    if (random.chance(0.4)) {
      const std::array<double, 2> centre{at[0] - size * std::sin(heading),
                                         at[1] + size * std::cos(heading)};
      block = arc_to(at, centre, random.between(0.2, 3.0), end);
      block.end[0] = std::round(block.end[0] * 1000.0) / 1000.0;
      block.end[1] = std::round(block.end[1] * 1000.0) / 1000.0;
      heading += block.sweep_rad;
    } else {
      end[0] += size * std::cos(heading);
      end[1] += size * std::sin(heading);
      block = line_to(end);
    }
    block.transform = &transform;
    EXPECT_FALSE(builder.add(block));
    at = block.end;
  }
  builder.finish();
  return builder.built();
}

Segment circle_segment(double sweep, const kinematics::Transform& transform) {
  const PathMetric metric{3, 0b111};
  const Point start{20.0, 0.0, 0.0};
  Segment segment = segment_of(arc(metric, start, arc_to(start, {0.0, 0.0}, sweep, {})));
  segment.transform = &transform;
  return segment;
}

class BothModes : public ::testing::TestWithParam<kinematics::PointMode> {};
INSTANTIATE_TEST_SUITE_P(AxesAndTip, BothModes,
                         ::testing::Values(kinematics::PointMode::axes,
                                           kinematics::PointMode::tip));

TEST_P(BothModes, EveryAxisKeepsItsLimitsWithinSegmentLimits) {
  const auto scheme = head_table();
  const MotionConfig config = mill(5);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    kinematics::Transform transform;
    transform.scheme = scheme.get();
    transform.mode = GetParam();
    transform.tool.nose_to_tip_mm = {0.0, 0.0, -80.0};
    transform.frame.rotation = Rotation::about({1, 2, 3}, 17);
    for (const auto& built : random_segments(random, config, transform)) {
      expect_limits_kept(built.segment, config, random);
    }
  }
}

// X, Y and Z with one limit each: what acts along the path and across it adds in squares.
TEST(SegmentBounds, EveryAxisKeepsItsLimitsWhereSquaresAreAdded) {
  const MotionConfig config = mill(3);
  kinematics::Transform turned;
  turned.frame.rotation = Rotation::about({1, 2, 3}, 17);
  int squares = 0;
  for (std::uint64_t seed = 20; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const auto& built : random_segments(random, config, turned)) {
      expect_limits_kept(built.segment, config, random);
      squares += built.segment.bounds.euclidean.holds ? 1 : 0;
    }
  }
  EXPECT_GT(squares, 100);
}

TEST(SegmentBounds, SquaresLeaveACircleMoreThanSumsDo) {
  // R 20 at 180 mm/s: v^3 / R^2 takes 0.1458 of the jerk; of the rest 0.7 goes to 3 v a / R.
  const kinematics::Transform identity;
  const SegmentLimits limits =
      segment_limits(segment_bounds(circle_segment(2.0 * pi, identity), mill(3)), 180.0);
  const double rest = 1.0 - std::pow(180.0, 3) / 400.0 / 1e5;
  EXPECT_NEAR(limits.a, 0.7 * rest * 1e5 * 20.0 / (3.0 * 180.0), 1e-6);
  EXPECT_NEAR(limits.j, std::sqrt(1.0 - 0.49) * rest * 1e5, 1e-4);
}

// Bounds are not only safe but close: some sample reaches 90 % of each allowance that binds.
TEST_P(BothModes, BoundsAreNearlyReached) {
  const auto scheme = head_table();
  const MotionConfig config = mill(5);
  Random random(77);
  kinematics::Transform transform;
  transform.scheme = scheme.get();
  transform.mode = GetParam();
  for (const auto& built : random_segments(random, config, transform)) {
    // Cut blocks carry bounds of what is left of them.
    const SegmentBounds& b = built.segment.bounds;
    const AxisUse at_v = use_of(built.segment, config, 1.0 / b.velocity, 0.0, 0.0);
    EXPECT_GT(at_v.v, 0.9);
    if (b.curvature > 1e-9) {
      EXPECT_GT(use_of(built.segment, config, 1.0 / std::sqrt(b.curvature), 0.0, 0.0).a, 0.9);
    }
    if (b.aberrancy > 1e-9) {
      EXPECT_GT(use_of(built.segment, config, 1.0 / std::cbrt(b.aberrancy), 0.0, 0.0).j, 0.9);
    }
  }
}

TEST(SegmentBounds, CircleHasTheClosedForm) {
  const kinematics::Transform identity;
  const SegmentBounds b = segment_bounds(circle_segment(2.0 * pi, identity), mill(3));
  EXPECT_NEAR(b.velocity, 1.0 / 400.0, 1e-15);
  EXPECT_NEAR(b.curvature, 1.0 / 20.0 / 4000.0, 1e-16);
  EXPECT_NEAR(b.bend, 1.0 / 20.0 / 1e5, 1e-17);
  EXPECT_NEAR(b.aberrancy, 1.0 / 400.0 / 1e5, 1e-18);
}

TEST(SegmentBounds, ShortArcCountsOnlyTheDirectionsItTakes) {
  // From angle 0 to 30 deg of a circle: |x'| <= sin 30, |y'| <= 1; |x''| <= 1/R, |y''| <= 1/(2R).
  MotionConfig config = mill(3);
  config.axes[0].velocity_max = 100.0;
  config.axes[1].velocity_max = 1000.0;
  config.axes[0].acceleration_max = 10000.0;
  config.axes[1].acceleration_max = 1000.0;
  const kinematics::Transform identity;
  const SegmentBounds b = segment_bounds(circle_segment(pi / 6.0, identity), config);
  EXPECT_NEAR(b.velocity, 0.5 / 100.0, 1e-15);
  EXPECT_NEAR(b.tangent, 1.0 / 1000.0, 1e-15);
  EXPECT_NEAR(b.curvature, 0.5 / 20.0 / 1000.0, 1e-16);
}

TEST(SegmentBounds, LineAtAnAngleAllowsTheFasterDiagonal) {
  Segment segment = segment_of(line({3, 0b111}, {}, {3.0, 4.0, 0.0}));
  const SegmentBounds b = segment_bounds(segment, mill(3));
  EXPECT_DOUBLE_EQ(b.velocity, 0.8 / 400.0);
  EXPECT_EQ(b.curvature, 0.0);
  EXPECT_EQ(b.aberrancy, 0.0);
}

}  // namespace
}  // namespace stanok::motion
