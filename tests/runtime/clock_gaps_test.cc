// Periods of the clock that pass without a cycle, seeded: what the drives are told lies on the path
// at the time at which it is told, within the limits; behind long gaps the path rests or is held;
// the recorded run repeats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <vector>

#include "runtime/replay.h"
#include "tests/runtime/recorded_by_chance.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;

constexpr double period_s = 0.001;

// A cycle, as the one channel saw it.
struct Computed {
  std::int64_t cycle = 0;
  channels::ChannelOutput channel;
};
// One whose output the drives got.
struct Sent : Computed {
  std::int64_t lost = 0;    // periods before it
  std::int64_t period = 0;  // of the clock
};

// One channel runs one program while the clock is late as `lateness` says.
class LateClock {
 public:
  LateClock(const std::string& machine, DriveChoice drives, std::uint64_t seed)
      : run_(machine, drives, seed), random_(seed) {
    run_.come_late(
        [this] {
          lost_ = is_late_ ? lateness_(random_) : 0;
          period_ += lost_ + 1;
          return lost_;
        },
        [this](const channels::CycleOutput& output) {
          count_edge(output, valve_sent_, edges_sent);
          if (output.channels[0].running)
            sent.push_back({{output.cycle, output.channels[0]}, lost_, period_});
        });
    run_.watch([this](const channels::CycleOutput& output) { look(output); },
               [this](const channels::Event& event) { ++told[std::string(event.code.view())]; });
  }

  // Periods before a cycle, none of most of them.
  void be_late(std::function<std::int64_t(std::mt19937_64&)> lateness) {
    lateness_ = std::move(lateness);
    is_late_ = true;
  }

  // False: it has not ended after so many cycles.
  [[nodiscard]] bool run(const std::string& program, int cycles_max = 60'000) {
    begin(program);
    return go_on(cycles_max);
  }
  void begin(const std::string& program) {
    run_.program("part.nc", program);
    run_.run(300);  // the drives are on
    run_.ask(OperatorAction::program_run, 1, "part.nc");
    run_.run(1);
  }
  [[nodiscard]] bool go_on(int cycles_max = 60'000) {
    for (int n = 0; n < cycles_max; ++n) {
      run_.run(1);
      if (!shown.running && has_run_) return true;
    }
    return false;
  }

  RecordedByChance& by_chance() { return run_; }

  std::vector<Sent> sent;
  std::vector<Computed> computed;  // while the program ran
  std::map<std::string, int> told;
  channels::ChannelOutput shown;
  int edges = 0;       // of the first digital output
  int edges_sent = 0;  // to it

 private:
  static void count_edge(const channels::CycleOutput& output, bool& is_on, int& count) {
    const bool was_on = std::exchange(is_on, output.signals.is_on(0));
    if (was_on != is_on) ++count;
  }
  void look(const channels::CycleOutput& output) {
    shown = output.channels[0];
    count_edge(output, valve_, edges);
    has_run_ = has_run_ || shown.running;
    if (shown.running) computed.push_back({output.cycle, shown});
  }

  RecordedByChance run_;
  std::mt19937_64 random_;
  std::function<std::int64_t(std::mt19937_64&)> lateness_;
  bool is_late_ = false;
  bool valve_ = false;
  bool valve_sent_ = false;
  bool has_run_ = false;
  std::int64_t lost_ = 0;
  std::int64_t period_ = 0;
};

// One of 20 cycles is late by up to so many periods.
auto up_to(std::int64_t periods_max) {
  return [=](std::mt19937_64& random) -> std::int64_t {
    if (random() % 20 != 0) return 0;
    return 1 + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(periods_max));
  };
}

// Lines of 1 to 30 mm and arcs, in X, Y and Z, at 600 to 9,000 mm/min.
std::string random_part(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-15.0, 15.0);
  std::ostringstream text;
  text << "G21 G90 G17 G64 P0.02\nG0 X0 Y0 Z0\nF" << 600 + random() % 8400 << "\n";
  for (int block = 0; block < 60; ++block) {
    if (random() % 4 == 0) {
      text << "G2 X" << place(random) << " Y" << place(random) << " R" << 40.0 << "\n";
    } else {
      text << "G1 X" << place(random) << " Y" << place(random) << " Z" << place(random) / 5.0
           << "\n";
    }
  }
  text << "M30\n";
  return text.str();
}

