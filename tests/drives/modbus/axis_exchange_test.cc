// Supervision of one drive: what it is told and what of its answers is believed.
#include "drives/modbus/axis_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/no_allocation.h"

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

constexpr BusTime poll_time = milliseconds{10};
constexpr BusTime drive_timeout = milliseconds{250};

// A drive that answers as the test says, one poll after the other.
class AxisExchangeTest : public ::testing::Test {
 protected:
  static AxisDriveConfig config() {
    return {.axis = "X",
            .following_error_max = 0.5,
            .velocity_max = 400.0,
            .acceleration_max = 1000.0,
            .target_acceleration_max = 1000.0};
  }

  // One good exchange; the drive is in `state` at `position_mm`.
  std::optional<ExchangeError> answer(double position_mm,
                                      DriveState state = DriveState::operation_enabled) {
    sent = exchange.command(target, TargetAge::fresh);
    now += poll_time;
    StatusBlock block{.status_word = state_bits(state)};
    block.status_word |= standard_bits.referenced;
    if (has_voltage) block.status_word |= status::voltage_enabled;
    block.position = static_cast<std::int32_t>(std::lround(position_mm * 1000.0));
    block.velocity = velocity_mm_per_s * 1000;
    block.following_error = following_error_um;
    block.heartbeat_echo = sent.heartbeat;
    const auto error = exchange.take(block, now, now);
    exchange.supervise(now);
    return error;
  }

  void no_answer() {
    sent = exchange.command(target, TargetAge::fresh);
    now += poll_time;
    exchange.fail(ExchangeError::timeout);
    exchange.supervise(now);
  }

  // Contact is lost, and comes back with the drive at `position_mm`.
  void lose_and_find_again(double position_mm) {
    while (!exchange.contact().is_lost()) {
      no_answer();
    }
    for (int i = 0; i < 100 && exchange.contact().is_lost(); ++i) {
      answer(position_mm, DriveState::switch_on_disabled);
    }
  }

  // The drive stands where the cycle wants it, and follows from now on.
  void take_over(double position_mm) {
    answer(position_mm);
    answer(position_mm);
  }

  // At 100 mm/s, seen last at 10 mm.
  void lose_in_motion_and_find_again(double position_mm, int polls_away = 0) {
    target.position = 4.0;
    take_over(4.0);
    velocity_mm_per_s = 100;
    target.velocity = 100.0;
    for (target.position = 5.0; target.position < 10.0; target.position += 1.0)
      answer(target.position);
    answer(10.0);
    while (!exchange.contact().is_lost()) {
      target.position += 1.0;
      no_answer();
    }
    velocity_mm_per_s = 0;
    for (int i = 0; i < polls_away; ++i) no_answer();
    lose_and_find_again(position_mm);
  }

  AxisExchange exchange{config(), poll_time, drive_timeout};
  bool has_voltage = false;  // as its status word says
  DriveTarget target{.enabled = true, .brake_closed = false};
  CommandBlock sent;
  BusTime now{0};
  int velocity_mm_per_s = 0;
  int following_error_um = 0;
};

TEST_F(AxisExchangeTest, PositionComesWithTheTargetOfItsExchange) {
  target.position = 0.25;
  answer(0.2);
  answer(0.2);
  EXPECT_EQ(exchange.feedback().target_position, 0.25);
  target.position = 0.5;
  no_answer();
  EXPECT_EQ(exchange.feedback().target_position, 0.25);
  EXPECT_EQ(exchange.feedback().position, 0.2);
}

TEST_F(AxisExchangeTest, FeedbackIsInvalidBeforeTheFirstAnswer) {
  EXPECT_FALSE(exchange.feedback().valid);
  EXPECT_EQ(answer(1.5), std::nullopt);
  EXPECT_TRUE(exchange.feedback().valid);
  EXPECT_EQ(exchange.feedback().position, 1.5);
}

TEST_F(AxisExchangeTest, SendsTargetsInIncrements) {
  target.position = 12.345;
  target.velocity = -3.5;
  answer(12.3);
  answer(12.3);
  EXPECT_EQ(sent.target_position, 12345);
  EXPECT_EQ(sent.target_velocity, -3500);
}

