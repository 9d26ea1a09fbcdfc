#include "channels/contract/operator_action.h"

#include <algorithm>
#include <array>

namespace stanok::channels {
namespace {

using Action = OperatorAction;
using Effect = MotionEffect;
using Rule = AdmissionRule;
using Reach = CommandReach;

// In the order of OperatorAction.
constexpr auto action_rows = std::to_array<ActionRow>({
    {Action::machine_on, "machine_on", Effect::begins, Rule::power_on, Reach::all_channels},
    {Action::machine_off, "machine_off", Effect::stops, Rule::always, Reach::channel},
    {Action::machine_estop, "machine_estop", Effect::stops, Rule::always, Reach::channel},
    {Action::program_load, "program_load", Effect::none, Rule::load, Reach::channel},
    {Action::program_run, "program_run", Effect::begins, Rule::run, Reach::channel},
    {Action::program_start, "program_start", Effect::begins, Rule::start, Reach::channel},
    {Action::program_hold, "program_hold", Effect::stops, Rule::always, Reach::channel},
    {Action::program_resume, "program_resume", Effect::begins, Rule::resume, Reach::channel},
    {Action::program_stop, "program_stop", Effect::stops, Rule::always, Reach::channel},
    {Action::program_reset, "program_reset", Effect::stops, Rule::always, Reach::channel},
    {Action::override_feed, "override_feed", Effect::none, Rule::always, Reach::channel},
    {Action::override_rapid, "override_rapid", Effect::none, Rule::always, Reach::channel},
    {Action::override_spindle, "override_spindle", Effect::none, Rule::always, Reach::channel},
    {Action::kinematics_select, "kinematics_select", Effect::begins, Rule::select, Reach::channel},
    {Action::alarm_acknowledge, "alarm_acknowledge", Effect::none, Rule::always, Reach::channel},
    {Action::optional_stop, "optional_stop", Effect::none, Rule::always, Reach::channel},
    {Action::block_skip, "block_skip", Effect::none, Rule::always, Reach::channel},
    {Action::block_skip_off, "block_skip_off", Effect::none, Rule::always, Reach::channel},
    {Action::single_block, "single_block", Effect::none, Rule::always, Reach::channel},
    {Action::mdi, "mdi", Effect::begins, Rule::run, Reach::channel},
    {Action::process_interrupt, "process_interrupt", Effect::none, Rule::always, Reach::channel},
    {Action::process_automatic, "process_automatic", Effect::none, Rule::always, Reach::channel},
    {Action::jog, "jog", Effect::begins, Rule::jog, Reach::channel},
    {Action::home, "home", Effect::begins, Rule::run, Reach::channel},
    {Action::tool_set, "tool_set", Effect::none, Rule::tables, Reach::all_channels},
    {Action::offset_set, "offset_set", Effect::none, Rule::tables, Reach::all_channels},
    {Action::process_adaptive, "process_adaptive", Effect::none, Rule::always, Reach::channel},
    {Action::program_search, "program_search", Effect::none, Rule::search, Reach::channel},
    {Action::channel_control, "channel_control", Effect::none, Rule::always, Reach::channel},
    {Action::offset_touch, "offset_touch", Effect::none, Rule::touch, Reach::channel},
    {Action::tool_touch, "tool_touch", Effect::none, Rule::touch_tool, Reach::channel},
    {Action::program_return, "program_return", Effect::begins, Rule::go_back, Reach::channel},
    {Action::spindle_switch, "spindle_switch", Effect::begins, Rule::interlude, Reach::channel},
    {Action::coolant_switch, "coolant_switch", Effect::begins, Rule::interlude, Reach::channel},
    {Action::handwheel, "handwheel", Effect::begins, Rule::jog, Reach::channel},
    {Action::first_part, "first_part", Effect::none, Rule::always, Reach::channel},
    {Action::program_retrace, "program_retrace", Effect::begins, Rule::interlude, Reach::channel},
});

consteval bool is_complete() {
  for (std::size_t k = 0; k < action_rows.size(); ++k) {
    if (place_of(action_rows[k].action) != k) return false;
  }
  return action_rows.size() == std::variant_size_v<OperatorCommand>;
}
static_assert(is_complete(), "an action has no row, or stands in another place");

}  // namespace

const ActionRow& row_of(OperatorAction action) RT_SAFE {
  return action_rows[place_of(action)];
}

std::string_view name_of(OperatorAction action) {
  return place_of(action) < action_rows.size() ? row_of(action).name : std::string_view();
}

std::optional<OperatorAction> operator_action(std::string_view name) {
  const auto row = std::ranges::find(action_rows, name, &ActionRow::name);
  return row == action_rows.end() ? std::nullopt : std::optional(row->action);
}

bool is_stop(OperatorAction action) RT_SAFE {
  return row_of(action).effect == MotionEffect::stops;
}

bool begins_motion(OperatorAction action) RT_SAFE {
  return row_of(action).effect == MotionEffect::begins;
}

}  // namespace stanok::channels
