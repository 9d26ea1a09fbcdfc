// The search for the home position, on a drive that is a straight edge: where the switches and the
// index pulses are is known here, so is the home position.
#include "channels/axes/axis_homing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/cycle.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
constexpr double poll = 0.010;
constexpr double none = 1e9;

// Switches in positions of the machine; the encoder counts from where it was switched on.
struct Bench {
  double home_from = none;
  double home_to = -none;
  double limit_negative = -none;
  double limit_positive = none;
  double index_offset = 0.0;
  double index_pitch = 0.0;

  double machine = 0.0;  // position
  double zero = 0.0;     // machine position at counter 0
  std::uint32_t index_count = 0;
  double index_at = 0.0;

  AxisFeedback seen;

  void take(double to) {
    if (index_pitch > 0.0) {
      const double before = std::floor((machine - index_offset) / index_pitch);
      const double after = std::floor((to - index_offset) / index_pitch);
      if (before != after) {
        const double pulse = to > machine ? after : before;
        ++index_count;
        index_at = index_offset + pulse * index_pitch;
      }
    }
    machine = to;
  }

  void exchange() {
    seen.valid = true;
    seen.enabled = true;
    seen.position = machine - zero;
    seen.home_switch = machine >= home_from && machine <= home_to;
    seen.limit_negative = machine <= limit_negative;
    seen.limit_positive = machine >= limit_positive;
    seen.index_count = index_count;
    seen.index_position = index_at - zero;
  }
};

HomingConfig search(double velocity) {
  return {.order = 1, .velocity = velocity, .velocity_slow = std::abs(velocity) / 10.0};
}

// Runs the search from `start`; the axis is moved in counts.
AxisHoming::Result run(Bench& bench, const HomingConfig& config, double start, AxisHoming& homing,
                       double search_length = 700.0) {
  constexpr motion::RampLimits ramp{.a = 1000.0, .j = 20000.0};
  bench.machine = start;
  bench.zero = start;
  motion::AxisMove move;
  move.begin(0.0, 0.0, {.speed = 100.0, .ramp = ramp});
  homing.begin(config, ramp, search_length);
  for (int k = 0; k < 400'000; ++k) {
    if (k % std::lround(poll / cycle_s) == 0) bench.exchange();
    const AxisHoming::Result result = homing.advance(bench.seen, move);
    if (result != AxisHoming::Result::running) {
      EXPECT_TRUE(move.is_at_rest());
      return result;
    }
    move.advance(cycle_s);
    bench.take(bench.zero + move.position().value);
  }
  ADD_FAILURE() << "the search does not end";
  return AxisHoming::Result::failed;
}

// Wherever switch and axis are, in both directions: home is the edge that the search meets,
// within what the axis goes in a poll at the slow velocity.
TEST(AxisHoming, MeetsTheEdgeOfTheSwitchFromAnywhere) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 300; ++k) {
    Bench bench;
    bench.limit_negative = -300.0;
    bench.limit_positive = 300.0;
    bench.home_from = -290.0 + 500.0 * part(random);
    bench.home_to = bench.home_from + 5.0 + 60.0 * part(random);
    const double velocity = (k % 2 == 0 ? 1.0 : -1.0) * (5.0 + 35.0 * part(random));
    const double start = -299.0 + 598.0 * part(random);
    SCOPED_TRACE(::testing::Message() << "switch " << bench.home_from << " to " << bench.home_to
                                      << ", from " << start << " with " << velocity);
    AxisHoming homing;
    ASSERT_EQ(run(bench, search(velocity), start, homing), AxisHoming::Result::found)
        << homing.reason();
    const double edge = velocity > 0.0 ? bench.home_from : bench.home_to;
    const double beyond = (homing.home() + bench.zero - edge) * (velocity > 0.0 ? 1.0 : -1.0);
    EXPECT_GE(beyond, -1e-9);
    EXPECT_LE(beyond, std::abs(velocity) / 10.0 * poll + 1e-9);
  }
}

// With the index pulse the home position is exact, whatever the poll.
TEST(AxisHoming, IndexPulseBehindTheSwitchIsExact) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    Bench bench;
    bench.limit_negative = -300.0;
    bench.limit_positive = 300.0;
    bench.home_from = 100.0;
    bench.home_to = 160.0;
    bench.index_pitch = 10.0;
    bench.index_offset = 2.0 + 6.0 * part(random);  // not on the edge
    HomingConfig config = search(20.0);
    config.index = true;
    AxisHoming homing;
    ASSERT_EQ(run(bench, config, -299.0 + 598.0 * part(random), homing), AxisHoming::Result::found);
    EXPECT_NEAR(homing.home() + bench.zero, 100.0 + bench.index_offset, 1e-9);
  }
}

TEST(AxisHoming, LimitSwitchCanBeTheMark) {
  for (const double start : {-200.0, 0.0, 299.0, 300.5}) {
    Bench bench;
    bench.limit_negative = -300.0;
    bench.limit_positive = 300.0;
    HomingConfig config = search(20.0);
    config.signal = HomingSignal::limit_switch;
    AxisHoming homing;
    ASSERT_EQ(run(bench, config, start, homing), AxisHoming::Result::found);
    EXPECT_NEAR(homing.home() + bench.zero, 300.0, 2.0 * poll + 1e-9);
    EXPECT_FALSE(bench.seen.limit_positive);  // a program may start
  }
}

TEST(AxisHoming, AnAxisThatTurnsNeedsItsIndexOnly) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 50; ++k) {
    Bench bench;
    bench.index_pitch = 360.0;
    HomingConfig config = search(200.0);
    config.signal = HomingSignal::index_alone;
    AxisHoming homing;
    ASSERT_EQ(run(bench, config, 1.0 + 358.0 * part(random), homing), AxisHoming::Result::found);
    EXPECT_NEAR(std::remainder(homing.home() + bench.zero, 360.0), 0.0, 1e-9);
  }
}

TEST(AxisHoming, SaysWhatIsMissing) {
  AxisHoming homing;
  Bench bare;
  EXPECT_EQ(run(bare, search(40.0), 0.0, homing), AxisHoming::Result::failed);
  EXPECT_EQ(homing.reason(), "there is no home switch within the whole travel");

  Bench between;
  between.limit_negative = -100.0;
  between.limit_positive = 100.0;
  EXPECT_EQ(run(between, search(40.0), 0.0, homing), AxisHoming::Result::failed);
  EXPECT_EQ(homing.reason(), "there is no home switch between the limit switches");

  Bench without_index;
  without_index.home_from = 50.0;
  without_index.home_to = 60.0;
  HomingConfig config = search(40.0);
  config.index = true;
  EXPECT_EQ(run(without_index, config, 0.0, homing), AxisHoming::Result::failed);
  EXPECT_EQ(homing.reason(), "the encoder gave no index pulse");
}

}  // namespace
}  // namespace stanok::channels
