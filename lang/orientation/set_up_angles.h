// The rotary axes under G54.4, which turns the workpiece: the angles of a program are those of the
// workpiece as it is drawn, and the tool leans against it as it lies by other angles.
//
// A direction of the tool is turned as the workpiece is; the channel answers which angles give it.
// Where both stand for the tool of now is kept in the modal state.
#pragma once

#include <optional>

#include "lang/block/active_block.h"
#include "lang/contract/tool_alignment.h"

namespace stanok::lang {

// Whether lines under G43.4 and G43.5 take their angles so: not within an aligned plane, whose tool
// stands square to it already.
[[nodiscard]] bool corrects_angles(const ActiveBlock& block);

// Where the rotary axes have to stand at the end of `move`; nothing: they stay, or the block has
// failed.
struct CorrectedAngles {
  Alignment alignment;
  AxisValues drawn_W{};
};
[[nodiscard]] std::optional<CorrectedAngles> corrected_angles(ActiveBlock& block, const Move& move);

// The tool stands where a vector or a plane has turned it, which is as the workpiece lies.
void note_turned_tool(ActiveBlock& block);

}  // namespace stanok::lang
