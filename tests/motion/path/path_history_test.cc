// Segments are kept as they were, the newest ones, and read in both directions.
#include "motion/path/path_history.h"

#include <gtest/gtest.h>

#include <cstring>
#include <deque>

#include "tests/motion/random_programs.h"
#include "tests/support/no_allocation.h"

namespace stanok::motion::testing {
namespace {

// What a history keeps of a segment.
void expect_same(const Segment& kept, const Segment& passed) {
  EXPECT_EQ(kept.tag.block, passed.tag.block);
  EXPECT_EQ(kept.tag.line, passed.tag.line);
  EXPECT_EQ(kept.length, passed.length);
  EXPECT_EQ(kept.feed_per_s, passed.feed_per_s);
  EXPECT_EQ(kept.rapid, passed.rapid);
  EXPECT_EQ(std::memcmp(&kept.bounds.velocity, &passed.bounds.velocity, sizeof(double)), 0);
  for (const double part : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    JetPoint a;
    JetPoint b;
    evaluate(kept, part * kept.length, a);
    evaluate(passed, part * passed.length, b);
    for (std::size_t k = 0; k < axes_max; ++k) {
      EXPECT_EQ(a[k].value, b[k].value);
      EXPECT_EQ(a[k].third, b[k].third);
    }
  }
}

TEST(PathHistory, KeepsTheNewestSegmentsToTheBitAndCountsTheirBlocks) {
  const MotionConfig config = mill(5);
  Random random(7);
  PathBuilder builder(config);
  builder.restart({});
  for (int n = 0; n < 12; ++n) {
    const Program program =
        n % 2 == 0
            ? arcs(random,
                   builder.built().empty() ? Point{} : builder.built().back().segment.geometry.end)
            : Program{};
    for (const PathBlock& block : program.blocks) ASSERT_FALSE(builder.add(block));
  }
  builder.finish();
  PathHistory history(20000);
  std::deque<Segment> passed;
  for (const auto& built : builder.built()) {
    {
      const stanok::testing::NoAllocation guard;
      history.note(built.segment, built.ends_chain ? ChainPlace::last : ChainPlace::within);
    }
    passed.push_back(built.segment);
  }
  PassedSegment record;
  std::size_t count = 0;
  auto place = history.newest();
  for (; place != history.oldest(); ++count) {
    place = history.before(place);
    history.read(place, record);
    expect_same(record.segment, passed[passed.size() - 1 - count]);
  }
  EXPECT_GT(count, 20U);
  EXPECT_LT(count, passed.size());
  for (std::size_t k = 0; k < count; ++k) place = history.behind(place);
  EXPECT_EQ(place, history.newest());
  std::uint64_t blocks = 1;
  for (std::size_t k = passed.size() - count + 1; k < passed.size(); ++k)
    blocks += passed[k].tag.block != passed[k - 1].tag.block ? 1U : 0U;
  EXPECT_EQ(history.blocks_between(history.oldest(), history.newest()), blocks);
}

TEST(PathHistory, KnowsWhereTheAxesRested) {
  PathHistory history(100000);
  Segment segment;
  segment.length = 1.0;
  EXPECT_TRUE(history.rests());
  history.note(segment, ChainPlace::within);
  EXPECT_FALSE(history.rests());
  history.note(segment, ChainPlace::last);
  EXPECT_TRUE(history.rests());
  history.note(segment, ChainPlace::within);
  PassedSegment record;
  auto place = history.oldest();
  for (const bool begins : {true, false, true}) {
    history.read(place, record);
    EXPECT_EQ(record.begins_chain, begins);
    place = history.behind(place);
  }
  history.cut();
  EXPECT_TRUE(history.is_empty());
  EXPECT_TRUE(history.rests());
}

TEST(PathHistory, WithoutMemoryKeepsNothing) {
  PathHistory history(0);
  Segment segment;
  segment.length = 1.0;
  history.note(segment, ChainPlace::within);
  EXPECT_TRUE(history.is_empty());
}

}  // namespace
}  // namespace stanok::motion::testing
