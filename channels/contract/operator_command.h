// OperatorCommand: what an operator (or a test, or a replay) asks of the machine: one struct for
// each action, all plain data.
//
// Recordings and the command table (protocol/contract/method_table.h) have commands in one form for
// all, the number of the action and CommandFields; one function each leads there and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <variant>

#include "base/rt_safe.h"
#include "channels/contract/texts.h"

namespace stanok::channels {

// Logs hold the numbers: a new action goes to the end, here and in OperatorCommand.
enum class OperatorAction : std::uint8_t {
  machine_on,
  machine_off,
  machine_estop,
  program_load,
  program_run,
  program_start,
  program_hold,
  program_resume,
  program_stop,
  program_reset,
  override_feed,
  override_rapid,
  override_spindle,
  kinematics_select,
  alarm_acknowledge,
  optional_stop,
  block_skip,
  block_skip_off,
  single_block,
  mdi,
  process_interrupt,
  process_automatic,
  jog,
  home,
  tool_set,
  offset_set,
  process_adaptive,
  program_search,
  channel_control,
  offset_touch,
  tool_touch,
  program_return,
  spindle_switch,
  coolant_switch,
  handwheel,
  first_part,
  program_retrace,
};

enum class Switch : std::uint8_t { off, on };

// What a search computes on its way to a block; else the run begins with the default modal state.
enum class SearchWay : std::uint8_t { calculated, not_calculated };

// A feed law of the cycle: after the vibration, or after the power of the spindle.
enum class AutomaticLaw : std::uint8_t { modulated, linear };

// What an operator does with the force control of a channel, and with which of its quantities.
enum class ForceAction : std::uint8_t { off, on, set };
enum class ForceQuantity : std::uint8_t { not_named, force, level, mass, frequency };

enum class RetraceDirection : std::uint8_t { back, forward };

// Whose directions a jog takes: axes of the machine, the tool, or the workpiece as programs see it
// now, tilted planes included.
enum class JogFrame : std::uint8_t { machine, tool, plane };

namespace commands {

// Drives of the axes that take part are enabled.
struct MachineOn {};
struct MachineOff {};
// All channels stop along their path, then drives off.
struct MachineEstop {};
struct ProgramLoad {
  ShortText program{};
};
// Load and start.
struct ProgramRun {
  ShortText program{};
};
// Start the loaded program, resume when held.
struct ProgramStart {};
struct ProgramHold {};
struct ProgramResume {};
// Hold, then abort: the program is over, no alarm.
struct ProgramStop {};
// Abort and clear alarms.
struct ProgramReset {};
struct OverrideFeed {
  double factor = 1.0;  // 0..2
};
struct OverrideRapid {
  double factor = 1.0;  // 0..1
};
struct OverrideSpindle {
  double factor = 1.0;  // 0.5..1.5
};
struct KinematicsSelect {
  std::int32_t scheme = 0;
};
struct AlarmAcknowledge {};
// Whether M1 stops.
struct OptionalStop {
  Switch to = Switch::off;
};
// Blocks of the level are skipped from the next sync point on.
struct BlockSkip {
  std::int32_t level = 1;  // 1..9
};
struct BlockSkipOff {
  std::int32_t level = 1;
};
// Whether the program stops after each block.
struct SingleBlock {
  Switch to = Switch::off;
};
// One line, compiled and run.
struct Mdi {
  ShortText line{};
};
// Of the feed.
struct ProcessInterrupt {
  double stand_mm = 0.0;  // L_A; 0 ends it
  double cut_mm = 0.0;    // L_B
};
struct ProcessAutomatic {
  AutomaticLaw law = AutomaticLaw::modulated;
  Switch to = Switch::off;
};
struct Jog {
  ShortText axis{};        // of the machine, or X, Y, Z of the frame
  double velocity = 0.0;   // mm/s or deg/s
  double increment = 0.0;  // mm or deg; 0: while it is renewed
  JogFrame frame = JogFrame::machine;
};
struct Home {
  ShortText axis{};  // empty: all of the channel
};
struct ToolSet {
  ShortText key{};  // which value of it
  double value = 0.0;
  std::int32_t tool = 0;
  std::int32_t edge = 0;  // 0: the first
};
struct OffsetSet {
  ShortText place{};  // work offset and axis of the machine, "G54.1 P2 X"; R is the rotation
  double value = 0.0;
};
struct ProcessAdaptive {
  ForceAction action = ForceAction::off;
  ForceQuantity quantity = ForceQuantity::not_named;
  double value = 0.0;
};
// Where the loaded program begins when it is started.
struct ProgramSearch {
  ShortText target{};  // of lang::search_target
  SearchWay way = SearchWay::calculated;
  std::int32_t passes = 0;  // the block is met for this many times; 0: once
};
// The work offset gets the value with which an axis stands at `point_W`, as far as G54 to G59.3
// alone change between the one that is active and this one.
struct OffsetTouch {
  ShortText place{};        // as OffsetSet::place, without the rotation
  double point_W = 0.0;     // mm (a radius) or deg
  std::int32_t active = 1;  // work offset that is active: 1 = G54
};
// The length of the tool gets the value with which an axis stands at `point_W`.
struct ToolTouch {
  ShortText key{};  // length, length_x or length_y
  double point_W = 0.0;
  std::int32_t tool = 0;
  std::int32_t edge = 1;
};
// The session that has the channel to itself.
struct ChannelControl {
  std::int32_t session = 0;  // 0: nobody
};
// Whether rapid traverse keeps to a quarter, whatever its override is.
struct FirstPart {
  Switch to = Switch::off;
};
// An axis goes on by this way, as the handwheel was turned.
struct Handwheel {
  ShortText axis{};  // of the machine
  double way = 0.0;  // mm or deg; its sign is the direction
};
// Axes of a held program go along what they passed, back, or forwards as far as where it is held.
struct ProgramRetrace {
  RetraceDirection direction = RetraceDirection::back;
  double length = 0.0;  // mm along the path; 0: while it is renewed
};
// Axes that were moved away from a held program go back to its path.
struct ProgramReturn {
  double velocity = 0.0;  // mm/s or deg/s along the way; 0: that of each axis's search
};
// Spindles of a held program: off, or again as it commanded them.
struct SpindleSwitch {
  Switch to = Switch::off;
};
struct CoolantSwitch {
  Switch to = Switch::off;
};

}  // namespace commands

// In the order of OperatorAction.
using OperatorCommand = std::variant<
    commands::MachineOn, commands::MachineOff, commands::MachineEstop, commands::ProgramLoad,
    commands::ProgramRun, commands::ProgramStart, commands::ProgramHold, commands::ProgramResume,
    commands::ProgramStop, commands::ProgramReset, commands::OverrideFeed, commands::OverrideRapid,
    commands::OverrideSpindle, commands::KinematicsSelect, commands::AlarmAcknowledge,
    commands::OptionalStop, commands::BlockSkip, commands::BlockSkipOff, commands::SingleBlock,
    commands::Mdi, commands::ProcessInterrupt, commands::ProcessAutomatic, commands::Jog,
    commands::Home, commands::ToolSet, commands::OffsetSet, commands::ProcessAdaptive,
    commands::ProgramSearch, commands::ChannelControl, commands::OffsetTouch, commands::ToolTouch,
    commands::ProgramReturn, commands::SpindleSwitch, commands::CoolantSwitch, commands::Handwheel,
    commands::FirstPart, commands::ProgramRetrace>;
static_assert(std::is_trivially_copyable_v<OperatorCommand>);

[[nodiscard]] inline OperatorAction action_of(const OperatorCommand& command) RT_SAFE {
  return static_cast<OperatorAction>(command.index());
}

// In OperatorCommand, and in tables of all actions.
[[nodiscard]] constexpr std::size_t place_of(OperatorAction action) RT_SAFE {
  return static_cast<std::uint8_t>(action);
}

// The form that all commands have in recordings and in the command table; fields that a command
// has no use for are 0 and empty.
struct CommandFields {
  OperatorAction action = OperatorAction::program_hold;
  std::int32_t number = 0;
  double value = 0.0;
  double value_2 = 0.0;
  ShortText text{};

  friend bool operator==(const CommandFields&, const CommandFields&) = default;
};

[[nodiscard]] CommandFields fields_of(const OperatorCommand& command);
// Nothing: there is no such action, or no such choice.
[[nodiscard]] std::optional<OperatorCommand> command_of(const CommandFields& fields);

}  // namespace stanok::channels
