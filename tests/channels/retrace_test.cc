// Retrace: how far the axes of a held program go back along its path, and what ends that.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/machine/machine_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

class RetraceTest : public ::testing::Test {
 protected:
  RetraceTest() { bench.cycle(); }

  // `session`: who asks; `seen`: cycle that it saw last, < 0: it does not say.
  struct Asker {
    std::int32_t session = 1;
    std::int64_t seen = -1;
  };

  std::string code_of(const OperatorCommand& command, const Asker& asker = {1, -1}) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    event.session = asker.session;
    event.seen_cycle = asker.seen;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  static commands::ProgramRetrace back(double length = 0.0) {
    return {RetraceDirection::back, length};
  }
  static commands::ProgramRetrace forward(double length = 0.0) {
    return {RetraceDirection::forward, length};
  }

  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  void rest() {
    bench.cycle();
    for (int n = 0; n < 60000 && channel().moving; ++n) bench.cycle();
  }
  // Held where X passes `x`.
  void hold_at(double x, const std::string& text) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    for (int n = 0; n < 60000 && this->x() < x; ++n) bench.cycle();
    bench.ask(OperatorAction::program_hold, 1);
    cycles(5);
    rest();
  }

  [[nodiscard]] const ChannelOutput& channel() const { return bench.channel(1); }
  [[nodiscard]] double x() const { return channel().axes[0].position; }

  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].probe_input = 7;
    return config;
  }

  MachineBench bench{machine(), {.on_at_start = true, .stops_go_on = false}};
};

TEST_F(RetraceTest, GoesBackByAWayAlongThePathAndSaysHowFarItCan) {
  hold_at(25.0, "G1 X10 F3000\nY5\nX20\nY0\nX40\nM30\n");
  EXPECT_EQ(channel().retrace.blocks_back, 5U);
  EXPECT_EQ(channel().retrace.oldest_line, 1U);
  EXPECT_EQ(channel().retrace.line, 0U);
  const double held = x();
  EXPECT_EQ(code_of(back(held - 20.0 + 2.0)), "");
  rest();
  EXPECT_NEAR(channel().axes[0].position, 20.0, 1e-9);
  EXPECT_NEAR(channel().axes[1].position, 2.0, 1e-9);
  EXPECT_EQ(channel().retrace.line, 4U);
  EXPECT_EQ(channel().retrace.blocks_back, 4U);
  EXPECT_TRUE(channel().aside);
  EXPECT_EQ(channel().state, ChannelState::held);
  EXPECT_EQ(code_of(commands::ProgramResume{}), "E6097");
  EXPECT_EQ(code_of(forward(1000.0)), "");
  rest();
  EXPECT_EQ(x(), held);
  EXPECT_FALSE(channel().aside);
  EXPECT_EQ(code_of(forward()), "E6102");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
  bench.run_to_end();
  EXPECT_EQ(x(), 40.0);
}

// What acts on the machine cannot be undone; a frame, a dwell and a stop can.
TEST_F(RetraceTest, EndsBehindTheLastCommandToTheMachine) {
  struct Row {
    const char* command;
    std::uint32_t oldest_line;
  };
  for (const Row& row :
       {Row{"M3 S500", 3}, Row{"M8", 3}, Row{"T2 M6", 3}, Row{"M62 P1", 3}, Row{"M64 P1", 3},
        Row{"G38.3 X11", 3}, Row{"G4 P0.01", 1}, Row{"G55", 1}}) {
    SCOPED_TRACE(row.command);
    hold_at(15.0, std::string("G1 X10 F3000\n") + row.command + "\nG1 X20\nX30\nM30\n");
    EXPECT_EQ(code_of(back()), "");
    for (int n = 0; n < 100 && channel().retrace.blocks_back > 0; ++n) {
      cycles(100);
      static_cast<void>(code_of(back()));
    }
    rest();
    EXPECT_EQ(channel().retrace.line, row.oldest_line);
    EXPECT_EQ(code_of(back()), "E6102");
    EXPECT_EQ(code_of(commands::ProgramReset{}), "");
    bench.run_to_end();
    EXPECT_EQ(code_of(commands::Mdi{ShortText("G53 G0 X0 Y0 Z0")}), "");
    bench.run_to_end();
  }
}

TEST_F(RetraceTest, IsALeaseOfOneSession) {
  hold_at(25.0, "G1 X40 F600\nM30\n");
  const std::int64_t seen = bench.output().cycle;
  EXPECT_EQ(code_of(back(), {1, seen}), "");
  for (int n = 0; n < 10; ++n) {
    cycles(100);
    EXPECT_EQ(code_of(back(), {1, seen}), "") << "a renewal may be old";
    EXPECT_EQ(code_of(back(), {2, seen}), "E6056") << "another session moves it";
  }
  EXPECT_TRUE(channel().moving);
  cycles(300);
  EXPECT_FALSE(channel().moving) << "it is not renewed";
  EXPECT_EQ(code_of(back(), {1, seen}), "E6073");
  const double stands = x();
  EXPECT_EQ(code_of(forward(), {2, bench.output().cycle}), "");
  cycles(50);
  EXPECT_GT(x(), stands);
  EXPECT_EQ(code_of(commands::ProgramHold{}), "");
  cycles(100);
  EXPECT_FALSE(channel().moving) << "hold stops it at once";
}

