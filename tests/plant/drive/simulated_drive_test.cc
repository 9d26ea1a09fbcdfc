// A simulated drive seen through its register blocks.
#include "plant/drive/simulated_drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drives/cia402.h"
#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

using drives::CommandBlock;
using drives::DriveState;

SimulatedDriveConfig linear_drive() {
  SimulatedDriveConfig drive;
  drive.registers.axis = "X";
  drive.start = 20.0;
  return drive;
}

class SimulatedDriveTest : public ::testing::Test {
 protected:
  void command(std::uint16_t control_word, double position_mm, double velocity_mm_per_s = 0.0) {
    drive.command(
        {.control_word = control_word,
         .target_position = static_cast<std::int32_t>(std::lround(position_mm * 1e3)),
         .target_velocity = static_cast<std::int32_t>(std::lround(velocity_mm_per_s * 1e3)),
         .heartbeat = ++heartbeat});
  }
  void switch_on() {
    command(0x06, 20.0);
    command(0x0F, 20.0);
    ASSERT_EQ(drive.state(), DriveState::operation_enabled);
  }
  void advance(double time_s) {
    for (int i = 0; i < std::lround(time_s * 1e3); ++i) {
      drive.advance(1e-3);
    }
  }

  SimulatedDrive drive{linear_drive()};
  std::uint16_t heartbeat = 0;
};

TEST_F(SimulatedDriveTest, EchoesTheHeartbeatAndShowsItsPosition) {
  command(0, 0.0);
  EXPECT_EQ(drive.status().heartbeat_echo, heartbeat);
  EXPECT_EQ(drive.status().position, 20000);
  EXPECT_EQ(drives::state_of(drive.status().status_word), DriveState::switch_on_disabled);
}

TEST_F(SimulatedDriveTest, GoesToItsTargetWhenEnabled) {
  switch_on();
  command(0x0F, 20.1);
  advance(0.2);
  EXPECT_EQ(drive.status().position, 20100);
  EXPECT_EQ(drive.status().following_error, 0);
}

TEST_F(SimulatedDriveTest, StaysWhenNotEnabled) {
  command(0x06, 300.0);
  advance(0.2);
  EXPECT_EQ(drive.status().position, 20000);
}

TEST_F(SimulatedDriveTest, BridgesTheTimeBetweenTargetsWithTheirVelocity) {
  switch_on();
  const double v = 100.0;
  for (int poll = 0; poll < 100; ++poll) {
    command(0x0F, 20.0 + v * 0.01 * poll, v);
    advance(0.01);
  }
  // The second-order loop has settled: at constant velocity there is no error between the targets.
  EXPECT_NEAR(drive.motion().position, 20.0 + v, 1e-6);
  EXPECT_NEAR(drive.motion().velocity, v, 1e-6);
}

TEST_F(SimulatedDriveTest, ARepeatedTargetIsNoNews) {
  switch_on();
  command(0x0F, 20.0, 10.0);
  for (int i = 0; i < 5; ++i) {
    advance(0.01);
    command(0x0F, 20.0, 10.0);
  }
  EXPECT_NEAR(drive.motion().position, 20.5, 0.05);  // 10 mm/s for 50 ms, settling
}

TEST_F(SimulatedDriveTest, WatchdogTripsWhenNothingIsWritten) {
  switch_on();
  advance(0.49);
  EXPECT_EQ(drive.state(), DriveState::operation_enabled);
  advance(0.05);
  EXPECT_EQ(drive.state(), DriveState::fault);
  EXPECT_EQ(drive.status().fault_code, 0x8130);
}

TEST_F(SimulatedDriveTest, WatchdogIsLongerThanALongTimeoutOfTheBus) {
  drives::BusConfig bus;
  bus.timeout_ms = 3000;
  bus.axes = {linear_drive().registers};
  drive = SimulatedDrive(drives_of(bus, {}).front());
  switch_on();
  advance(5.9);
  EXPECT_EQ(drive.state(), DriveState::operation_enabled);
  advance(0.2);
  EXPECT_EQ(drive.state(), DriveState::fault);
}

