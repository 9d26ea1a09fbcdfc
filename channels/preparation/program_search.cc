#include "channels/preparation/program_search.h"

#include <algorithm>
#include <cmath>

namespace stanok::channels {
namespace {

constexpr double nearly_there = 1e-9;  // mm, deg

lang::SpindleCommand speed_command(int spindle, double speed) {
  lang::SpindleCommand command;
  command.spindle = spindle;
  command.action = lang::SpindleAction::set_speed;
  command.speed_rev_per_min = speed;
  return command;
}

}  // namespace

std::vector<lang::Payload> commands_to_restore(const lang::SearchState& state) {
  std::vector<lang::Payload> commands{state.overrides};
  if (state.tool_prepared != 0) commands.emplace_back(lang::ToolPrepare{state.tool_prepared});
  if (state.tool_changed) commands.emplace_back(lang::ToolChange{state.tool, false});
  for (const auto& [spindle, speed] : state.speeds)
    commands.emplace_back(speed_command(spindle, speed));
  for (const auto& [spindle, mode] : state.cutting_speeds) commands.emplace_back(mode);
  for (const auto& [spindle, command] : state.spindles) commands.emplace_back(command);
  if (state.coolant.mist || state.coolant.flood) commands.emplace_back(state.coolant);
  for (const lang::ForceControl& order : state.force_commands) commands.emplace_back(order);
  return commands;
}

lang::AxisSet axes_apart(const motion::Point& a, const motion::Point& b) {
  lang::AxisSet apart = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::abs(a[k] - b[k]) > nearly_there) apart = static_cast<lang::AxisSet>(apart | 1U << k);
  }
  return apart;
}

Approach approach_to(const motion::Point& target, const motion::Point& start, const WayOut& out,
                     double height) {
  Approach approach;
  motion::Point at = start;
  const auto leg = [&](const motion::Point& end) -> std::optional<motion::Point> {
    if (axes_apart(at, end) == 0) return std::nullopt;
    at = end;
    return end;
  };
  if (out.infeed < 0) {
    approach.lateral = leg(target);
    return approach;
  }
  const double top = std::max({height, start[out.infeed], target[out.infeed]});
  const auto above = [&](motion::Point point, const motion::Point& way) {
    const double rise = top - point[out.infeed];
    for (std::size_t k = 0; k < point.size(); ++k) point[k] += rise * way[k];
    point[out.infeed] = top;
    return point;
  };
  approach.lift = leg(above(start, out.at_start));
  approach.lateral = leg(above(target, out.at_target));
  approach.plunge = leg(target);
  return approach;
}

}  // namespace stanok::channels
