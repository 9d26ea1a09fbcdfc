// Motion along smooth runs: limits and tolerance under hold, resume and override, and the feed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/motion/path_samples.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937_64 engine_;
};

// Short blocks along a winding path, now and then a corner.
std::vector<PathBlock> winding_way(Draw& draw, int count, double tolerance) {
  std::vector<PathBlock> blocks;
  Point at{};
  double heading = 0.0;
  double bend = 0.0;
  for (int n = 0; n < count; ++n) {
    const double length = draw.between(0.05, 0.6);
    if (n % 25 == 0) bend = draw.between(-0.3, 0.3);
    heading += bend * length + draw.between(-0.01, 0.01);
    if (draw.between(0.0, 1.0) < 0.02) heading += draw.between(-2.5, 2.5);
    at[0] += length * std::cos(heading);
    at[1] += length * std::sin(heading);
    at[2] = 2.0 * std::sin(0.1 * n);
    PathBlock block;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n + 1)};
    block.end = at;
    block.feed_per_s = draw.between(10.0, 120.0);
    block.tolerance_mm = tolerance;
    block.tolerance_deg = 0.05;
    blocks.push_back(block);
  }
  return blocks;
}

// Of the setpoints from the blocks around the one they belong to.
double worst_deviation(const std::vector<Sample>& samples, const std::vector<PathBlock>& blocks) {
  double worst = 0.0;
  for (const Sample& sample : samples) {
    if (sample.out.tag.block == 0) continue;
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = sample.out.point[k].value;
    const std::size_t at = sample.out.tag.block - 1;
    double nearest = 1e300;
    for (std::size_t n = at > 8 ? at - 8 : 0; n < std::min(blocks.size(), at + 9); ++n) {
      const Point start = n == 0 ? Point{} : blocks[n - 1].end;
      nearest = std::min(nearest, distance_to_leg(p, start, blocks[n].end));
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

void expect_kept(const std::vector<Sample>& samples, const std::vector<PathBlock>& blocks,
                 double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(columns_of(samples, axis, channel_limits).worst(), 1.0 + 1e-9) << "axis " << axis;
    EXPECT_LE(quotients_of(axis_of(samples, axis), channel_limits, 0.001).worst(), 1.0 + 1e-6);
    EXPECT_EQ(samples.back().out.axes[axis].value, blocks.back().end[axis]);
  }
  EXPECT_LE(worst_deviation(samples, blocks), tolerance);
}

TEST(SmoothRunMotion, KeepsLimitsAndToleranceAtTheFeed) {
  const MotionConfig config = three_axes(channel_limits);
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(20U); ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed);
    const double tolerance = std::pow(10.0, draw.between(-3.7, -1.5));
    const auto blocks = winding_way(draw, 400, tolerance);
    expect_kept(run_path(config, built_from(config, blocks)), blocks, tolerance);
  }
}

TEST(SmoothRunMotion, KeepsThemUnderHoldResumeAndOverride) {
  const MotionConfig config = three_axes(channel_limits);
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(40U); ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(1000 + seed);
    const double tolerance = std::pow(10.0, draw.between(-3.7, -1.5));
    const auto blocks = winding_way(draw, 300, tolerance);
    FeedControl now;
    int until = 0;
    const auto control = [&](int cycle) {
      if (cycle > 30000) return FeedControl{};
      if (cycle >= until) {
        until = cycle + static_cast<int>(draw.between(5.0, 400.0));
        now.hold = draw.between(0.0, 1.0) < 0.25;
        now.feed_override = draw.between(0.0, 1.0) < 0.3 ? 1.0 : draw.between(0.0, 2.0);
      }
      return now;
    };
    expect_kept(run_path(config, built_from(config, blocks), control), blocks, tolerance);
  }
}

