// Taps that are stopped in their hole: G30 P99 brings them out in step with the spindle, to where
// they began, whatever stopped them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/support/cycle.h"
#include "tests/support/helix.h"
#include "tests/support/machine/machine_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::cycle_s;
using testing::increment_mm;
using testing::MachineBench;

MachineConfig mill() {
  MachineConfig config = testing::two_channel_machine();
  config.spindles[0].encoder_pulses = 1024;
  config.spindles[0].acceleration = 2000.0;
  config.spindles[0].speed_max = 3000.0;
  return config;
}

using Position = std::array<double, 5>;

Position axes_of(const MachineBench& bench) {
  Position at{};
  for (std::size_t k = 0; k < at.size(); ++k) at[k] = bench.channel(1).axes[k].position;
  return at;
}

double distance(const Position& one, const Position& other) {
  double squared = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) squared += std::pow(one[k] - other[k], 2);
  return std::sqrt(squared);
}

struct TapProgram {
  std::string text;  // ends where the tap began
  double lead = 0.0;
  std::uint32_t line = 0;  // of the tap
};

class TapMill {
 public:
  TapMill() : bench(mill(), {.on_at_start = true, .stops_go_on = false}) { bench.cycle(); }

  // What the spindle has turned since the start, and the axes with it.
  void cycle() {
    if (!drives.empty()) follow_setpoints();
    bench.cycle();
    const double speed = bench.channel(1).process.spindle_rev_per_min;
    turns += 0.5 * (speed_ + speed) / 60.0 * cycle_s;
    speed_ = speed;
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) cycle();
  }
  void start(const TapProgram& program) {
    bench.program("p.nc", program.text);
    bench.run(1, "p.nc");
  }
  void stop(OperatorAction action) {
    const bool is_machine = action == OperatorAction::machine_estop;
    bench.ask(action, is_machine ? 0 : 1);
    cycles(2500);
    ASSERT_FALSE(bench.channel(1).moving);
  }
  void recover() {
    for (const int channel : {1, 2}) {
      bench.ask(OperatorAction::program_reset, channel);
      to_end();
    }
    bench.ask(OperatorAction::machine_on, 0);
    to_end();
  }
  void to_end() {
    cycle();
    for (int n = 0; n < 60000 && !bench.machine().waits_for_operator(); ++n) cycle();
  }
  // Code of the alarm that the line ends with, if any.
  std::string line(const std::string& text) {
    bench.ask(OperatorAction::mdi, 1, text);
    bench.run_to_end();
    return codes_since_last_line();
  }
  // To its end, watching that the axes move with the spindle.
  void take_out(double lead, const Position& end) {
    const Position from = axes_of(bench);
    const double turns_before = turns;
    bench.ask(OperatorAction::mdi, 1, "G30 P99");
    double error = 0.0;
    for (int n = 0; n < 60000; ++n) {
      cycle();
      const Position now = axes_of(bench);
      if (n > 0 && bench.machine().waits_for_operator()) break;
      if (distance(now, end) < 2.5) continue;  // the axes brake there
      error =
          std::max(error, std::abs(distance(now, from) - lead * std::abs(turns - turns_before)));
    }
    EXPECT_LE(error, 2.0 * increment_mm);
  }
  std::string codes_since_last_line() {
    const auto codes = bench.alarm_codes();
    std::string found;
    for (std::size_t k = seen_; k < codes.size(); ++k) found += codes[k];
    seen_ = codes.size();
    return found;
  }

  MachineBench bench;
  double turns = 0.0;
  std::vector<AxisFeedback> drives;  // ideal ones while it is empty

 private:
  // Those that have power.
  void follow_setpoints() {
    for (std::size_t k = 0; k < drives.size(); ++k) {
      if (!drives[k].enabled) continue;
      drives[k].position = drives[k].setpoint = bench.channel(1).axes[k].position;
      drives[k].brake_closed = bench.channel(1).drives[k].brake_closed;
    }
    bench.feedback(drives);
  }

  double speed_ = 0.0;
  std::size_t seen_ = 0;
};

