// Single block: the program stops after each block and each statement with an effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using ::testing::DoubleNear;
using ::testing::IsEmpty;
using testing::MachineBench;
using ::testing::Pointwise;

// On channel 1 with single block on from the beginning.
class SingleBlockTest : public ::testing::Test {
 protected:
  void begin(const std::string& text) {
    bench.program("p.nc", text);
    bench.ask(OperatorAction::single_block, 1, "", 0.0, 1);
    bench.run(1, "p.nc");
    bench.run_to_end();
  }
  void next() {
    bench.ask(OperatorAction::program_start, 1);
    bench.run_to_end();
  }
  [[nodiscard]] double x() const { return bench.channel(1).axes[0].position; }
  [[nodiscard]] bool stands_at_step() const {
    return bench.channel(1).state == ChannelState::held &&
           bench.channel(1).hold_cause == HoldCause::single_block;
  }
  // X at every stop until the program is over.
  std::vector<double> stops() {
    std::vector<double> found;
    for (int n = 0; n < 100 && bench.channel(1).state == ChannelState::held; ++n) {
      EXPECT_TRUE(stands_at_step());
      found.push_back(x());
      next();
    }
    EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
    EXPECT_THAT(bench.alarm_codes(), IsEmpty());
    return found;
  }

  MachineBench bench;
};

TEST_F(SingleBlockTest, EachStartLetsOneBlockRun) {
  begin("G1 X1 F6000\nX2\nG0 X5\nM30\n");
  EXPECT_THAT(stops(), Pointwise(DoubleNear(1e-9), {1.0, 2.0, 5.0}));
}

// As somebody does who is not sure that it stands.
TEST_F(SingleBlockTest, HoldPressedBetweenBlocksCostsNoSecondStart) {
  begin("G1 X1 F6000\nX2\nX3\nM30\n");
  std::vector<double> found;
  for (int n = 0; n < 100 && bench.channel(1).state == ChannelState::held; ++n) {
    found.push_back(x());
    bench.ask(OperatorAction::program_hold, 1);
    bench.cycle();
    EXPECT_TRUE(stands_at_step());
    next();
  }
  EXPECT_THAT(found, Pointwise(DoubleNear(1e-9), {1.0, 2.0, 3.0}));
}

TEST_F(SingleBlockTest, BlocksThatMoveNothingAreNoStepsButTheirEffectsAre) {
  begin("G21 G90 G94\nF6000\nG1 X1\nM8\nG4 P0.1\nS500 M3 X2\nM30\n");
  EXPECT_THAT(stops(), Pointwise(DoubleNear(1e-9), {1.0, 1.0, 1.0, 2.0}));
}

// A tool change before the first move, and a spindle that takes its time before a move: each block
// is one stop, and shows its own line.
TEST_F(SingleBlockTest, EachBlockIsOneStopThatShowsItsLine) {
  begin("G21 G90 G94 F6000\nT1 M6\nS3000 M3\nG54\nG1 X1\nM8\nX2\nG55\nG43.4 H1\nX3\nG49\nM30\n");
  std::vector<std::uint32_t> lines;
  for (int n = 0; n < 100 && bench.channel(1).state == ChannelState::held; ++n) {
    EXPECT_FALSE(bench.channel(1).waiting);
    lines.push_back(bench.channel(1).tag.line);
    next();
  }
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{2, 3, 5, 6, 7, 9, 10, 11}));
}

TEST_F(SingleBlockTest, AStatementIsAStepOnlyWhenItAsksTheMachine) {
  begin("num end = 1;\nG1 X=end F6000\nend = 2;\nif (end > 1) { sync (); }\nX=end\nM30\n");
  EXPECT_THAT(stops(), Pointwise(DoubleNear(1e-9), {1.0, 1.0, 2.0}));
}

