// Stops at random moments: deceleration begins within two cycles of the command, and nothing starts
// behind an abort: neither motion nor spindle nor an output of a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/machine/machine_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::MachineBench;

class RandomRun {
 public:
  explicit RandomRun(unsigned seed) : random_(seed) {}

  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  // Lines, arcs, rapids, dwells, spindle, outputs and changes of kinematics, in any order.
  // `corners`: only with G61 there is never a move that begins while the one before it ends.
  enum class Corners : std::uint8_t { exact, of_any_kind };
  std::string program(Corners corners) {
    std::string text =
        "#kinematics (1, 1)\nG61 G90 G54 F" + std::to_string(pick(500, 14000)) + "\n";
    for (int n = 0; n < 40; ++n) {
      const std::string x = std::to_string(pick(-60, 60));
      const std::string y = std::to_string(pick(-60, 60));
      switch (pick(0, 9)) {
        case 0:
          text += "G0 X" + x + " Y" + y + "\n";
          break;
        case 1:
          text += "G91 G2 X10 Y10 R10\nG90\n";
          break;
        case 2:
          text += "G4 P0.0" + std::to_string(pick(1, 9)) + "\n";
          break;
        case 3:
          text += "M3 S" + std::to_string(pick(100, 9000)) + "\n";
          break;
        case 4:
          text += pick(0, 1) == 0 ? "M5\n" : "M62 P3\n";
          break;
        case 5:
          text += corners == Corners::exact || pick(0, 1) == 0 ? "G61\n" : "G64 P0.1\n";
          break;
        default:
          text += "G1 X" + x + " Y" + y + "\n";
      }
    }
    return text + "#kinematics (2, 1)\nG1 X0 B20 C30\nM30\n";
  }

 private:
  std::mt19937 random_;
};

// Speed of the tip along its path, cycle by cycle, from the command on.
class SpeedWatch {
 public:
  SpeedWatch(double speed, RandomRun::Corners corners)
      : speed_(speed), ramps_from_(corners == RandomRun::Corners::exact ? 3 : 41) {}

  // `cycles` since the command was given, the one that took it being 1. Speeding up, as far as it
  // is under way, is ramped down without pause; afterwards it only gets slower. Two moves that
  // overlap do so to the end of the overlap first; a pace takes some 20 cycles from 1 to 0, in
  // which what has just left its rest comes to some mm/s.
  void look(const ChannelOutput& channel, int cycles) {
    constexpr double rounding = 1e-7;  // mm/s, of a speed formed by differences of time polynomials
    const double gain = channel.path_speed - speed_;
    const bool has_just_begun = cycles <= 20 && channel.path_speed < 3.0;
    if (cycles >= ramps_from_ && !has_just_begun) {
      const double most = gain_ > rounding ? gain_ : rounding;
      ASSERT_LE(gain, most) << cycles << " cycles after the stop, at " << speed_ << " mm/s";
    }
    gain_ = gain;
    speed_ = channel.path_speed;
  }

 private:
  double speed_;
  int ramps_from_;  // cycle since the command
  double gain_ = 0.0;
};

constexpr std::array stopping_actions = {
    OperatorAction::program_hold, OperatorAction::program_stop, OperatorAction::program_reset,
    OperatorAction::machine_estop, OperatorAction::machine_off};

bool is_abort(OperatorAction action) {
  return action != OperatorAction::program_hold;
}

double spindle_speed(const ChannelOutput& channel) {
  return std::abs(channel.process.spindles[0].rev_per_min);
}

void run_and_stop(MachineBench& bench, RandomRun& random) {
  const auto corners =
      random.pick(0, 1) == 0 ? RandomRun::Corners::exact : RandomRun::Corners::of_any_kind;
  bench.program("p.nc", random.program(corners));
  bench.run(1, "p.nc");
  const int before = random.pick(1, 4000);
  for (int n = 0; n < before; ++n) bench.cycle();
  ASSERT_FALSE(bench.replies().empty());
  ASSERT_TRUE(bench.replies().back().ok) << bench.replies().back().text.view();
  if (random.pick(0, 4) == 0) {
    bench.ask(OperatorAction::program_hold, 1);
    for (int n = random.pick(1, 300); n > 0; --n) bench.cycle();
  }
  const OperatorAction stop = stopping_actions[static_cast<std::size_t>(random.pick(0, 4))];
  const bool machine_wide =
      stop == OperatorAction::machine_estop || stop == OperatorAction::machine_off;
  const ChannelOutput at_stop = bench.channel(1);
  const Signals signals = bench.output().signals;
  SpeedWatch speed(at_stop.path_speed, corners);
  bench.ask(stop, machine_wide ? 0 : 1);
  bool stood = false;
  double turned = spindle_speed(at_stop);
  constexpr int rest_within =
      3000;  // cycles: 250 mm/s at 2500 mm/s2 are 100, 18000 rev/min at once
  for (int n = 1; n <= rest_within; ++n) {
    const ChannelOutput& now = bench.cycle().channels[0];
    ASSERT_NO_FATAL_FAILURE(speed.look(now, n));
    ASSERT_FALSE(stood && now.moving) << "moves again, " << n << " cycles after the stop";
    stood = stood || !now.moving;
    if (!is_abort(stop)) continue;
    ASSERT_TRUE(turned > 0.0 || spindle_speed(now) == 0.0) << "the spindle starts";
    turned = spindle_speed(now);
    ASSERT_EQ(bench.output().signals, signals) << "an output of the program changes";
  }
  EXPECT_TRUE(stood);
  if (is_abort(stop)) {
    EXPECT_FALSE(bench.channel(1).running);
    EXPECT_EQ(spindle_speed(bench.channel(1)), 0.0);
  }
  if (machine_wide) {
    for (int k = 0; k < 5; ++k) EXPECT_FALSE(bench.channel(1).drives[std::size_t(k)].enabled);
  }
}

