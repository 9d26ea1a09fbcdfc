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

// Where the path is held with another length.
motion::Point held_with(AxisMotion& motion, const kinematics::LengthChange& change) RT_SAFE {
  const motion::Point held = motion.aside().is_on() ? motion.aside().path() : motion.axes_M();
  kinematics::LengthChanges lengths = motion.lengths();
  motion::Point point_W{};
  kinematics::forward(kinematics::with_changes(motion.frame(), lengths), held, point_W);
  lengths.note(change);
  motion::Point now{};
  kinematics::inverse(kinematics::with_changes(motion.frame(), lengths), point_W, now);
  return now;
}

std::optional<Verdict> leaves_travel(Channel& channel, const kinematics::LengthChange& change)
    RT_SAFE {
  const motion::Point held = held_with(channel.motion, change);
  for (int axis = 0; axis < channel.axes.count(); ++axis) {
    const motion::AxisLimits& limits = channel.motion.config().axes[axis];
    if (channel.axes.is_spindle(axis)) continue;
    if (held[axis] >= limits.position_min && held[axis] <= limits.position_max) continue;
    Verdict verdict = refusal("E6053", "with this length axis ");
    verdict.text.append(channel.axes.name(axis).view())
        .append(" would leave its travel where the path is held");
    return verdict;
  }
  return std::nullopt;
}

std::optional<Verdict> obstacle_to_length(Channel& channel, const kinematics::LengthChange& change)
    RT_SAFE {
  AxisMotion& motion = channel.motion;
  if (!motion.path_is_at_rest()) return refusal("E6070", "the program has not come to rest yet");
  if (motion.is_in_thread() || !channel.items().lets_axes_leave())
    return refusal("E6099", "the held program is in a thread, measures, or changes kinematics");
  if (motion.moves_by_hand()) return refusal("E6056", "axes of the channel are being jogged");
  if (motion.retracing().is_on())
    return refusal("E6097", "the axes are on the way back along the path: return first");
  if (leads_point_of(channel, change.tool, change.edge))
    return refusal("E6101",
                   "the held program leads the point of this tool by rotary axes: its length "
                   "cannot change in the hold");
  if (motion.aside().is_full()) return refusal("E6100", "the way back has too many parts");
  if (motion.lengths().is_full() || channel.link.lengths.space() == 0)
    return refusal("E6101", "too many lengths were changed in this run");
  return leaves_travel(channel, change);
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

kinematics::LengthChange LengthDesk::next(int tool, int edge, int axis, double by_mm) const
    RT_SAFE {
  kinematics::LengthChange change{
      .tool = tool, .edge = edge, .version = stores_.tables->version() + 1};
  change.by_mm[static_cast<std::size_t>(axis)] = by_mm;
  return change;
}

std::optional<Verdict> LengthDesk::refusal_in_hold(const kinematics::LengthChange& change) const
    RT_SAFE {
  for (Channel* const channel : channels_.all()) {
    if (!channel->state().is_held()) continue;
    if (auto refused = obstacle_to_length(*channel, change)) return refused;
  }
  return std::nullopt;
}

void LengthDesk::apply(const kinematics::LengthChange& change) const RT_SAFE {
  if (change.by_mm == std::array<double, 3>{}) return;
  for (Channel* const channel : channels_.all()) {
    if (!channel->state().is_held()) continue;
    static_cast<void>(channel->link.lengths.push(change));
    channel->motion.change_length(change);
    if (channel->motion.is_off_path()) channel->run.apply(Change::path_left);
  }
}

}  // namespace stanok::channels
