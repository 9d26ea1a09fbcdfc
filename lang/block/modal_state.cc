#include "lang/block/modal_state.h"

#include <cmath>
#include <string>

namespace stanok::lang {
namespace {

// About its centre c: p = R * p_within + c - R * c.
SystemWithin rotated_system(const ProgrammedRotation& rotation) {
  if (rotation.rotation.is_identity()) return {};
  const Vector3<double> centre = vector3(rotation.centre);
  return {true, rotation.rotation, components(centre - rotation.rotation.turned(centre))};
}

}  // namespace

ModalState default_modal_state(ChannelKind kind) {
  ModalState state;
  state.codes = default_codes(kind);
  return state;
}

Note ModalState::origin_of(Group group) const {
  const std::uint32_t line = lines[group];
  const std::string code_name = code_text(letter_of(group), code(group));
  if (line == 0) return {code_name + " is active by default", {}};
  return {code_name + " is active since line " + std::to_string(line), {}};
}

Plane ModalState::plane() const {
  switch (code(Group::plane)) {
    case g(18):
      return Plane::zx;
    case g(19):
      return Plane::yz;
    default:
      return Plane::xy;
  }
}

FeedMode ModalState::feed_mode() const {
  switch (code(Group::feed_mode)) {
    case g(93):
      return FeedMode::inverse_time;
    case g(95):
      return FeedMode::per_revolution;
    default:
      return FeedMode::per_minute;
  }
}

WorkFrame ModalState::frame() const {
  WorkFrame frame = frames.frame(geometry);
  if (tool.overhang_axis >= 0) frame.offset[tool.overhang_axis] -= tool.overhang_shift_mm;
  return frame;
}

void ModalState::reexpress_position(const WorkFrame& before) {
  adopt_position(before.base_from_work(position_W));
}

void ModalState::adopt_position(const AxisValues& position_B) {
  const AxisValues position = frame().work_from_base(position_B);
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (std::abs(position[i] - position_W[i]) > position_noise) position_W[i] = position[i];
  }
}

FrameChange frame_of(const ModalState& modal) {
  const WorkFrame frame = modal.frame();
  return {modal.frames.work_offset_number, frame.offset, frame.rotation};
}

MeaningTerms terms_of(const ModalState& modal) {
  const FrameSettings& frames = modal.frames;
  MeaningTerms terms;
  terms.frame = frame_of(modal);
  terms.work_offset_B = frames.work_offset;
  terms.work_offset_rotation = frames.work_offset_rotation;
  terms.local_shift = frames.local_shift;
  if (frames.axis_shift_active) terms.axis_shift = frames.axis_shift;
  terms.overhang_axis = modal.tool.overhang_axis;
  terms.overhang_mm = modal.tool.overhang_shift_mm;
  if (frames.set_up.is_on) terms.set_up_error = {true, frames.set_up.rotation, frames.set_up.shift};
  if (frames.plane.is_on) terms.plane = {true, frames.plane.rotation, frames.plane.origin};
  terms.plane_shift = frames.plane.local_shift;
  terms.rotation = rotated_system(frames.rotation);
  terms.gain = modal.map.gains();
  terms.shift = modal.map.shifts();
  terms.tool = {modal.tool.active, modal.tool.edge};
  terms.length = modal.tool.length;
  terms.radius_offset = modal.tool.radius_offset;
  terms.transformation = modal.transformation.change;
  terms.geometry = modal.geometry;
  return terms;
}

void ModalState::shift_position(const AxisValues& distance_B) {
  const AxisValues distance_W = turned_back(frame().rotation, geometry, distance_B);
  for (std::size_t i = 0; i < distance_W.size(); ++i) position_W[i] += distance_W[i];
}

}  // namespace stanok::lang