void recover(MachineBench& bench) {
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  bench.ask(OperatorAction::program_reset, 2);
  bench.run_to_end();
  bench.ask(OperatorAction::machine_on, 0);
  bench.run_to_end();
}

// 1,000 runs, some of them on the same machine one after the other.
TEST(Stops, SlowDownAtOnceAndStartNothing) {
  constexpr int runs_of_a_machine = 25;
  for (unsigned seed = 1; seed <= stanok::testing::cases(40U) && !::testing::Test::HasFailure();
       ++seed) {
    RandomRun random(seed);
    MachineBench bench;
    for (int n = 0; n < runs_of_a_machine && !::testing::Test::HasFailure(); ++n) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", run " + std::to_string(n));
      run_and_stop(bench, random);
      recover(bench);
    }
  }
}

// y = 3 sin (x / 4) in chords of 0.2 mm, at a feed at which the axes limit the speed.
std::string wave() {
  std::string text = "G90 G54 G64 F8000\n";
  for (int n = 1; n <= 400; ++n) {
    const double x = 0.17 * n;
    text += "G1 X" + std::to_string(x) + " Y" + std::to_string(3.0 * std::sin(0.25 * x)) + "\n";
  }
  return text + "M30\n";
}

// Positions of X and Y from a stop on, in every cycle until they rest.
std::vector<std::array<double, 2>> course_to_rest(OperatorAction stop, int cycles_before) {
  MachineBench bench;
  bench.program("wave.nc", wave());
  bench.run(1, "wave.nc");
  for (int n = 0; n < cycles_before; ++n) bench.cycle();
  const bool is_machine_wide =
      stop == OperatorAction::machine_estop || stop == OperatorAction::machine_off;
  bench.ask(stop, is_machine_wide ? 0 : 1);
  std::vector<std::array<double, 2>> course;
  constexpr std::size_t cycles_max = 500;
  do {
    const ChannelOutput& now = bench.cycle().channels[0];
    course.push_back({now.axes[0].position, now.axes[1].position});
  } while (bench.channel(1).moving && course.size() < cycles_max);
  return course;
}

// Whatever stops the path brakes it in the same way, to the bit: how soon it rests is judged where
// the path is tested (tests/motion/stop_test.cc).
TEST(Stops, OfEveryKindBrakeAlike) {
  for (const int cycles_before : {400, 640}) {
    const auto held = course_to_rest(OperatorAction::program_hold, cycles_before);
    EXPECT_LT(held.size(), 250U);
    EXPECT_GT(held.size(), 50U);
    for (const OperatorAction stop : {OperatorAction::program_stop, OperatorAction::program_reset,
                                      OperatorAction::machine_estop, OperatorAction::machine_off,
                                      OperatorAction::override_feed}) {
      const auto course = course_to_rest(stop, cycles_before);
      const std::size_t common = std::min(held.size(), course.size());
      EXPECT_LE(std::max(held.size(), course.size()), common + 2) << static_cast<int>(stop);
      for (std::size_t n = 0; n < common; ++n) EXPECT_EQ(course[n], held[n]) << "cycle " << n;
    }
  }
}

// Ways in which something could begin behind a stop.
class StopTest : public ::testing::Test {
 protected:
  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  void begin(const std::string& text) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    cycles(300);
  }
  // While the axes are still on their way to rest.
  void expect_rest_after(OperatorAction stop, OperatorAction next) {
    bench.ask(stop, 1);
    bench.cycle();
    ASSERT_TRUE(bench.channel(1).moving);
    bench.ask(next, 1, next == OperatorAction::program_run ? "p.nc" : "");
    cycles(1000);
    EXPECT_FALSE(bench.channel(1).moving);
    EXPECT_FALSE(bench.channel(1).running);
  }

  MachineBench bench{testing::two_channel_machine(), {.on_at_start = true}};
};

