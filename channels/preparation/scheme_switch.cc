#include "channels/preparation/scheme_switch.h"

#include <array>
#include <cstdio>

#include "base/place.h"

namespace stanok::channels {
namespace {

lang::AxisSet bit(int axis) {
  return static_cast<lang::AxisSet>(1U << axis);
}

lang::AxisSet with(lang::AxisSet set, int axis) {
  return static_cast<lang::AxisSet>(set | bit(axis));
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data();
}

}  // namespace

SwitchPlan plan_switch(const ChannelConfig& channel, const kinematics::Scheme& next,
                       const motion::Point& axes_M, lang::AxisSet enabled) {
  const kinematics::SchemeConfig& config = next.config();
  const auto stands_at = [&](int axis, double position) { return axes_M[axis] == position; };
  lang::AxisSet must_move = 0;
  for (const auto& [axis, position] : config.retract) {
    if (!stands_at(axis, position)) must_move = with(must_move, axis);
  }
  for (const auto& parking : config.parking) {
    if (!stands_at(parking.axis, parking.position)) must_move = with(must_move, parking.axis);
  }

  SwitchPlan plan;
  const auto released = static_cast<lang::AxisSet>(must_move & ~enabled);
  if (released != 0) plan.push_back({SwitchStepKind::join, 0, 0.0, 0.0, released});
  for (const auto& [axis, position] : config.retract) {
    if (!stands_at(axis, position)) plan.push_back({SwitchStepKind::move, axis, position, 0.0, 0});
  }
  for (const auto& parking : config.parking) {
    if (!stands_at(parking.axis, parking.position)) {
      plan.push_back({SwitchStepKind::move, parking.axis, parking.position, parking.velocity, 0});
    }
    plan.push_back({SwitchStepKind::park, 0, 0.0, 0.0, bit(parking.axis)});
  }
  lang::AxisSet joining = 0;
  for (std::size_t k = 0; k < channel.axes.size(); ++k) {
    if (next.takes_part(static_cast<int>(k))) joining = with(joining, static_cast<int>(k));
  }
  joining = static_cast<lang::AxisSet>(joining & ~(enabled | released));
  if (joining != 0) plan.push_back({SwitchStepKind::join, 0, 0.0, 0.0, joining});
  return plan;
}

motion::Point axes_behind_switch(const kinematics::Scheme& next, motion::Point axes_M) {
  for (const auto& parking : next.config().parking) axes_M[parking.axis] = parking.position;
  for (const auto& [axis, position] : next.config().retract) axes_M[axis] = position;
  return axes_M;
}

const kinematics::Transform& machine_axes_transform() {
  static const kinematics::Transform identity{};
  return identity;
}

std::string axis_word(const ChannelConfig& channel, int axis) {
  return channel.words[checked_size(axis)];
}

Diagnostic unreachable_pose(const motion::Unreachable& pose, const ChannelConfig& channel) {
  const std::string axis = axis_word(channel, pose.axis);
  Diagnostic diagnostic;
  diagnostic.code = "E5101";
  diagnostic.message = "axis " + axis + " would go to machine position " + number(pose.position) +
                       ", but its limit is " + number(pose.limit);
  diagnostic.help = {
      "check the work offset, the tool length and the kinematic scheme, or move the workpiece"};
  return diagnostic;
}

}  // namespace stanok::channels
