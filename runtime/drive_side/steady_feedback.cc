#include "runtime/drive_side/steady_feedback.h"

#include <algorithm>
#include <cmath>

namespace stanok::runtime {
namespace {

// Positions are multiples of the increment in binary: two neighbours differ by a little more.
constexpr double one_and_rounding = 1.0 + 1e-6;

bool is_at_rest(const channels::CycleOutput& output) RT_SAFE {
  return std::ranges::none_of(output.of_channels(),
                              [](const channels::ChannelOutput& channel)
                                  RT_SAFE { return channel.moving || channel.running; });
}

// The position that was given before, moved no more than so that it is within the noise; what moved
// by more than noise can is as it is told. An extreme that was given first does not flicker with
// the other one.
double steadied(double told, double before, double noise) RT_SAFE {
  const double way = told - before;
  if (std::abs(way) <= noise) return before;
  if (std::abs(way) > 2.0 * noise) return told;
  return told - std::copysign(noise, way);
}

}  // namespace

SteadyFeedback::SteadyFeedback(const channels::MachineConfig& machine, const drives::BusConfig& bus)
    : cycles_per_s_(1e6 / machine.cycle_us), given_(machine.axes.size()) {
  const auto drives = drives::drives_of(bus);
  for (std::size_t k = 0; k < machine.axes.size(); ++k) {
    increments_.push_back(k < drives.size() ? 1.0 / std::abs(drives[k].map.position.scale)
                                            : machine.axes[k].resolution);
  }
}

std::span<const channels::AxisFeedback> SteadyFeedback::of(
    std::span<const channels::AxisFeedback> told, const channels::CycleOutput& last) RT_SAFE {
  if (told.size() != given_.size()) return told;
  const bool rests = is_at_rest(last);
  const std::span<channels::AxisFeedback> given(given_);
  const std::span<const double> increments(increments_);
  for (std::size_t k = 0; k < told.size(); ++k) {
    const double noise = increments[k] * one_and_rounding;
    const double before = given[k].position;
    given[k] = told[k];
    if (!rests) continue;
    given[k].position = steadied(told[k].position, before, noise);
    if (std::abs(told[k].velocity) <= noise * cycles_per_s_) given[k].velocity = 0.0;
  }
  return given;
}

}  // namespace stanok::runtime
