#include "lang/orientation/set_up_angles.h"

#include <cmath>

#include "base/vector3.h"
#include "lang/orientation/tool_orientation.h"

namespace stanok::lang {
namespace {

bool is_rotary(const ActiveBlock& block, std::size_t axis) {
  return (block.channel_words.linear_axes() & axis_bit(axis)) == 0;
}

bool is_increment(const ActiveBlock& block, std::size_t axis) {
  if ((block.incremental & axis_bit(axis)) != 0) return true;
  return block.modal.incremental() && (block.absolute & axis_bit(axis)) == 0;
}

// The axes stand where the last correction has left them.
bool stands_corrected(const ActiveBlock& block, std::size_t axis) {
  const SetUpAngles& angles = block.modal.frames.set_up_angles;
  return angles.are_known &&
         std::abs(block.modal.position_W[axis] - angles.lying_W[axis]) <= position_noise;
}

// A direction in B as it is drawn, turned as the workpiece lies.
Vector3<double> as_it_lies(const FrameSettings& frames, const Vector3<double>& drawn_B) {
  return frames.work_offset_rotation.turned(
      frames.set_up.rotation.turned(frames.work_offset_rotation.turned_back(drawn_B)));
}

Vector3<double> as_it_is_drawn(const FrameSettings& frames, const Vector3<double>& lying_B) {
  return frames.work_offset_rotation.turned(
      frames.set_up.rotation.turned_back(frames.work_offset_rotation.turned_back(lying_B)));
}

}  // namespace

bool corrects_angles(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  return modal.frames.set_up.turns() && leads_tip(modal.code(Group::length)) &&
         !modal.frames.plane.is_aligned;
}

std::optional<CorrectedAngles> corrected_angles(ActiveBlock& block, const Move& move) {
  const ModalState& modal = block.modal;
  const WorkFrame frame = modal.frame();
  AxisValues drawn_W = modal.position_W;
  bool turns = false;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_rotary(block, i)) continue;
    const bool stands = stands_corrected(block, i);
    const bool is_programmed = (block.programmed & axis_bit(i)) != 0;
    turns = turns || is_programmed || !stands;
    if (stands) drawn_W[i] = modal.frames.set_up_angles.drawn_W[i];
    if (!is_programmed) continue;
    drawn_W[i] =
        is_increment(block, i) ? drawn_W[i] + move.end[i] - modal.position_W[i] : move.end[i];
  }
  if (!turns) return std::nullopt;
  const Vector3<double> drawn_B =
      vector3(block.tables.spindle_axes(frame.base_from_work(drawn_W))[2]);
  const OrientationWish wish{.word = {},
                             .name = "a tool under `G54.4`",
                             .tool_B = components(as_it_lies(modal.frames, drawn_B)),
                             .purpose = "tilt with the workpiece, to",
                             .said_by = Group::length,
                             .remedy = "clamp the workpiece differently"};
  const auto found = reachable_angles(block, wish);
  if (!found) return std::nullopt;
  return CorrectedAngles{*found, drawn_W};
}

void note_turned_tool(ActiveBlock& block) {
  ModalState& modal = block.modal;
  if (!modal.frames.set_up.turns()) return;
  const WorkFrame frame = modal.frame();
  const AxisValues lying_B = frame.base_from_work(modal.position_W);
  AlignmentWish asked;
  asked.tool_B =
      components(as_it_is_drawn(modal.frames, vector3(block.tables.spindle_axes(lying_B)[2])));
  asked.from_B = lying_B;
  const Alignment drawn = block.tables.alignment(asked);
  const bool is_found = drawn.outcome == Alignment::Outcome::found;
  modal.frames.set_up_angles = {
      true, is_found ? frame.work_from_base(drawn.angles_B) : modal.position_W, modal.position_W};
}

}  // namespace stanok::lang
