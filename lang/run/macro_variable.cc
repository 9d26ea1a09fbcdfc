#include "lang/run/macro_variable.h"

#include <algorithm>
#include <array>

#include "lang/block/point_parameter.h"
#include "lang/words/code_system.h"

namespace stanok::lang {
namespace {

using Kind = MachineVariable::Kind;

// Numbers of the blocks with one variable for each axis.
constexpr int axes_of_block = 8;
constexpr int block_end_first = 5001;
constexpr int machine_first = 5021;
constexpr int work_first = 5041;
constexpr int skip_first = 5061;
constexpr int length_first = 5081;  // of the tool length in force; not on lathes

// Work offsets: first number, page of it, pages, numbers from page to page.
struct OffsetBlock {
  int first;
  int page;
  int pages;
};
constexpr int offset_step = 20;
constexpr auto offset_blocks = std::to_array<OffsetBlock>({
    {5221, 1, 6},      // G54 to G59
    {7001, 10, 48},    // G54.1 P1 to P48
    {14001, 10, 300},  // G54.1 P1 to P300
});

// Tool values: first number, how many, and which value of settable_tool.
struct ToolBlock {
  int first;
  int count;
  int value;
};
constexpr int length = 1;
constexpr int length_x = 3;
constexpr int radius = 4;
constexpr int wear_length = 5;
constexpr int wear_radius = 6;
constexpr int orientation = 8;
constexpr int wear_length_x = 11;
constexpr auto tools_of_mills = std::to_array<ToolBlock>({
    {2001, 200, wear_length},
    {2201, 200, length},
    {10001, 999, wear_length},
    {11001, 999, length},
    {12001, 999, wear_radius},
    {13001, 999, radius},
});
constexpr auto tools_of_lathes = std::to_array<ToolBlock>({
    {2001, 64, wear_length_x},
    {2101, 64, wear_length},
    {2201, 64, wear_radius},
    {2301, 64, orientation},
    {2701, 49, length_x},
    {2801, 49, length},
    {2901, 64, radius},
    {10001, 999, wear_length_x},
    {11001, 999, wear_length},
    {12001, 999, wear_radius},
    {13001, 999, orientation},
    {15001, 999, length_x},
    {16001, 999, length},
    {17001, 999, radius},
});

// Of Haas: geometry before wear. Source: Haas operator's manuals (mill and lathe), table of the
// macro variables.
constexpr auto tools_of_haas_mills = std::to_array<ToolBlock>({
    {2001, 200, length},
    {2201, 200, wear_length},
    {2401, 200, radius},
    {2601, 200, wear_radius},
});
constexpr auto tools_of_haas_lathes = std::to_array<ToolBlock>({
    {2001, 50, length_x},
    {2101, 50, length},
    {2201, 50, radius},
    {2301, 50, orientation},
    {2701, 50, wear_length_x},
    {2801, 50, wear_length},
    {2901, 50, wear_radius},
});

// Modal codes, by the group that has them: mills and lathes number them differently.
struct ModalNumber {
  int number;
  Group group;
};
constexpr auto modals_of_mills = std::to_array<ModalNumber>({
    {4001, Group::motion},
    {4002, Group::plane},
    {4003, Group::distance},
    {4005, Group::feed_mode},
    {4006, Group::units},
    {4007, Group::radius_compensation},
    {4008, Group::length},
    {4010, Group::return_level},
    {4011, Group::scaling},
    {4013, Group::spindle_mode},
    {4014, Group::work_offset},
    {4015, Group::path_mode},
    {4016, Group::rotation},
    {4022, Group::mirror},
});
constexpr auto modals_of_lathes = std::to_array<ModalNumber>({
    {4001, Group::motion},
    {4002, Group::spindle_mode},
    {4003, Group::distance},
    {4005, Group::feed_mode},
    {4006, Group::units},
    {4007, Group::radius_compensation},
    {4014, Group::work_offset},
    {4015, Group::path_mode},
    {4016, Group::plane},
});
// Where Haas numbers its groups otherwise. Source: Haas operator's manuals, lists of G codes with
// their groups.
constexpr auto modals_of_haas = std::to_array<ModalNumber>({
    {4012, Group::work_offset},
    {4015, Group::path_mode},
});

std::optional<int> place_in(int number, int first, int count) {
  const bool inside = number >= first && number < first + count;
  return inside ? std::optional(number - first) : std::nullopt;
}

// The axis with which a variable of a block is concerned.
std::optional<AxisIndex> axis_at(int number, int first, const ChannelDescription& channel) {
  const auto place = place_in(number, first, axes_of_block);
  if (!place || *place >= static_cast<int>(channel.axes.size())) return std::nullopt;
  return AxisIndex(*place);
}

template <class Blocks>
std::optional<MachineVariable> tool_variable(int number, const Blocks& blocks) {
  for (const ToolBlock& block : blocks) {
    if (const auto place = place_in(number, block.first, block.count))
      return MachineVariable{Kind::tool_value, *place + 1, block.value};
  }
  return std::nullopt;
}

std::optional<MachineVariable> offset_variable(int number, const ChannelDescription& channel) {
  for (const OffsetBlock& block : offset_blocks) {
    const auto place = place_in(number, block.first, block.pages * offset_step);
    if (!place) continue;
    if (*place % offset_step >= static_cast<int>(channel.axes.size())) return std::nullopt;
    return MachineVariable{Kind::work_offset, *place % offset_step,
                           block.page + *place / offset_step};
  }
  return std::nullopt;
}

bool is_drilling(CodeNumber code) {
  return (code >= g(81) && code <= g(89)) || code == g(73) || code == g(74) || code == g(76);
}

std::optional<double> modal_variable(int number, const ParameterView& view,
                                     const TextRules& rules) {
  const ModalState& modal = view.around.modal;
  const bool lathe = view.around.channel.kind == ChannelKind::lathe;
  const CodeNumber motion = modal.code(Group::motion);
  if (number == (lathe ? 4010 : 4009)) return is_drilling(motion) ? motion / 10.0 : 80.0;
  if (number == 4001 && is_drilling(motion)) return std::nullopt;
  const auto find = [&](const auto& rows) -> std::optional<double> {
    for (const ModalNumber& row : rows) {
      if (row.number == number)
        return code_as_written(modal.code(row.group), rules.code_system) / 10.0;
    }
    return std::nullopt;
  };
  if (const auto code = rules.is_haas() ? find(modals_of_haas) : std::nullopt) return code;
  if (const auto code = lathe ? find(modals_of_lathes) : find(modals_of_mills)) return code;
  switch (number) {
    case 4107:
      return std::max(modal.tool.radius_offset, 0);
    case 4109:
      return modal.feed.programmed;
    case 4111:
      return modal.tool.length.tool;
    case 4119:
      return modal.spindles.speed_rev_per_min;
    case 4120:
      return modal.tool.active;
    case 4130:
      return std::max(modal.frames.work_offset_number - first_extended_offset + 1, 0);
    default:
      return std::nullopt;
  }
}

// What these lengths are along an axis, in units of the program; 0 on lathes, where the offset of a
// tool shifts the zero of the workpiece.
double programmed_length(const BlockSurroundings& around, AxisIndex axis,
                         const std::array<double, 3>& lengths_mm) {
  if (around.channel.kind == ChannelKind::lathe) return 0.0;
  const double length_mm = length_along(around, axis, lengths_mm);
  return around.modal.inches() ? length_mm / mm_per_inch : length_mm;
}

}  // namespace

double position_with_tool(const BlockSurroundings& around, AxisIndex axis) {
  return programmed_position(around, axis) +
         programmed_length(around, axis, around.modal.tool.length.offset_mm);
}

std::optional<double> system_variable(int number, const ParameterView& view,
                                      const TextRules& rules) {
  const BlockSurroundings& around = view.around;
  if (const auto axis = axis_at(number, block_end_first, around.channel))
    return programmed_position(around, *axis);
  if (const auto axis = axis_at(number, skip_first, around.channel))
    return as_programmed(around, *axis, around.probe.position[*axis]) +
           programmed_length(around, *axis, around.probe.tool_length_mm);
  if (const auto offset = offset_variable(number, around.channel)) {
    const AxisIndex axis = offset->index;
    const auto row = around.tables.work_offset(offset->value);
    return row ? std::optional(as_programmed(around, axis, (*row)[axis])) : std::nullopt;
  }
  if (const auto axis = axis_at(number, length_first, around.channel);
      axis && around.channel.kind != ChannelKind::lathe)
    return programmed_length(around, *axis, around.modal.tool.length.offset_mm);
  constexpr int tool_in_spindle = 3026;
  if (rules.is_haas() && number == tool_in_spindle) return around.modal.tool.active;
  return modal_variable(number, view, rules);
}

int haas_variable(int number) {
  constexpr int of_new_control = 10000;
  const bool legacy = number >= 100 && number <= 199;
  if (legacy) return number + of_new_control;
  const bool also_legacy = number > haas_variable_last && number < 11000;
  return also_legacy ? number - of_new_control : number;
}

bool is_hidden_on_haas(int number) {
  return (number >= 200 && number < 500) || (number >= 700 && number < 800);
}

std::optional<MachineVariable> machine_variable(int number, const ChannelDescription& channel,
                                                const TextRules& rules) {
  const bool lathe = channel.kind == ChannelKind::lathe;
  if (rules.is_haas()) {
    if (const auto place = place_in(number, 11000, 64))
      return MachineVariable{Kind::input, *place, 0};
    if (const auto place = place_in(number, 12000, 64))
      return MachineVariable{Kind::output, *place, 0};
  }
  if (const auto axis = axis_at(number, machine_first, channel))
    return MachineVariable{Kind::machine_position, axis->number(), 0};
  if (const auto axis = axis_at(number, work_first, channel))
    return MachineVariable{Kind::work_position, axis->number(), 0};
  if (number == 3001) return MachineVariable{Kind::timer, 0, 0};
  if (number == 3003 || number == 3004) return MachineVariable{Kind::override_switch, number, 0};
  if (number == 3901 || number == 3902) return MachineVariable{Kind::parts, number, 0};
  if (const auto place = place_in(number, 1000, 32)) return MachineVariable{Kind::input, *place, 0};
  if (const auto place = place_in(number, 1100, 32))
    return MachineVariable{Kind::output, *place, 0};
  if (const auto offset = offset_variable(number, channel)) return offset;
  if (rules.is_haas())
    return lathe ? tool_variable(number, tools_of_haas_lathes)
                 : tool_variable(number, tools_of_haas_mills);
  return lathe ? tool_variable(number, tools_of_lathes) : tool_variable(number, tools_of_mills);
}

std::string_view meaning_elsewhere(int number) {
  const auto within = [number](int first, int last) { return number >= first && number <= last; };
  if (within(1000, 1199)) return "signals that go to and from the PLC";
  if (within(2001, 2999) || within(10001, 19999)) return "a tool offset that stanok does not have";
  if (number == 3000) return "an alarm; it is set to a number alone in its block";
  if (number == 3006) return "a stop with a message; it is set to a number alone in its block";
  if (number == 3002) return "the hours of operation";
  if (number == 3011 || number == 3012) return "date and time, which programs do not see";
  if (within(3000, 3999)) return "settings of the control";
  if (within(4001, 4399)) return "modal information that stanok does not have";
  if (within(5001, 5199)) return "a position of an axis that the channel does not have";
  if (within(5201, 5228))
    return "the external work offset, or that of an axis that the channel does not have";
  return {};
}

}  // namespace stanok::lang