class RandomTap {
 public:
  explicit RandomTap(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  TapProgram program() {
    TapProgram made;
    made.lead = 0.5 * pick(1, 4);
    const bool is_left = pick(0, 2) == 0;
    const std::string lead = " K" + std::to_string(made.lead);
    const std::string depth = " Z-" + std::to_string(pick(12, 25));
    const std::string speed = "S" + std::to_string(pick(150, 700)) + (is_left ? " M4\n" : " M3\n");
    static constexpr std::array planes{"G54\n", "G55\n", "G68.2 X10 Y-5 Z3 I0 J30 K0\nG53.1\n",
                                       "G68.2 X10 Y-5 Z3 I90 J20 K0\nG53.1\n"};
    const int plane = pick(0, 3);
    made.text = std::string("#kinematics (") + (plane > 1 ? "2" : "1") + ", 1)\nG90 G94 G17 G99\n";
    made.text += planes[static_cast<std::size_t>(plane)] + speed + "G0 X5 Y-7 Z6\nZ3\n";
    made.line = 1U + static_cast<std::uint32_t>(std::ranges::count(made.text, '\n'));
    if (pick(0, 1) == 0) {
      made.text += "G33.1" + depth + lead + "\n";
    } else {
      made.text += (is_left ? "G74" : "G84") + depth + " R3" + lead + "\nG80\n";
    }
    made.text += "M30\n";
    return made;
  }

 private:
  std::mt19937 random_;
};

constexpr std::array stops{OperatorAction::program_stop, OperatorAction::program_reset,
                           OperatorAction::machine_estop};

class StoppedTap : public ::testing::TestWithParam<unsigned> {};

TEST_P(StoppedTap, ComesOutInStepToWhereItBegan) {
  RandomTap random(GetParam());
  const TapProgram program = random.program();
  SCOPED_TRACE(program.text);
  TapMill whole;
  whole.start(program);
  std::vector<Position> in_tap;
  int before_tap = 0;
  whole.cycles(50);
  for (int n = 50; whole.bench.channel(1).running; ++n) {
    ASSERT_LT(n, 200000);
    whole.cycle();
    EXPECT_FALSE(whole.bench.channel(1).tap_in_hole);
    if (whole.bench.channel(1).tag.line != program.line) continue;
    if (in_tap.empty()) before_tap = n;
    in_tap.push_back(axes_of(whole.bench));
  }
  ASSERT_EQ(whole.codes_since_last_line(), "");
  const Position end = axes_of(whole.bench);
  const auto is_in = [&](const Position& at) { return distance(at, end) > 0.2; };
  const auto first = std::ranges::find_if(in_tap, is_in) - in_tap.begin();
  const auto count = std::ranges::count_if(in_tap, is_in);
  ASSERT_GT(count, 500);

  TapMill mill;
  mill.start(program);
  // Close to its end the tap is braked out of its hole whatever is asked.
  mill.cycles(before_tap + static_cast<int>(first) +
              random.pick(0, static_cast<int>(count) * 9 / 10));
  mill.stop(stops[static_cast<std::size_t>(random.pick(0, 2))]);
  ASSERT_TRUE(mill.bench.channel(1).tap_in_hole);
  EXPECT_THAT(mill.bench.event_codes(), Contains("W734"));
  mill.recover();
  ASSERT_TRUE(mill.bench.channel(1).tap_in_hole);
  mill.cycles(10);
  mill.codes_since_last_line();
  mill.take_out(program.lead, end);
  EXPECT_EQ(mill.codes_since_last_line(), "");
  EXPECT_FALSE(mill.bench.channel(1).tap_in_hole);
  EXPECT_LE(distance(axes_of(mill.bench), end), 1e-9);
  EXPECT_EQ(mill.bench.channel(1).process.spindle_rev_per_min, 0.0);
  EXPECT_EQ(mill.line("G30 P99"), "E6103");
}

INSTANTIATE_TEST_SUITE_P(Random, StoppedTap,
                         ::testing::Range(1U, 1U + stanok::testing::cases(40U)));

// A mill with a tap that was stopped in its way in; it began at Z3.
class TapInItsHole : public ::testing::Test, protected TapMill {
 protected:
  static constexpr double lead = 1.0;
  static TapProgram program() {
    return {.text = "#kinematics (1, 1)\nG90 G94 G17\nS300 M3\nG0 X5 Y-7 Z3\nG33.1 Z-20 K1\nM30\n",
            .lead = lead,
            .line = 5};
  }