// An old renewal that comes to the end is told so, and not that it is late.
TEST_F(RetraceTest, SaysThatTheWayHasEnded) {
  hold_at(5.0, "G1 X40 F600\nM30\n");
  const std::int64_t seen = bench.output().cycle;
  std::string code;
  for (int n = 0; n < 1000 && code.empty(); ++n) {
    code = code_of(back(), {1, seen});
    cycles(80);
  }
  EXPECT_EQ(code, "E6102");
  EXPECT_EQ(x(), 0.0);
}

TEST_F(RetraceTest, IsForAHeldProgramWhoseAxesAreOnItsPath) {
  EXPECT_EQ(code_of(back()), "E6007");
  hold_at(5.0, "G1 X40 F600\nM30\n");
  EXPECT_EQ(code_of(commands::Jog{ShortText("Y"), 20.0, 1.0, JogFrame::machine}), "");
  rest();
  EXPECT_EQ(code_of(back()), "E6097");
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
  EXPECT_EQ(code_of(back(-1.0)), "E6054");
  EXPECT_EQ(code_of(back(1.0)), "");
  EXPECT_EQ(code_of(commands::Jog{ShortText("Y"), 20.0, 1.0, JogFrame::machine}), "E6056");
  rest();
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
  EXPECT_EQ(code_of(back()), "E6096");
}

// Turned back and forwards, at any pace: the axes follow, and stand soon after the wheel.
TEST_F(RetraceTest, FollowsAHandwheel) {
  hold_at(35.0, "G1 X40 F1200\nM30\n");
  const double held = x();
  double turned = 0.0;
  for (int n = 0; n < 40; ++n) {  // 2 mm/s
    EXPECT_EQ(code_of(commands::Handwheel{ShortText("path"), -0.1}), "");
    turned += 0.1;
    cycles(50);
  }
  cycles(100);
  EXPECT_FALSE(channel().moving);
  EXPECT_NEAR(x(), held - turned, 1e-9) << "slow turns are followed to the end";
  for (int n = 0; n < 100; ++n) {  // 200 mm/s, the feed is 20 mm/s
    EXPECT_EQ(code_of(commands::Handwheel{ShortText("path"), -2.0}), "");
    cycles(10);
  }
  EXPECT_TRUE(channel().moving);
  const double when_it_stops = x();
  for (int n = 0; n < 400 && channel().moving; ++n) bench.cycle();
  EXPECT_FALSE(channel().moving);
  EXPECT_NEAR(x(), when_it_stops, 20.0 * 0.3);
  EXPECT_GT(x(), 0.0);
  for (int n = 0; n < 100 && channel().aside; ++n) {
    const std::string code = code_of(commands::Handwheel{ShortText("path"), 2.0});
    EXPECT_TRUE(code.empty() || code == "E6102") << code;
    cycles(60);
  }
  EXPECT_EQ(x(), held);
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
  EXPECT_EQ(code_of(commands::Handwheel{ShortText("path"), 2.0}), "E6003");
}

// What was asked for at an override of 0 is over, and does not begin when that is raised.
TEST_F(RetraceTest, DoesNotWaitForAnOverride) {
  hold_at(25.0, "G1 X40 F3000\nM30\n");
  const double held = x();
  EXPECT_EQ(code_of(commands::OverrideFeed{0.0}), "");
  EXPECT_EQ(code_of(back(10.0)), "");
  cycles(50);
  EXPECT_FALSE(channel().moving);
  EXPECT_EQ(code_of(commands::OverrideFeed{1.0}), "");
  cycles(500);
  EXPECT_EQ(x(), held);
  EXPECT_EQ(code_of(back(10.0)), "");
  cycles(100);
  EXPECT_EQ(code_of(commands::OverrideFeed{0.0}), "");
  rest();
  const double stands = x();
  EXPECT_LT(stands, held);
  EXPECT_EQ(code_of(commands::OverrideFeed{1.0}), "");
  cycles(500);
  EXPECT_EQ(x(), stands);
}

// While it comes to rest no way is taken that would be dropped.
TEST_F(RetraceTest, RefusesAWayWhileItStops) {
  hold_at(25.0, "G1 X40 F3000\nM30\n");
  EXPECT_EQ(code_of(back(20.0)), "");
  cycles(200);
  bench.ask(OperatorAction::program_hold, 1);
  bench.cycle();
  ASSERT_TRUE(channel().moving);
  EXPECT_EQ(code_of(back(1.0)), "E6056");
  rest();
  const double stands = x();
  EXPECT_EQ(code_of(back(1.0)), "");
  rest();
  EXPECT_NEAR(x(), stands - 1.0, 1e-9);
}

