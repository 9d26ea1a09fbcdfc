// What the look-ahead commits: how far, in which chunks, how fast.
#include "motion/look_ahead/look_ahead.h"

#include <gtest/gtest.h>

#include "tests/motion/path_samples.h"

namespace stanok::motion::testing {
namespace {

// All chunks with their phases, delivered after every segment or only when everything is planned.
struct CommittedPath {
  std::vector<Chunk> chunks;
  std::vector<std::vector<Phase>> phases;
};

void drain(PathQueue& queue, CommittedPath& path) {
  Chunk chunk;
  while (queue.chunks.pop(chunk)) {
    path.chunks.push_back(chunk);
    auto& phases = path.phases.emplace_back();
    for (std::uint32_t k = 0; k < chunk.phases; ++k) phases.push_back(queue.phases[k]);
    queue.phases.pop_front(chunk.phases);
    queue.segments.pop_front(chunk.segments);
  }
}

CommittedPath commit_all(const std::vector<PathBuilder::Built>& built, std::size_t deliver_every) {
  PathQueue queue;
  LookAhead look_ahead(three_axes(usual_limits));
  CommittedPath path;
  std::size_t count = 0;
  for (const auto& segment : built) {
    look_ahead.add(segment);
    if (++count % deliver_every != 0) continue;
    static_cast<void>(look_ahead.deliver(queue));
    drain(queue, path);
  }
  while (!look_ahead.is_empty()) {
    static_cast<void>(look_ahead.deliver(queue));
    drain(queue, path);
  }
  return path;
}

ChainMaker random_walk(unsigned seed, int count, double length_mean) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  ChainMaker chain(usual_limits);
  double feed = 100.0;
  for (int k = 0; k < count; ++k) {
    if (part(random) < 0.05) feed = 20.0 + 300.0 * part(random);
    chain.line(length_mean * (0.5 + part(random)), feed);
  }
  chain.end_chain();
  return chain;
}

TEST(LookAhead, CommitsOnlyWhatAThousandLaterBlocksSecure) {
  const ChainMaker chain = random_walk(1, 6000, 0.1);
  const CommittedPath path = commit_all(chain.built(), 1);
  ASSERT_GT(path.chunks.size(), 3U);
  std::uint32_t beyond = 0;  // one block a segment
  for (auto chunk = path.chunks.rbegin(); chunk != path.chunks.rend(); ++chunk) {
    EXPECT_GE(chunk->lookahead_blocks, std::min(beyond, 1000U) + chunk->segments - 1);
    if (beyond == 0) {
      EXPECT_EQ(chunk->lookahead_blocks, chunk->segments - 1);
    }
    beyond += chunk->segments;
  }
}

std::uint32_t farthest_seen(const ChainMaker& chain) {
  std::uint32_t blocks = 0;
  for (const Chunk& chunk : commit_all(chain.built(), 1).chunks)
    blocks = std::max(blocks, chunk.lookahead_blocks);
  return blocks;
}

// A thousand blocks, what is planned at a time and what is planned again: a few thousand, however
// long the program is, at an even feed and at any other.
TEST(LookAhead, LooksNoFartherInALongerProgram) {
  constexpr int blocks = 30000;
  constexpr std::uint32_t few = 5000;
  for (const double feed : {20.0, 100.0, 250.0, 500.0}) {  // the last above what the axis allows
    ChainMaker even(usual_limits);
    for (int k = 0; k < blocks; ++k) even.line(0.05, feed);
    even.end_chain();
    EXPECT_LE(farthest_seen(even), few) << feed;
  }
  for (unsigned seed = 1; seed <= 3; ++seed) {
    EXPECT_LE(farthest_seen(random_walk(seed, blocks, 0.05)), few) << seed;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    ChainMaker stairs(usual_limits);  // feeds that only rise, only fall, and stay the same
    double feed = 100.0;
    double change = 0.0;
    for (int k = 0; k < blocks; ++k) {
      if (k % 3000 == 0) change = part(random) < 0.3 ? 0.0 : 0.1 * (part(random) - 0.5);
      feed = std::clamp(feed + change, 20.0, 390.0);
      stairs.line(0.05, feed);
    }
    stairs.end_chain();
    EXPECT_LE(farthest_seen(stairs), few) << seed;
  }
}

TEST(LookAhead, ChunksMeetInOneStateToTheBit) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const ChainMaker chain = random_walk(seed, 8000, 0.2);
    const CommittedPath path = commit_all(chain.built(), 1);
    double v = 0.0;
    double a = 0.0;
    for (std::size_t k = 0; k < path.chunks.size(); ++k) {
      const auto& phases = path.phases[k];
      EXPECT_EQ(phases.front().s, 0.0);
      EXPECT_EQ(phases.front().v, v);
      EXPECT_NEAR(phases.front().a, a, 1e-8);
      for (std::size_t i = 1; i < phases.size(); ++i) {
        EXPECT_EQ(phases[i].s, phases[i - 1].s_end);
        EXPECT_NEAR(phases[i].v, phases[i - 1].v_end, 1e-10);
      }
      EXPECT_EQ(phases.back().s_end, path.chunks[k].length);
      a = phases.back().a + phases.back().j * phases.back().duration;
      v = phases.back().v_end;
    }
    EXPECT_EQ(v, 0.0);
    EXPECT_TRUE(path.chunks.back().last);
  }
}

