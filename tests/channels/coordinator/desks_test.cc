// The desks of the coordinator, each alone with two channels that run no program.
#include <gtest/gtest.h>

#include "channels/coordinator/control_desk.h"
#include "channels/coordinator/operator_desk.h"
#include "channels/coordinator/value_desk.h"
#include "tests/support/machine/coordinator_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using stanok::testing::bench_x;
using stanok::testing::CoordinatorBench;

OperatorEvent event(OperatorAction action, std::int32_t channel, std::int32_t number = 0,
                    double value = 0.0, std::string_view text = "") {
  OperatorEvent made;
  made.command =
      command_of({.action = action, .number = number, .value = value, .text = text}).value();
  made.channel = channel;
  return made;
}

class DeskTest : public ::testing::Test {
 protected:
  CoordinatorBench bench_;
  ControlDesk control_{bench_.table, bench_.ownership};
};

TEST_F(DeskTest, AChannelIsFoundByItsIdAndAsAMember) {
  EXPECT_EQ(bench_.table.index_of(7), 1);
  EXPECT_EQ(bench_.table.index_of(5), -1);
  EXPECT_EQ(bench_.table.with_ids(1U << 7 | 1U << 9), channel_bit(1));
}

TEST_F(DeskTest, WhoHasAChannelIsAdmittedAndItsPrograms) {
  ASSERT_TRUE(control_.set(7, 33).ok);
  Errand command;
  command.target = 1;
  command.controller = 12;  // of the session that asked
  EXPECT_FALSE(control_.admits(command));
  command.controller = 33;
  EXPECT_TRUE(control_.admits(command));
  Errand request;
  request.asker = 0;
  request.target = 1;
  EXPECT_FALSE(control_.admits(request));
  request.asker = 1;
  EXPECT_TRUE(control_.admits(request));
  EXPECT_EQ(control_.set(9, 33).code.view(), "E6001");
}

TEST_F(DeskTest, AnAxisOfItsOwnIsNeverForeign) {
  ASSERT_TRUE(control_.set(7, 33).ok);
  EXPECT_FALSE(control_.foreign_axis(0, 1U << bench_x));
}

TEST_F(DeskTest, AnOverrideOfAllChannelsOrOfOneIsKeptWithinItsBounds) {
  OperatorDesk desk(bench_.table, control_, {.inputs = &bench_.inputs});
  Channel& second = bench_.table[1];
  ASSERT_TRUE(desk.apply(event(OperatorAction::override_feed, 7, 0, 7.5), &second)->ok);
  EXPECT_EQ(second.switches.feed_override(), 2.0);
  EXPECT_EQ(bench_.table[0].switches.feed_override(), 1.0);
  ASSERT_TRUE(desk.apply(event(OperatorAction::override_feed, 0, 0, 0.5), nullptr)->ok);
  EXPECT_EQ(bench_.table[0].switches.feed_override(), 0.5);
}

TEST_F(DeskTest, WhatTakesTimeIsLeftToOthers) {
  OperatorDesk desk(bench_.table, control_, {.inputs = &bench_.inputs});
  EXPECT_FALSE(desk.apply(event(OperatorAction::program_run, 4), &bench_.table[0]));
  EXPECT_FALSE(desk.apply(event(OperatorAction::home, 4), &bench_.table[0]));
}

TEST_F(DeskTest, AJogNamesAnAxisAndAVelocity) {
  OperatorDesk desk(bench_.table, control_, {.inputs = &bench_.inputs});
  Channel* const first = &bench_.table[0];
  const auto jog = [&](std::string_view axis, double velocity) {
    return desk.apply(event(OperatorAction::jog, 4, 0, velocity, axis), first)->code;
  };
  EXPECT_EQ(jog("Q", 1.0).view(), "E6052");
  EXPECT_EQ(jog("X", 0.0).view(), "E6054");
  EXPECT_EQ(jog("C", 1.0).view(), "E6058");  // takes no part in the scheme
  EXPECT_EQ(jog("X", 1.0).view(), "");
  EXPECT_EQ(first->state().situation(), Situation::by_hand);
  EXPECT_EQ(desk.apply(event(OperatorAction::jog, 0, 0, 1.0, "X"), nullptr)->code.view(), "E6001");
}