TEST_F(AxisExchangeTest, WhileItIsOffTheTargetIsWhereTheDriveStands) {
  target.position = 120.0;
  answer(1.5, DriveState::ready_to_switch_on);
  for (int i = 0; i < 10; ++i) {
    answer(2.5 + i, DriveState::ready_to_switch_on);
    EXPECT_EQ(sent.target_position, i == 0 ? 1500 : 1500 + 1000 * i);
    EXPECT_EQ(sent.target_velocity, 0);
    EXPECT_EQ(sent.control_word, control_word(DriveState::ready_to_switch_on, PowerRequest::off))
        << "not enabled towards 120 mm";
  }
  target.position = 11.6;
  answer(11.6, DriveState::operation_enabled);
  EXPECT_EQ(sent.control_word, control_word(DriveState::ready_to_switch_on, PowerRequest::on));
  EXPECT_EQ(sent.target_position, 11500);
  answer(11.6, DriveState::operation_enabled);
  EXPECT_EQ(sent.target_position, 11600);
}

TEST_F(AxisExchangeTest, ADriveFoundOnIsSwitchedOffWhereItStands) {
  target = {.position = 120.0, .brake_closed = false};
  answer(1.5);
  answer(1.5);
  EXPECT_EQ(sent.target_position, 1500);
  EXPECT_EQ(sent.control_word, control_word(DriveState::operation_enabled, PowerRequest::off));
}

TEST_F(AxisExchangeTest, WhatDropsOutIsNotEnabledAgainByItself) {
  answer(0.0);
  answer(0.0);
  answer(0.0, DriveState::switch_on_disabled);
  for (int i = 0; i < 10; ++i) {
    answer(0.0, DriveState::ready_to_switch_on);
    EXPECT_NE(sent.control_word & control::no_quick_stop, control::no_quick_stop);
  }
}

TEST_F(AxisExchangeTest, BrakeBitFollowsTheTarget) {
  answer(0.0);
  EXPECT_EQ(sent.control_word & standard_bits.close_brake, 0);
  target.brake_closed = true;
  answer(0.0);
  EXPECT_NE(sent.control_word & standard_bits.close_brake, 0);
}

TEST_F(AxisExchangeTest, NeverSendsATargetThatIsNoNumber) {
  target.position = 7.0;
  answer(7.0);
  target.position = std::numeric_limits<double>::quiet_NaN();
  target.velocity = 100.0;
  answer(7.0);
  EXPECT_EQ(sent.target_position, 7000);
  EXPECT_EQ(sent.target_velocity, 0);
  EXPECT_EQ(sent.control_word,
            control_word(DriveState::operation_enabled, PowerRequest::quick_stop));
}

TEST_F(AxisExchangeTest, AnAnswerWithoutEchoIsStuckAndDiscarded) {
  answer(1.0);
  sent = exchange.command(target, TargetAge::fresh);
  StatusBlock old{.status_word = state_bits(DriveState::operation_enabled), .position = 5000};
  old.heartbeat_echo = static_cast<std::uint16_t>(sent.heartbeat - 1);
  EXPECT_EQ(exchange.take(old, now, now), ExchangeError::stuck);
  EXPECT_EQ(exchange.feedback().position, 1.0);
  EXPECT_EQ(exchange.contact().error_count(), 1U);
}

TEST_F(AxisExchangeTest, AWordThatIsNoStateIsImplausible) {
  sent = exchange.command(target, TargetAge::fresh);
  EXPECT_EQ(exchange.take({.status_word = 0xFFFF, .heartbeat_echo = sent.heartbeat}, now, now),
            ExchangeError::implausible);
  EXPECT_FALSE(exchange.feedback().valid);
}

TEST_F(AxisExchangeTest, AJumpInSightIsImplausible) {
  answer(10.0);
  // In 10 ms at twice 400 mm/s the axis travels 8 mm.
  EXPECT_EQ(answer(18.4), std::nullopt);
  EXPECT_EQ(answer(30.0), ExchangeError::implausible);
  EXPECT_EQ(exchange.feedback().position, 18.4);
}

