#include "channels/contract/operator_action.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stanok::channels {
namespace {

constexpr auto names = std::to_array<std::pair<OperatorAction, std::string_view>>({
    {OperatorAction::machine_on, "machine_on"},
    {OperatorAction::machine_off, "machine_off"},
    {OperatorAction::machine_estop, "machine_estop"},
    {OperatorAction::program_load, "program_load"},
    {OperatorAction::program_run, "program_run"},
    {OperatorAction::mdi, "mdi"},
    {OperatorAction::program_start, "program_start"},
    {OperatorAction::program_hold, "program_hold"},
    {OperatorAction::program_resume, "program_resume"},
    {OperatorAction::program_stop, "program_stop"},
    {OperatorAction::program_reset, "program_reset"},
    {OperatorAction::override_feed, "override_feed"},
    {OperatorAction::override_rapid, "override_rapid"},
    {OperatorAction::override_spindle, "override_spindle"},
    {OperatorAction::kinematics_select, "kinematics_select"},
    {OperatorAction::alarm_acknowledge, "alarm_acknowledge"},
    {OperatorAction::optional_stop, "optional_stop"},
    {OperatorAction::single_block, "single_block"},
    {OperatorAction::block_skip, "block_skip"},
    {OperatorAction::block_skip_off, "block_skip_off"},
    {OperatorAction::process_interrupt, "process_interrupt"},
    {OperatorAction::process_automatic, "process_automatic"},
    {OperatorAction::jog, "jog"},
    {OperatorAction::home, "home"},
    {OperatorAction::tool_set, "tool_set"},
    {OperatorAction::offset_set, "offset_set"},
    {OperatorAction::process_adaptive, "process_adaptive"},
    {OperatorAction::program_search, "program_search"},
    {OperatorAction::channel_control, "channel_control"},
});

}  // namespace

std::string_view name_of(OperatorAction action) {
  const auto row =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == action; });
  return row == names.end() ? std::string_view{} : row->second;
}

std::optional<OperatorAction> operator_action(std::string_view name) {
  const auto row =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.second == name; });
  return row == names.end() ? std::nullopt : std::optional(row->first);
}

bool is_stop(OperatorAction action) RT_SAFE {
  switch (action) {
    case OperatorAction::machine_off:
    case OperatorAction::machine_estop:
    case OperatorAction::program_hold:
    case OperatorAction::program_stop:
    case OperatorAction::program_reset:
      return true;
    default:
      return false;
  }
}

bool begins_motion(OperatorAction action) RT_SAFE {
  switch (action) {
    case OperatorAction::machine_on:
    case OperatorAction::program_run:
    case OperatorAction::program_start:
    case OperatorAction::program_resume:
    case OperatorAction::kinematics_select:
    case OperatorAction::mdi:
    case OperatorAction::jog:
    case OperatorAction::home:
      return true;
    default:
      return false;
  }
}

}  // namespace stanok::channels