std::vector<double> positions(const channels::ChannelOutput& channel) {
  std::vector<double> axes;
  for (int k = 0; k < channel.axis_count; ++k) axes.push_back(channel.axes[k].position);
  return axes;
}

// Up to three periods: what is told at a time is what would have been told without any gap.
TEST(ClockGaps, ThePathGoesOnOverShortOnes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LateClock in_time("mill3.toml", DriveChoice::ideal, seed);
    ASSERT_TRUE(in_time.run(random_part(seed)));
    LateClock late("mill3.toml", DriveChoice::ideal, seed);
    late.be_late(up_to(3));
    ASSERT_TRUE(late.run(random_part(seed)));
    int gaps_in_motion = 0;
    for (std::size_t k = 1; k < late.sent.size(); ++k) {
      const Sent& before = late.sent[k - 1];
      const Sent& now = late.sent[k];
      const bool moved = before.channel.moving && now.channel.moving;
      if (now.lost == 0 || !moved) continue;
      ++gaps_in_motion;
      EXPECT_EQ(now.cycle - before.cycle, now.period - before.period);
    }
    EXPECT_GT(gaps_in_motion, 20);
    const std::vector<channels::RunReport> runs = late.by_chance().runs();
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_GE(runs[0].lost.total, gaps_in_motion);
    EXPECT_EQ(runs[0].lost.longest, 3);
    // The path is that of the clock in time, cycle by cycle of the motion.
    std::vector<std::vector<double>> wanted;
    for (const Computed& one : in_time.computed) {
      if (one.channel.moving) wanted.push_back(positions(one.channel));
    }
    std::vector<std::vector<double>> got;
    for (const Computed& one : late.computed) {
      if (one.channel.moving) got.push_back(positions(one.channel));
    }
    EXPECT_EQ(got, wanted);
    EXPECT_EQ(late.told["W731"], 0);
    late.by_chance().close();
    const ReplayResult result = replay(late.by_chance().path(), {});
    EXPECT_TRUE(result.is_same()) << (result.difference ? result.difference->field : "");
  }
}

// A drive that went on with its last velocity is off by a t^2 / 2 at most, and an increment.
TEST(ClockGaps, ADriveThatWentOnIsNearWhatItIsToldNext) {
  LateClock late("mill3.toml", DriveChoice::ideal, 5);
  late.be_late(up_to(3));
  ASSERT_TRUE(late.run(random_part(5)));
  double worst = 0.0;  // of what is allowed
  for (std::size_t k = 1; k < late.sent.size(); ++k) {
    const Sent& before = late.sent[k - 1];
    const Sent& now = late.sent[k];
    if (now.lost == 0) continue;
    const double time = static_cast<double>(now.period - before.period) * period_s;
    const auto& machine = late.by_chance().file().machine;
    for (int axis = 0; axis < 3; ++axis) {
      const channels::AxisSetpoint& from = before.channel.axes[axis];
      const double expected = from.position + from.velocity * time;
      const double off = std::abs(now.channel.axes[axis].position - expected);
      const double allowed = machine.axes[axis].limits.acceleration_max * time * time / 2.0 +
                             machine.axes[axis].resolution;
      worst = std::max(worst, off / allowed);
    }
  }
  EXPECT_GT(worst, 0.1) << "it does brake and accelerate";
  EXPECT_LE(worst, 1.0);
}

std::string circles() {
  return "G21 G90 G17 G64 P0.01\nG0 X20 Y0\nF6000\n"
         "G3 I-20\nG3 I-20\nG3 I-20\nG3 I-20\nG3 I-20\nG3 I-20\nM30\n";
}