// Chords between setpoints cut an inside corner by (v T)^2 / 8R more than the curve does: 2.1 um
// where the curve turns at 17,000 mm/s^2.
void expect_chords_within(double tolerance) {
  const MotionConfig config = three_axes({.v = 1000.0, .a = 20000.0, .j = 4e6});
  std::vector<PathBlock> blocks;
  Point at{};
  for (int n = 0; n < 40; ++n) {
    const double heading = n % 2 == 0 ? 0.0 : 0.19;
    at[0] += 2.689 * std::cos(heading);
    at[1] += 2.689 * std::sin(heading);
    PathBlock block;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n + 1)};
    block.end = at;
    block.feed_per_s = 500.0;
    block.tolerance_mm = tolerance;
    block.tolerance_deg = 0.05;
    blocks.push_back(block);
  }
  std::vector<double> passed(blocks.size(), 1e300);
  Point before{};
  for (const Sample& sample : run_path(config, built_from(config, blocks))) {
    Point here;
    for (std::size_t k = 0; k < 3; ++k) here[k] = sample.out.axes[k].value;
    for (std::size_t n = 0; n < blocks.size(); ++n)
      passed[n] = std::min(passed[n], distance_to_leg(blocks[n].end, before, here));
    before = here;
  }
  EXPECT_LE(*std::ranges::max_element(passed), tolerance);
}

TEST(SmoothRunMotion, ChordsBetweenSetpointsPassCornersWithinTolerance) {
  for (const double tolerance : {0.01, 0.005, 0.002, 0.0007, 0.0003}) {
    SCOPED_TRACE(tolerance);
    expect_chords_within(tolerance);
  }
}

// A row over a gentle surface, its coordinates rounded to 1 um.
std::vector<PathBlock> rounded_row(double step, double tolerance) {
  constexpr double resolution = 0.001;
  std::vector<PathBlock> blocks;
  for (int n = 1; n * step <= 20.0; ++n) {
    const double x = n * step;
    PathBlock block;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n)};
    block.end = {x, 0.0, std::round(0.8 * std::sin(x / 3.0) / resolution) * resolution};
    block.feed_per_s = 100.0;
    block.tolerance_mm = tolerance;
    block.tolerance_deg = 0.05;
    blocks.push_back(block);
  }
  return blocks;
}

// What rounding adds to the path is averaged away as long as the tolerance is above it, and half of
// the tolerance never costs much.
TEST(SmoothRunMotion, RoundedCoordinatesCostLittle) {
  const MotionConfig config = three_axes({.v = 250.0, .a = 2500.0, .j = 50000.0});
  constexpr double at_the_feed = 0.2 + 0.045;  // s; with two ramps of sqrt(v / j) each
  for (const double step : {0.1, 0.02}) {
    SCOPED_TRACE(step);
    double coarser = unlimited;
    for (const double tolerance : {0.016, 0.008, 0.004, 0.002, 0.001}) {
      SCOPED_TRACE(tolerance);
      const auto blocks = rounded_row(step, tolerance);
      const auto samples = run_path(config, built_from(config, blocks));
      const double time = config.cycle_s * static_cast<double>(samples.size());
      EXPECT_LE(time, 1.15 * coarser);
      EXPECT_LE(time, 1.3 * at_the_feed);
      EXPECT_LE(worst_deviation(samples, blocks), tolerance);
      coarser = time;
    }
  }
}

// The turn of the whole path into a circle: 1 % of the time may go into its two ramps.
TEST(SmoothRunMotion, ChordsOfACircleRunAtTheFeed) {
  const MotionConfig config = three_axes(channel_limits);
  std::vector<PathBlock> blocks;
  for (int n = 1; n <= 6000; ++n) {
    PathBlock block;
    const double angle = n * 0.01;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n)};
    block.end = {10.0 * std::sin(angle), 10.0 - 10.0 * std::cos(angle)};
    block.feed_per_s = 83.0;
    block.tolerance_mm = 0.01;
    block.tolerance_deg = 0.05;
    blocks.push_back(block);
  }
  const auto samples = run_path(config, built_from(config, blocks));
  int steady = 0;
  for (const Sample& sample : samples) {
    const double speed = std::hypot(sample.out.point[0].first, sample.out.point[1].first);
    steady += std::abs(speed / 83.0 - 1.0) < 1e-9 ? 1 : 0;
  }
  EXPECT_GT(steady, 0.97 * static_cast<double>(samples.size()));
}

}  // namespace
}  // namespace stanok::motion::testing
