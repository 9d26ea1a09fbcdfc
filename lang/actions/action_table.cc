#include "lang/actions/action_table.h"

#include <array>
#include <cstddef>

#include "base/assert.h"
#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

struct ActionRow {
  CodeAction action;
  Action function;
};

// In the order of CodeAction, so that its value is the index.
constexpr auto action_rows = std::to_array<ActionRow>({
    {CodeAction::unsupported, nullptr},
    {CodeAction::move_straight, move_straight},
    {CodeAction::move_in_arc, move_in_arc},
    {CodeAction::dwell, dwell},
    {CodeAction::move_in_cubic, move_in_cubic},
    {CodeAction::move_in_quadratic, move_in_quadratic},
    {CodeAction::collect_nurbs_point, collect_nurbs_point},
    {CodeAction::end_nurbs, end_nurbs},
    {CodeAction::only_modal, only_modal},
    {CodeAction::select_cylinder, select_cylinder},
    {CodeAction::stop_at_block_end, stop_at_block_end},
    {CodeAction::write_table, write_table},
    {CodeAction::select_polar_face, select_polar_face},
    {CodeAction::cancel_transformation, cancel_transformation},
    {CodeAction::go_to_reference_point, go_to_reference_point},
    {CodeAction::store_reference_point, store_reference_point},
    {CodeAction::cut_thread, cut_thread},
    {CodeAction::tap_rigidly, tap_rigidly},
    {CodeAction::probe, probe},
    {CodeAction::select_compensation, select_compensation},
    {CodeAction::compensate_length, compensate_length},
    {CodeAction::cancel_scaling, cancel_scaling},
    {CodeAction::cancel_mirror, cancel_mirror},
    {CodeAction::scale_axes, scale_axes},
    {CodeAction::mirror_axes, mirror_axes},
    {CodeAction::shift_locally, shift_locally},
    {CodeAction::use_machine_coordinates, use_machine_coordinates},
    {CodeAction::select_work_offset, select_work_offset},
    {CodeAction::select_path_mode, select_path_mode},
    {CodeAction::rotate_system, rotate_system},
    {CodeAction::cancel_rotation, cancel_rotation},
    {CodeAction::finish_contour, finish_contour},
    {CodeAction::rough_contour, rough_contour},
    {CodeAction::drill_hole, drill_hole},
    {CodeAction::bore_or_thread, bore_or_thread},
    {CodeAction::turn_once, turn_once},
    {CodeAction::shift_axes, shift_axes},
    {CodeAction::select_feed_mode, select_feed_mode},
    {CodeAction::select_spindle_mode, select_spindle_mode},
    {CodeAction::stop_program, stop_program},
    {CodeAction::end_program, end_program},
    {CodeAction::switch_spindle, switch_spindle},
    {CodeAction::change_tool, change_tool},
    {CodeAction::switch_coolant, switch_coolant},
    {CodeAction::return_from_program, return_from_program},
    {CodeAction::orient_spindle, orient_spindle},
    {CodeAction::switch_overrides, switch_overrides},
    {CodeAction::switch_override, switch_override},
    {CodeAction::set_tool_number, set_tool_number},
    {CodeAction::switch_output, switch_output},
    {CodeAction::wait_for_input, wait_for_input},
    {CodeAction::set_analog_output, set_analog_output},
    {CodeAction::save_state, save_state},
    {CodeAction::drop_state, drop_state},
    {CodeAction::restore_saved_state, restore_saved_state},
    {CodeAction::call_program, call_program},
    {CodeAction::make_axis_of_spindle, make_axis_of_spindle},
    {CodeAction::make_spindle_of_axis, make_spindle_of_axis},
    {CodeAction::accept_high_speed, accept_high_speed},
    {CodeAction::take_feed, take_feed},
    {CodeAction::take_speed, take_speed},
    {CodeAction::take_tool, take_tool},
    {CodeAction::take_feed_law, take_feed_law},
    {CodeAction::send_machine_function, send_machine_function},
});

constexpr bool stand_in_order() {
  for (std::size_t i = 0; i < action_rows.size(); ++i) {
    if (static_cast<std::size_t>(action_rows[i].action) != i) return false;
  }
  return action_rows.back().action == CodeAction::send_machine_function;
}
static_assert(stand_in_order(), "each CodeAction has its row, in their order");

}  // namespace

Action function_of(CodeAction action) {
  const Action function = action_rows[static_cast<std::size_t>(action)].function;
  STANOK_ASSERT(function != nullptr);
  return function;
}

}  // namespace stanok::lang
