// Marks and outputs on their way along the path, without a channel around them.
#include "channels/cycle/mark_worker.h"

#include <gtest/gtest.h>

#include "motion/profile/feed_control.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

constexpr std::uint64_t no_gate = motion::FeedControl::no_gate;

template <class Content>
Rider rider(std::uint64_t before_block, const Content& content) {
  Rider made;
  made.tag.run = 1;
  made.before_block = before_block;
  made.content = content;
  return made;
}

int mark_of(const Rider& rider) {
  return std::get<riders::SoftMark>(rider.content).mark;
}

// The path is at a block, in motion or standing before one that is closed.
MarkWorker::Progress at_block(std::uint64_t block, bool stands_at_gate = false) {
  MarkWorker::Progress progress;
  progress.path.run = 1;
  progress.path.block = block;
  progress.stands_at_gate = stands_at_gate;
  progress.closed_block = no_gate;
  return progress;
}

class MarkWorkerTest : public ::testing::Test {
 protected:
  // A cycle as the channel makes it.
  std::optional<motion::BlockTag> cycle(const MarkWorker::Progress& progress) {
    const stanok::testing::NoAllocation guard;
    worker_.begin_cycle();
    worker_.find_gates();
    return worker_.advance(progress);
  }

  Ring<Rider> riders_{64};
  Signals outputs_;
  MarkWorker worker_{riders_, outputs_};
};

TEST_F(MarkWorkerTest, TakesEffectWhereThePathComesToItsBlock) {
  ASSERT_TRUE(riders_.push(rider(5, riders::DigitalOutput{3, true})));
  ASSERT_TRUE(riders_.push(rider(6, riders::AnalogOutput{2, 0.25})));
  ASSERT_TRUE(riders_.push(rider(6, riders::MarkChange{7, true})));
  ASSERT_TRUE(riders_.push(rider(9, riders::MarkChange{7, false})));
  EXPECT_FALSE(cycle(at_block(4)));
  EXPECT_FALSE(outputs_.is_on(3));
  EXPECT_FALSE(cycle(at_block(5)));
  EXPECT_TRUE(outputs_.is_on(3));
  EXPECT_EQ(outputs_.analog[2], 0.0);
  EXPECT_FALSE(cycle(at_block(7)));
  EXPECT_EQ(outputs_.analog[2], 0.25);
  EXPECT_TRUE(worker_.is_set(7));
  EXPECT_FALSE(cycle(at_block(9)));
  EXPECT_FALSE(worker_.is_set(7));
}

TEST_F(MarkWorkerTest, OfAnotherRunOrBeforeAClosedBlockTakesNoEffect) {
  Rider other = rider(1, riders::DigitalOutput{4, true});
  other.tag.run = 2;
  ASSERT_TRUE(riders_.push(other));
  EXPECT_FALSE(cycle(at_block(5)));
  EXPECT_FALSE(outputs_.is_on(4));
  worker_.forget_riders();
  ASSERT_TRUE(riders_.push(rider(5, riders::DigitalOutput{4, true})));
  EXPECT_FALSE(cycle(at_block(5, true)));
  EXPECT_FALSE(outputs_.is_on(4));
}

TEST_F(MarkWorkerTest, TakesEffectBeforeAnItemThatWaitsForItAlone) {
  ASSERT_TRUE(riders_.push(rider(90, riders::DigitalOutput{5, true})));
  ASSERT_TRUE(riders_.push(rider(90, riders::DigitalOutput{6, true})));
  MarkWorker::Progress progress = at_block(2);
  progress.riders_before_item = 1;
  EXPECT_FALSE(cycle(progress));
  EXPECT_TRUE(outputs_.is_on(5));
  EXPECT_FALSE(outputs_.is_on(6));
}

TEST_F(MarkWorkerTest, ClosesThePathAtAMarkUntilAllPartnersAreThere) {
  ASSERT_TRUE(riders_.push(rider(5, riders::SoftMark{1})));
  ASSERT_TRUE(riders_.push(rider(8, riders::SoftMark{2})));
  EXPECT_FALSE(cycle(at_block(3)));
  EXPECT_EQ(worker_.closed_from_block(), 5U);
  EXPECT_FALSE(worker_.is_waiting());  // it is still on its way
  EXPECT_FALSE(cycle(at_block(4, true)));
  EXPECT_TRUE(worker_.is_waiting());
  ASSERT_NE(worker_.soft_mark(), nullptr);
  EXPECT_EQ(mark_of(*worker_.soft_mark()), 1);
  worker_.open();
  EXPECT_EQ(worker_.closed_from_block(), 8U);  // through the first, not through the second
  EXPECT_FALSE(cycle(at_block(4, true)));
  EXPECT_FALSE(worker_.is_waiting());
  ASSERT_NE(worker_.passed_mark(), nullptr);
  EXPECT_EQ(mark_of(*worker_.passed_mark()), 1);
  EXPECT_FALSE(cycle(at_block(6)));
  EXPECT_EQ(worker_.passed_mark(), nullptr);
  EXPECT_EQ(worker_.closed_from_block(), 8U);
}

// Partners are there before the path is: it does not stop.
TEST_F(MarkWorkerTest, FlowsThroughAnOpenMark) {
  ASSERT_TRUE(riders_.push(rider(5, riders::SoftMark{1})));
  EXPECT_FALSE(cycle(at_block(3)));
  worker_.open();
  EXPECT_EQ(worker_.closed_from_block(), no_gate);
  EXPECT_FALSE(cycle(at_block(5)));
  EXPECT_NE(worker_.passed_mark(), nullptr);
  EXPECT_TRUE(riders_.empty());
}

TEST_F(MarkWorkerTest, TellsAMarkThatThePathCameTooFastTo) {
  ASSERT_TRUE(riders_.push(rider(5, riders::SoftMark{1})));
  const auto missed = cycle(at_block(6));
  ASSERT_TRUE(missed);
  EXPECT_EQ(missed->run, 1U);
  EXPECT_EQ(riders_.size(), 1U);
}

// A gate of another kind, a step or a stop of single block, is none of a mark behind it.
TEST_F(MarkWorkerTest, WaitsOnlyAtItsOwnGate) {
  ASSERT_TRUE(riders_.push(rider(5, riders::SoftMark{1})));
  MarkWorker::Progress progress = at_block(2, true);
  progress.closed_block = 3;
  EXPECT_FALSE(cycle(progress));
  EXPECT_FALSE(worker_.is_waiting());
}

TEST_F(MarkWorkerTest, ForgetsWhatHasNotComeToItsPlace) {
  ASSERT_TRUE(riders_.push(rider(5, riders::SoftMark{1})));
  EXPECT_FALSE(cycle(at_block(4, true)));
  worker_.forget_riders();
  EXPECT_FALSE(worker_.is_waiting());
  EXPECT_EQ(worker_.soft_mark(), nullptr);
  EXPECT_EQ(worker_.closed_from_block(), no_gate);
}

}  // namespace
}  // namespace stanok::channels
