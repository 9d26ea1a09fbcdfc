// A length of the tool that an operator changes in a hold counts at once, also for what was
// prepared before. That the axes go by the change beside where they went: hands_on_machine_test.cc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/machine/held_program.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

// The point of a longer tool goes back where the one before came: up first.
TEST(NewLengthAside, TheWayOfThePointIsTheOneThatWasFree) {
  testing::HeldProgram scene(testing::held_mill(), 1);
  scene.go_on(1500);
  scene.hold();
  const testing::HeldProgram::Places held = scene.axes();
  scene.jog("X", 20.0);
  EXPECT_EQ(scene.change("length", 30.0), "");
  scene.bench.ask(OperatorAction::program_return, 1);
  double lowest = 1e9;
  for (int n = 0; n < 20000 && scene.bench.channel(1).aside; ++n) {
    scene.cycle();
    const testing::HeldProgram::Places now = scene.axes();
    if (std::abs(now[0] - held[0] - 20.0) > 1e-6) lowest = std::min(lowest, now[2]);
  }
  EXPECT_NEAR(lowest, held[2] + 30.0, 1e-9);
}

// What lies in the queue when the length changes was prepared for the one before.
class PreparedBefore : public ::testing::Test {
 protected:
  explicit PreparedBefore(MachineConfig config = testing::two_channel_machine())
      : bench(std::move(config), {.on_at_start = true, .stops_go_on = false}) {}

  std::string code_of(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = std::holds_alternative<commands::ToolSet>(command) ? 0 : 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  std::string set(int tool, const char* key, double value) {
    return code_of(commands::ToolSet{.key = ShortText(key), .value = value, .tool = tool});
  }
  void hold_in(const std::string& text, int after = 400) {
    ASSERT_EQ(set(1, "length", 50.0), "");
    ASSERT_EQ(set(2, "length", 80.0), "");
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    for (int n = 0; n < after; ++n) bench.cycle();
    bench.ask(OperatorAction::program_hold, 1);
    for (int n = 0; n < 400; ++n) bench.cycle();
    ASSERT_EQ(bench.channel(1).state, ChannelState::held);
  }
  // To the end of the run, or to where the path is elsewhere than the axes; Z at the end of each
  // line.
  void go_on() {
    if (bench.channel(1).aside) {
      EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
    }
    bench.ask(OperatorAction::program_start, 1);
    for (int n = 0; n < 60000; ++n) {
      bench.cycle();
      z[bench.channel(1).tag.line] = bench.channel(1).axes[2].position;
      if (!bench.channel(1).running || bench.channel(1).hold_cause == HoldCause::changed_length)
        return;
    }
    ADD_FAILURE() << "no end";
  }

  std::map<std::uint32_t, double> z;
  MachineBench bench;
};

TEST_F(PreparedBefore, AMachinePositionIsWhereItIs) {
  hold_in("G61 G43 H1\nG1 Z1 F3000\nX50\nG53 G1 Z100\nX60 Z2\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_NEAR(z[3], 1.0 + 52.5, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  EXPECT_TRUE(bench.channel(1).aside);
  go_on();
  EXPECT_NEAR(z[4], 100.0, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  go_on();
  EXPECT_NEAR(z[5], 2.0 + 52.5, 1e-9);
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, ALengthThatWasReadAheadCountsWhereItComesIntoForce) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nG43 H2\nX60 Z2\nM30\n");
  EXPECT_EQ(set(2, "length", 81.0), "");
  EXPECT_FALSE(bench.channel(1).aside);
  go_on();
  EXPECT_NEAR(z[3], 1.0 + 50.0, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  go_on();
  EXPECT_NEAR(z[5], 2.0 + 81.0, 1e-9);
  EXPECT_FALSE(bench.channel(1).running);
}

// So much that the blocks behind it are prepared later.
std::string many_blocks() {
  std::string text;
  for (int n = 0; n < 400; ++n) text += n % 2 == 0 ? "X10\n" : "X14\n";
  return text;
}

TEST_F(PreparedBefore, WhatIsPreparedLaterKnowsIt) {
  hold_in("G61 G43 H1\nG1 Z1 F6000\n" + many_blocks() +
          "G53 G1 Z100\nG91 G1 Z-1\nG90 X20\nG49\nG91 Z3\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[403], 100.0, 1e-6);
  EXPECT_NEAR(z[404], 99.0, 1e-6);
  EXPECT_NEAR(z[407], 102.0, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, TheEndOfALengthMovesNothing) {
  hold_in("G61 G43 H1\nG1 Z1 F6000\n" + many_blocks() + "G49\nG91 X1\nZ3\nG43 H1\nG90 Z7\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[404], 53.5, 1e-9);
  EXPECT_NEAR(z[405], 56.5, 1e-9);
  EXPECT_NEAR(z[407], 59.5, 1e-9);
}

// The position on the way to which the program reads it again.
TEST_F(PreparedBefore, AnswersOfTheMachineAreInIt) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nT2 M6\nG91 Z1\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[5], 2.0 + 52.5, 1e-9);
}

TEST_F(PreparedBefore, TheNextRunBeginsWithTheTable) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  z.clear();
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_NEAR(bench.channel(1).axes[2].position, 1.0 + 52.5, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, OtherValuesChangeAsInARun) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n");
  EXPECT_EQ(set(1, "radius", 5.0), "E6101");
  EXPECT_EQ(set(1, "wear_radius", 0.51), "E6101");
  EXPECT_EQ(set(1, "wear_radius", 0.1), "");
  EXPECT_FALSE(bench.channel(1).aside);
  EXPECT_EQ(set(1, "length", 1e7), "E5020");
  EXPECT_FALSE(bench.channel(1).aside);
}

class Probed : public PreparedBefore {
 protected:
  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].probe_input = 7;
    return config;
  }
  Probed() : PreparedBefore(machine()) {}
};

// The axes stand where the probe changed, and not at the end of the way that was programmed.
TEST_F(Probed, AContactBehindTheChangeIsWhereTheAxesStand) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nG38.3 Z-20 F600\nG91 G1 Z5 F600\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
  bench.ask(OperatorAction::program_start, 1);
  Signals signals;
  double stands_at = 0.0;
  for (int n = 0; n < 60000 && bench.channel(1).running; ++n) {
    const double z_M = bench.cycle().channels[0].axes[2].position;
    signals.set(7, bench.channel(1).tag.line == 4 && z_M < 45.0);
    bench.inputs(signals);
    if (bench.channel(1).tag.line == 4) stands_at = z_M;
    ASSERT_NE(bench.channel(1).hold_cause, HoldCause::changed_length);
  }
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_GT(stands_at, 30.0) << "it did not reach the end of its way";
  EXPECT_NEAR(bench.channel(1).axes[2].position, stands_at + 5.0, 1e-6);
}

