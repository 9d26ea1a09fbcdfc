// Steps within the tolerance become lines: fast, within tolerance of every block, and not where
// something happens at their ends.
#include "motion/segments/straightening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/motion/path_fixture.h"
#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

constexpr Limits mill_limits{.v = 250.0, .a = 2500.0, .j = 50000.0};

struct Steps {
  std::vector<PathBlock> blocks;

  void to(const Point& end, double tolerance, double straightening = -1.0) {
    PathBlock block;
    block.tag = {.run = 1, .block = blocks.size() + 1};
    block.end = end;
    block.feed_per_s = 100.0;
    block.tolerance_mm = tolerance;
    block.tolerance_deg = 0.05;
    block.straightening_mm = straightening;
    blocks.push_back(block);
  }
};

// Steps of x and y in turn.
Steps stairs(int count, double x, double y, double tolerance, double straightening = -1.0) {
  Steps steps;
  for (int n = 1; n <= count; ++n) {
    const int steps_of_y = n / 2;
    steps.to({x * (n - steps_of_y), y * steps_of_y}, tolerance, straightening);
  }
  return steps;
}

double taken_by(const MotionConfig& config, const std::vector<Sample>& samples) {
  return config.cycle_s * static_cast<double>(samples.size());
}

double farthest_off(const std::vector<Sample>& samples, const std::vector<PathBlock>& blocks) {
  double worst = 0.0;
  for (const Sample& sample : samples) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = sample.out.point[k].value;
    double nearest = unlimited;
    for (std::size_t n = 0; n < blocks.size(); ++n) {
      const Point start = n == 0 ? Point{} : blocks[n - 1].end;
      nearest = std::min(nearest, distance_to_leg(p, start, blocks[n].end));
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

void expect_mill_limits(const MotionConfig& config, const std::vector<Sample>& samples) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_LE(quotients_of(axis_of(samples, axis), mill_limits, config.cycle_s).worst(),
              1.0 + 1e-6);
}

// 8 mm in X and Y by 8,000 corners of 90 deg: as fast as the line, which takes 0.11 s at the feed
// and 0.2 s for ramps of this jerk.
TEST(Straightening, AStaircaseIsALine) {
  const MotionConfig config = three_axes(mill_limits);
  const auto blocks = stairs(8000, 0.002, 0.002, 0.01).blocks;
  const auto samples = run_path(config, built_from(config, blocks));
  EXPECT_LE(taken_by(config, samples), 0.5);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(samples.back().out.point[k].value, blocks.back().end[k]);
  expect_mill_limits(config, samples);
}

TEST(Straightening, StaysWithinToleranceOfTheBlocks) {
  const MotionConfig config = three_axes(mill_limits);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double tolerance = std::pow(10.0, random.between(-3.0, -1.5));
    const bool has_own = random.chance(0.3);
    const double own = has_own ? tolerance * random.between(0.0, 3.0) : -1.0;
    Steps steps;
    Point at{};
    for (int n = 0; n < 200; ++n) {
      const double size = random.chance(0.1) ? 50.0 : random.between(0.1, 3.0);
      at[n % 2 == 0 ? 0 : 1] += size * tolerance * random.between(0.3, 1.0);
      if (random.chance(0.2)) at[2] += tolerance * random.between(-1.0, 1.0);
      steps.to(at, tolerance, own);
    }
    const auto samples = run_path(config, built_from(config, steps.blocks));
    EXPECT_LE(farthest_off(samples, steps.blocks), std::max(tolerance, own));
    expect_mill_limits(config, samples);
    EXPECT_EQ(samples.back().out.point[0].value, at[0]);
    EXPECT_EQ(samples.back().out.point[1].value, at[1]);
  }
}

// With a straightening of 0 every corner is passed; the programmed one is used without more of P.
TEST(Straightening, IsWhatTheProgramSays) {
  const MotionConfig config = three_axes(mill_limits);
  const auto lines = [&](double straightening) {
    return built_from(config, stairs(40, 0.002, 0.002, 0.01, straightening).blocks).size();
  };
  EXPECT_GE(lines(0.0), 40U);
  EXPECT_LE(lines(0.005), 4U);
  EXPECT_GE(lines(0.001), 40U);  // corners are 1.4 um off
}

// A block of its own feed is not mixed with others, and where an output is set the path passes.
TEST(Straightening, KeepsEndsAtWhichSomethingHappens) {
  const MotionConfig config = three_axes(mill_limits);
  auto blocks = stairs(4, 0.002, 0.002, 0.01).blocks;
  PathBuilder builder(config);
  builder.restart({});
  EXPECT_FALSE(builder.add(blocks[0]));
  EXPECT_FALSE(builder.add(blocks[1]));
  builder.keep_end();
  EXPECT_FALSE(builder.add(blocks[2]));
  EXPECT_FALSE(builder.add(blocks[3]));
  builder.finish();
  std::set<std::uint64_t> seen;
  for (const auto& built : builder.built()) seen.insert(built.segment.tag.block);
  EXPECT_TRUE(seen.contains(2));
  EXPECT_TRUE(seen.contains(4));
}

TEST(Straightening, ALineThatTurnsBackIsLeft) {
  const MotionConfig config = three_axes(mill_limits);
  Straightening straightening(config);
  const auto segment = [](const Point& from, const Point& to) {
    Segment of;
    of.geometry.start = from;
    of.geometry.end = to;
    return of;
  };
  Segment line = segment({}, {0.01});
  EXPECT_FALSE(straightening.extend(line, segment({0.01}, {0.005, 0.001}), {1.0, 1.0}));
  EXPECT_TRUE(straightening.extend(line, segment({0.01}, {0.02, 0.001}), {1.0, 1.0}));
  EXPECT_EQ(line.geometry.end[0], 0.02);
}

}  // namespace
}  // namespace stanok::motion::testing