  TapInItsHole() {
    bench.may_refuse();
    start(program());
    while (bench.channel(1).axes[2].position > -8.0) cycle();
  }
  [[nodiscard]] static Position at(double z) { return {5.0, -7.0, z, 0.0, 0.0}; }
};

TEST_F(TapInItsHole, IsTakenOutAgainWhenItsWayOutWasStopped) {
  stop(OperatorAction::program_stop);
  for (const OperatorAction next : stops) {
    recover();
    bench.ask(OperatorAction::mdi, 1, "G30 P99");
    const double z = bench.channel(1).axes[2].position;
    while (bench.channel(1).axes[2].position < z + 1.5) cycle();
    EXPECT_TRUE(bench.channel(1).tap_in_hole);
    stop(next);
    EXPECT_TRUE(bench.channel(1).tap_in_hole);
    EXPECT_EQ(bench.channel(1).process.spindle_rev_per_min, 0.0);
  }
  recover();
  cycles(10);
  codes_since_last_line();
  take_out(lead, at(3.0));
  EXPECT_LE(distance(axes_of(bench), at(3.0)), 1e-9);
  EXPECT_FALSE(bench.channel(1).tap_in_hole);
  start(program());
  bench.run_to_end([](const CycleOutput& output) { EXPECT_FALSE(output.channels[0].tap_in_hole); });
  EXPECT_EQ(codes_since_last_line(), "");
}

// Nothing else knows of the tap: the next program does as it always did.
TEST_F(TapInItsHole, OneThatWasFreedByHandIsForgottenWithTheNext) {
  stop(OperatorAction::program_reset);
  recover();
  start(program());
  bench.run_to_end();
  EXPECT_FALSE(bench.channel(1).tap_in_hole);
  EXPECT_EQ(codes_since_last_line(), "");
  EXPECT_EQ(line("G30 P99"), "E6103");
}

TEST_F(TapInItsHole, StaysInWhereItDoesNotStandOnItsWay) {
  stop(OperatorAction::program_stop);
  recover();
  codes_since_last_line();
  struct Way {
    const char* line;
    bool is_shown;  // where it leads, the tap may still be
  };
  for (const auto& [aside, is_shown] : {Way{"G91 G0 X0.2", true}, Way{"G91 G0 Z20", false}}) {
    const Position before = axes_of(bench);
    EXPECT_EQ(line(aside), "");
    const Position jogged = axes_of(bench);
    EXPECT_EQ(line("G30 P99"), "E6104") << aside;
    EXPECT_EQ(axes_of(bench), jogged);
    EXPECT_EQ(bench.channel(1).tap_in_hole, is_shown) << aside;
    recover();
    codes_since_last_line();
    EXPECT_EQ(line("G90 G0 X" + std::to_string(before[0]) + " Z" + std::to_string(before[2])), "");
    EXPECT_TRUE(bench.channel(1).tap_in_hole);
  }
  EXPECT_EQ(line("G30 P99"), "");
  EXPECT_NEAR(bench.channel(1).axes[2].position, 3.0, 1e-9);
}

TEST_F(TapInItsHole, ASpindleThatTurnsIsStoppedBefore) {
  stop(OperatorAction::program_stop);
  recover();
  codes_since_last_line();
  EXPECT_EQ(line("M3 S200"), "");
  EXPECT_EQ(line("G30 P99"), "");
  EXPECT_LE(distance(axes_of(bench), at(3.0)), 1e-9);
  EXPECT_FALSE(bench.channel(1).tap_in_hole);
  EXPECT_EQ(bench.channel(1).process.spindle_rev_per_min, 0.0);
  EXPECT_EQ(line("G33.1 Z-5 K1"), "E4064");
}

TEST_F(TapInItsHole, IsNotTakenOutWhereNothingWasStopped) {
  bench.run_to_end();
  EXPECT_EQ(codes_since_last_line(), "");
  EXPECT_EQ(line("G30 P99"), "E6103");
  recover();
  codes_since_last_line();
  EXPECT_EQ(line("G30 P99 X1"), "E4003");
  recover();
  codes_since_last_line();
  EXPECT_EQ(line("G30 P98"), "E4008");
}

// The power is off at once: the tap screws itself on a little, and the axis sags beside its way.
TEST_F(TapInItsHole, ComesOutParallelToItsWayFromWhereItCameToRestWithoutPower) {
  const double z = bench.channel(1).axes[2].position;
  drives.assign(5, {.valid = true, .enabled = true, .referenced = true});
  cycles(20);
  for (AxisFeedback& drive : drives) drive.enabled = false;
  cycles(100);
  drives[0].position = 5.03;
  drives[2].position = z - 0.4;
  bench.ask(OperatorAction::program_reset, 1);
  cycles(500);
  for (AxisFeedback& drive : drives) drive.enabled = true;
  recover();
  ASSERT_NEAR(bench.channel(1).axes[0].position, 5.03, 1e-9);
  ASSERT_NEAR(bench.channel(1).axes[2].position, z - 0.4, 1e-9);
  ASSERT_TRUE(bench.channel(1).tap_in_hole);
  cycles(10);
  codes_since_last_line();
  const Position end{5.03, -7.0, 3.0, 0.0, 0.0};
  take_out(lead, end);
  EXPECT_TRUE(bench.replies().back().ok) << bench.replies().back().text.view();
  EXPECT_EQ(codes_since_last_line(), "");
  EXPECT_LE(distance(axes_of(bench), end), 1e-9);
}

}  // namespace
}  // namespace stanok::channels
