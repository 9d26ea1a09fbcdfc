// Corners that swing out: the closed forms, how far the curves are from the programmed path on
// either side, and how fast the axes come round.
#include "motion/path/swing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/motion/path_samples.h"
#include "tests/motion/random_programs.h"

namespace stanok::motion::testing {
namespace {

Segment straight(const Point& start, const Point& end) {
  Segment segment;
  PathMetric metric;
  metric.axis_count = 3;
  const Shape shape = line(metric, start, end);
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  return segment;
}

// Two legs of `length` that meet at the origin and turn by `turn`.
struct Legs {
  Point start{};
  Point end{};
  Segment incoming;
  Segment outgoing;

  Legs(double length, double turn) {
    start[0] = -length;
    end[0] = length * std::cos(turn);
    end[1] = length * std::sin(turn);
    incoming = straight(start, {});
    outgoing = straight({}, end);
  }
};

// Signed distance in the plane XY to the nearer leg: negative on the outside of the corner.
double distance_to(const Point& point, const Legs& legs) {
  const auto to_leg = [&point](const Point& from, const Point& to) {
    const double x = to[0] - from[0];
    const double y = to[1] - from[1];
    const double part =
        std::clamp(((point[0] - from[0]) * x + (point[1] - from[1]) * y) / (x * x + y * y), 0., 1.);
    const double dx = point[0] - from[0] - part * x;
    const double dy = point[1] - from[1] - part * y;
    const double side = x * dy - y * dx < 0.0 ? -1.0 : 1.0;
    return side * std::hypot(dx, dy);
  };
  const double one = to_leg(legs.start, {});
  const double other = to_leg({}, legs.end);
  return std::abs(one) < std::abs(other) ? one : other;
}

struct Range {
  double outside = 0.0;
  double inside = 0.0;
  double at_corner = unlimited;
};

Range deviations_of(const Swing& swing, const Legs& legs) {
  Range range;
  for (const Shape& part : swing.parts) {
    Segment segment;
    segment.geometry = part.geometry;
    segment.length = part.length;
    for (int i = 0; i <= 200; ++i) {
      JetPoint jet;
      evaluate(segment, segment.length * i / 200.0, jet);
      const Point point = contact(jet).position;
      const double off = distance_to(point, legs);
      range.outside = std::max(range.outside, -off);
      range.inside = std::max(range.inside, off);
      range.at_corner = std::min(range.at_corner, std::hypot(point[0], point[1]));
    }
  }
  return range;
}

TEST(SwingForm, MeetsTheLegsAndIsEven) {
  for (const double turn : {SwingForm::turn_min, 0.85, 0.93, 1.0}) {
    const SwingForm form(turn);
    const double slope = 1.0 / (2.0 * turn * turn - 1.0);
    EXPECT_DOUBLE_EQ(form.at(0.0).value, form.at_corner());
    EXPECT_DOUBLE_EQ(form.at(0.0).first, -0.5);  // with its mirror image the whole kink
    EXPECT_NEAR(form.at(1.0).value, 0.0, 1e-15);
    EXPECT_NEAR(form.at(1.0).first, 0.0, 1e-15);
    EXPECT_NEAR(form.at(1.0).second, 0.0, 1e-15);
    // Each derivative is that of the one before, by central differences; the third is +-slope.
    constexpr double h = 1e-4;
    for (double t = 0.01; t < 0.99; t += 0.02) {
      if (std::abs(t - turn) < h) continue;
      const auto before = form.at(t - h);
      const auto behind = form.at(t + h);
      EXPECT_NEAR(form.at(t).first, (behind.value - before.value) / (2 * h), 1e-7);
      EXPECT_NEAR(form.at(t).second, (behind.first - before.first) / (2 * h), 1e-7);
      EXPECT_NEAR((behind.second - before.second) / (2 * h), t < turn ? -slope : slope, 1e-7);
    }
  }
}

TEST(SwingForm, LeastTurnUsesBothSidesAlike) {
  const SwingForm form(SwingForm::turn_min);
  double lowest = 0.0;
  for (int i = 0; i <= 100000; ++i) lowest = std::min(lowest, form.at(i / 100000.0).value);
  EXPECT_NEAR(-lowest, form.at_corner(), 1e-10);
}

TEST(SwingForm, WithoutSwingIsASixthAtTheCorner) {
  // D'' falls evenly from 1 to 0: D(0) = 1/2 - integral of (1 - t)^2 = 1/6.
  EXPECT_NEAR(SwingForm(1.0).at_corner(), 1.0 / 6.0, 1e-15);
  for (const double deviation : {0.05, 0.1, 0.16})
    EXPECT_NEAR(SwingForm::with_deviation(deviation).at_corner(), deviation, 1e-9);
}

TEST(StepForm, MeetsTheSegmentsAndIsOdd) {
  EXPECT_DOUBLE_EQ(StepForm::at(0.0).value, 0.0);
  EXPECT_DOUBLE_EQ(StepForm::at(0.0).second, -0.5);  // with its mirror image the whole step
  EXPECT_NEAR(StepForm::at(1.0).value, 0.0, 1e-15);
  EXPECT_NEAR(StepForm::at(1.0).first, 0.0, 1e-15);
  EXPECT_NEAR(StepForm::at(1.0).second, 0.0, 1e-15);
  constexpr double h = 1e-4;
  double largest = 0.0;
  for (double t = 0.001; t < 0.999; t += 0.001) {
    largest = std::max(largest, StepForm::at(t).value);
    if (std::abs(t - StepForm::turn) < 2 * h) continue;
    const auto before = StepForm::at(t - h);
    const auto behind = StepForm::at(t + h);
    EXPECT_NEAR(StepForm::at(t).first, (behind.value - before.value) / (2 * h), 1e-7);
    EXPECT_NEAR(StepForm::at(t).second, (behind.first - before.first) / (2 * h), 1e-7);
    EXPECT_NEAR((behind.second - before.second) / (2 * h),
                t < StepForm::turn ? StepForm::slope : -StepForm::slope, 1e-7);
  }
  EXPECT_NEAR(largest, StepForm::largest, 1e-6);
}

TEST(Swing, KeepsTheToleranceOnBothSidesAndUsesIt) {
  const MotionConfig config = three_axes(channel_limits);
  for (const double degrees : {2.0, 14.0, 45.0, 90.0, 120.0, 160.0}) {
    const Legs legs(50.0, degrees * std::numbers::pi / 180.0);
    const auto swing = fit_swing(legs.incoming, legs.outgoing, 25.0, {0.01, 0.01}, config);
    ASSERT_TRUE(swing) << degrees;
    const Range range = deviations_of(*swing, legs);
    EXPECT_LE(range.inside, 0.01) << degrees;
    EXPECT_LE(range.outside, 0.01) << degrees;
    EXPECT_LE(range.at_corner, 0.01) << degrees;
    EXPECT_GE(range.at_corner, 0.0095) << degrees;
    // Across a leg the deviation is less by cos(turn / 2) than from corner to curve.
    EXPECT_GE(range.outside, 0.0095 * std::cos(degrees * std::numbers::pi / 360.0)) << degrees;
  }
}

TEST(Swing, BetweenALineAndAnArcKeepsTheTolerance) {
  // Along X to the origin, then a circle around (0, r), tangent or with a kink.
  const MotionConfig config = three_axes(channel_limits);
  for (const double radius : {1.0, 3.0, 20.0}) {
    for (const double kink : {0.0, 0.02, 0.3}) {
      Point start;
      start[0] = -30.0 * std::cos(kink);
      start[1] = 30.0 * std::sin(kink);
      const Segment incoming = straight(start, {});
      PathBlock block;
      block.kind = BlockKind::arc;
      block.centre = {0.0, radius};
      block.sweep_rad = 2.0;
      block.end[0] = radius * std::sin(2.0);
      block.end[1] = radius * (1.0 - std::cos(2.0));
      const Shape round = arc(incoming.geometry.metric, {}, block);
      Segment outgoing;
      outgoing.geometry = round.geometry;
      outgoing.length = round.length;
      const auto swing = fit_swing(incoming, outgoing, 15.0, {0.01, 0.01}, config);
      ASSERT_TRUE(swing) << radius << ' ' << kink;
      double largest = 0.0;
      for (const Shape& part : swing->parts) {
        Segment segment;
        segment.geometry = part.geometry;
        segment.length = part.length;
        for (int i = 0; i <= 100; ++i) {
          const Point p = contact_at(segment, segment.length * i / 100.0).position;
          const double along = -p[0] * std::cos(kink) + p[1] * std::sin(kink);
          const double to_line = along >= 0.0
                                     ? std::abs(p[0] * std::sin(kink) + p[1] * std::cos(kink))
                                     : std::hypot(p[0], p[1]);
          const double to_arc = p[0] >= 0.0 ? std::abs(std::hypot(p[0], p[1] - radius) - radius)
                                            : std::hypot(p[0], p[1]);
          largest = std::max(largest, std::min(to_line, to_arc));
        }
      }
      EXPECT_LE(largest, 0.01) << radius << ' ' << kink;
    }
  }
}

TEST(Swing, StaysWithinTheReachItIsGiven) {
  const MotionConfig config = three_axes(channel_limits);
  const Legs legs(50.0, 0.25);
  // To the full tolerance the reach is 0.97 * 0.01 / (0.03917 * 2 sin(0.125)) = 0.99 mm, without
  // any swing 0.23 mm.
  EXPECT_NEAR(full_swing_reach(legs.incoming, legs.outgoing, {0.01, 0.01}, config), 0.9932, 1e-3);
  for (const double reach : {0.25, 0.5, 0.9}) {
    const auto swing = fit_swing(legs.incoming, legs.outgoing, reach, {0.01, 0.01}, config);
    ASSERT_TRUE(swing);
    EXPECT_DOUBLE_EQ(swing->reach, reach);
    EXPECT_LE(deviations_of(*swing, legs).at_corner, 0.01);
  }
  EXPECT_FALSE(fit_swing(legs.incoming, legs.outgoing, 0.2, {0.01, 0.01}, config));
}

std::vector<Sample> run_corner(double turn, double feed) {
  const MotionConfig config = three_axes(channel_limits);
  const Legs legs(4.0, turn);
  PathBuilder builder(config);
  builder.restart(legs.start);
  for (const Point& end : {Point{}, legs.end}) {
    PathBlock block;
    block.end = end;
    block.feed_per_s = feed;
    block.tolerance_mm = block.tolerance_deg = 0.01;
    EXPECT_FALSE(builder.add(block));
  }
  builder.finish();
  return run_path(config, builder.built());
}

TEST(Swing, IsPassedAtTheSpeedOfTheClosedForm) {
  // At an even speed the jerk is v^3 kink slope / L^2 with L = e / (0.03917 kink), 3.097 the slope:
  // v = (J e^2 / (3.097 * 0.03917^2 * kink^3))^(1/3). Along the bisector X and Y share it.
  const double turn = 0.25;
  const auto samples = run_corner(turn, 100.0);
  const double kink = 2.0 * std::sin(0.5 * turn);
  const double jerk_max = channel_limits.j / std::cos(0.5 * turn);  // Y takes nearly all of it
  const double even = std::cbrt(jerk_max * std::pow(0.97 * 0.01 / 0.0391670, 2) / 3.0971959) / kink;
  double slowest = unlimited;
  for (const Sample& sample : samples) {
    const double x = sample.out.axes[0].value;
    if (std::abs(x) < 0.5) slowest = std::min(slowest, sample.out.s_speed);
  }
  // The plan also changes its speed within the curve.
  EXPECT_GT(slowest, 0.8 * even);
  EXPECT_LT(slowest, 1.5 * even);
}

// As in single block. The plan is left before the gate, and is not taken up again on the way: it
// would have to be left anew, a little nearer to the gate each time, for many seconds.
TEST(Swing, AGateBehindItIsReachedSoon) {
  const MotionConfig config = three_axes(channel_limits);
  PathBuilder builder(config);
  Point at{};
  builder.restart(at);
  double heading = 0.3;
  for (std::uint64_t n = 1; n <= 6; ++n) {
    at[0] += 10.0 * std::cos(heading);
    at[1] += 10.0 * std::sin(heading);
    heading += n % 2 == 1 ? 0.2 : -0.2;
    PathBlock block = line_to(at, 5000.0 / 60.0);
    block.tag = {.run = 1, .block = n};
    EXPECT_FALSE(builder.add(block));
  }
  builder.finish();
  // Three legs of 10 mm with a full stop behind each take 0.68 s.
  const auto samples = run_path(
      config, builder.built(), [](int) { return FeedControl{.closed_from_block = 3}; }, 1500);
  EXPECT_TRUE(samples.back().out.at_gate);
}

// Which curve a corner has, by the number of segments, is the same at every feed: so a higher feed
// cannot be slower for another curve.
TEST(Swing, IsTakenAtEveryFeedOrAtNone) {
  const MotionConfig config = three_axes(channel_limits);
  Random random(1);
  int swings = 0;
  int blends = 0;
  for (int n = 0; n < 100; ++n) {
    const double length = random.between(0.3, 3.0);
    const double turn = random.between(0.02, 0.35);  // sharper ones may stop, with overlap
    const Point end{length + length * std::cos(turn), length * std::sin(turn)};
    std::vector<std::size_t> counts;
    for (const double feed : {10.0, 25.0, 60.0, 140.0, 240.0}) {
      counts.push_back(built_from(config, {line_to({length}, feed), line_to(end, feed)}).size());
    }
    for (const std::size_t count : counts) EXPECT_EQ(count, counts.front()) << "corner " << n;
    (counts.front() > 3 ? swings : blends) += 1;
  }
  EXPECT_GT(swings, 10);
  EXPECT_GT(blends, 10);
}

}  // namespace
}  // namespace stanok::motion::testing