TEST_F(AxisExchangeTest, AnAnswerReadLateMakesTheNextOneNoJump) {
  sent = exchange.command(target, TargetAge::fresh);
  StatusBlock block{.status_word = state_bits(DriveState::operation_enabled)};
  block.heartbeat_echo = sent.heartbeat;
  // Read 40 ms after it was sampled; the next one, right after it, shows where the axis is now.
  const BusTime asked = now;
  now += milliseconds{40};
  EXPECT_EQ(exchange.take(block, asked, now), std::nullopt);
  block.heartbeat_echo = exchange.command(target, TargetAge::fresh).heartbeat;
  block.position = 16000;  // 400 mm/s
  EXPECT_EQ(exchange.take(block, now, now), std::nullopt);
}

TEST_F(AxisExchangeTest, AVelocityOutOfReachIsImplausible) {
  velocity_mm_per_s = 801;
  EXPECT_EQ(answer(0.0), ExchangeError::implausible);
}

TEST_F(AxisExchangeTest, ContactIsLostAfterTheTimeout) {
  answer(0.0);
  const BusTime last = now;
  while (!exchange.contact().is_lost()) {
    EXPECT_TRUE(exchange.feedback().valid);
    now += milliseconds{1};
    exchange.supervise(now);
  }
  EXPECT_GT(now - last, drive_timeout);
  EXPECT_LE(now - last, drive_timeout + milliseconds{1});
  EXPECT_FALSE(exchange.feedback().valid);
  EXPECT_EQ(exchange.feedback().losses, 1U);
}

TEST_F(AxisExchangeTest, OneFailureInFiveIsBorneOneInTwoIsNot) {
  for (int i = 0; i < 10000; ++i) {
    i % 5 == 0 ? no_answer() : static_cast<void>(answer(0.0));
    ASSERT_FALSE(exchange.contact().is_lost()) << i;
  }
  int exchanges = 0;
  while (!exchange.contact().is_lost() && exchanges < 1000) {
    exchanges++ % 2 == 0 ? no_answer() : static_cast<void>(answer(0.0));
  }
  // Up by 3, down by 1: 200 is reached within 200 exchanges.
  EXPECT_LE(exchanges, 200);
}

TEST_F(AxisExchangeTest, OneFailureInFiveIsBorneWhenItComesAtRandom) {
  const unsigned seed = 23;
  std::mt19937 random(seed);
  for (int i = 0; i < 300000; ++i) {
    random() % 5 == 0 ? no_answer() : static_cast<void>(answer(0.0));
    ASSERT_FALSE(exchange.contact().is_lost()) << i << ", seed " << seed;
  }
}

TEST_F(AxisExchangeTest, ThreeFailuresInTenAreNotBorne) {
  const unsigned seed = 23;
  std::mt19937 random(seed);
  int exchanges = 0;
  while (!exchange.contact().is_lost() && exchanges < 20000) {
    random() % 10 < 3 ? no_answer() : static_cast<void>(answer(0.0));
    ++exchanges;
  }
  EXPECT_LT(exchanges, 20000) << "seed " << seed;
}

TEST_F(AxisExchangeTest, NothingResumesByItselfAfterALoss) {
  answer(0.0);
  lose_and_find_again(0.0);
  ASSERT_TRUE(exchange.feedback().valid);
  for (int i = 0; i < 100; ++i) {
    answer(0.0, DriveState::ready_to_switch_on);
    ASSERT_EQ(sent.control_word,
              control_word(DriveState::switch_on_disabled, PowerRequest::quick_stop));
  }
  target.enabled = false;
  answer(0.0, DriveState::ready_to_switch_on);
  target.enabled = true;
  answer(0.0, DriveState::ready_to_switch_on);
  EXPECT_EQ(sent.control_word, control_word(DriveState::ready_to_switch_on, PowerRequest::on));
}

TEST_F(AxisExchangeTest, StaleTargetsStopTheDriveUntilEnabledAnew) {
  answer(0.0);
  const auto stopped = control_word(DriveState::operation_enabled, PowerRequest::quick_stop);
  EXPECT_EQ(exchange.command(target, TargetAge::stale).control_word, stopped);
  EXPECT_EQ(exchange.command(target, TargetAge::fresh).control_word, stopped);
}

