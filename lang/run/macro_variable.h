// System variables of Fanuc and Haas: what a number of the Fanuc dialect beyond #999 means.
//
// Numbers and meanings are those of the operator's manuals B-63944EN (machining centres, tool
// compensation memory C) and B-64304EN-1 (lathes), 16.2; lengths stand in programmed units, X in
// diameters where these are programmed. Axes count in the order of the channel.
#pragma once

#include <cstdint>
#include <optional>

#include "lang/block/predefined_parameter.h"
#include "lang/contract/dialect.h"

namespace stanok::lang {

// The value of #number as far as the interpreter knows it without asking: positions of the program,
// modal codes, work offsets, what a probe found. Nothing for all others.
[[nodiscard]] std::optional<double> system_variable(int number, const ParameterView& view,
                                                    const TextRules& rules);

// #5041 and on: where the axes stand in the workpiece, with the tool length in force included,
// which is what makes #5043 more than #5003. So are #5061 and on. Source: Fanuc B-64304EN, 16.2,
// table of position information, "tool compensation value".
[[nodiscard]] double position_with_tool(const BlockSurroundings& around, AxisIndex axis);

// A variable for which the machine is asked, or which acts when it is set.
struct MachineVariable {
  enum class Kind : std::uint8_t {
    machine_position,  // #5021: of axis `index`
    work_position,     // #5041
    timer,             // #3001, ms
    input,             // #1000: `index`
    output,            // #1100, can be set only
    tool_value,        // #2001, #10001: value `value` (settable_tool) of tool `index`
    work_offset,       // #5221, #7001: axis `index` of page `value`; can be set only
    parts,             // #3901, #3902
    override_switch,   // #3003, #3004: `index`; what keys of the operator do
  };
  Kind kind = Kind::timer;
  int index = 0;
  int value = 0;
};
[[nodiscard]] std::optional<MachineVariable> machine_variable(int number,
                                                              const ChannelDescription& channel,
                                                              const TextRules& rules);

// What the number means on the controls it is known from, where stanok has nothing for it; empty:
// nothing is known.
[[nodiscard]] std::string_view meaning_elsewhere(int number);

// The number under which a variable of the Haas dialect is kept: #100 is #10100, #10500 is #500.
[[nodiscard]] int haas_variable(int number);
// Numbers that are nobody's there, although Fanuc has some of them.
[[nodiscard]] bool is_hidden_on_haas(int number);

}  // namespace stanok::lang
