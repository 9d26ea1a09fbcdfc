// PartPlace: where the tool of a channel is on the part, for pictures.
//
// In the workpiece system W the same place has other numbers after G55, G68.2 or a turn of the
// table. A picture of the whole part wants one system that stays on it: the *part system* P, which
// is W as it lies when a path begins, before planes and turns of the coordinates, carried on by the
// base of the scheme that is active then (docs/integrator/kinematics.md). Tools count with the
// length of the tool table.
#pragma once

#include <optional>

#include "base/axis_index.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "simulation/machine_geometry.h"

namespace stanok::jobs {

struct PartSystem {
  int scheme = 0;                                           // whose base carries it
  simulation::Pose in_base = simulation::Pose::Identity();  // P -> B of that scheme, mm
};

class PartPlace {
 public:
  PartPlace(const channels::MachineConfig& machine, const channels::ChannelConfig& channel);

  // W as it lies now becomes P; nothing: no scheme is active.
  [[nodiscard]] std::optional<PartSystem> system_of(const channels::ChannelOutput& output) const;
  // Tip in P and direction from it into the spindle; nothing: one of the schemes is not known.
  [[nodiscard]] std::optional<simulation::ToolPlace> tool_in(
      const PartSystem& part, const channels::ChannelOutput& output) const;
  // The same over a bed that does not turn, of axes that stand so under a scheme.
  [[nodiscard]] std::optional<simulation::ToolPlace> tool_over_bed_in(
      const PartSystem& part, int scheme, const simulation::Axes& axes_M,
      const simulation::ToolMount& mount) const;
  // W -> P, now; nothing: another scheme is active than the one that carries P.
  [[nodiscard]] std::optional<simulation::Pose> work_in(
      const PartSystem& part, const channels::ChannelOutput& output) const;
  // M -> P, now, M being the machine in which X, Y and Z read where the tip of an upright head
  // without a tool is; nothing: the scheme that carries P is not known.
  [[nodiscard]] std::optional<simulation::Pose> machine_in(
      const PartSystem& part, const channels::ChannelOutput& output) const;

 private:
  explicit PartPlace(const simulation::ChannelGeometry& geometry);
  [[nodiscard]] simulation::Pose work_in_base(const channels::ChannelOutput& output) const;
  [[nodiscard]] bool has_both(const PartSystem& part, int scheme) const {
    return machine_.has_scheme(part.scheme) && machine_.has_scheme(scheme);
  }

  simulation::MachineGeometry machine_;
  AxisIndex turning_axis_;  // of a lathe: the spindle as an axis
};

// Which P a path has: the newest W of its run without a turn (G68, G68.2), up to where it first
// moves; where there is none, W there.
class PartChoice {
 public:
  // Each cycle of the run before it moves.
  void see(const PartPlace& place, const channels::ChannelOutput& output);
  // Where it first moves.
  [[nodiscard]] std::optional<PartSystem> at_begin(const PartPlace& place,
                                                   const channels::ChannelOutput& output);

 private:
  std::optional<PartSystem> upright_;
};

}  // namespace stanok::jobs
