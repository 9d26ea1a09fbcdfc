// Leave and return: what ends it, what it refuses, and the first run of a part. That a program goes
// on as if nobody had touched it: hands_on_machine_test.cc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/machine/held_program.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

using testing::HeldProgram;

class MoveAside : public ::testing::TestWithParam<testing::HeldCase> {};

TEST_P(MoveAside, AResetLeavesTheAxesWhereTheyAre) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    HeldProgram scene(GetParam(), seed);
    scene.go_on(scene.pick(100, 3000));
    scene.hold();
    if (!scene.bench.channel(1).running) continue;
    for (int jogs = scene.pick(1, 6); jogs > 0; --jogs) scene.jog();
    const HeldProgram::Places away = scene.axes();
    scene.bench.ask(OperatorAction::program_reset, 1);
    scene.cycle();
    scene.rest();
    EXPECT_EQ(scene.axes(), away);
    EXPECT_FALSE(scene.bench.channel(1).aside);
    scene.bench.ask(OperatorAction::mdi, 1, "G53 G1 X" + std::to_string(away[0]) + " F500");
    scene.bench.run_to_end();
    for (std::size_t k = 0; k < away.size(); ++k) EXPECT_NEAR(scene.axes()[k], away[k], 1e-5);
  }
}

// The rapid override may lower it further; the feed is what it was.
TEST(FirstPart, RapidTraverseKeepsToAQuarter) {
  const auto fastest = [](int is_first, double override_percent) {
    MachineBench bench(testing::two_channel_machine(), {.on_at_start = true});
    bench.program("p.nc", "G0 X200\nG1 X0 F6000\nM30\n");
    bench.ask(OperatorAction::first_part, 1, "", 0.0, is_first);
    bench.ask(OperatorAction::override_rapid, 1, "", 0.01 * override_percent);
    bench.run(1, "p.nc");
    std::array<double, 2> speeds{};
    bench.run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      double& speed = speeds[channel.feed_commanded > 0.0 ? 1 : 0];
      speed = std::max(speed, channel.path_speed);
    });
    return speeds;
  };
  EXPECT_NEAR(fastest(0, 100.0)[0], 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 100.0)[0], 0.25 * 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 10.0)[0], 0.10 * 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 100.0)[1], 100.0, 1e-6);
}

// [machine] first_run: until a program has run to its end; a subprogram belongs to its text.
TEST(FirstPart, IsTheFirstRunOfEachText) {
  MachineConfig machine = testing::two_channel_machine();
  machine.first_run = true;
  MachineBench bench(machine, {.on_at_start = true, .stops_go_on = false});
  const auto fastest = [&](const char* name, int reset_after = 0) {
    bench.run(1, name);
    double speed = 0.0;
    int cycles = 0;
    bench.run_to_end([&](const CycleOutput& output) {
      if (++cycles == reset_after) bench.ask(OperatorAction::program_reset, 1);
      speed = std::max(speed, output.channels[0].path_speed);
    });
    bench.ask(OperatorAction::mdi, 1, "G0 X0");
    bench.run_to_end();
    return speed;
  };
  bench.program("sub.nc", "const num far = 100;\n");
  bench.program("a.nc", "#include \"sub.nc\"\nG0 X200\nM30\n");
  bench.program("b.nc", "G0 X150\nM30\n");
  EXPECT_NEAR(fastest("a.nc", 500), 62.5, 1e-6) << "a reset is no end";
  EXPECT_NEAR(fastest("a.nc"), 62.5, 1e-6);
  EXPECT_NEAR(fastest("a.nc"), 250.0, 1e-6);
  EXPECT_NEAR(fastest("b.nc"), 62.5, 1e-6);
  EXPECT_NEAR(fastest("a.nc"), 250.0, 1e-6);
  EXPECT_NEAR(fastest("b.nc"), 250.0, 1e-6);
  bench.program("b.nc", "G0 X151\nM30\n");
  EXPECT_NEAR(fastest("b.nc"), 62.5, 1e-6);
  bench.program("sub.nc", "const num far = 101;\n");
  EXPECT_NEAR(fastest("a.nc"), 62.5, 1e-6);
}

