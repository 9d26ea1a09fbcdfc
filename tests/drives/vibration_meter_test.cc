// The meter against signals whose lines are known: noise, two lines, run-out, a drifting spindle.
#include "drives/vibration_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/support/no_allocation.h"

namespace stanok::drives {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rate = 4000.0;

struct Signal {
  std::function<double(double t, double turns)> vibration;
  std::function<double(double t)> rev_per_min = [](double) { return 600.0; };
  double noise = 0.0;
  double seconds = 3.0;
};

// What the meter says at each block, from the end of the first one on.
std::vector<VibrationLevel> measure(const Signal& signal, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  VibrationMeter meter(rate);
  std::vector<VibrationLevel> levels;
  double turns = 0.3;
  for (int block = 0; block < static_cast<int>(signal.seconds * 1000.0); ++block) {
    std::vector<double> samples;
    const double speed = signal.rev_per_min(block * 1e-3);
    for (int k = 0; k < 4; ++k) {
      turns += speed / 60.0 / rate;
      const double t = (4 * block + k) / rate;
      samples.push_back(signal.vibration(t, turns) + signal.noise * gauss(random));
    }
    meter.add(samples, speed);
    const VibrationLevel before = meter.level();
    static_cast<void>(meter.work());
    if (meter.level().amplitude_um != before.amplitude_um) levels.push_back(meter.level());
  }
  return levels;
}

double sine(double amplitude, double hz, double t, double phase = 0.4) {
  return amplitude * std::sin(2.0 * pi * hz * t + phase);
}

void expect_line(const Signal& signal, double amplitude, double hz, const std::string& what) {
  const std::vector<VibrationLevel> levels = measure(signal);
  ASSERT_GE(levels.size(), 5U) << what;
  for (const VibrationLevel& level : levels) {
    EXPECT_NEAR(level.frequency_hz, hz, 0.01 * hz) << what;
    EXPECT_NEAR(level.amplitude_um, amplitude, 0.02 * amplitude) << what;
  }
}

TEST(VibrationMeter, MeasuresASineOfTheBandInNoise) {
  for (int step = 0; step < 25; ++step) {
    const double hz = 21.0 * std::pow(1.13, step);  // up to 394.5
    expect_line({.vibration = [&](double t, double) { return 3.0 + sine(10.0, hz, t); },
                 .rev_per_min = [](double) { return 0.0; },
                 .noise = 1.0},
                10.0, hz, std::to_string(hz) + " Hz");
  }
}

TEST(VibrationMeter, TakesTheLargerOfTwoLines) {
  for (const double other : {36.0, 97.0, 140.0, 310.0}) {
    expect_line(
        {.vibration = [&](double t,
                          double) { return sine(10.0, 113.0, t) + sine(7.0, other, t, 1.1); },
         .rev_per_min = [](double) { return 0.0; },
         .noise = 1.0},
        10.0, 113.0, std::to_string(other) + " Hz beside it");
  }
}

// Twice as high as the vibration: out of round by the first three orders, and six teeth.
double run_out(double turns) {
  return 20.0 * std::sin(2.0 * pi * turns) + 6.0 * std::sin(6.0 * pi * turns + 1.0) +
         5.0 * std::sin(12.0 * pi * turns + 2.0);
}

TEST(VibrationMeter, LeavesTheOrdersOfTheSpindleOut) {
  for (const double rev_per_min : {420.0, 600.0, 1500.0, 3000.0}) {
    for (const double hz : {73.0, 113.0, 227.0}) {
      const double orders = hz / (rev_per_min / 60.0);
      // Closer to an order than the block can tell, it is one.
      if (std::abs(orders - std::round(orders)) * rev_per_min / 60.0 < 2.0) continue;
      expect_line(
          {.vibration = [&](double t, double turns) { return sine(10.0, hz, t) + run_out(turns); },
           .rev_per_min = [&](double) { return rev_per_min; },
           .noise = 1.0},
          10.0, hz, std::to_string(hz) + " Hz at " + std::to_string(rev_per_min) + " rev/min");
    }
  }
}

TEST(VibrationMeter, FindsBothLinesAndRunOutTogether) {
  expect_line({.vibration =
                   [](double t, double turns) {
                     return sine(10.0, 113.0, t) + sine(6.0, 187.0, t, 2.0) + run_out(turns);
                   },
               .noise = 1.0},
              10.0, 113.0, "all");
}

// The orders go with the angle when the speed drifts by 3 % in a second; none
// crosses the line.
TEST(VibrationMeter, FollowsTheAngleOfASpindleWhoseSpeedDrifts) {
  expect_line(
      {.vibration = [](double t, double turns) { return sine(10.0, 36.5, t) + run_out(turns); },
       .rev_per_min = [](double t) { return 600.0 * (1.0 + 0.03 * t); },
       .noise = 1.0},
      10.0, 36.5, "drift");
}

TEST(VibrationMeter, ARunOutAloneIsNoVibration) {
  const std::vector<VibrationLevel> levels =
      measure({.vibration = [](double, double turns) { return run_out(turns); }, .noise = 0.5});
  ASSERT_FALSE(levels.empty());
  for (const VibrationLevel& level : levels) {
    EXPECT_LT(level.amplitude_um, 0.5);
    EXPECT_NEAR(level.synchronous_um, std::hypot(20.0, 6.0, 5.0), 1.0);
  }
}

// A force that swings at 4 Hz, an electrical hum at 700 Hz: neither is in the band.
TEST(VibrationMeter, TakesNothingFromOutsideTheBand) {
  expect_line({.vibration =
                   [](double t, double) {
                     return sine(30.0, 4.0, t) + sine(10.0, 113.0, t) + sine(20.0, 700.0, t);
                   },
               .rev_per_min = [](double) { return 0.0; },
               .noise = 1.0},
              10.0, 113.0, "4 and 700 Hz beside it");
}

TEST(VibrationMeter, NeitherAllocatesNorNeedsMoreThanAMomentOfEachCycle) {
  VibrationMeter meter(rate);
  std::vector<double> samples(4);
  int pieces = 0;
  const testing::NoAllocation guard;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    for (int k = 0; k < 4; ++k)
      samples[static_cast<std::size_t>(k)] = sine(10.0, 113.0, (4 * cycle + k) / rate);
    meter.add(samples, 600.0);
    pieces += meter.work() ? 1 : 0;
  }
  EXPECT_GT(pieces, 100);
  EXPECT_NEAR(meter.level().frequency_hz, 113.0, 0.1);
}

}  // namespace
}  // namespace stanok::drives