TEST_F(SingleBlockTest, TurnedOnInMotionTheBlockAtHandIsFinished) {
  bench.program("p.nc", "G1 X10 F6000\nX20\nX30\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  while (x() < 12.0) bench.cycle();
  bench.ask(OperatorAction::single_block, 1, "", 0.0, 1);
  bench.run_to_end();
  EXPECT_TRUE(stands_at_step());
  EXPECT_NEAR(x(), 20.0, 1e-9);
  EXPECT_THAT(stops(), Pointwise(DoubleNear(1e-9), {20.0, 30.0}));
}

// 100 mm/s with 2500 mm/s2 and 50000 mm/s3 need 100/2/2500 s * 100 + jerk time, more than 2 mm.
TEST_F(SingleBlockTest, TurnedOnTooLateForTheEndOfTheBlockItIsTheNextOneThatEnds) {
  bench.program("p.nc", "G1 X10 F6000\nX20\nX30\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  while (x() < 9.5) bench.cycle();
  bench.ask(OperatorAction::single_block, 1, "", 0.0, 1);
  bench.run_to_end();
  EXPECT_TRUE(stands_at_step());
  EXPECT_NEAR(x(), 20.0, 1e-9);
}

TEST_F(SingleBlockTest, AHoldInsideABlockDoesNotUseUpAStep) {
  begin("G1 X10 F6000\nX20\nX30\nM30\n");
  bench.ask(OperatorAction::program_start, 1);
  while (x() < 15.0) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.run_to_end();
  EXPECT_LT(x(), 20.0);
  next();
  EXPECT_TRUE(stands_at_step());
  EXPECT_NEAR(x(), 20.0, 1e-9);
}

TEST_F(SingleBlockTest, AfterAProgramStopOneStartLetsTheNextBlockRun) {
  MachineBench stopping(testing::two_channel_machine(), {.on_at_start = true});
  stopping.program("p.nc", "G1 X1 F6000\nM0\nX2\nX3\nM30\n");
  stopping.ask(OperatorAction::single_block, 1, "", 0.0, 1);
  stopping.run(1, "p.nc");
  stopping.run_to_end();
  stopping.ask(OperatorAction::program_start, 1);
  stopping.run_to_end();
  EXPECT_EQ(stopping.channel(1).hold_cause, HoldCause::program_stop);
  stopping.ask(OperatorAction::program_start, 1);
  stopping.run_to_end();
  EXPECT_EQ(stopping.channel(1).hold_cause, HoldCause::single_block);
  EXPECT_NEAR(stopping.channel(1).axes[0].position, 2.0, 1e-9);
}

TEST_F(SingleBlockTest, TurnedOffTheProgramGoesOnAfterTheNextStart) {
  begin("G1 X1 F6000\nX2\nX3\nX4\nM30\n");
  bench.ask(OperatorAction::single_block, 1, "", 0.0, 0);
  bench.run_to_end();
  EXPECT_TRUE(stands_at_step()) << "a switch moves nothing";
  next();
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_EQ(x(), 4.0);
}

TEST_F(SingleBlockTest, OutputsOfTheNextBlockWaitForItsStep) {
  begin("G1 X1 F6000\nM62 P3\nX2\nM30\n");
  EXPECT_FALSE(bench.output().signals.is_on(3));
  next();
  EXPECT_NEAR(x(), 2.0, 1e-9);
  EXPECT_TRUE(bench.output().signals.is_on(3));
}

TEST_F(SingleBlockTest, ResetAtAStepEndsTheProgram) {
  begin("G1 X1 F6000\nX2\nM30\n");
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_NEAR(x(), 1.0, 1e-9);
}

// Seeded random ways along X with corners in Y: every stop is at a programmed end, none is left
// out.
TEST_F(SingleBlockTest, EveryProgrammedEndIsAStop) {
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> length(0.05, 8.0);
  std::string text = "G61 F9000\n";
  std::vector<double> ends;
  double at = 0.0;
  for (int n = 0; n < 40; ++n) {
    at += length(random);
    at = std::round(at * 1000.0) / 1000.0;
    ends.push_back(at);
    text += (n % 3 == 0 ? "G0 X" : "G1 X") + std::to_string(at) + (n % 4 == 0 ? " Y1\n" : " Y0\n");
  }
  begin(text + "M30\n");
  EXPECT_THAT(stops(), Pointwise(DoubleNear(1e-6), ends));
}

TEST_F(SingleBlockTest, StepsNeitherAllocateNorLeaveTheCycle) {
  begin("G1 X1 F6000\nX2\nX3\nM30\n");
  OperatorEvent event;
  event.command = commands::ProgramStart{};
  event.channel = 1;
  CycleInputs inputs;
  inputs.events = {&event, 1};
  CycleOutput output;
  const testing::NoAllocation guard;
  bench.machine().cycle(inputs, output);
  inputs.events = {};
  for (int n = 0; n < 2000; ++n) bench.machine().cycle(inputs, output);
}

}  // namespace
}  // namespace stanok::channels
