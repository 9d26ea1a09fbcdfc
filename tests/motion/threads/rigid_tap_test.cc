// Rigid taps: in, back on the same helix, and the spindle as before
// (docs/developer/motion.md#threads).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/motion/threads/thread_bench.h"

namespace stanok::motion::testing {
namespace {

// A spindle with an acceleration, 20 % of ripple on whatever speed it has, and the obedience that a
// tap asks for.
class TapSpindle {
 public:
  TapSpindle(double speed, double acceleration, double ripple)
      : commanded_(speed), wanted_(speed), acceleration_(acceleration), ripple_(ripple) {
    speed_ = speed;
    braking_ = acceleration;
  }

  [[nodiscard]] double angle() const { return angle_; }
  [[nodiscard]] double wanted() const { return wanted_; }

  // As commanded, without the ripple.
  [[nodiscard]] SpindleMotion commanded(double later) const {
    const double step = braking_ * later;
    const double speed = speed_ + std::clamp(wanted_ - speed_, -step, step);
    return {.turns = commanded_turns_ + 0.5 * (speed_ + speed) * later,
            .speed = speed,
            .acceleration = later > 0.0 ? (speed - speed_) / later : 0.0,
            .speed_wanted = wanted_};
  }

  // One cycle, in small steps.
  void turn(const SpindleOrder& order) {
    if (order.kind == SpindleOrder::Kind::stop_within) {
      wanted_ = 0.0;
      braking_ = std::min(acceleration_, 0.5 * speed_ * speed_ / order.turns);
    } else if (order.kind == SpindleOrder::Kind::turn_back) {
      wanted_ = -order.factor * commanded_;
      braking_ = std::min(acceleration_, order.acceleration);
    } else if (order.kind == SpindleOrder::Kind::go_on) {
      wanted_ = commanded_;
    } else if (order.kind == SpindleOrder::Kind::turn_out) {
      wanted_ = order.speed;
      braking_ = std::min(acceleration_, order.acceleration);
    } else if (order.kind == SpindleOrder::Kind::stop) {
      wanted_ = 0.0;
      braking_ = acceleration_;
    }
    constexpr int steps = 100;
    const double h = cycle_s / steps;
    for (int k = 0; k < steps; ++k) {
      const double before = speed_;
      speed_ += std::clamp(wanted_ - speed_, -braking_ * h, braking_ * h);
      time_ += h;
      commanded_turns_ += 0.5 * (before + speed_) * h;
      const double w = 2.0 * std::numbers::pi * 2.0;
      angle_ += 0.5 * (before + speed_) * h * (1.0 + ripple_ * std::sin(w * time_));
    }
  }

