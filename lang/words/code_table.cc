#include "lang/words/code_table.h"

#include <array>

#include "lang/contract/code_number.h"

namespace stanok::lang {
namespace {

using enum Group;
using enum CodeAction;
using P = EffectOrder;
constexpr auto no_axes = AxisWords::unused;
constexpr auto axes = AxisWords::optional;
constexpr auto needs_axes = AxisWords::required;
constexpr auto everywhere = Availability::everywhere;
constexpr auto not_master = Availability::not_master;
constexpr auto mill_only = Availability::mill_only;
constexpr auto lathe_only = Availability::lathe_only;
constexpr CodeAction later = unsupported;

constexpr Code g(CodeNumber number, Group group, EffectOrder order, AxisWords axis_words,
                 std::string_view words, Availability availability, CodeAction action,
                 std::string_view title) {
  return {'G',          number, group, group_bit(group), order, axis_words, letters_of(words),
          availability, action, title};
}

constexpr Code m(CodeNumber number, Group group, EffectOrder order, std::string_view words,
                 Availability availability, CodeAction action, std::string_view title) {
  return {'M',          number, group, group_bit(group), order, no_axes, letters_of(words),
          availability, action, title};
}

constexpr Code with_groups(Code code, GroupSet groups) {
  code.groups = groups;
  return code;
}

// Columns: number in tenths, modal group, order, axis words, other words, channels, action, title.
constexpr auto code_rows = std::to_array<Code>({
    g(0, motion, P::motion, axes, "IJK", everywhere, move_straight, "rapid"),
    g(10, motion, P::motion, axes, "IJK", everywhere, move_straight, "line at feed"),
    g(20, motion, P::motion, axes, "IJKRP", everywhere, move_in_arc, "arc clockwise"),
    g(24, motion, P::motion, axes, "IJK", not_master, later, "arc through a point, clockwise"),
    g(30, motion, P::motion, axes, "IJKRP", everywhere, move_in_arc, "arc counter-clockwise"),
    g(34, motion, P::motion, axes, "IJK", not_master, later,
      "arc through a point, counter-clockwise"),
    g(40, none, P::dwell, no_axes, "P", everywhere, dwell, "dwell"),
    g(50, motion, P::motion, axes, "IJKPQ", not_master, move_in_cubic, "cubic spline"),
    g(51, motion, P::motion, axes, "IJKQ", not_master, move_in_quadratic, "quadratic spline"),
    g(52, motion, P::motion, axes, "PL", not_master, collect_nurbs_point, "NURBS block"),
    g(53, motion, P::motion, no_axes, "", not_master, end_nurbs, "end of NURBS block"),
    g(62, motion, P::motion, axes, "PKRQ", not_master, collect_knot, "NURBS with knots"),
    g(70, diameter, P::diameter, no_axes, "", not_master, only_modal, "diameter programming"),
    g(71, transformation, P::settings, axes, "", not_master, select_cylinder, "cylinder surface"),
    g(80, diameter, P::diameter, no_axes, "", everywhere, only_modal, "radius programming"),
    g(90, none, P::motion_modifier, no_axes, "", everywhere, stop_at_block_end, "exact stop"),
    g(100, none, P::settings, axes, "LPRIJQ", not_master, write_table, "table input"),
    g(120, none, P::motion, axes, "IKQLD", mill_only, mill_circular_pocket,
      "circular pocket, clockwise"),
    g(121, transformation, P::settings, no_axes, "", not_master, select_polar_face,
      "polar face on"),
    g(130, none, P::motion, axes, "IKQLD", mill_only, mill_circular_pocket,
      "circular pocket, counter-clockwise"),
    g(131, transformation, P::settings, no_axes, "", everywhere, cancel_transformation,
      "transformation off"),
    g(150, polar, P::settings, no_axes, "", everywhere, only_modal, "polar input off"),
    g(160, polar, P::settings, no_axes, "", mill_only, only_modal, "polar input on"),
    g(170, plane, P::plane, no_axes, "", everywhere, only_modal, "plane XY"),
    g(171, plane, P::plane, axes, "", not_master, later, "plane of other axes"),
    g(180, plane, P::plane, no_axes, "", everywhere, only_modal, "plane ZX"),
    g(181, plane, P::plane, axes, "", not_master, later, "plane of other axes"),
    g(190, plane, P::plane, no_axes, "", everywhere, only_modal, "plane YZ"),
    g(191, plane, P::plane, axes, "", not_master, later, "plane of other axes"),
    g(200, units, P::units, no_axes, "", everywhere, only_modal, "inch"),
    g(210, units, P::units, no_axes, "", everywhere, only_modal, "millimetre"),
    g(270, none, P::settings, needs_axes, "", not_master, check_reference_point,
      "reference point check"),
    g(280, none, P::settings, axes, "", not_master, go_to_reference_point, "to reference point"),
    g(281, none, P::settings, no_axes, "", not_master, store_reference_point,
      "store reference point"),
    g(300, none, P::settings, axes, "P", not_master, go_to_reference_point,
      "to reference point 2 to 4"),
    g(301, none, P::settings, no_axes, "P", not_master, store_reference_point,
      "store reference point 2 to 4"),
    g(310, none, P::motion, needs_axes, "P", not_master, probe, "move until the probe touches"),
    g(320, motion, P::motion, needs_axes, "FKQ", not_master, cut_thread, "thread"),
    g(330, motion, P::motion, needs_axes, "FKQ", not_master, cut_thread, "thread"),
    g(331, motion, P::motion, needs_axes, "KI", not_master, tap_rigidly, "rigid tapping"),
    g(340, motion, P::motion, axes, "KQ", not_master, later, "thread of variable lead"),
    g(370, none, P::motion, needs_axes, "", not_master, measure_tool_length,
      "automatic tool length measurement"),
    g(382, motion, P::motion, needs_axes, "", not_master, probe, "probing"),
    g(383, motion, P::motion, needs_axes, "", not_master, probe, "probing"),
    g(384, motion, P::motion, needs_axes, "", not_master, probe, "probing"),
    g(385, motion, P::motion, needs_axes, "", not_master, probe, "probing"),
    g(400, radius_compensation, P::radius_compensation, no_axes, "", everywhere,
      select_compensation, "radius compensation off"),
    g(410, radius_compensation, P::radius_compensation, no_axes, "D", not_master,
      select_compensation, "radius compensation left"),
    g(411, radius_compensation, P::radius_compensation, no_axes, "DL", not_master,
      select_compensation, "radius compensation left, diameter given"),
    g(420, radius_compensation, P::radius_compensation, no_axes, "D", not_master,
      select_compensation, "radius compensation right"),
    g(421, radius_compensation, P::radius_compensation, no_axes, "DL", not_master,
      select_compensation, "radius compensation right, diameter given"),
    g(430, length, P::length, no_axes, "H", not_master, compensate_length, "tool length on"),
    g(431, length, P::length, needs_axes, "", not_master, compensate_length,
      "tool length given by axis words"),
    g(432, length, P::length, no_axes, "H", not_master, compensate_length,
      "second tool length added"),
    g(434, length, P::length, no_axes, "H", not_master, compensate_length, "TCP (RTCP)"),
    g(435, length, P::length, no_axes, "H", not_master, compensate_length,
      "TCP (RTCP) by tool vector"),
    g(440, length, P::length, no_axes, "H", not_master, compensate_length, "tool length, negative"),
    g(490, length, P::length, no_axes, "", everywhere, compensate_length, "tool length off"),
    g(500, scaling, P::settings, no_axes, "S", everywhere, cancel_scaling, "scaling off"),
    g(501, mirror, P::settings, axes, "", everywhere, cancel_mirror, "mirror off"),
    g(510, scaling, P::settings, axes, "PIJK", not_master, scale_axes, "scaling"),
    g(511, mirror, P::settings, needs_axes, "", not_master, mirror_axes, "mirror"),
    g(520, none, P::settings, needs_axes, "", not_master, shift_locally, "local shift"),
    g(530, none, P::motion_modifier, no_axes, "", not_master, use_machine_coordinates,
      "machine coordinates"),
    g(531, none, P::settings, no_axes, "P", not_master, align_tool,
      "tool aligned with the tilted plane"),
    g(536, none, P::settings, no_axes, "P", not_master, align_tool,
      "the same, the tool tip stays in place"),
    g(540, work_offset, P::work_offset, no_axes, "", everywhere, select_work_offset,
      "work offset 1"),
    g(541, work_offset, P::work_offset, no_axes, "P", not_master, select_work_offset,
      "work offset of the extended table"),
    g(542, work_offset, P::work_offset, no_axes, "P", not_master, carry_work_offset,
      "work offset carried by the rotary table"),
    g(544, none, P::settings, axes, "PIJK", not_master, compensate_set_up,
      "set-up error of the workpiece"),
    g(550, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 2"),
    g(560, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 3"),
    g(570, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 4"),
    g(580, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 5"),
    g(590, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 6"),
    g(591, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 7"),
    g(592, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 8"),
    g(593, work_offset, P::work_offset, no_axes, "", not_master, select_work_offset,
      "work offset 9"),
    g(600, path_mode, P::path_mode, no_axes, "", everywhere, select_path_mode, "exact path"),
    g(610, path_mode, P::path_mode, no_axes, "", everywhere, select_path_mode, "exact path"),
    g(611, path_mode, P::path_mode, no_axes, "", everywhere, select_path_mode, "exact stop"),
    g(640, path_mode, P::path_mode, no_axes, "PQ", everywhere, select_path_mode, "continuous path"),
    g(650, none, P::stop, no_axes, "PL", everywhere, only_modal, "macro call"),
    g(660, none, P::stop, no_axes, "PL", everywhere, only_modal,
      "macro call after each block that moves"),
    g(661, none, P::stop, no_axes, "PL", everywhere, only_modal,
      "macro call for each block, with its words as arguments"),
    g(670, none, P::stop, no_axes, "", everywhere, end_modal_call, "end of G66 and G66.1"),
    g(680, rotation, P::settings, axes, "RIJK", not_master, rotate_system, "rotation"),
    g(682, rotation, P::settings, axes, "IJKPQR", not_master, tilt_plane, "tilted plane"),
    g(683, rotation, P::settings, axes, "R", not_master, tilt_plane,
      "tilted plane perpendicular to the tool"),
    g(684, rotation, P::settings, axes, "IJKPQR", not_master, tilt_plane,
      "tilted plane relative to the active one"),
    g(690, rotation, P::settings, no_axes, "", everywhere, cancel_rotation, "rotation off"),
    g(700, none, P::motion, no_axes, "PQ", not_master, finish_contour, "finishing cycle"),
    g(710, none, P::motion, no_axes, "PQRUWD", not_master, rough_contour, "roughing cycle"),
    g(720, none, P::motion, no_axes, "PQRUWD", lathe_only, rough_contour, "facing cycle"),
    g(730, motion, P::motion, axes, "RQLK", not_master, drill_or_repeat,
      "drilling with chip break, pattern repeating"),
    g(740, motion, P::motion, axes, "RPKLQID", not_master, peck_or_tap,
      "left-hand tapping, face peck cycle"),
    g(750, none, P::motion, axes, "RPQIKD", lathe_only, peck_groove, "grooving cycle"),
    g(760, motion, P::motion, axes, "RQPIJKEFHL", not_master, bore_or_thread,
      "fine boring, thread cycle"),
    g(770, motion, P::motion, axes, "R", lathe_only, turn_once, "turning cycle"),
    g(780, motion, P::motion, axes, "FR", lathe_only, turn_once, "thread cycle"),
    g(790, motion, P::motion, axes, "R", lathe_only, turn_once, "facing cycle"),
    g(800, motion, P::motion, no_axes, "", everywhere, end_cycle, "end of cycle"),
    g(810, motion, P::motion, axes, "RLK", mill_only, drill_hole, "drilling"),
    g(820, motion, P::motion, axes, "RPLK", mill_only, drill_hole, "drilling with dwell"),
    g(830, motion, P::motion, axes, "RQLK", not_master, drill_hole, "deep hole drilling"),
    g(840, motion, P::motion, axes, "RPKL", not_master, drill_hole, "tapping"),
    g(850, motion, P::motion, axes, "RLK", not_master, drill_hole, "boring, feed out"),
    g(860, motion, P::motion, axes, "RPLK", mill_only, drill_hole, "boring, spindle stop"),
    g(870, motion, P::motion, axes, "RQPLK", not_master, drill_hole,
      "back boring; on lathes drilling into the side"),
    g(880, motion, P::motion, axes, "RPLK", not_master, drill_hole,
      "boring, manual retract; on lathes tapping into the side"),
    g(890, motion, P::motion, axes, "RPLK", not_master, drill_hole,
      "boring with dwell, feed out; on lathes into the side"),
    g(900, distance, P::distance, no_axes, "", everywhere, only_modal, "absolute"),
    g(901, arc_distance, P::distance, no_axes, "", everywhere, only_modal, "absolute arc centre"),
    g(910, distance, P::distance, no_axes, "", everywhere, only_modal, "incremental"),
    g(911, arc_distance, P::distance, no_axes, "", everywhere, only_modal,
      "arc centre from the start point"),
    g(920, none, P::settings, axes, "S", not_master, shift_axes, "set position"),
    g(921, none, P::settings, no_axes, "", not_master, shift_axes, "clear position shift"),
    g(922, none, P::settings, no_axes, "", not_master, shift_axes, "suspend position shift"),
    g(923, none, P::settings, no_axes, "", not_master, shift_axes, "restore position shift"),
    g(930, feed_mode, P::feed_mode, no_axes, "", everywhere, select_feed_mode, "inverse time feed"),
    g(940, feed_mode, P::feed_mode, no_axes, "", everywhere, select_feed_mode, "feed per minute"),
    g(950, feed_mode, P::feed_mode, no_axes, "", everywhere, select_feed_mode,
      "feed per revolution"),
    g(960, spindle_mode, P::spindle_mode, no_axes, "DS", not_master, select_spindle_mode,
      "constant cutting speed"),
    g(970, spindle_mode, P::spindle_mode, no_axes, "", everywhere, select_spindle_mode,
      "constant spindle speed"),
    g(980, return_level, P::return_level, no_axes, "", everywhere, only_modal,
      "return to initial level"),
    g(990, return_level, P::return_level, no_axes, "", everywhere, only_modal, "return to R level"),
    g(1000, mirror, P::settings, axes, "", not_master, cancel_mirror, "mirror off, as G50.1"),
    g(1010, mirror, P::settings, needs_axes, "", not_master, mirror_axes, "mirror, as G51.1"),
    g(1030, none, P::path_mode, no_axes, "P", everywhere, only_modal, "look-ahead limit"),
    g(1500, none, P::motion, axes, "IJKPQR", mill_only, mill_contour_pocket, "pocket with islands"),
    g(1540, work_offset, P::work_offset, no_axes, "P", not_master, select_work_offset,
      "work offset of the extended table"),
    g(1840, motion, P::motion, axes, "RPKL", lathe_only, drill_hole,
      "left-hand tapping into the face"),
    g(1870, none, P::path_mode, no_axes, "PE", everywhere, only_modal, "smoothness"),
    m(0, stop, P::stop, "", everywhere, stop_program, "program stop"),
    m(10, stop, P::stop, "", everywhere, stop_program, "optional stop"),
    m(20, stop, P::stop, "", everywhere, end_program, "end of program"),
    m(30, spindle, P::spindle, "", not_master, switch_spindle, "spindle clockwise"),
    m(40, spindle, P::spindle, "", not_master, switch_spindle, "spindle counter-clockwise"),
    m(50, spindle, P::spindle, "", not_master, switch_spindle, "spindle stop"),
    m(60, tool, P::tool_change, "", not_master, change_tool, "tool change"),
    m(70, mist, P::coolant, "", everywhere, switch_coolant, "mist coolant on"),
    m(80, flood, P::coolant, "", everywhere, switch_coolant, "flood coolant on"),
    with_groups(m(90, mist, P::coolant, "", everywhere, switch_coolant, "coolant off"),
                group_bit(mist) | group_bit(flood)),
    m(170, subprogram, P::stop, "", everywhere, return_from_program, "return, as M99"),
    m(190, spindle, P::spindle, "RPQ", not_master, orient_spindle, "spindle orientation"),
    m(290, none, P::spindle, "", not_master, only_modal, "rigid tapping ahead"),
    m(300, stop, P::stop, "", everywhere, end_program, "end of program and rewind"),
    m(480, override_control, P::override_control, "", everywhere, switch_overrides,
      "overrides enabled"),
    m(490, override_control, P::override_control, "", everywhere, switch_overrides,
      "overrides disabled"),
    m(500, none, P::override_control, "P", everywhere, switch_override, "feed override"),
    m(510, none, P::override_control, "P", everywhere, switch_override, "spindle override"),
    m(520, none, P::override_control, "P", everywhere, switch_override, "adaptive feed"),
    m(530, none, P::override_control, "P", everywhere, switch_override, "feed stop"),
    m(600, stop, P::stop, "", everywhere, stop_program, "pallet stop"),
    m(610, tool, P::tool_change, "Q", not_master, set_tool_number, "tool number set"),
    m(620, input_output, P::motion_modifier, "P", everywhere, switch_output,
      "output on with motion"),
    m(630, input_output, P::motion_modifier, "P", everywhere, switch_output,
      "output off with motion"),
    m(640, input_output, P::functions_before, "P", everywhere, switch_output, "output on"),
    m(650, input_output, P::functions_before, "P", everywhere, switch_output, "output off"),
    m(660, input_output, P::functions_before, "PELQ", everywhere, wait_for_input, "wait for input"),
    m(670, input_output, P::motion_modifier, "EQ", everywhere, set_analog_output,
      "analog output, motion"),
    m(680, input_output, P::functions_before, "EQ", everywhere, set_analog_output, "analog output"),
    m(700, state, P::functions_before, "", everywhere, save_state, "save modal state"),
    m(710, state, P::functions_before, "", everywhere, drop_state, "drop modal state"),
    m(720, state, P::functions_before, "", everywhere, restore_saved_state, "restore modal state"),
    m(730, state, P::functions_before, "", everywhere, save_state, "save and auto-restore"),
    m(970, subprogram, P::stop, "PL", everywhere, call_block, "call of a block of this program"),
    m(980, subprogram, P::stop, "PL", everywhere, call_program, "subprogram call"),
    m(990, subprogram, P::stop, "P", everywhere, return_from_program, "return from subprogram"),
    m(1980, subprogram, P::stop, "PL", everywhere, call_program, "call of another file"),
    m(9020, spindle_axis, P::spindle_axis, "", not_master, make_axis_of_spindle,
      "spindle becomes an axis"),
    m(9030, spindle_axis, P::spindle_axis, "", not_master, make_spindle_of_axis,
      "axis becomes a spindle"),
});

// Row of each number below G100 and M100, found without a search.
using Index = std::array<std::uint8_t, 1000>;
constexpr std::uint8_t no_row = 255;
static_assert(code_rows.size() < no_row);

constexpr Index index_of(char letter) {
  Index index{};
  for (std::uint8_t& row : index) row = no_row;
  for (std::size_t i = 0; i < code_rows.size(); ++i) {
    if (code_rows[i].letter == letter && code_rows[i].number < 1000) {
      index[static_cast<std::size_t>(code_rows[i].number)] = static_cast<std::uint8_t>(i);
    }
  }
  return index;
}

constexpr Index g_index = index_of('G');
constexpr Index m_index = index_of('M');

}  // namespace

std::span<const Code> code_table() {
  return code_rows;
}

const Code* find_code(char letter, CodeNumber number) {
  if (number >= 0 && number < 1000) {
    const std::uint8_t row = (letter == 'G' ? g_index : m_index)[static_cast<std::size_t>(number)];
    return row == no_row ? nullptr : &code_rows[row];
  }
  for (const Code& code : code_rows) {
    if (code.letter == letter && code.number == number) return &code;
  }
  return nullptr;
}

bool changes_program_flow(const Code& code) {
  const bool macro_call = code.letter == 'G' && (calls_macro(code.number) || code.number == g(67));
  const bool follows_subprogram = code.action == CodeAction::mill_contour_pocket;
  return follows_subprogram || macro_call || code.group == Group::subprogram ||
         code.action == CodeAction::end_program;
}

}  // namespace stanok::lang
