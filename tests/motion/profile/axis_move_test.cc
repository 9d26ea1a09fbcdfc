// Moves of a single axis: exact ends, limits, and rest wherever they are stopped.
#include "motion/profile/axis_move.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;

struct Ride {
  std::vector<kinematics::Jet> jets;
};

// Runs to rest; stops in cycle `stop_at`.
Ride ride(AxisMove& move, int stop_at = -1) {
  Ride result;
  for (int k = 0; k < 1'000'000 && !move.is_at_rest(); ++k) {
    if (k == stop_at) move.stop();
    move.advance(cycle_s);
    result.jets.push_back(move.position());
  }
  return result;
}

void expect_limits(const Ride& ride, const AxisMoveLimits& limits) {
  for (const kinematics::Jet& jet : ride.jets) {
    ASSERT_LE(std::abs(jet.first), limits.speed * (1 + 1e-9));
    ASSERT_LE(std::abs(jet.second), limits.ramp.a * (1 + 1e-9));
    ASSERT_LE(std::abs(jet.third), limits.ramp.j * (1 + 1e-9));
  }
  for (std::size_t k = 1; k < ride.jets.size(); ++k) {
    const double step = std::abs(ride.jets[k].value - ride.jets[k - 1].value);
    ASSERT_LE(step, limits.speed * cycle_s * (1 + 1e-9));
  }
}

TEST(AxisMove, EndsExactlyAndKeepsTheLimits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const AxisMoveLimits limits{
        .speed = 0.1 + 400.0 * part(random),
        .ramp = {.a = 50.0 + 3000.0 * part(random), .j = 500.0 + 80000.0 * part(random)}};
    const double from = 700.0 * (part(random) - 0.5);
    const double to = from + std::pow(10.0, 6.0 * part(random) - 3.5) * (k % 2 == 0 ? 1.0 : -1.0);
    AxisMove move;
    move.begin(from, to, limits);
    const Ride result = ride(move);
    EXPECT_EQ(move.position().value, to);
    EXPECT_EQ(move.position().first, 0.0);
    expect_limits(result, limits);
  }
}

// Rest comes after the braking distance of v, at most: v T / 2 with T of the ramp from v to 0, and
// what an acceleration still adds.
TEST(AxisMove, StopsAnywhereBeforeItsEnd) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const AxisMoveLimits limits{.speed = 1.0 + 200.0 * part(random),
                                .ramp = {.a = 1000.0, .j = 20000.0}};
    AxisMove move;
    const double to = k % 2 == 0 ? 80.0 : -80.0;
    move.begin(0.0, to, limits);
    const Ride result = ride(move, static_cast<int>(400.0 * part(random)));
    const double rest = move.position().value;
    EXPECT_LE(std::abs(rest), 80.0 + 1e-9);
    EXPECT_GE(rest * to, 0.0);
    expect_limits(result, limits);
  }
}

// v = 100, a = 1000, j = 20000: T = j-time 0.05 + 0.1 s, D = 100 / 2 * 0.15 = 7.5.
TEST(AxisMove, BrakesInTheShortestWay) {
  AxisMove move;
  move.begin(0.0, 500.0, {.speed = 100.0, .ramp = {.a = 1000.0, .j = 20000.0}});
  for (int k = 0; k < 1000; ++k) move.advance(cycle_s);
  const double from = move.position().value;
  move.stop();
  ride(move);
  EXPECT_NEAR(move.position().value - from, 7.5, 1e-9);
}

TEST(AxisMove, OfNoLengthIsAtRest) {
  AxisMove move;
  move.begin(3.0, 3.0, {.speed = 100.0, .ramp = {.a = 1000.0, .j = 20000.0}});
  EXPECT_TRUE(move.is_at_rest());
  EXPECT_EQ(move.position().value, 3.0);
}

// Extended again and again while it moves, also while it brakes already: one motion to the new end.
TEST(AxisMove, IsExtendedWithoutARestBetween) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const AxisMoveLimits limits{
        .speed = 1.0 + 200.0 * part(random),
        .ramp = {.a = 200.0 + 3000.0 * part(random), .j = 2000.0 + 80000.0 * part(random)}};
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    AxisMove move;
    double to = sign * (0.01 + 20.0 * part(random));
    move.begin(0.0, to, limits);
    Ride ride;
    for (int cycle = 0; cycle < 100'000 && !move.is_at_rest(); ++cycle) {
      if (cycle < 2000 && part(random) < 0.03) {
        to += sign * 5.0 * part(random) * part(random);
        move.extend(to, limits.speed);
      }
      move.advance(cycle_s);
      ride.jets.push_back(move.position());
      if (!move.is_at_rest()) {
        EXPECT_GT(sign * move.position().first, 0.0);
      }
    }
    EXPECT_NEAR(move.position().value, to, 1e-9);
    expect_limits(ride, limits);
  }
}

}  // namespace
}  // namespace stanok::motion