// What lies before the line where it was started has not run.
TEST(FirstPart, ARunFromTheMiddleIsNone) {
  MachineConfig machine = testing::two_channel_machine();
  machine.first_run = true;
  MachineBench bench(machine, {.on_at_start = true, .stops_go_on = false});
  bench.program("a.nc", "G0 X200\nG0 X0\nG0 X200\nG0 X0\nM30\n");
  const auto fastest = [&](const char* from) {
    bench.ask(OperatorAction::program_load, 1, "a.nc");
    bench.run_to_end();
    if (from != nullptr) bench.ask(OperatorAction::program_search, 1, from);
    bench.run_to_end();
    bench.ask(OperatorAction::program_start, 1);
    double speed = 0.0;
    bench.run_to_end(
        [&](const CycleOutput& output) { speed = std::max(speed, output.channels[0].path_speed); });
    return speed;
  };
  EXPECT_NEAR(fastest("3"), 62.5, 1e-6);
  EXPECT_NEAR(fastest(nullptr), 62.5, 1e-6);
  EXPECT_NEAR(fastest("3"), 250.0, 1e-6);
}

class Refusals : public ::testing::Test {
 protected:
  std::string code_of(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 20000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  void hold_in(const std::string& text) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    cycles(300);
    EXPECT_EQ(code_of(commands::ProgramReturn{}), "E6096");
    bench.ask(OperatorAction::program_hold, 1);
    cycles(300);
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  static commands::Jog jog_of(const char* axis) {
    return {.axis = ShortText(axis), .velocity = 50.0, .increment = 0.1};
  }

  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].probe_input = 7;
    return config;
  }

  MachineBench bench{machine(), {.on_at_start = true}};
};

TEST_F(Refusals, OnThePathThereIsNothingToReturnFrom) {
  hold_in("G1 X100 F600\nM30\n");
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "E6098");
}

TEST_F(Refusals, AProbeThatIsAwaitedKeepsTheAxesOnThePath) {
  hold_in("G38.3 X100 F600\nM30\n");
  EXPECT_EQ(code_of(jog_of("Y")), "E6099");
}

TEST_F(Refusals, TheWayBackHasAnEnd) {
  hold_in("G1 X100 F600\nM30\n");
  for (int n = 0; n < 63; ++n) {
    EXPECT_EQ(code_of(jog_of(n % 2 == 0 ? "Y" : "Z")), "");
    cycles(100);
  }
  EXPECT_EQ(code_of(jog_of("Z")), "E6100");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "E6097");
  EXPECT_EQ(code_of(commands::ProgramReturn{.velocity = 50.0}), "");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
}

// One move after the other, so that the way back is the way that was free.
TEST_F(Refusals, OneAxisMovesAtATime) {
  hold_in("G1 X100 F600\nM30\n");
  bench.ask(OperatorAction::jog, 1, "Y", 5.0);
  bench.cycle();
  EXPECT_EQ(code_of(jog_of("Z")), "E6056");
}

// A return that waits for its spindle is called off by whoever moves on by hand: it does not begin
// behind that move.
TEST(Return, IsCalledOffByAJogWhileItWaitsForTheSpindle) {
  MachineBench bench(testing::turning_machine(), {.on_at_start = true});
  const auto ask = [&](const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    bench.ask(event);
  };
  const auto cycles = [&](int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  };
  const commands::Jog jog{.axis = ShortText("X"), .velocity = 50.0, .increment = 1.0};
  bench.program("p.nc", "S1000 M3\nG94 G1 X50 F600\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  for (int n = 0; n < 20000 && bench.channel(1).path_speed < 5.0; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  cycles(300);
  ask(commands::SpindleSwitch{Switch::off});
  for (int n = 0; n < 20000 && bench.channel(1).process.spindles[0].rev_per_min != 0.0; ++n)
    bench.cycle();
  ask(jog);
  cycles(300);
  ASSERT_TRUE(bench.channel(1).aside);
  ask(commands::ProgramReturn{});
  cycles(20);
  ASSERT_LT(bench.channel(1).process.spindles[0].rev_per_min, 900.0) << "it still waits";
  ask(jog);
  cycles(300);
  const double stands = bench.channel(1).axes[testing::lathe_X].position;
  cycles(5000);
  EXPECT_EQ(bench.channel(1).axes[testing::lathe_X].position, stands);
  EXPECT_TRUE(bench.channel(1).aside);
  EXPECT_EQ(bench.replies()[bench.replies().size() - 1].code.view(), "E6072");
}

INSTANTIATE_TEST_SUITE_P(All, MoveAside,
                         ::testing::Values(testing::held_mill(), testing::held_led_point(),
                                           testing::held_lathe()),
                         [](const auto& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace stanok::channels