// Gaps of 1 to 40 ms: the axes rest behind the long ones, on the circle, and go on by themselves.
TEST(ClockGaps, ThePathRestsBehindLongOnes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LateClock late("mill3.toml", DriveChoice::ideal, seed);
    late.be_late([](std::mt19937_64& random) -> std::int64_t {
      if (random() % 250 != 0) return 0;
      return 1 + static_cast<std::int64_t>(random() % 40);
    });
    ASSERT_TRUE(late.run(circles()));
    const auto& machine = late.by_chance().file().machine;
    int long_gaps = 0;
    for (std::size_t k = 1; k < late.sent.size(); ++k) {
      const bool moved = late.sent[k - 1].channel.moving;
      if (late.sent[k].lost > machine.catch_up_max && moved) ++long_gaps;
    }
    int rests = 0;
    for (std::size_t k = 1; k < late.computed.size(); ++k) {
      const channels::ChannelOutput& before = late.computed[k - 1].channel;
      const channels::ChannelOutput& now = late.computed[k].channel;
      const bool in_cut = now.tag.line > 3 && now.tag.line < 10 && before.tag.line > 3;
      if (!in_cut) continue;
      EXPECT_NEAR(std::hypot(now.point_W[0].value, now.point_W[1].value), 20.0, 1e-9);
      if (now.path_speed == 0.0 && before.path_speed > 0.0) ++rests;
      for (int axis = 0; axis < 3; ++axis) {
        const motion::AxisLimits& limits = machine.axes[axis].limits;
        const channels::AxisSetpoint& setpoint = now.axes[axis];
        EXPECT_LE(std::abs(setpoint.velocity), limits.velocity_max);
        EXPECT_LE(std::abs(setpoint.acceleration), limits.stop_limits * limits.acceleration_max);
      }
    }
    --rests;  // the end of the path
    EXPECT_GE(rests, 2);
    EXPECT_LE(rests, long_gaps) << "one gap may come while the axes brake behind another";
    EXPECT_GE(late.told["W731"], rests);
    EXPECT_LE(late.told["W731"], rests + 2) << "one in the rapid, one while the end is near";
    late.by_chance().close();
    const ReplayResult result = replay(late.by_chance().path(), {});
    EXPECT_TRUE(result.is_same()) << (result.difference ? result.difference->field : "");
  }
}

