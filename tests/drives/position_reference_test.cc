// What one axis knows of its position, its faults and its following, each part alone.
#include "drives/modbus/position_reference.h"

#include <gtest/gtest.h>

#include "drives/modbus/fault_reset.h"
#include "drives/modbus/following_watch.h"

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

constexpr Band reach{.low = -1.0, .high = 2.0};

DriveTarget accepted(double offset) {
  DriveTarget target;
  target.position_accepted = true;
  target.position_offset = offset;
  return target;
}

TEST(PositionReference, TheOffsetCountsOnlyWhereThePositionIsAccepted) {
  PositionReference reference(Encoder::incremental);
  DriveTarget target = accepted(12.5);
  target.position_accepted = false;
  reference.take(target);
  EXPECT_EQ(reference.offset(), 0.0);
  reference.take(accepted(12.5));
  EXPECT_EQ(reference.offset(), 12.5);
  EXPECT_TRUE(reference.is_accepted());
  EXPECT_FALSE(reference.is_found()) << "no answer has confirmed it";
  reference.confirm();
  EXPECT_TRUE(reference.is_found());
}

TEST(PositionReference, AnAxisThatWentFurtherOutOfSightThanItCanHasLostIt) {
  PositionReference reference(Encoder::absolute);
  reference.confirm();
  reference.lose_sight(reach);
  reference.see_again(-1.0);
  reference.see_again(2.0);
  EXPECT_FALSE(reference.has_moved_out_of_sight());
  reference.see_again(2.001);
  EXPECT_TRUE(reference.has_moved_out_of_sight());
  reference.see_again(0.0);
  EXPECT_TRUE(reference.has_moved_out_of_sight()) << "until it is found again";
  reference.confirm();
  EXPECT_FALSE(reference.has_moved_out_of_sight());
}

TEST(PositionReference, AnIncrementalEncoderLosesItWithContact) {
  for (const Encoder encoder : {Encoder::incremental, Encoder::absolute}) {
    PositionReference reference(encoder);
    reference.confirm();
    reference.lose_sight(reach);
    EXPECT_EQ(reference.is_found(), encoder == Encoder::absolute);
    EXPECT_FALSE(reference.has_moved_out_of_sight());
  }
}

TEST(FollowingWatch, AShortExcursionIsALateTarget) {
  FollowingWatch following(0.5);
  EXPECT_FALSE(following.is_exceeded(0.6, milliseconds{0}));
  EXPECT_FALSE(following.is_exceeded(-0.6, milliseconds{100}));
  EXPECT_TRUE(following.is_exceeded(0.6, milliseconds{101}));
  EXPECT_FALSE(following.is_exceeded(0.5, milliseconds{102})) << "it follows again";
  EXPECT_FALSE(following.is_exceeded(0.6, milliseconds{103})) << "the time begins anew";
}

TEST(FaultReset, OneDemandResetsOneFault) {
  FaultReset reset;
  DriveTarget target;
  target.fault_reset = true;
  reset.look(target, DriveState::fault);
  EXPECT_TRUE(reset.is_pending());
  reset.look(target, DriveState::switch_on_disabled);
  EXPECT_FALSE(reset.is_pending());
  reset.look(target, DriveState::fault);
  EXPECT_FALSE(reset.is_pending()) << "the fault came again";
  target.fault_reset = false;
  reset.look(target, DriveState::fault);
  target.fault_reset = true;
  reset.look(target, DriveState::fault);
  EXPECT_TRUE(reset.is_pending()) << "a new demand";
}

}  // namespace
}  // namespace stanok::drives