TEST_F(StopTest, NothingThatIsAskedOnTheWayToRestBeginsBehindIt) {
  bench.may_refuse();
  for (const auto next :
       {OperatorAction::program_hold, OperatorAction::program_resume, OperatorAction::program_start,
        OperatorAction::program_run, OperatorAction::mdi}) {
    begin("G1 X200 F12000\nX0\nM30\n");
    expect_rest_after(OperatorAction::program_stop, next);
    begin("G1 X200 F12000\nX0\nM30\n");
    expect_rest_after(OperatorAction::program_stop, OperatorAction::program_hold);
  }
}

TEST_F(StopTest, AHoldAndAResumeDoNotUndoAReset) {
  bench.may_refuse();
  begin("G1 X200 F12000\nX0\nM30\n");
  bench.ask(OperatorAction::program_reset, 1);
  bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.cycle();
  bench.ask(OperatorAction::program_resume, 1);
  cycles(1000);
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_LT(bench.channel(1).axes[0].position, 100.0);
}

// A start that still waits for its drives, or for its turn, when the stop comes.
TEST_F(StopTest, AStartThatHasNotBegunIsOverWithAStop) {
  for (const auto stop : {OperatorAction::program_stop, OperatorAction::program_hold,
                          OperatorAction::machine_estop}) {
    MachineBench fresh;
    fresh.program("p.nc", "G1 X200 F12000\nM30\n");
    std::vector<AxisFeedback> drives(5);
    for (AxisFeedback& drive : drives) drive = {.valid = true, .referenced = true};
    fresh.feedback(drives);  // none of them is enabled yet
    fresh.run(1, "p.nc");
    for (int n = 0; n < 100; ++n) fresh.cycle();
    ASSERT_TRUE(fresh.replies().empty()) << "the start waits";
    fresh.ask(stop, stop == OperatorAction::machine_estop ? 0 : 1);
    fresh.cycle();
    for (AxisFeedback& drive : drives) drive.enabled = true;
    fresh.feedback(drives);
    for (int n = 0; n < 4000; ++n) {
      fresh.cycle();
      ASSERT_FALSE(fresh.channel(1).running);
    }
    EXPECT_FALSE(fresh.replies().front().ok && fresh.replies().back().ok);
  }
}

TEST_F(StopTest, ASpindleThatALineLeftOnStopsWithEveryAbort) {
  for (const auto stop : stopping_actions) {
    if (!is_abort(stop)) continue;
    MachineBench fresh;
    fresh.ask(OperatorAction::mdi, 1, "M3 S1000");
    fresh.run_to_end();
    ASSERT_EQ(spindle_speed(fresh.channel(1)), 1000.0);
    fresh.ask(stop, stop == OperatorAction::program_stop || stop == OperatorAction::program_reset);
    for (int n = 0; n < 100; ++n) fresh.cycle();
    EXPECT_EQ(spindle_speed(fresh.channel(1)), 0.0) << static_cast<int>(stop);
  }
}

TEST_F(StopTest, AnEmergencyStopOnTheWayToRestTakesThePower) {
  begin("G1 X200 F12000\nX0\nM30\n");
  bench.ask(OperatorAction::program_stop, 1);
  bench.cycle();
  bench.ask(OperatorAction::machine_estop, 0);
  cycles(1000);
  EXPECT_FALSE(bench.channel(1).drives[0].enabled);
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  EXPECT_THAT(bench.alarm_codes(), Contains("A1001"));
}

TEST_F(StopTest, OnlyAResetClearsAnAlarm) {
  bench.ask(OperatorAction::machine_estop, 0);
  cycles(10);
  for (const auto stop : {OperatorAction::program_stop, OperatorAction::machine_off}) {
    bench.ask(stop, stop == OperatorAction::program_stop ? 1 : 0);
    cycles(10);
    EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  }
  bench.ask(OperatorAction::program_reset, 1);
  cycles(10);
  EXPECT_EQ(bench.channel(1).state, ChannelState::idle);
}

TEST_F(StopTest, AHoldEndsAChangeOfKinematicsOfAnOperator) {
  bench.ask(OperatorAction::kinematics_select, 1, "", 0.0, 2);
  bench.run_to_end();
  bench.ask(OperatorAction::mdi, 1, "G0 C90");
  bench.run_to_end();
  bench.ask(OperatorAction::kinematics_select, 1, "", 0.0, 1);  // C is parked at 0
  while (!bench.channel(1).moving) bench.cycle();
  cycles(50);
  bench.ask(OperatorAction::program_hold, 1);
  cycles(1000);
  EXPECT_FALSE(bench.channel(1).moving);
  EXPECT_EQ(bench.channel(1).scheme, 2);
  EXPECT_GT(bench.channel(1).axes[4].position, 1.0) << "it stopped on its way";
  EXPECT_FALSE(bench.replies().back().ok && bench.replies()[bench.replies().size() - 2].ok);
  bench.ask(OperatorAction::kinematics_select, 1, "", 0.0, 1);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).scheme, 1);
}

