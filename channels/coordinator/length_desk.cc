#include "channels/coordinator/length_desk.h"

namespace stanok::channels {
namespace {

// Where rotary axes move with the tool point, speeds were planned for the length that it had.
bool leads_point_of(const kinematics::Transform& transform, int tool, int edge) RT_SAFE {
  const bool is_of_row =
      transform.row.sign != 0 && transform.row.tool == tool && transform.row.edge == edge;
  return is_of_row && transform.scheme != nullptr && !transform.scheme->is_affine(transform.mode);
}

bool leads_point_of(const Channel& channel, int tool, int edge) RT_SAFE {
  if (leads_point_of(channel.motion.frame(), tool, edge)) return true;
  const auto& segments = channel.link.path.segments;
  const kinematics::Transform* seen = nullptr;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const kinematics::Transform* const transform = segments[k].transform;
    if (transform == seen || transform == nullptr) continue;
    if (leads_point_of(*transform, tool, edge)) return true;
    seen = transform;
  }
  return false;
}

std::optional<Verdict> obstacle_to_length(Channel& channel, int tool, int edge) RT_SAFE {
  const AxisMotion& motion = channel.motion;
  if (!motion.path_is_at_rest()) return refusal("E6070", "the program has not come to rest yet");
  if (motion.is_in_thread() || !channel.items().lets_axes_leave())
    return refusal("E6099", "the held program is in a thread, measures, or changes kinematics");
  if (motion.moves_by_hand()) return refusal("E6056", "axes of the channel are being jogged");
  if (motion.retracing().is_on())
    return refusal("E6097", "the axes are on the way back along the path: return first");
  if (leads_point_of(channel, tool, edge))
    return refusal(
        "E6101",
        "the held program leads the point of this tool by rotary axes: its length cannot "
        "change in the hold");
  if (motion.aside().is_full()) return refusal("E6100", "the way back has too many parts");
  if (channel.motion.lengths().is_full() || channel.link.lengths.space() == 0)
    return refusal("E6101", "too many lengths were changed in this run");
  return std::nullopt;
}

}  // namespace

int axis_of_length(ToolValue value) RT_SAFE {
  switch (value) {
    case ToolValue::length_x:
    case ToolValue::wear_length_x:
      return 0;
    case ToolValue::length_y:
      return 1;
    case ToolValue::length:
    case ToolValue::wear_length:
      return 2;
    default:
      return -1;
  }
}

std::optional<Verdict> LengthDesk::refusal_in_hold(int tool, int edge) const RT_SAFE {
  for (Channel* const channel : channels_.all()) {
    if (!channel->state().is_held()) continue;
    if (auto refused = obstacle_to_length(*channel, tool, edge)) return refused;
  }
  return std::nullopt;
}

void LengthDesk::change(int tool, int edge, int axis, double by_mm) const RT_SAFE {
  if (by_mm == 0.0) return;
  kinematics::LengthChange change{
      .tool = tool, .edge = edge, .version = stores_.tables->version() + 1};
  change.by_mm[static_cast<std::size_t>(axis)] = by_mm;
  for (Channel* const channel : channels_.all()) {
    if (!channel->state().is_held()) continue;
    static_cast<void>(channel->link.lengths.push(change));
    channel->motion.change_length(change);
    if (channel->motion.is_off_path()) channel->run.apply(Change::path_left);
  }
}

}  // namespace stanok::channels
