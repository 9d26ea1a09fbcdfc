#include "lang/block/predefined_parameter.h"

#include <algorithm>
#include <array>
#include <limits>

#include "lang/block/point_parameter.h"

namespace stanok::lang {
namespace {

// First numbers of the blocks, one parameter per axis.
constexpr int axis_shift_first = 5211;   // G92
constexpr int work_offset_first = 5221;  // G54; the next system 20 further on
constexpr int work_offset_step = 20;
constexpr int work_offset_rotation = 9;  // behind the axes of a system
constexpr int work_offset_count = 9;     // G54 to G59.3
constexpr int tool_offset_first = 5401;
constexpr int position_first = 5420;

const ModalState& modal_of(const ParameterView& view) {
  return view.around.modal;
}

// The value of the axis called `letter`; 0 where the channel has none.
double of_axis(const BlockSurroundings& around, char letter, const AxisValues& values) {
  const AxisIndex axis = around.channel_words.axis_called(std::string_view(&letter, 1));
  return axis.exists() ? as_programmed(around, axis, values[axis]) : 0.0;
}

template <Group Which>
double code_of_group(const ParameterView& view) {
  return modal_of(view).code(Which);
}

template <Group Which, CodeNumber Number>
double has_code(const ParameterView& view) {
  return modal_of(view).code(Which) == Number ? 1.0 : 0.0;
}

template <bool ModalSwitches::* Flag>
double flag(const ParameterView& view) {
  return modal_of(view).switches.*Flag ? 1.0 : 0.0;
}

double position_of_letter(const BlockSurroundings& around, char letter) {
  const AxisIndex axis = around.channel_words.axis_called(std::string_view(&letter, 1));
  return axis.exists() ? programmed_position(around, axis) : 0.0;
}

template <char Letter>
double position_along(const ParameterView& view) {
  return position_of_letter(view.around, Letter);
}

// Where the axis stands in machine coordinates, at the end of the block before. Not known (NaN)
// while the words of the program are no coordinates of axes: TCP, G12.1, G7.1.
template <char Letter>
double machine_position_along(const ParameterView& view) {
  constexpr char letter = Letter;
  const BlockSurroundings& around = view.around;
  const ModalState& modal = around.modal;
  const AxisIndex axis = around.channel_words.axis_called(std::string_view(&letter, 1));
  if (!axis.exists()) return 0.0;
  const ToolLength& length = modal.tool.length;
  if (length.mode == LengthMode::tip || modal.transformation.axis >= 0)
    return std::numeric_limits<double>::quiet_NaN();
  const double tool = length_along(around, axis, length.offset_mm);
  const AxisValues position_B = modal.frame().base_from_work(modal.position_W);
  return machine_as_programmed(
      around, axis, around.tables.machine_reading().in_machine(axis, position_B[axis] + tool));
}

double spindle_runs(const ParameterView& view) {
  return modal_of(view).spindles.any_runs ? 1.0 : 0.0;
}

double spindle_runs_clockwise(const ParameterView& view) {
  const ModalState& modal = modal_of(view);
  return modal.spindles.any_runs && modal.code(Group::spindle) == m(3) ? 1.0 : 0.0;
}

double active_tool(const ParameterView& view) {
  return modal_of(view).tool.active;
}

double prepared_tool(const ParameterView& view) {
  return std::max(modal_of(view).tool.prepared, 0);
}

// A program that is interpreted here is always meant for its machine.
double always(const ParameterView&) {
  return 1.0;
}

// Programs of LinuxCNC ask which version they run on; its meaning is that of 2.9 here
// (docs/reference/language.md).
double linuxcnc_version(const ParameterView&) {
  return 2.9;
}

double linuxcnc_revision(const ParameterView&) {
  return 0.0;
}

constexpr auto parameter_rows = std::to_array<PredefinedParameter>({
    {"_line", [](const ParameterView& view) { return static_cast<double>(view.line); }},
    {"_call_level", [](const ParameterView& view) { return static_cast<double>(view.call_level); }},
    {"_value", [](const ParameterView& view) { return view.value; }},
    {"_value_returned", [](const ParameterView& view) { return view.value_returned ? 1.0 : 0.0; }},
    {"_task", always},
    {"_vmajor", linuxcnc_version},
    {"_vminor", linuxcnc_revision},
    {"_motion_mode", code_of_group<Group::motion>},
    {"_plane", code_of_group<Group::plane>},
    {"_ccomp", code_of_group<Group::radius_compensation>},
    {"_coord_system", code_of_group<Group::work_offset>},
    {"_metric", has_code<Group::units, g(21)>},
    {"_imperial", has_code<Group::units, g(20)>},
    {"_absolute", has_code<Group::distance, g(90)>},
    {"_incremental", has_code<Group::distance, g(91)>},
    {"_ijk_absolute_mode", has_code<Group::arc_distance, g(90, 1)>},
    {"_inverse_time", has_code<Group::feed_mode, g(93)>},
    {"_units_per_minute", has_code<Group::feed_mode, g(94)>},
    {"_units_per_rev", has_code<Group::feed_mode, g(95)>},
    {"_tool_offset",
     [](const ParameterView& view) {
       return modal_of(view).tool.length.mode == LengthMode::off ? 0.0 : 1.0;
     }},
    {"_retract_r_plane", has_code<Group::return_level, g(99)>},
    {"_retract_old_z", has_code<Group::return_level, g(98)>},
    {"_spindle_rpm_mode", has_code<Group::spindle_mode, g(97)>},
    {"_spindle_css_mode", has_code<Group::spindle_mode, g(96)>},
    {"_lathe_diameter_mode", has_code<Group::diameter, g(7)>},
    {"_lathe_radius_mode", has_code<Group::diameter, g(8)>},
    {"_spindle_on", spindle_runs},
    {"_spindle_cw", spindle_runs_clockwise},
    {"_mist", flag<&ModalSwitches::mist>},
    {"_flood", flag<&ModalSwitches::flood>},
    {"_feed_override", flag<&ModalSwitches::feed_override>},
    {"_speed_override", flag<&ModalSwitches::spindle_override>},
    {"_adaptive_feed", flag<&ModalSwitches::adaptive_feed>},
    {"_feed_hold", flag<&ModalSwitches::feed_stop>},
    {"_remap_level", [](const ParameterView&) { return 0.0; }},
    {"_feed", [](const ParameterView& view) { return modal_of(view).feed.programmed; }},
    {"_rpm", [](const ParameterView& view) { return modal_of(view).spindles.speed_rev_per_min; }},
    {"_x", position_along<'X'>},
    {"_y", position_along<'Y'>},
    {"_z", position_along<'Z'>},
    {"_a", position_along<'A'>},
    {"_b", position_along<'B'>},
    {"_c", position_along<'C'>},
    {"_u", position_along<'U'>},
    {"_v", position_along<'V'>},
    {"_w", position_along<'W'>},
    {"_abs_x", machine_position_along<'X'>},
    {"_abs_y", machine_position_along<'Y'>},
    {"_abs_z", machine_position_along<'Z'>},
    {"_abs_a", machine_position_along<'A'>},
    {"_abs_b", machine_position_along<'B'>},
    {"_abs_c", machine_position_along<'C'>},
    {"_abs_u", machine_position_along<'U'>},
    {"_abs_v", machine_position_along<'V'>},
    {"_abs_w", machine_position_along<'W'>},
    {"_current_tool", active_tool},
    {"_current_pocket", active_tool},
    {"_selected_tool", prepared_tool},
    {"_selected_pocket", prepared_tool},
});

// The place of `number` in a block of one parameter per axis, from 0.
std::optional<std::size_t> place_in_block(int number, int first) {
  const auto place = static_cast<unsigned>(number - first);  // of a smaller number: a large one
  return place < parameter_axes.size() ? std::optional<std::size_t>(place) : std::nullopt;
}

// The letter of the axis whose value stands there.
std::optional<char> letter_in_block(int number, int first) {
  const auto place = place_in_block(number, first);
  return place ? std::optional(parameter_axes[*place]) : std::nullopt;
}

std::optional<double> work_offset_parameter(int number, const BlockSurroundings& around) {
  const int behind = number - work_offset_first;
  if (behind < 0 || behind >= work_offset_count * work_offset_step) return std::nullopt;
  const int system = behind / work_offset_step + 1;
  if (behind % work_offset_step == work_offset_rotation) {
    return around.tables.work_offset_rotation(system);
  }
  const auto letter = letter_in_block(behind % work_offset_step, 0);
  if (!letter) return std::nullopt;
  return of_axis(around, *letter, around.tables.work_offset(system).value_or(AxisValues{}));
}

// Of the tool table, whether the length is active or not (LinuxCNC, "Numbered parameters").
std::optional<double> tool_offset_parameter(int number, const BlockSurroundings& around) {
  const auto coordinate = place_in_block(number, tool_offset_first);
  if (!coordinate) return std::nullopt;
  const auto tool = around.tables.tool(around.modal.tool.active);
  if (!tool || *coordinate >= tool->length_mm.size()) return 0.0;
  const double unit = around.modal.inches() ? mm_per_inch : 1.0;
  return tool->length_mm[*coordinate] / unit;
}

double tool_diameter(const BlockSurroundings& around) {
  const auto tool = around.tables.tool(around.modal.tool.active);
  const double unit = around.modal.inches() ? mm_per_inch : 1.0;
  return tool ? 2.0 * tool->radius_mm / unit : 0.0;
}

}  // namespace

double as_programmed(const BlockSurroundings& around, AxisIndex axis, double value) {
  return value / from_programmed(around, axis, 1.0);
}

double machine_as_programmed(const BlockSurroundings& around, AxisIndex axis, double value_M) {
  return as_programmed(around, axis, value_M / around.tables.machine_reading().counts(axis));
}

double from_programmed(const BlockSurroundings& around, AxisIndex axis, double value) {
  const AxisDescription& description = around.channel.axes[axis];
  if (!description.rotary && around.modal.inches()) value *= mm_per_inch;
  if (around.modal.diameters() && description.geometry == 0) value *= 0.5;
  return value;
}

double programmed_position(const BlockSurroundings& around, AxisIndex axis) {
  return as_programmed(around, axis, around.modal.programmed_position(axis));
}

std::span<const PredefinedParameter> predefined_parameters() {
  return parameter_rows;
}

const PredefinedParameter* find_predefined_parameter(std::string_view folded_name) {
  const auto row =
      std::find_if(parameter_rows.begin(), parameter_rows.end(),
                   [&](const PredefinedParameter& one) { return one.name == folded_name; });
  return row == parameter_rows.end() ? nullptr : &*row;
}

std::optional<double> machine_parameter(int number, const ParameterView& view) {
  const BlockSurroundings& around = view.around;
  const ModalState& modal = around.modal;
  switch (number) {
    case 5210:
      return modal.frames.axis_shift_active && modal.frames.axis_shift != AxisValues{} ? 1.0 : 0.0;
    case 5220:
      return modal.frames.work_offset_number;
    case 5400:
      return modal.tool.active;
    case 5410:
      return tool_diameter(around);
    default:
      break;
  }
  if (const auto letter = letter_in_block(number, axis_shift_first)) {
    return of_axis(around, *letter, modal.frames.axis_shift);
  }
  if (const auto letter = letter_in_block(number, position_first)) {
    return position_of_letter(around, *letter);
  }
  if (const auto point = point_parameter(number, around)) return point;
  if (const auto offset = work_offset_parameter(number, around)) return offset;
  return tool_offset_parameter(number, around);
}

}  // namespace stanok::lang