TEST_F(PreparedBefore, TheAxesKeepTheirTravel) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n", 1500);
  EXPECT_EQ(set(1, "length", 499.0), "");
  EXPECT_EQ(set(1, "length", 501.0), "E6053");
  EXPECT_EQ(set(1, "length", 52.0), "");
}

TEST_F(PreparedBefore, WhileTheAxesComeToRestNoLengthChanges) {
  ASSERT_EQ(set(1, "length", 50.0), "");
  bench.program("p.nc", "G43 H1\nG1 Z1 F6000\nX200\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 1000; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.cycle();
  EXPECT_EQ(set(1, "length", 51.0), "E6070");
}

class LedPoint : public PreparedBefore {
 protected:
  LedPoint() : PreparedBefore(testing::five_axis_machine()) {}
};

// Speeds of the linear axes depend on the length there.
TEST_F(LedPoint, KeepsItsLength) {
  hold_in("G43.4 H1\nG1 Z1 F3000\nX50 B10\nM30\n");
  EXPECT_EQ(set(1, "length", 51.0), "E6101");
  EXPECT_EQ(set(2, "length", 81.0), "");
}

TEST_F(LedPoint, HasALengthThatCounts) {
  constexpr const char* text = "G43 H1\nG1 Z1 F3000\nX50\nG43.4 H2\nX60 Z3 B10\nM30\n";
  hold_in(text);
  EXPECT_EQ(set(2, "length", 81.0), "");
  go_on();
  if (bench.channel(1).running) go_on();
  EXPECT_FALSE(bench.channel(1).running);
  const double x = bench.channel(1).axes[0].position;
  const double held_z = bench.channel(1).axes[2].position;
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_NEAR(bench.channel(1).axes[0].position, x, 1e-9);
  EXPECT_NEAR(bench.channel(1).axes[2].position, held_z, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

}  // namespace
}  // namespace stanok::channels
