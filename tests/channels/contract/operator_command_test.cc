// The commands of operators and the one form that all of them have in recordings: its fields are a
// format, written down here once more.
#include "channels/contract/operator_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "channels/contract/operator_action.h"

namespace stanok::channels {
namespace {

struct Recorded {
  OperatorCommand command;
  int action;
  const char* name;
  std::int32_t number = 0;
  double value = 0.0;
  double value_2 = 0.0;
  const char* text = "";
};

std::vector<Recorded> all_commands() {
  using namespace commands;
  const ShortText text("G54 X");
  return {
      {MachineOn{}, 0, "machine_on"},
      {MachineOff{}, 1, "machine_off"},
      {MachineEstop{}, 2, "machine_estop"},
      {ProgramLoad{text}, 3, "program_load", 0, 0.0, 0.0, "G54 X"},
      {ProgramRun{text}, 4, "program_run", 0, 0.0, 0.0, "G54 X"},
      {ProgramStart{}, 5, "program_start"},
      {ProgramHold{}, 6, "program_hold"},
      {ProgramResume{}, 7, "program_resume"},
      {ProgramStop{}, 8, "program_stop"},
      {ProgramReset{}, 9, "program_reset"},
      {OverrideFeed{1.5}, 10, "override_feed", 0, 1.5},
      {OverrideRapid{0.25}, 11, "override_rapid", 0, 0.25},
      {OverrideSpindle{1.1}, 12, "override_spindle", 0, 1.1},
      {KinematicsSelect{12}, 13, "kinematics_select", 12},
      {AlarmAcknowledge{}, 14, "alarm_acknowledge"},
      {OptionalStop{Switch::on}, 15, "optional_stop", 1},
      {BlockSkip{9}, 16, "block_skip", 9},
      {BlockSkipOff{3}, 17, "block_skip_off", 3},
      {SingleBlock{Switch::on}, 18, "single_block", 1},
      {Mdi{text}, 19, "mdi", 0, 0.0, 0.0, "G54 X"},
      {ProcessInterrupt{0.4, 2.5}, 20, "process_interrupt", 0, 0.4, 2.5},
      {ProcessAutomatic{AutomaticLaw::linear, Switch::on}, 21, "process_automatic", 1, 0.0, 0.0,
       "linear"},
      {commands::Jog{ShortText("X"), -5.0, 0.1, JogFrame::tool}, 22, "jog", 1, -5.0, 0.1, "X"},
      {Home{ShortText("Z")}, 23, "home", 0, 0.0, 0.0, "Z"},
      {ToolSet{ShortText("length"), 12.5, 7, 2}, 24, "tool_set", 7, 12.5, 2.0, "length"},
      {OffsetSet{text, -3.5}, 25, "offset_set", 0, -3.5, 0.0, "G54 X"},
      {ProcessAdaptive{ForceAction::set, ForceQuantity::mass, 60.0}, 26, "process_adaptive", 2,
       60.0, 0.0, "mass"},
      {ProgramSearch{ShortText("N40"), SearchWay::not_calculated, 3}, 27, "program_search", 1, 3.0,
       0.0, "N40"},
      {ChannelControl{41}, 28, "channel_control", 41},
      {OffsetTouch{text, 12.5, 3}, 29, "offset_touch", 3, 12.5, 0.0, "G54 X"},
      {ToolTouch{ShortText("length"), -4.0, 7, 2}, 30, "tool_touch", 7, -4.0, 2.0, "length"},
      {ProgramReturn{12.5}, 31, "program_return", 0, 12.5},
      {SpindleSwitch{Switch::on}, 32, "spindle_switch", 1},
      {CoolantSwitch{Switch::on}, 33, "coolant_switch", 1},
      {Handwheel{ShortText("X"), -0.5}, 34, "handwheel", 0, -0.5, 0.0, "X"},
      {FirstPart{Switch::on}, 35, "first_part", 1},
      {ProgramRetrace{RetraceDirection::forward, 2.5}, 36, "program_retrace", 1, 2.5},
  };
}

CommandFields fields_in(const Recorded& row) {
  return {.action = static_cast<OperatorAction>(row.action),
          .number = row.number,
          .value = row.value,
          .value_2 = row.value_2,
          .text = ShortText(row.text)};
}

TEST(OperatorCommandTest, EachHasItsRecordedForm) {
  const auto rows = all_commands();
  ASSERT_EQ(rows.size(), std::variant_size_v<OperatorCommand>) << "a command has no row here";
  for (const Recorded& row : rows) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(name_of(action_of(row.command)), row.name);
    EXPECT_EQ(operator_action(row.name), static_cast<OperatorAction>(row.action));
    EXPECT_EQ(fields_of(row.command), fields_in(row));
  }
}

TEST(OperatorCommandTest, EachComesBackFromItsRecordedForm) {
  for (const Recorded& row : all_commands()) {
    SCOPED_TRACE(row.name);
    const auto command = command_of(fields_in(row));
    ASSERT_TRUE(command.has_value());
    EXPECT_EQ(command->index(), row.command.index());
    EXPECT_EQ(fields_of(*command), fields_in(row));
  }
}

// A request that gives only what it must leaves the rest at 0 and empty.
TEST(OperatorCommandTest, FieldsThatAreNotGivenStayEmpty) {
  for (const Recorded& row : all_commands()) {
    SCOPED_TRACE(row.name);
    CommandFields bare;
    bare.action = static_cast<OperatorAction>(row.action);
    const bool has_choice = bare.action == OperatorAction::process_automatic;  // must be given
    const auto command = command_of(bare);
    ASSERT_EQ(command.has_value(), !has_choice);
    if (command) {
      EXPECT_EQ(fields_of(*command), bare);
    }
  }
}

TEST(OperatorCommandTest, WhatNoCommandHasIsNone) {
  EXPECT_FALSE(command_of({.action = static_cast<OperatorAction>(37)}));
  EXPECT_FALSE(command_of({.action = static_cast<OperatorAction>(255)}));
  EXPECT_FALSE(
      command_of({.action = OperatorAction::process_automatic, .text = ShortText("other")}));
  EXPECT_FALSE(command_of({.action = OperatorAction::process_adaptive, .number = 3}));
  EXPECT_FALSE(
      command_of({.action = OperatorAction::process_adaptive, .text = ShortText("colour")}));
  EXPECT_FALSE(command_of({.action = OperatorAction::program_search, .number = -1}));
}

// Logs may come from anywhere.
TEST(OperatorCommandTest, ACountThatIsNoneIsKeptWithinItsType) {
  for (const double value : {-1.0, std::nan(""), 1e300, -1e300}) {
    const auto search = command_of({.action = OperatorAction::program_search, .value = value});
    const int passes = std::get<commands::ProgramSearch>(*search).passes;
    EXPECT_GE(passes, 0);
    EXPECT_LE(passes, 1000000000);
  }
}

}  // namespace
}  // namespace stanok::channels
