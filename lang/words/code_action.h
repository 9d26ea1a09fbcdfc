// What a code does, by name: a row of the code table has one of these, lang/actions has the
// function of the same name.
#pragma once

#include <cstdint>

namespace stanok::lang {

enum class CodeAction : std::uint8_t {
  unsupported,  // the code is known, but not part of this release
  move_straight,
  move_in_arc,
  dwell,
  move_in_cubic,
  move_in_quadratic,
  collect_nurbs_point,
  end_nurbs,
  only_modal,
  select_cylinder,
  stop_at_block_end,
  write_table,
  select_polar_face,
  cancel_transformation,
  go_to_reference_point,
  store_reference_point,
  cut_thread,
  tap_rigidly,
  probe,
  select_compensation,
  compensate_length,
  cancel_scaling,
  cancel_mirror,
  scale_axes,
  mirror_axes,
  shift_locally,
  use_machine_coordinates,
  select_work_offset,
  select_path_mode,
  rotate_system,
  cancel_rotation,
  finish_contour,
  rough_contour,
  drill_hole,
  bore_or_thread,
  turn_once,
  shift_axes,
  select_feed_mode,
  select_spindle_mode,
  stop_program,
  end_program,
  switch_spindle,
  change_tool,
  switch_coolant,
  return_from_program,
  orient_spindle,
  switch_overrides,
  switch_override,
  set_tool_number,
  switch_output,
  wait_for_input,
  set_analog_output,
  save_state,
  drop_state,
  restore_saved_state,
  call_program,
  make_axis_of_spindle,
  make_spindle_of_axis,
  // Of rows that stand in no table: G5 and G5.1 as switches, F, S, T and feed laws, outputs of the
  // machine file.
  accept_high_speed,
  take_feed,
  take_speed,
  take_tool,
  take_feed_law,
  send_machine_function,
};

}  // namespace stanok::lang