TEST_F(SimulatedDriveTest, ALastingFollowingErrorTrips) {
  SimulatedDriveConfig slow = linear_drive();
  slow.axis.velocity_max = 1.0;
  drive = SimulatedDrive(slow);
  switch_on();
  command(0x0F, 30.0);
  advance(0.3);
  EXPECT_EQ(drive.state(), DriveState::fault);
  EXPECT_EQ(drive.status().fault_code, 0x8611);
}

TEST_F(SimulatedDriveTest, QuickStopEndsAtRestAndDisabled) {
  switch_on();
  for (int poll = 0; poll < 20; ++poll) {
    command(0x0F, 20.0 + poll, 100.0);
    advance(0.01);
  }
  command(0x02, 0.0);
  EXPECT_EQ(drive.state(), DriveState::quick_stop_active);
  advance(0.1);
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(drive.motion().velocity, 0.0);
}

TEST_F(SimulatedDriveTest, BrakeHoldsAgainstTheTarget) {
  switch_on();
  command(0x080F, 20.4);
  advance(0.2);
  EXPECT_EQ(drive.motion().position, 20.0);
  EXPECT_NE(drive.status().status_word & drives::standard_bits.brake_closed, 0);
}

TEST_F(SimulatedDriveTest, TripsOnceAndCanBeReset) {
  switch_on();
  drive.inject(FaultKind::trip);
  EXPECT_EQ(drive.fault(), FaultKind::none);
  advance(0.01);
  EXPECT_EQ(drive.state(), DriveState::fault);
  EXPECT_EQ(drive.status().fault_code, 0x2310);
  command(0x80, 20.0);
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
}

TEST_F(SimulatedDriveTest, StuckFreezesItsAnswers) {
  switch_on();
  drive.inject(FaultKind::stuck);
  const auto frozen = drive.status();
  command(0x0F, 20.3);
  advance(0.2);
  EXPECT_EQ(drive.status(), frozen);
  drive.inject(FaultKind::none);
  EXPECT_EQ(drive.status().position, 20300);
}

TEST_F(SimulatedDriveTest, OffIsSilentAndComesBackDisabled) {
  switch_on();
  drive.inject(FaultKind::off);
  EXPECT_EQ(drive.answer_kind(), AnswerKind::none);
  advance(0.1);
  drive.inject(FaultKind::none);
  EXPECT_EQ(drive.answer_kind(), AnswerKind::normal);
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(drive.status().position, 20000);
}

TEST_F(SimulatedDriveTest, ElsewhereComesBackWithAnotherPosition) {
  drive.inject(FaultKind::elsewhere);
  EXPECT_EQ(drive.answer_kind(), AnswerKind::none);
  drive.inject(FaultKind::none);
  EXPECT_EQ(drive.status().position, 30000);
}

TEST_F(SimulatedDriveTest, IntermittentLosesOneRequestInFive) {
  drive.inject(FaultKind::intermittent);
  int lost = 0;
  for (int i = 0; i < 10000; ++i) {
    lost += drive.answer_kind() == AnswerKind::none ? 1 : 0;
  }
  EXPECT_NEAR(lost, 2000, 200);  // five standard deviations of 40
}

TEST_F(SimulatedDriveTest, ShowsTheLoadOfTheProcess) {
  drive.load({.power_w = 1500.0, .vibration_um = 12.3, .vibration_hz = 85.5});
  EXPECT_EQ(drive.status().power, 1500);
  EXPECT_EQ(drive.status().vibration, 123);
  EXPECT_EQ(drive.status().vibration_frequency, 855);
  drive.load({.power_w = 1e9});
  EXPECT_EQ(drive.status().power, 32767);
}

// The temperature of a steady 1000 W after one time constant: 1 - 1/e of the rise.
TEST_F(SimulatedDriveTest, WarmsUpWithItsPower) {
  drive.load({.power_w = 1000.0});
  EXPECT_EQ(drive.status().temperature, 220);
  for (int i = 0; i < 900; ++i) drive.advance(1.0);
  EXPECT_NEAR(drive.status().temperature, 10.0 * (22.0 + 30.0 * (1.0 - std::exp(-1.0))), 1.0);
}

