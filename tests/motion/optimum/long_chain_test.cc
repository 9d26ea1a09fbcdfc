// Chains of many thousands of blocks: they are committed in parts, and stretches meet where one
// part ends. Limits hold there under every override, and the speed is not lower than elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/path_samples.h"
#include "tests/motion/random_programs.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

// Waves whose length changes every some hundred blocks, in chords of 0.1 mm, so that axes and not
// the feed are the limit everywhere, at quite different speeds.
std::vector<PathBlock> long_waves(Random& random, int count) {
  std::vector<PathBlock> blocks;
  constexpr double chord = 0.1;
  double heading_part = 0.0;
  double turn = 0.1;
  Point at{};
  for (int n = 1; n <= count; ++n) {
    if (n % 300 == 0) turn = std::pow(10.0, random.between(-2.2, -0.7));
    heading_part += turn;
    const double heading = 0.8 * std::sin(heading_part);
    at[0] += chord * std::cos(heading);
    at[1] += chord * std::sin(heading);
    PathBlock block = line_to(at, 500.0);
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(n)};
    blocks.push_back(block);
  }
  return blocks;
}

TEST(LongChain, KeepsLimitsUnderOverridesWhereItsPartsMeet) {
  const MotionConfig config = three_axes(channel_limits);
  double used = 0.0;
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(20U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    PathBuilder builder(config);
    builder.restart({});
    for (const PathBlock& block : long_waves(random, 6000)) EXPECT_FALSE(builder.add(block));
    builder.finish();
    FeedControl control;
    const auto overrides = [&](int) {
      if (random.chance(0.01)) control.feed_override = random.between(0.1, 1.0);
      return control;
    };
    for (const Sample& sample : run_path(config, builder.built(), overrides)) {
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& axis = sample.out.axes[k];
        used = std::max({used, std::abs(axis.second) / config.axes[k].acceleration_max,
                         std::abs(axis.third) / config.axes[k].jerk_max});
      }
    }
  }
  EXPECT_LE(used, 1.0 + 1e-9);
}

// Legs on which the feed is reached, with corners that are passed more slowly.
std::vector<PathBlock> zigzag_of(int legs, double feed) {
  constexpr double length = 20.0;
  constexpr double turn = 0.25;
  std::vector<PathBlock> blocks;
  Point at{};
  for (int n = 0; n < legs; ++n) {
    at[0] += length * std::cos(0.5 * turn);
    at[1] += (n % 2 == 0 ? 1.0 : -1.0) * length * std::sin(0.5 * turn);
    blocks.push_back(line_to(at, feed));
    blocks.back().tag = {.run = 1, .block = blocks.size()};
  }
  return blocks;
}

// Each corner is a stretch by itself, that begins on the leg on which the one before ended. All of
// them have many more phases than a segment may have.
TEST(LongChain, TheLastOfManyStretchesIsAsFastAsTheFirst) {
  const MotionConfig config = three_axes(channel_limits);
  const auto seconds = [&](int legs) {
    PathBuilder builder(config);
    builder.restart({});
    for (const PathBlock& block : zigzag_of(legs, 130.0)) EXPECT_FALSE(builder.add(block));
    builder.finish();
    return 0.001 * static_cast<double>(run_path(config, builder.built()).size());
  };
  const double few = seconds(20);
  const double more = seconds(40);
  EXPECT_NEAR(seconds(240) - more, 10.0 * (more - few), 0.05);
}

}  // namespace
}  // namespace stanok::motion::testing
