#include "client/offline/grind/grind_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/place.h"
#include "config/files/machine_file.h"

namespace stanok::client {
namespace {

using channels::ChannelConfig;
using channels::MachineConfig;

constexpr const char* infeed_word = "X";

const ChannelConfig& grind_channel(const MachineConfig& machine, int id) {
  const auto suits = [id](const ChannelConfig& channel) {
    return id == 0 ? channel.kind == lang::ChannelKind::grind : channel.id == id;
  };
  const auto channel = std::ranges::find_if(machine.channels, suits);
  if (channel == machine.channels.end()) {
    throw std::runtime_error(machine.name +
                             " has no such channel; a grinding program needs one of "
                             "kind \"grind\"");
  }
  return *channel;
}

const channels::AxisConfig& infeed_axis(const MachineConfig& machine,
                                        const ChannelConfig& channel) {
  const auto word = std::ranges::find(channel.words, infeed_word);
  if (word == channel.words.end()) {
    throw std::runtime_error("channel " + std::to_string(channel.id) + " of " + machine.name +
                             " has no axis X for the infeed");
  }
  return machine.axes[channel.axes[checked_size(word - channel.words.begin())]];
}

void check_speed(const MachineConfig& machine, int id, const char* what, double speed_rpm) {
  const auto spindle = std::ranges::find(machine.spindles, id, &channels::SpindleConfig::id);
  if (spindle == machine.spindles.end()) return;
  if (speed_rpm >= spindle->speed_min && speed_rpm <= spindle->speed_max) return;
  throw std::runtime_error(
      fmt::format("the {} would turn at {:g} rev/min; spindle {} of {} turns at {:g} to {:g}", what,
                  speed_rpm, id, machine.name, spindle->speed_min, spindle->speed_max));
}

// Places between the increments of the axis would be switched at the next one.
void check_increments(const channels::AxisConfig& axis, const process::InfeedLaw& law) {
  constexpr double part_of_increment = 1e-3;
  for (const process::InfeedRow& row : law) {
    const double increments = row.x_mm / axis.resolution;
    if (std::abs(increments - std::round(increments)) <= part_of_increment) continue;
    fmt::print(stderr, "warning: X {} lies between two increments of axis {}, {:g} mm\n", row.x_mm,
               axis.name, axis.resolution);
    return;
  }
}

}  // namespace

process::ProgramOptions program_options(const process::GrindingProcess& process,
                                        const process::InfeedLaw& law,
                                        const GrindMachineOptions& options) {
  process::ProgramOptions program;
  if (options.machine_file.empty()) return program;
  const MachineConfig machine = config::read_machine_file(options.machine_file).machine;
  const ChannelConfig& channel = grind_channel(machine, options.channel);
  check_increments(infeed_axis(machine, channel), law);
  if (channel.spindles.empty()) {
    throw std::runtime_error("channel " + std::to_string(channel.id) + " of " + machine.name +
                             " has no spindle that turns the part");
  }
  program.part_spindle = channel.spindles.front();
  check_speed(machine, program.part_spindle, "part", process.part_speed_rpm);
  if (channel.spindles.size() > 1) {
    program.wheel_spindle = channel.spindles[1];
    program.wheel_speed_rpm = std::floor(options.wheel_speed_m_per_s * 60.0e3 /
                                         (2.0 * std::numbers::pi * process.wheel_radius_mm));
    check_speed(machine, program.wheel_spindle, "wheel", program.wheel_speed_rpm);
  }
  return program;
}

}  // namespace stanok::client
