// The plan of a switch of kinematics: which axes move where, are parked and join, in order. Pure
// functions.
//
// Order (docs/integrator/kinematics.md, "Switching"): axes that must still move are released;
// retract moves; parking moves, each followed by its brake and power-off; then release of the axes
// that join. The transformation is exchanged after the plan.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/command.h"
#include "motion/segments/path_builder.h"

namespace stanok::channels {

enum class SwitchStepKind { move, park, join };

struct SwitchStep {
  SwitchStepKind kind = SwitchStepKind::move;
  int axis = 0;            // move
  double position = 0.0;   // move: mm or deg in M
  double velocity = 0.0;   // move: mm/s or deg/s; 0 = rapid
  lang::AxisSet axes = 0;  // park, join
};

using SwitchPlan = std::vector<SwitchStep>;

// `enabled`: axes whose drives are on now, standing at `axes_M`.
[[nodiscard]] SwitchPlan plan_switch(const ChannelConfig& channel, const kinematics::Scheme& next,
                                     const motion::Point& axes_M, lang::AxisSet enabled);

// Where the axes that stood at `axes_M` stand behind the plan.
[[nodiscard]] motion::Point axes_behind_switch(const kinematics::Scheme& next,
                                               motion::Point axes_M);

// The transform of retract and parking moves: the path is in machine axes.
[[nodiscard]] const kinematics::Transform& machine_axes_transform();

// The word by which programs call the axis.
[[nodiscard]] std::string axis_word(const ChannelConfig& channel, int axis);

// The program error of a pose that an axis cannot reach; its place is yet to be filled in.
[[nodiscard]] Diagnostic unreachable_pose(const motion::Unreachable& pose,
                                          const ChannelConfig& channel);

}  // namespace stanok::channels