TEST_F(AxisExchangeTest, ADriveThatComesBackElsewhereIsNotReferenced) {
  answer(10.0);
  lose_and_find_again(10.6);
  EXPECT_TRUE(exchange.feedback().valid);
  EXPECT_FALSE(exchange.feedback().referenced);
  target.position_accepted = true;
  answer(10.6);
  EXPECT_TRUE(exchange.feedback().referenced);
}

TEST_F(AxisExchangeTest, AMovingDriveMayComeToRestOutOfSight) {
  lose_in_motion_and_find_again(34.0);
  EXPECT_TRUE(exchange.feedback().referenced);
}

// 100 mm/s carry it from 10 mm to 36 mm before the loss is noticed, braking with 1000 mm/s^2 takes
// 5 mm, and 0.5 mm is the following error.
TEST_F(AxisExchangeTest, AMovingDriveIsNoFurtherThanItCanHaveMoved) {
  lose_in_motion_and_find_again(41.4);
  EXPECT_TRUE(exchange.feedback().referenced);
}

TEST_F(AxisExchangeTest, AMovingDriveThatWentTooFarIsNotReferenced) {
  lose_in_motion_and_find_again(41.6);
  EXPECT_FALSE(exchange.feedback().referenced);
}

TEST_F(AxisExchangeTest, AMovingDriveThatTurnedBackIsNotReferenced) {
  lose_in_motion_and_find_again(9.4);
  EXPECT_FALSE(exchange.feedback().referenced);
}

// However long it was away: it had to come to rest at once.
TEST_F(AxisExchangeTest, TimeOutOfSightMakesTheReachNoLonger) {
  lose_in_motion_and_find_again(60.0, 1000);
  EXPECT_FALSE(exchange.feedback().referenced);
}

// Some drives never tell; one that did and does not any more holds nothing.
TEST_F(AxisExchangeTest, ADriveWhoseVoltageGoesDoesNotHoldItsAxis) {
  has_voltage = false;
  take_over(0.0);
  EXPECT_EQ(exchange.feedback().state, DriveState::operation_enabled);
  has_voltage = true;
  take_over(0.0);
  EXPECT_EQ(exchange.feedback().state, DriveState::operation_enabled);
  has_voltage = false;
  answer(0.0);
  EXPECT_NE(exchange.feedback().state, DriveState::operation_enabled);
}

TEST_F(AxisExchangeTest, OneDemandResetsOneFault) {
  target.fault_reset = true;
  answer(0.0, DriveState::fault);  // the fault is not known when this command is sent
  answer(0.0, DriveState::fault);
  EXPECT_EQ(sent.control_word & control::fault_reset, 0) << "the demand came before the fault";
  target.fault_reset = false;
  answer(0.0, DriveState::fault);
  target.fault_reset = true;
  answer(0.0, DriveState::switch_on_disabled);
  EXPECT_NE(sent.control_word & control::fault_reset, 0);
  answer(0.0, DriveState::fault);
  answer(0.0, DriveState::fault);
  EXPECT_EQ(sent.control_word & control::fault_reset, 0) << "a fault that comes again stays";
}

TEST_F(AxisExchangeTest, FollowingErrorCountsOnlyWhenItLasts) {
  following_error_um = 600;
  for (int i = 0; i < 10; ++i) {
    answer(0.0);
    EXPECT_FALSE(exchange.feedback().following_error_exceeded);
  }
  following_error_um = 400;
  answer(0.0);
  following_error_um = -600;
  for (int i = 0; i < 12; ++i) {
    answer(0.0);
  }
  EXPECT_TRUE(exchange.feedback().following_error_exceeded);
  EXPECT_EQ(exchange.feedback().following_error, -0.6);
}

// At 100 mm/s a poll of 10 ms is 1 mm. The drive says of itself that it follows.
TEST_F(AxisExchangeTest, AnAxisThatStandsUnderMovingTargetsIsNoticed) {
  for (int i = 0; i < 20; ++i) answer(0.0);
  int polls = 0;
  while (!exchange.feedback().following_error_exceeded && polls < 100) {
    target.position += 1.0;
    answer(0.0);
    ++polls;
  }
  // More than 0.5 mm off from the second poll on, for 100 ms.
  EXPECT_EQ(polls, 2 + 11);
  EXPECT_NEAR(exchange.feedback().following_error, 12.0, 1e-9);
}

