// Plans along whole paths, by the setpoints of every cycle: as fast as the limits of the axes
// allow, and never slower for a higher feed or override.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/motion/path_samples.h"
#include "tests/motion/random_programs.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

double time_of(const std::vector<Sample>& samples) {
  return 0.001 * static_cast<double>(samples.size());
}

// Turns of a circle from rest to rest in short chords.
std::vector<PathBlock> circle(double radius, double feed_per_s, int turns = 1) {
  std::vector<PathBlock> blocks;
  constexpr int count = 400;
  for (int n = 1; n <= turns * count; ++n) {
    const double angle = 2.0 * std::numbers::pi * n / count;
    PathBlock block = line_to({radius * std::sin(angle), radius - radius * std::cos(angle)});
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n)};
    block.feed_per_s = feed_per_s;
    blocks.push_back(block);
  }
  return blocks;
}

// Where acceleration and jerk of each axis are all that limits it, a circle is passed at the speed
// at which an axis at its turning point has all of its acceleration: v^2 = a r; with its jerk,
// v^3 / r^2 <= j.
TEST(TimeOptimum, ACircleIsPassedAtTheSpeedThatItsAxesAllow) {
  const Limits limits{.v = 1000.0, .a = 2000.0, .j = 200000.0};
  const MotionConfig config = three_axes(limits);
  const double radius = 20.0;
  const double v = std::min(std::sqrt(limits.a * radius), std::cbrt(limits.j * radius * radius));
  double top = 0.0;
  for (const Sample& sample : run_path(config, built_from(config, circle(radius, 900.0))))
    top = std::max(top, sample.out.s_speed);
  EXPECT_GT(top, 0.97 * v);
  EXPECT_LT(top, 1.01 * v * std::numbers::sqrt2);  // between the turning points it may be faster
}

// Many turns are planned in several stretches: where two of them meet the speed is that of any
// other place.
TEST(TimeOptimum, WhereStretchesMeetTheSpeedStays) {
  const Limits limits{.v = 1000.0, .a = 2000.0, .j = 200000.0};
  const MotionConfig config = three_axes(limits);
  const double radius = 20.0;
  const double v = std::min(std::sqrt(limits.a * radius), std::cbrt(limits.j * radius * radius));
  constexpr int turns = 8;
  const auto samples = run_path(config, built_from(config, circle(radius, 900.0, turns)));
  double lowest = unlimited;
  for (std::size_t k = samples.size() / 10; k < samples.size() * 9 / 10; ++k)
    lowest = std::min(lowest, samples[k].out.s_speed);
  EXPECT_GT(lowest, 0.95 * v);
}

void expect_no_slower_for_a_higher_feed(std::uint64_t first, std::uint64_t last) {
  const MotionConfig config = three_axes(channel_limits);
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    SCOPED_TRACE(seed);
    double slower = unlimited;
    for (const double feed : {15.0, 25.0, 40.0, 60.0, 90.0, 140.0, 240.0}) {
      Random random(seed);
      Program program = winding_way(random, {}, {.blocks = 150});
      for (PathBlock& block : program.blocks) {
        block.feed_per_s = feed;
        block.tolerance_mm = 0.01;
        block.tolerance_deg = 0.05;
      }
      const double time = time_of(run_path(config, built_from(config, program.blocks)));
      EXPECT_LE(time, 1.002 * slower) << "feed " << feed;
      slower = std::min(slower, time);
    }
  }
}

TEST(TimeOptimum, AHigherFeedIsNotSlower) {
  expect_no_slower_for_a_higher_feed(1, stanok::testing::cases(20U));
}

TEST(TimeOptimum, AHigherFeedIsNotSlowerFullSize) {
  expect_no_slower_for_a_higher_feed(21, 200);
}

// The curves at both ends of the arc are passed at 17 mm/s. The ramps, from which the search
// begins, use twice the jerk there once they are to pass the arc at its own highest speed.
TEST(TimeOptimum, AnArcBetweenSlowCurvesIsNotSlowerForAHigherFeed) {
  const MotionConfig config = three_axes(channel_limits);
  const auto time_at = [&config](double feed) {
    std::vector<PathBlock> blocks;
    blocks.push_back(line_to({-6.801687, 5.888744}, feed));
    blocks.push_back(arc_to(blocks.back().end, {-5.011363, 4.338722}, -1.8994, {}, feed));
    blocks.push_back(line_to({-1.224884, 6.548678}, feed));
    return time_of(run_path(config, built_from(config, blocks)));
  };
  EXPECT_LE(time_at(150.0), 1.002 * time_at(100.0));
}

// At the higher feed an overlap of the first two legs would gain some microseconds, and cost 34 ms
// of the stretch behind it.
TEST(TimeOptimum, LegsThatHardlyOverlapAreNotSlowerForAHigherFeed) {
  const MotionConfig config = three_axes(channel_limits);
  const auto time_at = [&config](double feed) {
    const std::vector<PathBlock> blocks{line_to({-3.169226, 2.136282}, feed),
                                        line_to({2.493153, 7.965034}, feed),
                                        line_to({3.062485, 8.725259}, feed)};
    return time_of(run_path(config, built_from(config, blocks)));
  };
  EXPECT_LE(time_at(150.0), 1.002 * time_at(100.0));
}

