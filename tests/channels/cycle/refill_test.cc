// Where the path ran dry the axes rest until two seconds of it are known, or all of the chain.
#include "channels/cycle/refill.h"

#include <gtest/gtest.h>

#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using motion::PathState;

struct Chain {
  motion::PathQueue queue{64};
  void add(double time_s, bool last = false, std::uint32_t segments = 1) {
    for (std::uint32_t k = 0; k < segments; ++k) ASSERT_TRUE(queue.segments.push({}));
    ASSERT_TRUE(queue.chunks.push({.segments = segments, .last = last, .time_s = time_s}));
  }
};

TEST(Refill, GoesOnWithTwoSecondsOfMotion) {
  Chain chain;
  Refill refill;
  EXPECT_FALSE(refill.look(PathState::moving, chain.queue));
  EXPECT_FALSE(refill.is_on());
  const testing::NoAllocation guard;
  EXPECT_TRUE(refill.look(PathState::starved, chain.queue)) << "it is told once";
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  chain.add(0.9);
  chain.add(0.9);
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  EXPECT_TRUE(refill.is_on());
  chain.add(0.3);
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  EXPECT_FALSE(refill.is_on());
}

TEST(Refill, GoesOnWithTheEndOfTheChain) {
  Chain chain;
  Refill refill;
  EXPECT_TRUE(refill.look(PathState::starved, chain.queue));
  chain.add(0.1, true);
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  EXPECT_FALSE(refill.is_on());
}

TEST(Refill, GoesOnWithHalfOfWhatTheQueueHolds) {
  Chain chain;
  Refill refill;
  EXPECT_TRUE(refill.look(PathState::starved, chain.queue));
  chain.add(0.1, false, 31);
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  EXPECT_TRUE(refill.is_on());
  chain.add(0.1);
  EXPECT_FALSE(refill.look(PathState::holding, chain.queue));
  EXPECT_FALSE(refill.is_on());
}

TEST(Refill, IsOverWithTheRun) {
  Chain chain;
  Refill refill;
  EXPECT_TRUE(refill.look(PathState::starved, chain.queue));
  refill.forget();
  EXPECT_FALSE(refill.is_on());
}

}  // namespace
}  // namespace stanok::channels