// At a program stop the axes stand between two pieces of the path.
TEST_F(RetraceTest, GoesBackFromAProgramStop) {
  bench.program("p.nc", "G1 X10 F3000\nX10 Y7\nM0\nX0\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 60000 && channel().state != ChannelState::held; ++n) bench.cycle();
  EXPECT_EQ(code_of(back(9.0)), "");
  rest();
  EXPECT_NEAR(x(), 8.0, 1e-9);
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
  EXPECT_NEAR(channel().axes[1].position, 7.0, 1e-9);
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
  bench.run_to_end();
  EXPECT_EQ(x(), 0.0);
}

// Nothing is kept of a run for the next one.
TEST_F(RetraceTest, EndsWhereTheRunBegan) {
  bench.program("before.nc", "G1 X3 F3000\nM30\n");
  bench.run(1, "before.nc");
  bench.run_to_end();
  EXPECT_EQ(channel().retrace.blocks_back, 0U);
  EXPECT_EQ(channel().retrace.oldest_line, 0U);
  hold_at(10.0, "G1 X40 F3000\nM30\n");
  EXPECT_EQ(code_of(back(1000.0)), "");
  rest();
  EXPECT_NEAR(x(), 3.0, 1e-9);
}

TEST_F(RetraceTest, AFaultWhileItMovesStopsItWhereItIs) {
  hold_at(25.0, "G1 X40 F3000\nM30\n");
  EXPECT_EQ(code_of(back(20.0)), "");
  cycles(100);
  ASSERT_TRUE(channel().moving);
  bench.ask(OperatorAction::machine_estop, 1);
  bench.run_to_end();
  const double stands = x();
  EXPECT_GT(stands, 6.0);
  EXPECT_LT(stands, 25.0);
  EXPECT_FALSE(channel().aside);
  EXPECT_EQ(channel().state, ChannelState::alarm);
  cycles(500);
  EXPECT_EQ(x(), stands);
}

// The whole way of a program of many short blocks, which cannot be undone before.
TEST(Retrace, HoldsAHundredThousandBlocks) {
  const int blocks = testing::cases(100'000);
  MachineBench bench(testing::two_channel_machine(), {.on_at_start = true});
  std::string text = "M3 S500\nF6000\n";
  for (int k = 1; k <= blocks + 2000; ++k) {
    const double a = 0.002 * k;
    text += "G1 X" + std::to_string(20.0 - 20.0 * std::cos(a)) + " Y" +
            std::to_string(20.0 * std::sin(a)) + "\n";
  }
  bench.program("p.nc", text + "M30\n");
  bench.run(1, "p.nc");
  const auto& channel = [&]() -> const ChannelOutput& { return bench.channel(1); };
  bench.cycle();
  for (int n = 0; n < 1000 && !channel().running; ++n) bench.cycle();
  while (channel().retrace.blocks_back < static_cast<std::uint64_t>(blocks)) {
    ASSERT_TRUE(channel().running);
    bench.cycle();
  }
  bench.ask(OperatorAction::program_hold, 1);
  for (int n = 0; n < 500; ++n) bench.cycle();
  const double held_x = channel().axes[0].position;
  const double held_y = channel().axes[1].position;
  for (const RetraceDirection direction : {RetraceDirection::back, RetraceDirection::forward}) {
    OperatorEvent event;
    event.channel = 1;
    event.command = commands::ProgramRetrace{direction, 1e6};
    bench.ask(event);
    bench.cycle();
    for (int n = 0; n < 200000 && channel().moving; ++n) bench.cycle();
    const bool is_back = direction == RetraceDirection::back;
    EXPECT_NEAR(channel().axes[0].position, is_back ? 0.0 : held_x, 1e-9);
    EXPECT_NEAR(channel().axes[1].position, is_back ? 0.0 : held_y, 1e-9);
    EXPECT_EQ(channel().retrace.line, is_back ? 3U : 0U);
  }
  EXPECT_FALSE(channel().aside);
}

TEST(Retrace, WithoutMemoryTheWayEndsWithTheBlock) {
  MachineConfig config = testing::two_channel_machine();
  config.retrace_memory_mb = 0;
  MachineBench bench(config, {.on_at_start = true});
  bench.program("p.nc", "G1 X10 F3000\nX20 Y5\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  for (int n = 0; n < 60000 && bench.channel(1).axes[1].position < 2.0; ++n) bench.cycle();
  EXPECT_EQ(bench.channel(1).retrace.blocks_back, 1U);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).axes[0].position, 20.0);
}

}  // namespace
}  // namespace stanok::channels
