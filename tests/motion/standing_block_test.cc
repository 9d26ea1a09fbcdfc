// Blocks that hardly move: what the program says last is where the axes stand, to the bit, and
// nothing of it costs time.
#include <gtest/gtest.h>

#include <cmath>

#include "motion/look_ahead/look_ahead.h"
#include "motion/path/block_metric.h"
#include "motion/segments/path_builder.h"
#include "tests/motion/path_fixture.h"

namespace stanok::motion {
namespace {

constexpr double feed = 10.0;

// Path and profile of the blocks, planned whole; nothing may be left.
struct PlannedBlocks {
  Point end{};
  double time = 0.0;
  int chains = 0;
};

PlannedBlocks planned(const std::vector<PathBlock>& blocks, int axis_count = 3) {
  const MotionConfig config = mill(axis_count);
  PathBuilder builder(config);
  LookAhead look_ahead(config);
  PathQueue queue;
  builder.restart({});
  for (const PathBlock& block : blocks) EXPECT_FALSE(builder.add(block).has_value());
  builder.finish();
  PlannedBlocks result;
  for (const PathBuilder::Built& built : builder.built()) {
    EXPECT_GT(built.segment.length, 0.0);
    look_ahead.add(built);
    result.end = built.segment.geometry.end;
  }
  EXPECT_TRUE(look_ahead.deliver(queue));
  EXPECT_TRUE(look_ahead.is_empty());
  Chunk chunk;
  while (queue.chunks.pop(chunk)) result.chains += chunk.last ? 1 : 0;
  Phase phase;
  while (queue.phases.pop(phase)) {
    EXPECT_TRUE(std::isfinite(phase.duration) && std::isfinite(phase.s_end));
    result.time += phase.duration;
  }
  return result;
}

Point at_x(double x) {
  Point point{};
  point[0] = x;
  return point;
}

// 1e-13 to 1e-6 mm forward, back, and aside: around the border of what counts as motion.
TEST(StandingBlocks, EndWhereTheProgramSays) {
  for (double step = 1e-13; step < 2e-6; step *= std::sqrt(10.0)) {
    for (const double sign : {1.0, -1.0}) {
      Point end = at_x(10.0 + sign * step);
      EXPECT_EQ(planned({line_to(at_x(10.0), feed), line_to(end, feed)}).end, end) << step;
      end = at_x(10.0);
      end[1] = sign * step;
      EXPECT_EQ(planned({line_to(at_x(10.0), feed), line_to(end, feed)}).end, end) << step;
    }
  }
}

// The time of a millimetre at 10 mm/s and of one more rest, whatever stands between.
TEST(StandingBlocks, CostNoTime) {
  const double alone = planned({line_to(at_x(1.0), feed), line_to(at_x(2.0), feed)}).time;
  Point aside = at_x(1.0);
  aside[1] = 3e-10;
  const PlannedBlocks between =
      planned({line_to(at_x(1.0), feed), line_to(aside, feed), line_to(at_x(1.0 - 1e-10), feed),
               line_to(at_x(2.0), feed)});
  EXPECT_NEAR(between.time, alone, 1e-9);
  EXPECT_EQ(between.chains, 1);
}

// A thousand steps of a tenth, added up with their rounding, then the whole number.
TEST(StandingBlocks, OfSumsWithRoundingAreTaken) {
  double x = 0.0;
  std::vector<PathBlock> blocks;
  for (int n = 0; n < 1000; ++n) blocks.push_back(line_to(at_x(x += 0.1), 100.0));
  ASSERT_NE(x, 100.0);
  blocks.push_back(line_to(at_x(100.0), 100.0));
  EXPECT_EQ(planned(blocks).end, at_x(100.0));
}

// Steps of 0.9e-9 mm, each of which is none, and back over them.
TEST(StandingBlocks, AddUpToTheirSum) {
  std::vector<PathBlock> blocks{line_to(at_x(1.0), feed)};
  for (int n = 1; n <= 10; ++n) blocks.push_back(line_to(at_x(1.0 + 0.9e-9 * n), 0.0));
  EXPECT_EQ(planned(blocks).end, at_x(1.0 + 0.9e-9 * 10));
  blocks.push_back(line_to(at_x(1.0), feed));
  EXPECT_EQ(planned(blocks).end, at_x(1.0));
}

TEST(StandingBlocks, WantNoFeed) {
  PathBlock repeated = line_to(at_x(1.0), 0.0);
  EXPECT_EQ(planned({line_to(at_x(1.0), feed), repeated}).end, at_x(1.0));
}

// A rotary way of 0.3 deg beside 1e-10 mm counts in deg, for the length as for the segment.
TEST(BlockMetric, IsThatOfTheSegment) {
  const MotionConfig config = mill(5);
  Point end = at_x(1e-10);
  end[3] = 0.3;
  const PathBlock block = line_to(end, feed);
  EXPECT_EQ(travel_of(block, {}, config), BlockTravel::others);
  EXPECT_NEAR(length_of(block, {}, config), 0.3, 1e-12);
  EXPECT_NEAR(planned({block}, 5).end[0], 1e-10, 0.0);
}

// A full circle and a helix whose radius is nothing; the helix is the line along its axis.
TEST(BlockMetric, TakesArcsAroundNothingForLines) {
  const MotionConfig config = mill(3);
  PathBlock circle = line_to({}, feed);
  circle.kind = BlockKind::arc;
  circle.centre = {1e-11, 0.0};
  circle.sweep_rad = 2.0 * std::numbers::pi;
  EXPECT_EQ(travel_of(circle, {}, config), BlockTravel::none);
  PathBlock helix = circle;
  helix.end[2] = 5.0;
  EXPECT_EQ(travel_of(helix, {}, config), BlockTravel::geometry);
  EXPECT_NEAR(length_of(helix, {}, config), 5.0, 1e-12);
  EXPECT_EQ(planned({helix}).end, helix.end);
}

}  // namespace
}  // namespace stanok::motion
