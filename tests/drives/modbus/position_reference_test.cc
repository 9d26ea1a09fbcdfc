// What one axis knows of its position, its faults and its following, each part alone.
#include "drives/modbus/position_reference.h"

#include <gtest/gtest.h>

#include <cmath>

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
  FollowingWatch following(0.5, 4000.0);
  EXPECT_FALSE(following.is_exceeded(0.6, milliseconds{0}));
  EXPECT_FALSE(following.is_exceeded(-0.6, milliseconds{100}));
  EXPECT_TRUE(following.is_exceeded(0.6, milliseconds{101}));
  EXPECT_FALSE(following.is_exceeded(0.5, milliseconds{102})) << "it follows again";
  EXPECT_FALSE(following.is_exceeded(0.6, milliseconds{103})) << "the time begins anew";
}

// Targets of an axis at 300 mm/s, every 10 ms, of which the cycle may have lost some.
struct RapidTargets {
  static constexpr double velocity = 300.0;
  FollowingWatch following{0.5, 4000.0};
  double position = 0.0;
  int exchanges = 0;

  milliseconds now() const { return milliseconds{10 * exchanges}; }
  void give(milliseconds lost) {
    ++exchanges;
    position += velocity * 1e-3 * static_cast<double>((milliseconds{10} - lost).count());
    following.note_target(position, velocity, now());
  }
};

TEST(FollowingWatch, AnAxisThatIsPulledBackByLateCyclesFollows) {
  RapidTargets targets;
  targets.give(milliseconds{0});
  for (int k = 0; k < 30; ++k) {
    targets.give(milliseconds{7});  // 2.1 mm behind the drive that went on
    EXPECT_FALSE(targets.following.is_exceeded(-2.1 + 0.5 * 4000.0 * 1e-4, targets.now())) << k;
  }
}

TEST(FollowingWatch, ABlockedAxisIsNoticedThoughCyclesAreLate) {
  RapidTargets targets;
  targets.give(milliseconds{0});
  const double blocked_at = targets.position;
  bool is_noticed = false;
  while (!is_noticed && targets.exchanges < 100) {
    targets.give(milliseconds{7});
    is_noticed = targets.following.is_exceeded(targets.position - blocked_at, targets.now());
  }
  // Of 1.9 mm in 10 ms not more than 1.9 / (1 - exp(-0.1)) = 20 mm are kept, which 0.9 mm in 10 ms
  // pass in 0.23 s.
  EXPECT_LT(targets.now(), milliseconds{340});
}

TEST(FollowingWatch, ATargetThatJumpsBackExplainsNoMoreThanOneThatStands) {
  RapidTargets targets;
  targets.give(milliseconds{0});
  targets.position -= 360.0;
  targets.give(milliseconds{0});
  EXPECT_FALSE(targets.following.is_exceeded(3.6, targets.now())) << "the time begins";
  EXPECT_TRUE(targets.following.is_exceeded(3.6, targets.now() + milliseconds{101}));
}

TEST(FollowingWatch, OneLateTargetIsForgotten) {
  RapidTargets targets;
  targets.give(milliseconds{0});
  targets.give(milliseconds{7});
  while (targets.exchanges < 60) targets.give(milliseconds{0});
  EXPECT_FALSE(targets.following.is_exceeded(0.6, targets.now()));
  EXPECT_TRUE(targets.following.is_exceeded(0.6, targets.now() + milliseconds{101}));
}

TEST(FollowingWatch, BrakingAndUnevenTimesAreNoLateness) {
  FollowingWatch following(0.5, 4000.0);
  double time_s = 0.0;
  for (int k = 0; k < 40; ++k) {  // read a millisecond early and late in turn, and braking
    time_s = 0.01 * k + (k % 2 == 0 ? 0.001 : 0.0);
    const double velocity = 400.0 - 200.0 * 0.01 * k;
    const double position = 400.0 * 0.01 * k - 100.0 * 1e-4 * k * k;
    following.note_target(position, velocity, milliseconds{std::lround(1e3 * time_s)});
  }
  const milliseconds now{std::lround(1e3 * time_s)};
  EXPECT_FALSE(following.is_exceeded(1.0, now)) << "the time begins";
  EXPECT_TRUE(following.is_exceeded(1.0, now + milliseconds{101}));
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