 private:
  double commanded_;
  double wanted_;
  double acceleration_;
  double ripple_;
  double braking_ = 0.0;
  double speed_ = 0.0;
  double angle_ = 0.0;
  double commanded_turns_ = 0.0;
  double time_ = 0.0;
};

struct TapCase {
  const char* name;
  double speed;         // turns/s, < 0: counter-clockwise
  double acceleration;  // turns/s^2
  double ripple;
  double factor;  // of the way back
};

// It is the one of the bench, which has turned for half a second.
void lead_by_spindle(ThreadBench& bench, TapSpindle& spindle) {
  bench.spindle_obeys([&](const SpindleOrder& order) { spindle.turn(order); },
                      [&](double later) { return spindle.commanded(later); });
  bench.idle(0.5);
}

class Tap : public ::testing::TestWithParam<TapCase> {};

TEST_P(Tap, GoesInAndComesBackOnOneHelix) {
  const TapCase& the = GetParam();
  constexpr double lead = 1.5;
  TapSpindle spindle(the.speed, the.acceleration, the.ripple);
  ThreadBench bench([&](double) { return spindle.angle(); }, the.speed, at(0.0, 5.0));
  lead_by_spindle(bench, spindle);
  ThreadBuilder builder(bench.config());
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::tap;
  coupling.spindle_acceleration = the.acceleration;
  coupling.return_speed_factor = the.factor;
  coupling.dwell_s = 0.1;
  builder.begin(at(0.0, 5.0), bench.config().geometry, coupling,
                std::abs(the.speed) * std::max(1.0, the.factor));
  ASSERT_FALSE(builder.add_tap(block_to(at(0.0, -20.0), lead)));
  bench.send(builder);
  const std::uint64_t done = bench.output().chunks_done;
  double error = 0.0;
  double bottom = 5.0;
  double origin = 0.0;
  bool has_origin = false;
  int dwelling = 0;
  while (bench.output().chunks_done == done && bench.time() < 20.0) {
    bench.cycle();
    const double z = bench.output().axes[Z].value;
    bottom = std::min(bottom, z);
    if (z > 2.0) continue;  // run-in and run-out
    const double turns = std::copysign(1.0, the.speed) * spindle.angle();
    const double off = turns - (5.0 - z) / lead;
    if (!has_origin) origin = std::round(off);
    has_origin = true;
    error = std::max(error, std::abs(off - origin) * lead);
    dwelling += std::abs(bench.output().axes[Z].first) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(bench.output().chunks_done, done);
  EXPECT_LE(error, 2.0 * increment_mm);
  // With ripple the spindle stops elsewhere than it was asked to; the helix stays the same.
  EXPECT_NEAR(bottom, -20.0, the.ripple > 0.0 ? lead : 2.0 * increment_mm);
  EXPECT_GE(dwelling, 100);
  EXPECT_EQ(bench.output().axes[Z].value, 5.0);
  EXPECT_EQ(spindle.wanted(), the.speed);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

INSTANTIATE_TEST_SUITE_P(SynchronousRun, Tap,
                         ::testing::Values(TapCase{"S300", 5.0, 30.0, 0.0, 1.0},
                                           TapCase{"S600", 10.0, 33.0, 0.0, 1.0},
                                           TapCase{"S600Left", -10.0, 33.0, 0.0, 1.0},
                                           TapCase{"S600BackTwice", 10.0, 33.0, 0.0, 2.0},
                                           TapCase{"S1500", 25.0, 100.0, 0.0, 1.0},
                                           TapCase{"S600Ripple", 10.0, 33.0, 0.2, 1.0},
                                           TapCase{"S1200Ripple", 20.0, 60.0, 0.2, 1.5}),
                         [](const auto& with) { return std::string(with.param.name); });

TEST(RigidTap, LeavingATapStopsItsSpindleAndStaysOnTheHelix) {
  TapSpindle spindle(10.0, 33.0, 0.0);
  ThreadBench bench([&](double) { return spindle.angle(); }, 10.0);
  lead_by_spindle(bench, spindle);
  ThreadBuilder builder(bench.config());
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::tap;
  coupling.spindle_acceleration = 33.0;
  builder.begin(at(0.0, 0.0), bench.config().geometry, coupling, 10.0);
  ASSERT_FALSE(builder.add_tap(block_to(at(0.0, -30.0), 1.5)));
  bench.send(builder);
  while (bench.output().axes[Z].value > -5.0) bench.cycle();
  bench.control().hold = true;
  bench.control().leaves_thread = true;
  bench.idle(1.0);
  EXPECT_EQ(spindle.wanted(), 0.0);
  EXPECT_EQ(bench.output().axes[Z].first, 0.0);
  const double off = spindle.angle() + bench.output().axes[Z].value / 1.5;
  EXPECT_LE(std::abs(off - std::round(off)) * 1.5, 2.0 * increment_mm);
}

// The tap is stopped at a random place of its way in or out, by a spindle that turns either way,
// and taken out: in step with the spindle all the way, and exactly to where it began.
class StoppedTap : public ::testing::TestWithParam<int> {};

TEST_P(StoppedTap, ComesOutInStepWithItsSpindle) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double speed = std::copysign(between(3.0, 25.0), between(-1.0, 1.0));
  const double acceleration = between(30.0, 100.0);
  const double lead = between(0.5, 2.0);
  const double stopped_behind_s = between(0.01, 0.95) * 2.0 * 30.0 / (lead * std::abs(speed));
  TapSpindle spindle(speed, acceleration, GetParam() % 3 == 0 ? 0.2 : 0.0);
  ThreadBench bench([&](double) { return spindle.angle(); }, speed, at(0.0, 5.0));
  lead_by_spindle(bench, spindle);
  ThreadBuilder in(bench.config());
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::tap;
  coupling.spindle_acceleration = acceleration;
  in.begin(at(0.0, 5.0), bench.config().geometry, coupling, std::abs(speed));
  ASSERT_FALSE(in.add_tap(block_to(at(0.0, -25.0), lead)));
  bench.send(in);
  while (bench.output().tap.place != TapOnPath::Place::in_hole) bench.cycle();
  const double begins = bench.time();
  while (bench.time() < begins + stopped_behind_s) bench.cycle();
  ASSERT_EQ(bench.output().tap.place, TapOnPath::Place::in_hole);
  EXPECT_EQ(bench.output().tap.lead_mm, lead);
  bench.control().leaves_thread = true;
  bench.idle(2.0);
  ASSERT_EQ(bench.output().axes[Z].first, 0.0);
  bench.drop_chain();
  bench.idle(0.1);
  EXPECT_EQ(bench.output().tap.place, TapOnPath::Place::none);

  const double z_stopped = bench.output().axes[Z].value;
  const double angle_stopped = spindle.angle();
  ThreadBuilder out(bench.config());
  coupling.kind = SpindleCoupling::Kind::tap_out;
  coupling.out_speed = -speed;
  out.begin(at(0.0, 5.0), bench.config().geometry, coupling, std::abs(speed));
  ASSERT_FALSE(out.add_tap(block_to(at(0.0, z_stopped), lead)));
  bench.send(out);
  double error = 0.0;
  double deepest = z_stopped;
  const std::uint64_t done = bench.output().chunks_done;
  while (bench.output().chunks_done == done && bench.time() < 120.0) {
    bench.cycle();
    const double z = bench.output().axes[Z].value;
    deepest = std::min(deepest, z);
    if (z > 4.0 - 2.0 * lead) continue;  // it brakes there
    const double turned = std::copysign(1.0, -speed) * (spindle.angle() - angle_stopped);
    error = std::max(error, std::abs(z - z_stopped - lead * turned));
  }
  EXPECT_GT(bench.output().chunks_done, done) << "z " << bench.output().axes[Z].value;
  EXPECT_LE(error, 2.0 * increment_mm);
  EXPECT_GE(deepest, z_stopped - 2.0 * increment_mm);
  EXPECT_EQ(bench.output().axes[Z].value, 5.0);
  EXPECT_EQ(spindle.wanted(), 0.0);
  EXPECT_LE(bench.used(), 1.0 + rounding);
}

INSTANTIATE_TEST_SUITE_P(RigidTap, StoppedTap, ::testing::Range(1, 61));

}  // namespace
}  // namespace stanok::motion::testing