TEST(LookAhead, WhatIsCommittedDoesNotDependOnWhenItIsTaken) {
  const ChainMaker chain = random_walk(7, 7000, 0.1);
  const CommittedPath one = commit_all(chain.built(), 1);
  const CommittedPath other = commit_all(chain.built(), 1777);
  ASSERT_EQ(one.chunks.size(), other.chunks.size());
  for (std::size_t k = 0; k < one.chunks.size(); ++k) {
    ASSERT_EQ(one.phases[k].size(), other.phases[k].size());
    for (std::size_t i = 0; i < one.phases[k].size(); ++i) {
      EXPECT_EQ(one.phases[k][i].duration, other.phases[k][i].duration);
      EXPECT_EQ(one.phases[k][i].j, other.phases[k][i].j);
    }
  }
}

TEST(LookAhead, LongDenseChainRunsWithinItsLimitsAndWithoutStopping) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const ChainMaker chain = random_walk(seed, 12000, 0.05);
    const auto samples = run_path(three_axes(usual_limits), chain.built());
    EXPECT_LE(quotients_of(axis_of(samples, 0), usual_limits, 0.001).worst(), 1.000001);
    EXPECT_EQ(samples.back().out.axes[0].value, chain.end()[0]);
    for (std::size_t k = 100; k + 100 < samples.size(); ++k) {
      EXPECT_GT(samples[k].out.s_speed, 1.0);
    }
  }
}

TEST(LookAhead, ChunksAreOfASizeThatTheQueueHoldsSeveralOf) {
  ChainMaker chain(usual_limits);  // one block of very many segments, then a dense rest
  for (int k = 0; k < 9000; ++k) chain.line(0.001, 400.0);
  chain.end_chain();
  const CommittedPath path = commit_all(chain.built(), 1);
  std::uint32_t segments = 0;
  for (const Chunk& chunk : path.chunks) {
    EXPECT_LE(chunk.segments, LookAhead::chunk_segments_max);
    segments += chunk.segments;
  }
  EXPECT_EQ(segments, 9000U);
}

TEST(LookAhead, ClearedPathStartsAgainAtRest) {
  ChainMaker chain(usual_limits);
  for (int k = 0; k < 3000; ++k) chain.line(1.0, 100.0);
  LookAhead look_ahead(three_axes(usual_limits));
  for (const auto& built : chain.built()) look_ahead.add(built);
  look_ahead.clear();
  EXPECT_TRUE(look_ahead.is_empty());
  ChainMaker next(usual_limits);
  next.line(5.0, 50.0).end_chain();
  look_ahead.add(next.built().front());
  PathQueue queue;
  ASSERT_TRUE(look_ahead.deliver(queue));
  EXPECT_EQ(queue.phases.front().v, 0.0);
  EXPECT_EQ(queue.chunks.front().sequence, 0U);
}

}  // namespace
}  // namespace stanok::motion::testing