// The loop of the cycle asks for 40/s of the error in addition, up to the greatest velocity.
TEST_F(AxisExchangeTest, AVelocityDriveThatStandsIsNoticedThoughItsVelocityGrows) {
  AxisDriveConfig velocity_drive = config();
  velocity_drive.kind = DriveKind::velocity;
  exchange = AxisExchange(velocity_drive, poll_time, drive_timeout);
  for (int i = 0; i < 20; ++i) answer(0.0);
  int polls = 0;
  while (!exchange.feedback().following_error_exceeded && polls < 100) {
    target.position += 1.0;
    target.velocity = std::min(400.0, 100.0 + 40.0 * target.position);
    answer(0.0);
    ++polls;
  }
  EXPECT_EQ(polls, 2 + 11);
}

TEST_F(AxisExchangeTest, AnAxisBetweenTheLastTwoTargetsFollows) {
  for (const double behind_polls : {0.0, 0.5, 1.0}) {
    target.position = 0.0;
    exchange = AxisExchange{config(), poll_time, drive_timeout};
    take_over(0.0);
    for (int i = 0; i < 500; ++i) {
      const double before = target.position;
      target.position += 4.0;  // 400 mm/s
      answer(target.position - behind_polls * (target.position - before));
      ASSERT_EQ(exchange.feedback().following_error, 0.0) << i;
    }
  }
}

// What was sent in vain may have arrived: the drive is somewhere between.
TEST_F(AxisExchangeTest, LostAnswersMakeNoFollowingError) {
  take_over(0.0);
  for (int i = 0; i < 500; ++i) {
    target.position += 1.0;
    const double oldest = target.position - 2.0;  // of the last answer but one
    i % 5 == 0 ? no_answer() : static_cast<void>(answer(i % 5 == 1 ? oldest : target.position));
    ASSERT_FALSE(exchange.feedback().following_error_exceeded) << i;
    ASSERT_EQ(exchange.feedback().following_error, 0.0) << i;
  }
}

TEST_F(AxisExchangeTest, APositionThatIsOffAtRestIsNoticed) {
  take_over(0.0);
  for (int i = 0; i < 13; ++i) answer(-0.6);
  EXPECT_TRUE(exchange.feedback().following_error_exceeded);
  EXPECT_NEAR(exchange.feedback().following_error, 0.6, 1e-9);
}

TEST_F(AxisExchangeTest, ADriveWithoutThisRegisterIsWatchedAllTheSame) {
  AxisDriveConfig bare = config();
  bare.map.following_error = {};
  exchange = AxisExchange{bare, poll_time, drive_timeout};
  take_over(0.0);
  for (int i = 0; i < 30; ++i) {
    target.position += 1.0;
    answer(0.0);
  }
  EXPECT_TRUE(exchange.feedback().following_error_exceeded);
}

TEST_F(AxisExchangeTest, SurvivesArbitraryAnswers) {
  const unsigned seed = 23;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 65535);
  const RegisterMap standard = register_map({});
  answer(1.0);
  for (int i = 0; i < 20000; ++i) {
    sent = exchange.command(target, TargetAge::fresh);
    std::vector<std::uint16_t> registers(static_cast<std::size_t>(register_count(standard)));
    for (auto& value : registers) {
      value = static_cast<std::uint16_t>(any(random));
    }
    now += poll_time;
    if (exchange.take(status_block(standard, registers), now, now)) {
      exchange.supervise(now);
    }
    ASSERT_TRUE(std::isfinite(exchange.feedback().position)) << "seed " << seed;
  }
  EXPECT_GE(exchange.contact().error_count(), 19990U)
      << "an echo by chance is 1 in 65536; seed " << seed;
  EXPECT_TRUE(exchange.contact().is_lost());
}

TEST_F(AxisExchangeTest, AllocatesNothing) {
  const testing::NoAllocation guard;
  answer(0.0);
  no_answer();
}

}  // namespace
}  // namespace stanok::drives