// The drives went on for 100 ms and then stood, wherever: an operator looks before it goes on.
TEST(ClockGaps, TheRunIsHeldWhereTheControlStoodStill) {
  LateClock late("mill3.toml", DriveChoice::ideal, 1);
  late.begin(circles());
  EXPECT_FALSE(late.go_on(2000));
  ASSERT_TRUE(late.shown.moving);
  bool was_late = false;
  late.be_late(
      [&](std::mt19937_64&) -> std::int64_t { return std::exchange(was_late, true) ? 0 : 11'000; });
  EXPECT_FALSE(late.go_on(3000));
  EXPECT_EQ(late.shown.state, channels::ChannelState::held);
  EXPECT_EQ(late.shown.hold_cause, channels::HoldCause::clock_gap);
  EXPECT_EQ(late.shown.path_speed, 0.0);
  EXPECT_EQ(late.told["W732"], 1);
  late.by_chance().ask(OperatorAction::program_resume, 1);
  EXPECT_TRUE(late.go_on());
  late.by_chance().close();
  EXPECT_TRUE(replay(late.by_chance().path(), {}).is_same());
}

// A run that was held already stays so for its own cause, and goes on as behind that one.
TEST(ClockGaps, AHoldKeepsItsCauseWhereTheControlStoodStill) {
  LateClock late("mill3.toml", DriveChoice::ideal, 1);
  late.begin("G21 G90 G0 X1\nM0\nG0 X2\nG0 X3\nM30\n");
  const auto stand_still = [&] {
    ASSERT_FALSE(late.go_on(1000));
    const channels::HoldCause cause = late.shown.hold_cause;
    late.be_late([was_late = false](std::mt19937_64&) mutable -> std::int64_t {
      return std::exchange(was_late, true) ? 0 : 11'000;
    });
    ASSERT_FALSE(late.go_on(100));
    EXPECT_EQ(late.shown.state, channels::ChannelState::held);
    EXPECT_EQ(late.shown.hold_cause, cause);
  };
  stand_still();
  EXPECT_EQ(late.shown.hold_cause, channels::HoldCause::program_stop);
  channels::OperatorEvent single_block;
  single_block.channel = 1;
  single_block.command = channels::commands::SingleBlock{channels::Switch::on};
  late.by_chance().ask(single_block);
  late.by_chance().ask(OperatorAction::program_resume, 1);
  stand_still();
  EXPECT_EQ(late.shown.hold_cause, channels::HoldCause::single_block);
  EXPECT_NEAR(late.shown.axes[0].position, 2.0, 1e-9);
  late.by_chance().ask(OperatorAction::program_resume, 1);
  ASSERT_FALSE(late.go_on(1000));
  EXPECT_NEAR(late.shown.axes[0].position, 3.0, 1e-9) << "the next step, no other one";
  EXPECT_EQ(late.shown.hold_cause, channels::HoldCause::single_block);
  late.by_chance().ask(OperatorAction::program_resume, 1);
  EXPECT_TRUE(late.go_on());
  EXPECT_EQ(late.told["W732"], 0);
  late.by_chance().close();
  EXPECT_TRUE(replay(late.by_chance().path(), {}).is_same());
}

TEST(ClockGaps, AJogEndsWhereTheControlStoodStill) {
  LateClock late("mill3.toml", DriveChoice::ideal, 1);
  late.by_chance().run(300);
  late.by_chance().ask(OperatorAction::jog, 1, "X", 20.0, 100.0);
  late.by_chance().run(1000);
  ASSERT_TRUE(late.shown.moving);
  const double before = late.shown.axes[0].position;
  bool was_late = false;
  late.be_late(
      [&](std::mt19937_64&) -> std::int64_t { return std::exchange(was_late, true) ? 0 : 11'000; });
  late.by_chance().run(1000);
  EXPECT_FALSE(late.shown.moving);
  EXPECT_LT(late.shown.axes[0].position, before + 20.0 * 0.2);
}

// In a hold axes are jogged away, or led back along the path: these moves end, too, and the hold
// keeps its cause.
TEST(ClockGaps, AMoveInAHoldEndsWhereTheControlStoodStill) {
  for (const OperatorAction action : {OperatorAction::jog, OperatorAction::program_retrace}) {
    SCOPED_TRACE(static_cast<int>(action));
    LateClock late("mill3.toml", DriveChoice::ideal, 1);
    late.begin("G1 X200 F3000\nX400\nM30\n");
    ASSERT_FALSE(late.go_on(2000));
    late.by_chance().ask(OperatorAction::program_hold, 1);
    ASSERT_FALSE(late.go_on(500));
    const bool is_jog = action == OperatorAction::jog;
    late.by_chance().ask(action, 1, is_jog ? "Y" : "", is_jog ? 20.0 : 50.0, is_jog ? 100.0 : 0.0);
    ASSERT_FALSE(late.go_on(500));
    ASSERT_TRUE(late.shown.moving);
    const double before = late.shown.axes[is_jog ? 1 : 0].position;
    bool was_late = false;
    late.be_late([&](std::mt19937_64&) -> std::int64_t {
      return std::exchange(was_late, true) ? 0 : 11'000;
    });
    ASSERT_FALSE(late.go_on(1000));
    EXPECT_FALSE(late.shown.moving);
    EXPECT_TRUE(late.shown.aside);
    EXPECT_NEAR(late.shown.axes[is_jog ? 1 : 0].position, before, 50.0 * 0.2);
    EXPECT_EQ(late.shown.hold_cause, channels::HoldCause::operator_hold);
    late.by_chance().ask(OperatorAction::program_return, 1);
    ASSERT_FALSE(late.go_on(8000));
    EXPECT_FALSE(late.shown.aside);
    late.by_chance().close();
    EXPECT_TRUE(replay(late.by_chance().path(), {}).is_same());
  }
}

std::string thread() {
  return "G18 G8 G90 G97 S300 M3\nG0 X10 Z40\nG33 Z-5 K1.5\nG0 X20\nM30\n";
}

// Of the places of the drives in the steady part of the thread against the angle of the spindle's
// drive: the greatest distance from a straight line of 1.5 mm per turn, mm.
double pitch_error(const std::vector<Sent>& sent) {
  std::vector<double> errors;
  double turns = 0.0;
  double angle_before = 0.0;
  for (const Sent& one : sent) {
    const channels::ChannelOutput& channel = one.channel;
    const double angle = channel.feedback[2].position;
    double step = angle - angle_before;
    step -= 360.0 * std::round(step / 360.0);
    turns += step / 360.0;
    angle_before = angle;
    const double z = channel.feedback[1].position;
    if (channel.tag.line == 3 && z > 250.0 && z < 285.0) errors.push_back(z + 1.5 * turns);
  }
  if (errors.empty()) return std::numeric_limits<double>::infinity();
  const auto [least, most] = std::ranges::minmax(errors);
  return (most - least) / 2.0;
}

TEST(ClockGaps, AThreadIsCutThroughShortOnes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LateClock late("lathe.toml", DriveChoice::simulated, seed);
    late.be_late(up_to(3));
    ASSERT_TRUE(late.run(thread()));
    EXPECT_EQ(late.told["A4001"], 0);
    EXPECT_EQ(late.told["A4002"], 0);
    EXPECT_LE(pitch_error(late.sent), 0.001);
    late.by_chance().close();
    EXPECT_TRUE(replay(late.by_chance().path(), {}).is_same());
  }
}

TEST(ClockGaps, AThreadIsLeftInStepBehindLongOnes) {
  LateClock late("lathe.toml", DriveChoice::simulated, 3);
  late.begin(thread());
  for (int n = 0; n < 20'000 && late.shown.tag.line != 3; ++n) late.by_chance().run(1);
  late.by_chance().run(2500);
  ASSERT_NEAR(late.shown.path_speed, 7.5, 0.1);
  bool was_late = false;
  late.be_late(
      [&](std::mt19937_64&) -> std::int64_t { return std::exchange(was_late, true) ? 0 : 12; });
  ASSERT_TRUE(late.go_on());
  EXPECT_EQ(late.told["A4002"], 1);
  EXPECT_EQ(late.told["A4001"], 0);
}

// A valve is open for one period while another channel moves: a drive and a valve get what the last
// of the cycles says that are computed at once, so none of them may do both.
TEST(ClockGaps, NoItemIsCarriedOutInAPeriodThatIsMadeUpFor) {
  constexpr int pulses = 20;
  std::string blower = "G21 G90\n";
  for (int n = 0; n < pulses; ++n) blower += "M64 P0\nG4 P0.002\nM65 P0\nG4 P0.05\n";
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LateClock late("stress8.toml", DriveChoice::ideal, seed);
    late.by_chance().program("blower.nc", blower + "M30\n");
    late.be_late([](std::mt19937_64& random) -> std::int64_t {
      return random() % 10 == 0 ? 1 + static_cast<std::int64_t>(random() % 20) : 0;
    });
    late.begin(circles());
    late.by_chance().ask(OperatorAction::program_run, 2, "blower.nc");
    EXPECT_TRUE(late.go_on());
    EXPECT_EQ(late.edges, 2 * pulses);
    EXPECT_EQ(late.edges_sent, 2 * pulses);
    late.by_chance().close();
    EXPECT_TRUE(replay(late.by_chance().path(), {}).is_same());
  }
}

// Where the path goes depends on what was not looked at meanwhile.
TEST(ClockGaps, NothingIsMadeUpForWhileAProbeIsAwaited) {
  LateClock late("mill3_probe.toml", DriveChoice::ideal, 2);
  late.begin("G21 G90 G0 Z0\nG38.3 Z-20 F300\nM30\n");
  for (int n = 0; n < 20'000 && late.shown.tag.line != 2; ++n) late.by_chance().run(1);
  late.by_chance().run(300);
  ASSERT_TRUE(late.shown.moving);
  late.be_late(up_to(3));
  late.sent.clear();
  EXPECT_FALSE(late.go_on(1000));
  ASSERT_GT(late.sent.size(), 900U);
  for (std::size_t k = 1; k < late.sent.size(); ++k)
    EXPECT_EQ(late.sent[k].cycle, late.sent[k - 1].cycle + 1);
}

}  // namespace
}  // namespace stanok::runtime
