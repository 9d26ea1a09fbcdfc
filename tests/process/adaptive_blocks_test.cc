// The blocks of the adaptive system one by one, against their equations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "process/adaptive/clock_block.h"
#include "process/adaptive/idle_power_compensator.h"
#include "process/adaptive/oscillation.h"
#include "process/adaptive/power_correction.h"
#include "process/adaptive/radius_counter.h"
#include "process/adaptive/setpoint_law.h"
#include "process/adaptive/vibration_amplifier.h"

namespace stanok::process {
namespace {

using std::numbers::pi;

// 1000 N at 600 rev/min on 50 mm: 1000 N x 62.83 rad/s x 0.05 m.
TEST(ComputingBlock, IsForceTimesSpeedOfTheCut) {
  const ComputingBlock block{.omega = angular_speed(600.0), .radius_mm = 50.0};
  EXPECT_NEAR(block.power_w(1000.0), 1000.0 * 2.0 * pi * 10.0 * 0.05, 1e-9);
  EXPECT_NEAR(block.force_n(block.power_w(1234.5)), 1234.5, 1e-9);
  const ComputingBlock lossy{.omega = block.omega, .radius_mm = 50.0, .efficiency = 0.8};
  EXPECT_NEAR(lossy.power_w(1000.0), block.power_w(1000.0) / 0.8, 1e-9);
}

TEST(ComputingBlock, KnowsNoForceWhereThePowerSaysNothing) {
  EXPECT_EQ((ComputingBlock{.omega = 0.0, .radius_mm = 50.0}.force_n(100.0)), 0.0);
  EXPECT_EQ((ComputingBlock{.omega = 60.0, .radius_mm = 0.0}.force_n(100.0)), 0.0);
}

TEST(Comparator, IsAboveZeroUnderOverload) {
  EXPECT_EQ(deviation_w(2500.0, 300.0, 2000.0), 200.0);
  EXPECT_EQ(deviation_w(2100.0, 300.0, 2000.0), -200.0);
}

// The feed does not see speed and radius, only how the setpoint swings.
TEST(ClockBlock, IsNormalisedBySpeedAndRadius) {
  for (const double radius : {60.0, 40.0, 5.0}) {
    for (const double speed : {100.0, 900.0}) {
      const ComputingBlock block{.omega = angular_speed(speed), .radius_mm = radius};
      EXPECT_NEAR(clock_part(block, block.power_w(1300.0), 1000.0), 1.3, 1e-12);
    }
  }
}

TEST(RapidKey, PassesTheCodeOfTheProgramUnderTheRapidFlag) {
  EXPECT_EQ(rapid_key(Traverse::rapid, 300.0, 2.0), 300.0);
  EXPECT_EQ(rapid_key(Traverse::feed, 300.0, 2.0), 2.0);
}

// Random moves in whole increments and between, and overhang commands: the counter is where the
// slide and the overhangs are, to one increment; the drive gets the pulses of the moves and no
// others.
TEST(RadiusCounter, IsExactToOneIncrementAndKeepsOverhangsFromTheDrive) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step_mm(-0.8, 0.8);
  std::uniform_real_distribution<double> overhang_mm(-10.0, 10.0);
  constexpr double increment = 0.0005;
  RadiusCounter counter;
  OverhangKey key;
  double slide = 100.0;
  double overhang = 0.0;
  std::int64_t code = std::llround(slide / increment);
  std::int64_t to_drive = 0;
  counter.preset(slide, {.position_mm = slide, .code = code, .increment_mm = increment});
  for (int k = 0; k < 20000; ++k) {
    if (k % 997 == 0) {
      overhang = overhang_mm(random);
      key.set_blocked(true);
      to_drive += key.pass(std::llround(overhang / increment));
      counter.preset(slide + overhang,
                     {.position_mm = slide, .code = code, .increment_mm = increment});
      key.set_blocked(false);
    } else {
      slide += step_mm(random);
      const std::int64_t next = std::llround(slide / increment);
      to_drive += key.pass(next - code);
      counter.count(key.pass(next - code));
      code = next;
    }
    ASSERT_LE(std::abs(static_cast<double>(counter.code()) - (slide + overhang) / increment),
              1.0 + 1e-6);
  }
  EXPECT_EQ(to_drive, code - std::llround(100.0 / increment));
}

// Compensator: a spindle with the idle power of the plant, P (n/2 + n^2/2).
class IdlePower : public ::testing::Test {
 protected:
  static double idle_w(double rev_per_min) {
    const double r = rev_per_min / 3000.0;
    return 600.0 * 0.5 * (r + r * r);
  }
  void run(double seconds) {
    for (int k = 0; k < static_cast<int>(std::lround(seconds / cut.cycle_s)); ++k) {
      cut.power_w = idle_w(cut.rev_per_min) + load_w;
      compensator.advance(cut);
    }
  }
  void start(double rev_per_min) {
    ++cut.spindle_starts;
    cut.rev_per_min = rev_per_min;
    cut.at_speed = true;
  }

