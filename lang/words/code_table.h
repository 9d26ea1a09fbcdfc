// The table of G and M codes: group, order, words and action of each. It drives the checks of a
// block, its execution, the documentation and the tests; a new code is one row and one action
// (code_action.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lang/contract/modal_group.h"
#include "lang/words/block_words.h"
#include "lang/words/code_action.h"

namespace stanok::lang {

// The order in which the parts of a block take effect, whatever the order of its words.
enum class EffectOrder : std::uint8_t {
  feed_mode,
  feed,
  spindle_mode,
  speed,
  tool,
  tool_change,
  spindle_axis,
  spindle,
  coolant,
  override_control,
  functions_before,
  dwell,
  plane,
  units,
  diameter,
  radius_compensation,
  length,
  work_offset,
  path_mode,
  distance,
  return_level,
  settings,
  motion_modifier,  // G9, G53: must be known when the motion starts
  motion,
  functions_after,
  stop,
};

// How a code stands to the axis words of its block.
enum class AxisWords : std::uint8_t {
  unused,
  optional,  // takes those that are there
  required,
};

// Channel kinds on which a code exists.
enum class Availability : std::uint8_t {
  everywhere,
  not_master,  // needs axes or a spindle
  mill_only,
  lathe_only,
};

struct Code {
  char letter = 'G';
  CodeNumber number = 0;
  Group group = Group::none;
  GroupSet groups = 0;  // all groups it conflicts in; `group` is among them
  EffectOrder order = EffectOrder::motion;
  AxisWords axes = AxisWords::unused;
  LetterSet words = 0;  // beside the axis words; F, S and T are always allowed
  Availability availability = Availability::everywhere;
  CodeAction action = CodeAction::unsupported;
  std::string_view title;
};

// All rows, G before M, ascending.
[[nodiscard]] std::span<const Code> code_table();

// The row of a code, or nullptr.
[[nodiscard]] const Code* find_code(char letter, CodeNumber number);

// G65, G66 and G66.1: the other words of their block are arguments.
[[nodiscard]] constexpr bool calls_macro(CodeNumber g_code) {
  return g_code == g(65) || g_code == g(66) || g_code == g(66, 1);
}

// Codes that change the flow of the program and therefore are no plain text: M2, M30, M98, M99, ...
[[nodiscard]] bool changes_program_flow(const Code& code);

}  // namespace stanok::lang
