// The way from the machine positions of a channel to the words that it shows: everything that lies
// between them, one term after the other.
//
// Each step holds what its term adds to every axis and what there is behind it, so that the sum of
// the amounts is the word. The first step is the machine position itself; a term that is not in
// effect has no step. Some terms add the same wherever the axes stand; what a rotation or the
// kinematics adds holds for this place only. mm and deg, axes in the order of the channel. For
// displays; any thread.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "lang/contract/meaning.h"

namespace stanok::runtime {

enum class WordTerm : std::uint8_t {
  machine,
  scheme_zero,           // of the scheme file, or what follows from its geometry
  kinematics,            // how the scheme reads its axes, rotary axes among them
  tool_length,           // vector of the length that is in force
  work_offset,           // of the table
  overhang,              // #tool_overhang
  work_offset_rotation,  // R of the table
  set_up_error,          // G54.4
  local_shift,           // G52
  axis_shift,            // G92
  plane,                 // G68.2 to G68.4
  plane_shift,           // G52 along its axes
  rotation,              // G68
  transformation,        // G12.1, G7.1
  scaling,               // G51, G51.1
  polar,                 // G16
  diameter,              // G7
  rest,                  // between axes and path: a spindle that turns, a move to the parking place
};

// "scheme_zero", "tool_length", ...
[[nodiscard]] std::string_view name_of(WordTerm term);

enum class Adds : std::uint8_t { everywhere_the_same, as_the_axes_stand };

struct WordStep {
  WordTerm term = WordTerm::machine;
  Adds adds = Adds::everywhere_the_same;
  lang::AxisValues amount{};
  lang::AxisValues value{};  // behind it
};

// `meaning` is the one with the number that the output shows.
[[nodiscard]] std::vector<WordStep> steps_to_words(const channels::MachineConfig& machine,
                                                   const channels::ChannelConfig& channel,
                                                   const channels::ChannelOutput& output,
                                                   const lang::Meaning& meaning);

}  // namespace stanok::runtime