  IdlePowerCompensator compensator{ForceControlConfig{.idle_settle_s = 0.3, .idle_capture_s = 0.2}};
  motion::CutState cut;
  double load_w = 0.0;
};

TEST_F(IdlePower, IsTakenAfterEachStartAtSpeedSettledAndIdle) {
  start(600.0);
  run(0.49);
  EXPECT_FALSE(compensator.is_captured());
  run(0.03);
  ASSERT_TRUE(compensator.is_captured());
  EXPECT_NEAR(compensator.power_w(600.0), idle_w(600.0), 1e-9);
  start(600.0);  // stopped and started
  run(0.001);
  EXPECT_FALSE(compensator.is_captured());
  run(0.6);
  EXPECT_EQ(compensator.captures(), 2U);
}

TEST_F(IdlePower, IsNeverTakenWhileTheSpindleAccelerates) {
  start(0.0);
  cut.at_speed = false;
  for (int k = 0; k < 1000; ++k) {
    cut.rev_per_min += 0.5;
    load_w = 2000.0;
    run(cut.cycle_s);
    ASSERT_EQ(compensator.captures(), 0U);
  }
  cut.at_speed = true;
  load_w = 0.0;
  run(0.6);
  EXPECT_NEAR(compensator.power_w(cut.rev_per_min), idle_w(cut.rev_per_min), 1e-9);
}

TEST_F(IdlePower, IsNeverTakenWhileTheToolCuts) {
  start(600.0);
  cut.feed_programmed = cut.path_speed = 2.0;
  load_w = 1500.0;
  run(5.0);
  EXPECT_EQ(compensator.captures(), 0U);
  cut.feed_programmed = 0.0;  // rapid
  load_w = 0.0;
  run(0.6);
  EXPECT_EQ(compensator.captures(), 1U);
  EXPECT_NEAR(compensator.power_w(600.0), idle_w(600.0), 1e-9);
}

TEST_F(IdlePower, IsScaledWithTheSpeedAndTakenAnewWhenItCanBe) {
  start(1000.0);
  run(0.6);
  // In the share k = 1/2 of n_0 = 1000: half grows with n, half with its square.
  EXPECT_NEAR(compensator.power_w(2000.0), compensator.power_w(1000.0) * (0.5 * 2.0 + 0.5 * 4.0),
              1e-9);
  cut.rev_per_min = 2000.0;
  run(0.6);
  EXPECT_EQ(compensator.captures(), 2U);
  EXPECT_NEAR(compensator.power_w(2000.0), idle_w(2000.0), 1e-9);
}

TEST(VibrationAmplifier, LetsNothingThroughWithinItsLevelAndTheWholeAmplitudeAbove) {
  VibrationAmplifier amplifier;
  amplifier.set_level(5.0);
  EXPECT_EQ(amplifier.pass({4.9, 100.0}, 0.8).amplitude_um, 0.0);
  const Vibration above = amplifier.pass({12.0, 100.0}, 0.8);
  EXPECT_NEAR(above.amplitude_um, 12.0, 1e-12);
  EXPECT_EQ(above.frequency_hz, 100.0);
}

TEST(VibrationAmplifier, HasHysteresis) {
  VibrationAmplifier amplifier;
  amplifier.set_level(5.0);
  EXPECT_GT(amplifier.pass({5.1, 100.0}, 0.8).amplitude_um, 0.0);
  EXPECT_GT(amplifier.pass({4.1, 100.0}, 0.8).amplitude_um, 0.0) << "still above the release";
  EXPECT_EQ(amplifier.pass({3.9, 100.0}, 0.8).amplitude_um, 0.0);
  EXPECT_EQ(amplifier.pass({4.1, 100.0}, 0.8).amplitude_um, 0.0) << "not yet at the level again";
  EXPECT_EQ(amplifier.pass({std::nan(""), 0.0}, 0.8).amplitude_um, 0.0);
}

// 20 um at 100 Hz on 2 kg, swung at 4 Hz: 20e-6 / 1.4142 x 2 x |628.3^2 - 25.13^2|.
TEST(QuenchingForce, HasTheSquaresOfTheFrequencies) {
  EXPECT_NEAR(
      quenching_force_n({20.0, 100.0}, 2.0, 4.0),
      20e-6 / std::sqrt(2.0) * 2.0 * (std::pow(2.0 * pi * 100.0, 2) - std::pow(2.0 * pi * 4.0, 2)),
      1e-9);
}

// A sine of the feed averaged over a revolution, numerically.
TEST(ChipPart, IsTheMeanOverOneRevolution) {
  for (const double turns : {0.1, 0.5, 0.9, 1.5, 2.3}) {
    double sine = 0.0;
    double cosine = 0.0;
    constexpr int steps = 100000;
    for (int k = 0; k < steps; ++k) {
      const double angle = 2.0 * pi * turns * (k + 0.5) / steps;
      sine += std::sin(angle) / steps;
      cosine += std::cos(angle) / steps;
    }
    EXPECT_NEAR(chip_part(turns / 0.1, 0.1), std::hypot(sine, cosine), 1e-6) << turns;
  }
}

TEST(FormableFrequency, StaysAwayFromMultiplesOfTheSpindle) {
  const double revolution_s = 0.1;
  for (double frequency = 0.5; frequency < 60.0; frequency += 0.1) {
    const double formable = formable_frequency(frequency, revolution_s);
    const double turns = formable * revolution_s;
    EXPECT_TRUE(turns < 0.85 + 1e-9 || std::abs(turns - std::round(turns)) >= 0.15 - 1e-9)
        << frequency;
    EXPECT_LE(std::abs(formable - frequency), 0.5 / revolution_s + 1e-9);
  }
  EXPECT_EQ(formable_frequency(4.0, revolution_s), 4.0);
}

TEST(SetpointLaw, IsConstantToTheBitWithoutOscillation) {
  SetpointLaw law(ForceControlConfig{});
  law.set_mean(1234.5678);
  for (int k = 0; k < 1000; ++k) {
    const ForceSetpoint setpoint = law.advance({.cuts = true});
    ASSERT_EQ(setpoint.now_n, 1234.5678);
    ASSERT_EQ(setpoint.emphasised_n, 1234.5678);
  }
}

TEST(SetpointLaw, LimitsWhatTheFeedCannotForm) {
  SetpointLaw law({.feed_exponent = 0.75});
  law.set_mean(1000.0);
  law.set_programmed({.force_n = 900.0, .frequency_hz = 5.0});
  const ForceSetpoint setpoint = law.advance({.revolution_s = 0.1, .cuts = true});
  EXPECT_EQ(law.event(), motion::ForceEvent::oscillation_limited);
  EXPECT_GT(setpoint.emphasised_n, 0.0);
  // 0.9 of the feed, through the chip (2/pi at half a turn) and the exponent.
  EXPECT_NEAR(law.oscillation().force_n, 900.0 * 0.75 * 2.0 / pi, 1e-9);
}

}  // namespace
}  // namespace stanok::process