TEST_F(DeskTest, LevelsOfBlockSkipAreOneToNine) {
  OperatorDesk desk(bench_.table, control_, {.inputs = &bench_.inputs});
  EXPECT_EQ(desk.apply(event(OperatorAction::block_skip, 0, 10), nullptr)->code.view(), "E6027");
  EXPECT_TRUE(desk.apply(event(OperatorAction::block_skip, 0, 9), nullptr)->ok);
  EXPECT_EQ(bench_.table[1].switches.block_skip(), 1U << 9);
}

class ValueDeskTest : public DeskTest {
 protected:
  Verdict ask(const Request& request) {
    Errand errand;
    errand.asker = 0;
    errand.request = request;
    return desk_.step(errand);
  }
  Verdict value(std::string_view name, int index) {
    return ask(requests::MachineValueRead{{name}, index});
  }

  SharedVariables variables_;
  ValueDesk desk_{bench_.table,
                  bench_.ownership,
                  {.shared = &variables_, .inputs = &bench_.inputs},
                  stanok::testing::bench_cycle_s};
};

TEST_F(ValueDeskTest, TellsWhereTheAxesStandAndWhoMovesThem) {
  bench_.cycles(250);
  EXPECT_EQ(value("pos", bench_x).number, 10.0);
  EXPECT_EQ(value("pos_mcs", bench_x).number, 10.0);
  EXPECT_EQ(value("axis_channel", bench_x).number, 4.0);
  EXPECT_DOUBLE_EQ(value("clock", 0).number, 0.253) << "and three to settle";
  EXPECT_EQ(value("kinematics", 7).number, 0.0);
  EXPECT_EQ(value("kinematics", 9).code.view(), "E6001");
  EXPECT_EQ(value("no_such_value", 0).code.view(), "E6033");
}

TEST_F(ValueDeskTest, ReadsInputsWithinTheirNumbers) {
  bench_.inputs.set(5, true);
  bench_.inputs.analog[2] = 4.5;
  EXPECT_EQ(value("in", 5).number, 1.0);
  EXPECT_EQ(value("ain", 2).number, 4.5);
  EXPECT_EQ(value("in", 64).code.view(), "E6028");
  EXPECT_EQ(value("ain", 16).code.view(), "E6028");
  EXPECT_EQ(value("in", -1).code.view(), "E6028");
}

TEST_F(ValueDeskTest, ASharedVariableIsCountedInOneOperation) {
  using enum lang::Combination;
  ASSERT_TRUE(ask(requests::SharedNumberWrite{3, 40.0}).ok);
  ASSERT_TRUE(ask(requests::SharedNumberCombine{3, add, 2.0}).ok);
  EXPECT_EQ(ask(requests::SharedNumberRead{3}).number, 42.0);
  EXPECT_EQ(ask(requests::SharedNumberCombine{3, divide, 0.0}).code.view(), "E3008");
  EXPECT_EQ(ask(requests::SharedNumberRead{3}).number, 42.0);
}

TEST_F(ValueDeskTest, ASharedTextGrowsToItsRoom) {
  ASSERT_TRUE(ask(requests::SharedTextWrite{2, {"flange"}}).ok);
  ASSERT_TRUE(ask(requests::SharedTextAppend{2, {" done"}}).ok);
  EXPECT_EQ(ask(requests::SharedTextRead{2}).text.view(), "flange done");
  EXPECT_EQ(ask(requests::SharedTextAppend{2, {std::string(250, 'x')}}).code.view(), "E3009");
  EXPECT_EQ(ask(requests::SharedTextRead{2}).text.view(), "flange done");
}

// M66 L1: until the input rises; it was on already.
TEST_F(ValueDeskTest, AnInputThatIsWaitedForRisesOrTheTimeIsOver) {
  Errand wait;
  wait.request = requests::InputWait{5, requests::InputEvent::rise, 0.003};
  bench_.inputs.set(5, true);
  EXPECT_FALSE(desk_.step(wait).done);
  bench_.inputs.set(5, false);
  EXPECT_FALSE(desk_.step(wait).done);
  bench_.inputs.set(5, true);
  EXPECT_EQ(desk_.step(wait).number, 1.0);
  Errand late = wait;
  late.state = errand_states::Asked{};
  late.cycles = 3;
  EXPECT_EQ(desk_.step(late).number, -1.0);
}

}  // namespace
}  // namespace stanok::channels
