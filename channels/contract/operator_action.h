// What there is to know about each operator action, one row each: its name, what it does to motion,
// which channels it concerns and when it is admitted.
//
// The names connect the operator's command table (protocol/contract/method_table.h) with the input
// layer of the cycle; logs and event files use them too.
#pragma once

#include <optional>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/contract/operator_event.h"

namespace stanok::channels {

// The rules of channels/contract/command_rules.h.
enum class AdmissionRule : std::uint8_t {
  always,  // what stops, and what only sets something
  power_on,
  load,
  search,
  run,
  start,
  resume,
  select,
  jog,
  tables,
  touch,
  touch_tool,
  interlude,  // with a held program
  go_back,    // to the path
};

// What an action does to motion.
enum class MotionEffect : std::uint8_t {
  none,
  stops,   // only ever brings motion to rest; never turned away for want of room
  begins,  // something may begin to move, or get power
};

// Which channels an action concerns that names one or none.
enum class CommandReach : std::uint8_t {
  channel,
  all_channels,  // the machine or its tables: all channels must admit it
};

struct ActionRow {
  OperatorAction action = OperatorAction::program_hold;
  std::string_view name;  // "program_hold"
  MotionEffect effect = MotionEffect::none;
  AdmissionRule rule = AdmissionRule::always;
  CommandReach reach = CommandReach::channel;
};

[[nodiscard]] const ActionRow& row_of(OperatorAction action) RT_SAFE;

[[nodiscard]] std::string_view name_of(OperatorAction action);
[[nodiscard]] std::optional<OperatorAction> operator_action(std::string_view name);

[[nodiscard]] bool is_stop(OperatorAction action) RT_SAFE;
[[nodiscard]] bool begins_motion(OperatorAction action) RT_SAFE;

}  // namespace stanok::channels