TEST(TimeOptimum, AHigherOverrideIsNotSlower) {
  const MotionConfig config = three_axes(channel_limits);
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(20U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Program program = winding_way(random, {}, {.blocks = 150});
    for (PathBlock& block : program.blocks) {
      block.feed_per_s *= random.between(0.5, 4.0);
      block.tolerance_mm = 0.01;
      block.tolerance_deg = 0.05;
    }
    const auto built = built_from(config, program.blocks);
    double slower = unlimited;
    for (const double part : {0.3, 0.6, 0.9, 0.99, 1.0, 1.01, 1.2, 2.0}) {
      const auto control = [part](int) { return FeedControl{.feed_override = part}; };
      const double time = time_of(run_path(config, built, control));
      EXPECT_LE(time, 1.002 * slower + 0.003) << "override " << part;
      slower = std::min(slower, time);
    }
  }
}

// A hold comes to rest, wherever it comes: in 0.5 s at most with these limits, by which a move of
// the highest speed stops in 0.15 s.
TEST(TimeOptimum, AHoldComesToRestSoon) {
  const MotionConfig config = three_axes(channel_limits);
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(20U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Program program = winding_way(random, {}, {.blocks = 150});
    for (PathBlock& block : program.blocks) {
      block.feed_per_s = 200.0;
      block.tolerance_mm = 0.01;
      block.tolerance_deg = 0.05;
    }
    const auto built = built_from(config, program.blocks);
    const auto cycles = static_cast<double>(run_path(config, built).size());
    for (int n = 0; n < 8; ++n) {
      const int held = static_cast<int>(random.between(20.0, cycles - 20.0));
      const auto control = [held](int k) { return FeedControl{.hold = k >= held}; };
      const auto samples = run_path(config, built, control, held + 2000);
      const auto rest = std::find_if(samples.begin() + held + 1, samples.end(),
                                     [](const Sample& s) { return s.out.s_speed == 0.0; });
      ASSERT_NE(rest, samples.end());
      EXPECT_LE(rest - samples.begin() - held, 500) << "held at cycle " << held;
    }
  }
}

// An arc to a point, of a radius; `side` 1: against the clock, less than half of a circle.
PathBlock arc_of(const Point& start, const Point& end, double radius, double side) {
  const double chord = std::hypot(end[0] - start[0], end[1] - start[1]);
  const double from_chord = side * std::sqrt(radius * radius - 0.25 * chord * chord) / chord;
  const std::array<double, 2> centre{0.5 * (start[0] + end[0]) - from_chord * (end[1] - start[1]),
                                     0.5 * (start[1] + end[1]) + from_chord * (end[0] - start[0])};
  return arc_to(start, centre, side * 2.0 * std::asin(0.5 * chord / radius), end, 248.0);
}

// Arcs that meet in corners which are passed slowly, with a straight line behind them: by ramps
// they take longer than what is planned together. Divided on the top of the ramp on the line, which
// nothing but that ramp reaches, no motion was found for the arcs before it.
TEST(TimeOptimum, ALongChainOfSlowCornersIsNotDividedOnTheTopOfARamp) {
  const MotionConfig config = three_axes(channel_limits);
  const Point start{14.1083, -32.5423};
  std::vector<PathBlock> blocks{line_to({-12.883, -37.9385, -0.294}, 248.0)};
  const auto arc = [&](double x, double y, double radius, double side) {
    const Point& at = blocks.back().end;
    blocks.push_back(arc_of(at, {x, y, at[2]}, radius, side));
  };
  arc(-13.5622, -43.2259, 10.6264, -1.0);
  arc(-15.2281, -43.8285, 2.0541, 1.0);
  arc(-19.7062, -51.3324, 6.5237, -1.0);
  arc(-29.9389, -47.9288, 5.8433, -1.0);
  blocks.push_back(line_to({-27.7521, -41.9172, -0.294}, 248.0));
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].tag = {.run = 1, .block = k + 1};
    blocks[k].tolerance_mm = 0.0017;
  }
  const auto time = [&] {
    PathBuilder builder(config);
    builder.restart(start);
    for (const PathBlock& block : blocks) EXPECT_FALSE(builder.add(block));
    builder.finish();
    return time_of(run_path(config, builder.built()));
  };
  const double passed = time();
  for (PathBlock& block : blocks) block.ending = BlockEnding::exact_stop;
  EXPECT_LE(passed, 1.01 * time());
}

// What a hold leaves is run to its exact end.
TEST(TimeOptimum, AfterHoldsThePlanIsRunToItsEnd) {
  const MotionConfig config = three_axes(channel_limits);
  const auto blocks = circle(20.0, 300.0);
  const auto built = built_from(config, blocks);
  const double nominal = time_of(run_path(config, built));
  const auto control = [](int k) { return FeedControl{.hold = k % 700 > 400 && k < 3000}; };
  const auto samples = run_path(config, built, control);
  EXPECT_EQ(samples.back().out.point[0].value, blocks.back().end[0]);
  EXPECT_EQ(samples.back().out.point[1].value, blocks.back().end[1]);
  EXPECT_LT(time_of(samples), nominal + 4.0);
}

}  // namespace
}  // namespace stanok::motion::testing
