#include "jobs/foresight/part_place.h"

#include "kinematics/scheme_interface.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::jobs {
namespace {

simulation::Axes axes_at(const channels::ChannelOutput& output) {
  simulation::Axes axes_M{};
  for (std::size_t k = 0; k < axes_M.size(); ++k) axes_M[k] = output.axes[k].position;
  return axes_M;
}

simulation::ToolPlace in_part(const PartSystem& part, const simulation::ToolPlace& place_B) {
  const simulation::Pose to_part = part.in_base.inverse();
  return {to_part * place_B.tip, to_part.linear() * place_B.axis};
}

}  // namespace

PartPlace::PartPlace(const channels::MachineConfig& machine, const channels::ChannelConfig& channel)
    : PartPlace(runtime::geometry_of(machine, channel)) {}

PartPlace::PartPlace(const simulation::ChannelGeometry& geometry)
    : machine_(geometry), turning_axis_(geometry.turning_axis) {}

simulation::Pose PartPlace::work_in_base(const channels::ChannelOutput& output) const {
  simulation::Pose frame = runtime::pose_of(output.work_frame);
  if (output.point_mode == kinematics::PointMode::tip) return frame;
  return machine_.linear_axes_in(output.scheme, axes_at(output)) * frame;
}

std::optional<PartSystem> PartPlace::system_of(const channels::ChannelOutput& output) const {
  if (!machine_.has_scheme(output.scheme)) return std::nullopt;
  return PartSystem{output.scheme, work_in_base(output)};
}

void PartChoice::see(const PartPlace& place, const channels::ChannelOutput& output) {
  if (output.work_frame.rotation.is_identity()) upright_ = place.system_of(output);
}

std::optional<PartSystem> PartChoice::at_begin(const PartPlace& place,
                                               const channels::ChannelOutput& output) {
  see(place, output);
  return upright_ ? upright_ : place.system_of(output);
}

std::optional<simulation::ToolPlace> PartPlace::tool_in(
    const PartSystem& part, const channels::ChannelOutput& output) const {
  const simulation::Axes axes_M = axes_at(output);
  const simulation::ToolRecord tool = runtime::record_of(output.tool_row);
  // A spindle that is an axis turns the part beneath a tool that is no turning tool.
  const bool is_turned = turning_axis_.exists() && !output.drives[turning_axis_].follows_velocity &&
                         tool.shape.kind != simulation::ToolKind::insert;
  if (!is_turned) return tool_over_bed_in(part, output.scheme, axes_M, tool.mount);
  if (!has_both(part, output.scheme)) return std::nullopt;
  const auto place = machine_.place_in(part.scheme, output.scheme, axes_M, tool.mount);
  return in_part(part, machine_.turned_with_workpiece(part.scheme, axes_M, place));
}

std::optional<simulation::ToolPlace> PartPlace::tool_over_bed_in(
    const PartSystem& part, int scheme, const simulation::Axes& axes_M,
    const simulation::ToolMount& mount) const {
  if (!has_both(part, scheme)) return std::nullopt;
  return in_part(part, machine_.place_in(part.scheme, scheme, axes_M, mount));
}

std::optional<simulation::Pose> PartPlace::work_in(const PartSystem& part,
                                                   const channels::ChannelOutput& output) const {
  if (part.scheme != output.scheme || !machine_.has_scheme(output.scheme)) return std::nullopt;
  return part.in_base.inverse() * work_in_base(output);
}

std::optional<simulation::Pose> PartPlace::machine_in(const PartSystem& part,
                                                      const channels::ChannelOutput& output) const {
  if (!machine_.has_scheme(part.scheme)) return std::nullopt;
  return part.in_base.inverse() * machine_.machine_in(part.scheme, axes_at(output));
}

}  // namespace stanok::jobs
