#include "runtime/drive_side/process_plant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/place.h"
#include "channels/contract/motion_config.h"

namespace stanok::runtime {
namespace {

const channels::ChannelConfig& channel_of(const config::MachineFile& file) {
  const auto& channels = file.machine.channels;
  const int id = file.simulation.cutting.channel;
  const auto found = std::ranges::find(channels, id, &channels::ChannelConfig::id);
  if (found == channels.end() || found->spindles.empty()) {
    throw std::invalid_argument(file.machine.file + ": channel " + std::to_string(id) +
                                " of the cut has no spindle");
  }
  return *found;
}

const channels::SpindleConfig& spindle_of(const config::MachineFile& file) {
  return *std::ranges::find(file.machine.spindles, channel_of(file).spindles.front(),
                            &channels::SpindleConfig::id);
}

plant::SpindlePlantConfig motor_of(const channels::SpindleConfig& spindle) {
  plant::SpindlePlantConfig motor{.acceleration = 0.0};
  if (spindle.speed_max > 0.0) motor.speed_max = spindle.speed_max;
  if (spindle.power_idle_w > 0.0) motor.power_idle_w = spindle.power_idle_w;
  return motor;
}

}  // namespace

ProcessPlant::ProcessPlant(const config::MachineFile& file)
    : cycle_s_(file.machine.cycle_us * 1e-6),
      power_lag_s_(file.simulation.cutting.power_lag_s),
      sample_cycles_(std::max<std::int64_t>(
          1, file.simulation.cutting.sample_ms * 1000 / file.machine.cycle_us)),
      cut_(file.simulation.cutting),
      motor_(motor_of(spindle_of(file))),
      meter_(plant::CuttingProcess::vibration_samples / cycle_s_),
      sensors_(file.machine.spindles.size()) {
  const channels::ChannelConfig& channel = channel_of(file);
  channel_ = checked_size(&channel - file.machine.channels.data());
  spindle_ = checked_size(&spindle_of(file) - file.machine.spindles.data());
  const std::array<int, 3> geometry = channels::geometry_axes(channel);
  x_ = std::max(geometry[0], 0);
  z_ = std::max(geometry[2], 0);
}

void ProcessPlant::advance(const channels::CycleOutput& output) RT_SAFE {
  const channels::ChannelOutput& channel = output.channels[channel_];
  const double speed = channel.process.spindle_rev_per_min;
  cut_.advance({.x_mm = channel.point_W[x_].value, .z_mm = channel.point_W[z_].value}, speed,
               cycle_s_);
  motor_.follow({.velocity = speed}, cycle_s_);
  meter_.add(cut_.vibration_um(), speed);
  static_cast<void>(meter_.work());
  // The sensor's lag, as an exact step of its first order.
  const double part = power_lag_s_ > 0.0 ? 1.0 - std::exp(-cycle_s_ / power_lag_s_) : 1.0;
  power_w_ += part * (cut_.power_w() - power_w_);
  load_ = {.power_w = power_w_,
           .vibration_um = meter_.level().amplitude_um,
           .vibration_hz = meter_.level().frequency_hz};
  if (output.cycle % sample_cycles_ != 0) return;
  sensors_[spindle_] = {.power_w = motor_.power_w() + load_.power_w,
                        .vibration_um = load_.vibration_um,
                        .vibration_hz = load_.vibration_hz};
}

}  // namespace stanok::runtime
