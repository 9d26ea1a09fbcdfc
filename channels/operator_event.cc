#include "channels/operator_event.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stanok::channels {
namespace {

using Row = std::pair<OperatorAction, std::string_view>;

constexpr auto names = std::to_array<Row>({
    {OperatorAction::machine_on, "machine_on"},
    {OperatorAction::machine_off, "machine_off"},
    {OperatorAction::machine_estop, "machine_estop"},
    {OperatorAction::program_load, "program_load"},
    {OperatorAction::program_run, "program_run"},
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
});

}  // namespace

std::optional<OperatorAction> operator_action(std::string_view name) {
  const auto* row =
      std::find_if(names.begin(), names.end(), [&](const Row& r) { return r.second == name; });
  if (row == names.end()) return std::nullopt;
  return row->first;
}

std::string_view name_of(OperatorAction action) {
  const auto* row =
      std::find_if(names.begin(), names.end(), [&](const Row& r) { return r.first == action; });
  return row == names.end() ? std::string_view() : row->second;
}

}  // namespace stanok::channels
