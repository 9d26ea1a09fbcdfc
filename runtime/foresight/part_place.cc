#include "runtime/foresight/part_place.h"

#include "kinematics/scheme_interface.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::runtime {
namespace {

simulation::Axes axes_of(const channels::ChannelOutput& output) {
  simulation::Axes axes_M{};
  for (std::size_t k = 0; k < axes_M.size(); ++k) axes_M[k] = output.axes[k].position;
  return axes_M;
}

}  // namespace

PartPlace::PartPlace(const channels::MachineConfig& machine, const channels::ChannelConfig& channel)
    : PartPlace(geometry_of(machine, channel)) {}

PartPlace::PartPlace(const simulation::ChannelGeometry& geometry)
    : machine_(geometry), turning_axis_(geometry.turning_axis) {}

simulation::Pose PartPlace::work_in_base(const channels::ChannelOutput& output) const {
  const simulation::Pose frame = pose_of(output.work_frame);
  if (output.point_mode == kinematics::PointMode::tip) return frame;
  return machine_.linear_axes_in(output.scheme, axes_of(output)) * frame;
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
  if (!machine_.has_scheme(part.scheme) || !machine_.has_scheme(output.scheme)) return std::nullopt;
  const simulation::Axes axes_M = axes_of(output);
  const simulation::ToolRecord tool = record_of(output.tool_row);
  simulation::ToolPlace place = machine_.place_in(part.scheme, output.scheme, axes_M, tool.mount);
  // A spindle that is an axis turns the part beneath a tool that is no turning tool.
  const bool is_turned = turning_axis_.exists() && !output.drives[turning_axis_].follows_velocity &&
                         tool.shape.kind != simulation::ToolKind::insert;
  if (is_turned) place = machine_.turned_with_workpiece(part.scheme, axes_M, place);
  const simulation::Pose to_part = part.in_base.inverse();
  return simulation::ToolPlace{to_part * place.tip, to_part.linear() * place.axis};
}

std::optional<simulation::Pose> PartPlace::work_in(const PartSystem& part,
                                                   const channels::ChannelOutput& output) const {
  if (part.scheme != output.scheme || !machine_.has_scheme(output.scheme)) return std::nullopt;
  return part.in_base.inverse() * work_in_base(output);
}

std::optional<simulation::Pose> PartPlace::machine_in(const PartSystem& part,
                                                      const channels::ChannelOutput& output) const {
  if (!machine_.has_scheme(part.scheme)) return std::nullopt;
  return part.in_base.inverse() * machine_.machine_in(part.scheme, axes_of(output));
}

}  // namespace stanok::runtime
