// Single lines of an operator (MDI) on the machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::HasSubstr;
using testing::MachineBench;

class LineOnMachineTest : public ::testing::Test {
 protected:
  void enter(const std::string& line) {
    bench.ask(OperatorAction::mdi, 1, line);
    bench.run_to_end();
  }
  [[nodiscard]] double x() const { return bench.channel(1).axes[0].position; }
  [[nodiscard]] std::string refusal() const {
    const OperatorReply& reply = bench.replies().back();
    return reply.ok ? "" : std::string(reply.code.view()) + " " + std::string(reply.text.view());
  }

  MachineBench bench;
};

TEST_F(LineOnMachineTest, MovesTheAxesAndLeavesTheChannelIdle) {
  enter("G1 X10 F6000");
  EXPECT_EQ(x(), 10.0);
  EXPECT_EQ(bench.channel(1).state, ChannelState::idle);
  EXPECT_EQ(bench.machine().runs().back().program, "MDI");
}

TEST_F(LineOnMachineTest, IncrementalLinesAddUp) {
  enter("G91 G1 F6000");
  for (int n = 0; n < 5; ++n) enter("X2");
  EXPECT_EQ(x(), 10.0);
}

TEST_F(LineOnMachineTest, TheLoadedProgramStaysLoaded) {
  bench.program("p.nc", "void away () { G0 X50\n }\nG1 X5 F6000\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  enter("away ();");
  EXPECT_EQ(x(), 50.0);
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  bench.ask(OperatorAction::program_start, 1);
  bench.run_to_end();
  EXPECT_EQ(x(), 5.0);
  EXPECT_EQ(bench.machine().runs().back().program, "p.nc");
}

TEST_F(LineOnMachineTest, IsRefusedWhileAProgramRuns) {
  bench.program("p.nc", "G1 X50 F600\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 100; ++n) bench.cycle();
  bench.ask(OperatorAction::mdi, 1, "G0 X0");
  for (int n = 0; n < 10; ++n) bench.cycle();
  EXPECT_THAT(refusal(), HasSubstr("E6003"));
  bench.run_to_end();
  EXPECT_EQ(x(), 50.0);
}

TEST_F(LineOnMachineTest, AnErrorIsTheAnswerAndNothingMoves) {
  enter("G1 X10 W5 F6000");
  EXPECT_THAT(refusal(), HasSubstr("MDI:1:8"));
  EXPECT_EQ(x(), 0.0);
  EXPECT_EQ(bench.channel(1).state, ChannelState::idle);
}

TEST_F(LineOnMachineTest, AnAlarmOfALineIsClearedByReset) {
  enter("G1 X99999 F6000");
  EXPECT_EQ(bench.channel(1).state, ChannelState::alarm);
  ASSERT_EQ(bench.machine().alarms().size(), 1u);
  EXPECT_EQ(bench.machine().alarms()[0].diagnostic.place.file, "MDI");
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  enter("G1 X1 F6000");
  EXPECT_EQ(x(), 1.0);
}

}  // namespace
}  // namespace stanok::channels
