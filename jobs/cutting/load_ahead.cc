#include "jobs/cutting/load_ahead.h"

#include <algorithm>
#include <cmath>

#include "simulation/engagement.h"

namespace stanok::jobs {
namespace {

constexpr double look_ahead_part = 0.5;  // of the resolution: how far in front of the tool

std::vector<process::EngagedSlice> slices_of(
    const std::vector<simulation::EngagementSlice>& engagement) {
  std::vector<process::EngagedSlice> slices;
  slices.reserve(engagement.size());
  for (const simulation::EngagementSlice& slice : engagement) {
    slices.push_back({.height_mm = slice.height,
                      .width_mm = slice.width,
                      .radius_mm = slice.radius,
                      .slope = slice.slope,
                      .meets = slice.meets});
  }
  return slices;
}

}  // namespace

process::MillingLoad load_ahead(simulation::WorkpieceFollower& follower,
                                const simulation::WorkpieceFollower::ToolAtWork& tool,
                                const simulation::Vector& direction_K, double rev_per_min,
                                const process::CuttingProcess& cut) {
  follower.flush();
  const simulation::Workpiece& workpiece = *follower.at_work();
  const simulation::ToolPlace ahead{
      tool.place_K.tip + look_ahead_part * workpiece.blank().resolution * direction_K,
      tool.place_K.axis};
  const auto sense = rev_per_min < 0.0 ? simulation::SpindleSense::counter_clockwise
                                       : simulation::SpindleSense::clockwise;
  const auto engagement =
      simulation::engagement_of(workpiece.material(), tool.tool->solid, ahead, direction_K, sense);
  const double along = direction_K.dot(tool.place_K.axis);
  const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
  return {cut, slices_of(engagement), {.across = across, .along = along}};
}

}  // namespace stanok::jobs
