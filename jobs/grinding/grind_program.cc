#include "jobs/grinding/grind_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/place.h"
#include "config/files/machine_file.h"

namespace stanok::jobs {
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

// Places between the increments of the axis would be switched at the next one; empty: there is
// none.
std::string increment_warning(const channels::AxisConfig& axis, const process::InfeedLaw& law) {
  constexpr double part_of_increment = 1e-3;
  for (const process::InfeedRow& row : law) {
    const double increments = row.x_mm / axis.resolution;
    if (std::abs(increments - std::round(increments)) <= part_of_increment) continue;
    return fmt::format("X {} lies between two increments of axis {}, {:g} mm", row.x_mm, axis.name,
                       axis.resolution);
  }
  return "";
}

// What the machine adds to a program: spindle numbers and the speed of the wheel.
void add_spindles(process::ProgramOptions& program, const GrindProgramRequest& request,
                  const MachineConfig& machine, const ChannelConfig& channel) {
  if (channel.spindles.empty()) {
    throw std::runtime_error("channel " + std::to_string(channel.id) + " of " + machine.name +
                             " has no spindle that turns the part");
  }
  const process::GrindingProcess& process = request.process;
  program.part_spindle = channel.spindles.front();
  check_speed(machine, program.part_spindle, "part", process.part_speed_rpm);
  if (channel.spindles.size() > 1) {
    program.wheel_spindle = channel.spindles[1];
    program.wheel_speed_rpm = std::floor(request.machine.wheel_speed_m_per_s * 60.0e3 /
                                         (2.0 * std::numbers::pi * process.wheel_radius_mm));
    check_speed(machine, program.wheel_spindle, "wheel", program.wheel_speed_rpm);
  }
}

}  // namespace

GrindProgram grind_program(const GrindProgramRequest& request) {
  GrindProgram made;
  process::ProgramOptions program;
  if (!request.machine.machine_file.empty()) {
    const MachineConfig machine = config::read_machine_file(request.machine.machine_file).machine;
    const ChannelConfig& channel = grind_channel(machine, request.machine.channel);
    const std::string warning = increment_warning(infeed_axis(machine, channel), request.law);
    if (!warning.empty()) made.warnings.push_back(warning);
    add_spindles(program, request, machine, channel);
  }
  program.title = request.title;
  program.spark_out_s = request.spark_out_revolutions * process::revolution_s(request.process);
  program.gauge_margin_mm = request.gauge_margin_mm;
  made.text = process::part_program(request.process, request.law, program);
  return made;
}

}  // namespace stanok::jobs
