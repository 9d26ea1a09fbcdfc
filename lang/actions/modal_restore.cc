#include "lang/actions/modal_restore.h"

#include <algorithm>
#include <array>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

// Codes that mean nothing but themselves, or whose data is restored beside them.
constexpr auto restored_groups = std::to_array<Group>(
    {Group::plane, Group::distance, Group::arc_distance, Group::feed_mode, Group::units,
     Group::return_level, Group::path_mode, Group::diameter, Group::override_control});

// Codes with consequences that no saved text holds: they must be the same on both sides.
constexpr auto equal_groups =
    std::to_array<Group>({Group::radius_compensation, Group::transformation, Group::polar});

void restore_modal(ActiveBlock& block, const ModalState& saved) {
  ModalState& modal = block.modal;
  for (const Group group : restored_groups) {
    if (modal.code(group) != saved.code(group)) block.set_modal(group, saved.code(group));
  }
  modal.path = saved.path;
  modal.tool.turning = saved.tool.turning;
  if (modal.frames.work_offset_number != saved.frames.work_offset_number ||
      modal.frames.is_carried != saved.frames.is_carried) {
    restore_work_offset(block, saved);
    block.set_modal(Group::work_offset, saved.code(Group::work_offset));
  }
  const bool overrides_differ = modal.switches.feed_override != saved.switches.feed_override ||
                                modal.switches.spindle_override != saved.switches.spindle_override;
  modal.switches.feed_override = saved.switches.feed_override;
  modal.switches.spindle_override = saved.switches.spindle_override;
  if (overrides_differ) {
    block.queue.emit(
        OverrideControl{saved.switches.feed_override, saved.switches.spindle_override});
  }
}

// The master spindle; its speed only matters to the machine when it turns or was set.
void restore_spindle(ActiveBlock& block, const ModalState& saved) {
  ModalState& modal = block.modal;
  restore_spindle_mode(block, saved);
  const bool other_speed = modal.spindles.speed_rev_per_min != saved.spindles.speed_rev_per_min;
  modal.spindles.speed_rev_per_min = saved.spindles.speed_rev_per_min;
  modal.spindles.speeds_rev_per_min[0] = saved.spindles.speed_rev_per_min;
  SpindleCommand command;
  command.speed_rev_per_min = saved.spindles.speed_rev_per_min;
  const bool cutting = saved.code(Group::spindle_mode) == g(96) && saved.spindles.any_runs;
  if (other_speed) {
    command.action = SpindleAction::set_speed;
    block.queue.emit(command);
  }
  const CodeNumber code = saved.code(Group::spindle);
  if (modal.code(Group::spindle) == code && modal.spindles.any_runs == saved.spindles.any_runs)
    return;
  command.action = !saved.spindles.any_runs ? SpindleAction::stop
                   : code == m(4)           ? SpindleAction::counter_clockwise
                                            : SpindleAction::clockwise;
  constexpr std::uint16_t master = 1;
  saved.spindles.any_runs ? modal.spindles.start(master) : modal.spindles.stop(master);
  block.set_modal(Group::spindle, code);
  if (cutting) command.cutting_speed_m_per_min = saved.spindles.cutting_speed_m_per_min;
  block.queue.emit(command);
}

void restore_coolant(ActiveBlock& block, const ModalState& saved) {
  ModalState& modal = block.modal;
  if (modal.switches.mist == saved.switches.mist && modal.switches.flood == saved.switches.flood)
    return;
  modal.switches.mist = saved.switches.mist;
  modal.switches.flood = saved.switches.flood;
  block.set_modal(Group::mist, saved.code(Group::mist));
  block.set_modal(Group::flood, saved.code(Group::flood));
  block.queue.emit(CoolantCommand{saved.switches.mist, saved.switches.flood});
}

}  // namespace

std::string_view reason_against_restoring(const ModalState& now, const ModalState& saved,
                                          StateParts parts) {
  const auto differs = [&](Group group) { return now.code(group) != saved.code(group); };
  if ((parts & state_modal) != 0 &&
      std::any_of(equal_groups.begin(), equal_groups.end(), differs)) {
    return "radius compensation or a transformation differs";
  }
  if ((parts & state_frames) != 0 && now.transformation.axis >= 0 && differs(Group::rotation)) {
    return "a transformation excludes the rotation";
  }
  if ((parts & state_tool) != 0 && now.tool.active != saved.tool.active) {
    return "another tool is active";
  }
  if ((parts & state_frames) != 0 &&
      (now.frames.plane.is_aligned || saved.frames.plane.is_aligned) &&
      now.frames.plane != saved.frames.plane) {
    return "the tilted plane with which the tool is aligned differs";
  }
  // The tip of an aligned tool is led whatever mode of its length is restored.
  const LengthMode saved_mode =
      now.frames.plane.is_aligned ? LengthMode::tip : saved.tool.length.mode;
  const bool tip = now.tool.length.mode == LengthMode::tip || saved_mode == LengthMode::tip;
  if ((parts & (state_tool | state_length)) != 0 && tip &&
      (now.tool.length.mode != saved_mode ||
       now.tool.length.offset_mm != saved.tool.length.offset_mm)) {
    const bool by_plane = now.frames.plane.is_aligned || saved.frames.plane.is_aligned;
    return by_plane ? "the tool length differs while the tool is aligned with a tilted plane"
                    : "TCP (RTCP) differs";
  }
  return {};
}

void restore_state(ActiveBlock& block, const ModalState& saved, StateParts parts) {
  ModalState& modal = block.modal;
  if ((parts & state_modal) != 0) restore_modal(block, saved);
  if ((parts & state_motion) != 0) {
    block.set_modal(Group::motion, saved.code(Group::motion));
    modal.cycles.drilling = saved.cycles.drilling;
  }
  if ((parts & state_feed) != 0) restore_feed_law(block, saved);
  if (modal.feed.law.feed_mode != modal.feed_mode()) end_feed_law(block);
  if ((parts & state_spindle) != 0) restore_spindle(block, saved);
  if ((parts & (state_tool | state_length)) != 0) {
    restore_length(block, saved.tool.length);
    block.set_modal(Group::length, saved.code(Group::length));
  }
  if ((parts & state_tool) != 0) restore_overhang(block, saved);
  if ((parts & state_frames) != 0) restore_shifts(block, saved);
  if ((parts & state_coolant) != 0) restore_coolant(block, saved);
}

}  // namespace stanok::lang