// Two clients who ask at the same moment: what runs is what was answered.
TEST_F(StopTest, OfTwoProgramsAskedForAtOnceTheFirstOneRuns) {
  bench.program("a.nc", "G1 X10 F6000\nM30\n");
  bench.program("b.nc", "G1 X-10 F6000\nM30\n");
  bench.run(1, "a.nc");
  bench.run(1, "b.nc");
  bench.run_to_end();
  ASSERT_EQ(bench.replies().size(), 2U);
  EXPECT_TRUE(bench.replies()[0].ok);
  EXPECT_EQ(bench.replies()[1].code.view(), "E6003");
  EXPECT_NEAR(bench.channel(1).axes[0].position, 10.0, 1e-9);
}

// More requests than the coordinator has room for do not keep a stop out.
TEST_F(StopTest, HasItsEffectHoweverManyRequestsWait) {
  begin("G1 X200 F12000\nX0\nM30\n");
  bench.ask(OperatorAction::program_stop, 1);
  for (int n = 0; n < 40; ++n) bench.ask(OperatorAction::program_reset, 2);
  bench.ask(OperatorAction::program_reset, 1);
  cycles(1000);
  EXPECT_FALSE(bench.channel(1).running);
  ASSERT_EQ(bench.replies().size(), 43U);
  for (const OperatorReply& reply : bench.replies()) EXPECT_TRUE(reply.ok) << reply.code.view();
}

// A bound that no ramp can keep stands for a stop that lasts.
class StopBound : public ::testing::TestWithParam<OperatorAction> {
 protected:
  static constexpr int bound_cycles = 20;

  static MachineConfig machine() {
    MachineConfig machine = stanok::testing::two_channel_machine();
    machine.stop_time_max_s = bound_cycles * 1e-3;
    return machine;
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  void stop() {
    const bool is_of_channel =
        GetParam() == OperatorAction::program_stop || GetParam() == OperatorAction::program_reset;
    bench.ask(GetParam(), is_of_channel ? 1 : 0);
    bench.cycle();
  }

  MachineBench bench{machine()};
};

TEST_P(StopBound, PowerIsRemovedFromAxesThatStillMove) {
  bench.program("a.nc", "G1 X200 F12000\nM30\n");
  bench.run(1, "a.nc");
  do bench.cycle();
  while (bench.channel(1).path_speed < 199.0);
  stop();
  cycles(bound_cycles - 1);
  EXPECT_GT(bench.channel(1).path_speed, 10.0);
  EXPECT_TRUE(bench.channel(1).drives[0].enabled);
  cycles(3);
  for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(bench.channel(1).drives[axis].enabled) << axis;
  EXPECT_THAT(bench.alarm_codes(), Contains("A1002"));
  const double stood = bench.channel(1).axes[0].position;
  cycles(200);
  EXPECT_EQ(bench.channel(1).axes[0].position, stood);
  EXPECT_EQ(bench.channel(1).axes[0].velocity, 0.0);
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  EXPECT_FALSE(bench.channel(1).running);
  // Behind a reset the machine goes on from there.
  for (const int channel : {1, 2}) bench.ask(OperatorAction::program_reset, channel);
  cycles(10);
  bench.ask(OperatorAction::machine_on, 0);
  cycles(10);
  bench.ask(OperatorAction::mdi, 1, "G91 G1 X1 F600");
  bench.run_to_end();
  EXPECT_NEAR(bench.channel(1).axes[0].position, stood + 1.0, 1e-9);
}

TEST_P(StopBound, AJogIsBrokenOffToo) {
  for (int n = 0; n < 200; ++n) {
    if (n % 50 == 0) bench.ask(OperatorAction::jog, 1, "X", 200.0);
    bench.cycle();
  }
  ASSERT_GT(bench.channel(1).axes[0].velocity, 190.0);
  stop();
  cycles(bound_cycles + 2);
  EXPECT_FALSE(bench.channel(1).drives[0].enabled);
  EXPECT_FALSE(bench.channel(1).moving);
  EXPECT_THAT(bench.alarm_codes(), Contains("A1002"));
}

INSTANTIATE_TEST_SUITE_P(Stops, StopBound,
                         ::testing::Values(OperatorAction::program_stop,
                                           OperatorAction::program_reset,
                                           OperatorAction::machine_off,
                                           OperatorAction::machine_estop));

}  // namespace
}  // namespace stanok::channels