// Switched on at 20 mm it counts from there; index pulses at 2.05 mm + k 10 mm of the
// machine.
TEST(IncrementalDrive, CountsFromZeroAndShowsSwitchesAndIndexPulses) {
  SimulatedDriveConfig incremental = linear_drive();
  incremental.reference = {.absolute_encoder = false,
                           .home_switch_from = 25.0,
                           .home_switch_to = 40.0,
                           .limit_positive = 26.0,
                           .index_position = 2.05,
                           .index_pitch = 10.0};
  SimulatedDrive drive(incremental);
  EXPECT_EQ(drive.status().position, 0);
  EXPECT_EQ(drive.status().status_word & 1U << 15, 0U) << "not referenced";
  EXPECT_EQ(drive.status().inputs, 0);
  drive.command({.control_word = 0x06});
  const auto go_to = [&](std::int32_t um) {
    drive.command({.control_word = 0x0F, .target_position = um});
    for (int i = 0; i < 300; ++i) drive.advance(1e-3);
  };
  go_to(0);
  for (std::int32_t um = 0; um <= 5500; um += 100) go_to(um);
  EXPECT_EQ(drive.status().position, 5500);
  EXPECT_EQ(drive.status().inputs, 1U << 2) << "home switch";
  EXPECT_EQ(drive.status().index_count, 1);
  EXPECT_EQ(drive.status().index_position, 2050);  // 22.05 - 20 mm
  for (std::int32_t um = 5500; um <= 6100; um += 100) go_to(um);
  EXPECT_EQ(drive.status().inputs, 1U << 2 | 1U << 1);
}

TEST(IncrementalDrive, CountsAnewAfterItWasWithoutPower) {
  SimulatedDriveConfig incremental = linear_drive();
  incremental.reference.absolute_encoder = false;
  SimulatedDrive drive(incremental);
  drive.inject(FaultKind::elsewhere);
  drive.inject(FaultKind::none);
  EXPECT_EQ(drive.status().position, 0);
  EXPECT_EQ(drive.motion().position, 30.0);
}

TEST_F(SimulatedDriveTest, AllocatesNothing) {
  const testing::NoAllocation guard;
  command(0x06, 20.0);
  drive.advance(1e-3);
  static_cast<void>(drive.status());
  drive.inject(FaultKind::stuck);
}

// Cyclic synchronous velocity: the target position is only watched.
TEST(VelocityDrive, FollowsTheTargetVelocityAndReportsItsErrorAgainstTheTargetPosition) {
  SimulatedDriveConfig velocity_drive = linear_drive();
  velocity_drive.kind = PlantKind::velocity_axis;
  velocity_drive.velocity_loop.resonance_hz = 0.0;  // settles within the times below
  SimulatedDrive drive(velocity_drive);
  const auto command = [&](std::uint16_t word, std::int32_t velocity) {
    drive.command({.control_word = word, .target_position = 20100, .target_velocity = velocity});
  };
  command(0x06, 0);
  command(0x0F, 0);
  for (int i = 0; i < 50; ++i) drive.advance(1e-3);
  EXPECT_EQ(drive.status().position, 20000);
  EXPECT_EQ(drive.status().following_error, 100);
  command(0x0F, 5000);
  for (int i = 0; i < 90; ++i) drive.advance(1e-3);
  EXPECT_NEAR(drive.motion().velocity, 5.0, 0.01);
  for (int i = 0; i < 100; ++i) drive.advance(1e-3);  // no news for longer than 0.1 s
  EXPECT_NEAR(drive.motion().velocity, 0.0, 0.01);
}

// An axis of 100 deg/s that is a spindle of 6000 deg/s for a while.
TEST(SpindleAxisDrive, TurnsWithinATurnThenHoldsWhereItStands) {
  SimulatedDriveConfig axis = linear_drive();
  axis.start = 0.0;
  axis.axis.velocity_max = 7200.0;
  SimulatedDrive drive(axis);
  constexpr std::uint16_t spindle = 0x0F | 1U << 12;  // follow the velocity
  const auto run = [&](std::uint16_t word, double position, double velocity, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      drive.command({.control_word = word,
                     .target_position = static_cast<std::int32_t>(std::lround(position * 1e3)),
                     .target_velocity = static_cast<std::int32_t>(std::lround(velocity * 1e3))});
      drive.advance(1e-3);
      EXPECT_EQ(drive.state(), DriveState::operation_enabled);
      EXPECT_GE(drive.status().position, -2000);
      EXPECT_LT(drive.status().position, 362000);
    }
  };
  drive.command({.control_word = 0x06});
  drive.command({.control_word = 0x0F});
  for (int k = 1; k <= 600; ++k) run(spindle, 90.0, 10.0 * k, 1);
  run(spindle, 90.0, 6000.0, 400);
  EXPECT_NEAR(drive.motion().velocity, 6000.0, 1.0);
  EXPECT_EQ(drive.status().following_error, 0);
  for (int k = 599; k >= 0; --k) run(spindle, 90.0, 10.0 * k, 1);
  run(spindle, 90.0, 0.0, 200);
  // The sum of the velocities: 2 x 10 x 600 x 601 / 2 - 6000 on the ramps and 400 x 6000, per ms.
  const double turned = 1e-3 * (10.0 * 600 * 601 - 6000.0 + 400 * 6000.0);
  const double angle = drive.motion().position;
  EXPECT_NEAR(std::remainder(angle - turned, 360.0), 0.0, 0.01);
  run(0x0F, angle, 0.0, 300);
  EXPECT_NEAR(drive.motion().position, angle, 0.001);
}

// An inverter: 18 runs forward, 34 backward, 1 stops, 2 resets; status 3: runs, 80h: fault.
TEST(InverterDrive, ObeysTheWordsOfItsManufacturer) {
  SimulatedDriveConfig inverter = spindle_drive(1, {.speed_max = 6000.0, .acceleration = 6000.0});
  drives::AxisDriveConfig& registers = inverter.registers;
  registers.words = drives::RunWords{.stop = 1,
                                     .run = 18,
                                     .run_reverse = 34,
                                     .fault_reset = 2,
                                     .running = {.mask = 3, .value = 3},
                                     .fault = {.mask = 0x80, .value = 0x80}};
  SimulatedDrive drive(inverter);
  const auto run = [&](std::uint16_t word, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      drive.command({.control_word = word, .target_velocity = 3000});
      drive.advance(1e-3);
    }
  };
  run(34, 600);
  EXPECT_NEAR(drive.motion().velocity, -3000.0, 1e-6);
  EXPECT_EQ(drive.status().velocity, 3000);
  EXPECT_EQ(drive.status().status_word, 3);
  run(1, 600);
  EXPECT_EQ(drive.motion().velocity, 0.0);
  EXPECT_EQ(drive.status().status_word, 0);
  drive.inject(FaultKind::trip);
  run(1, 10);
  EXPECT_EQ(drive.status().status_word, 0x80);
  run(18, 10);
  EXPECT_EQ(drive.status().status_word, 0x80) << "running on is no reset";
  run(2, 1);
  run(18, 600);
  EXPECT_NEAR(drive.motion().velocity, 3000.0, 1e-6);
}

TEST(ContactorDrive, TurnsAtItsOneSpeed) {
  SimulatedDriveConfig contactor = spindle_drive(1, {.speed_max = 1440.0, .acceleration = 0.0});
  contactor.registers.kind = drives::DriveKind::on_off;
  contactor.registers.map = {};
  contactor.registers.map.control_word = {.address = 4};
  contactor.registers.words = drives::RunWords{.stop = 0, .run = 1};
  SimulatedDrive drive(contactor);
  drive.command({.control_word = 1});
  drive.advance(1e-3);
  EXPECT_EQ(drive.motion().velocity, 1440.0);
}

TEST(SpindleDrive, RunsAtTheTargetSpeed) {
  SimulatedDrive drive(spindle_drive(1, {.speed_max = 6000.0, .acceleration = 6000.0}));
  EXPECT_EQ(drive.config().registers.unit, 201);
  for (const std::uint16_t word : std::initializer_list<std::uint16_t>{0x06, 0x07, 0x0F}) {
    drive.command({.control_word = word, .target_velocity = -3000});
  }
  for (int i = 0; i < 600; ++i) {
    drive.advance(1e-3);
    drive.command({.control_word = 0x0F, .target_velocity = -3000});
  }
  EXPECT_EQ(drive.status().velocity, -3000);
  EXPECT_GT(drive.status().power, 0);
}

}  // namespace
}  // namespace stanok::plant
