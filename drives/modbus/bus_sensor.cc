#include "drives/modbus/bus_sensor.h"

#include <cmath>

#include "base/place.h"

namespace stanok::drives {
namespace {

// Samples that wait for the cycle: those of a second.
constexpr double kept_s = 1.0;

}  // namespace

BusSensor::BusSensor(const VibrationSensorConfig& config, BusTime timeout,
                     std::optional<std::size_t> drive)
    : block_{.unit = config.unit,
             .table = SignalTable::holding_register,
             .first = config.first_register,
             .bits = {},
             .words = std::vector<std::uint16_t>(checked_size(config.count) + 1)},
      reader_(config),
      meter_(config.rate_hz),
      samples_(checked_size(std::ceil(kept_s * config.rate_hz)) + 1),
      timeout_(timeout),
      drive_(drive),
      patience_(timeout) {
  level_.write(no_vibration_level);
}

void BusSensor::take(double rev_per_min) {
  const std::span<const double> fresh = reader_.take(block_.words);
  meter_.add(fresh, rev_per_min);
  while (meter_.work()) {
  }
  level_.write(meter_.level());
  for (const double sample : fresh) static_cast<void>(samples_.push(sample));
}

void BusSensor::fail(BusTime now) {
  ++errors_;
  level_.write(no_vibration_level);
  again_at_ = now + timeout_;
}

void BusSensor::tell(VibrationStatus& status) const {
  status.level = meter_.level();
  status.samples = reader_.samples();
  status.lost = reader_.lost();
  status.errors = errors_;
}

std::size_t BusSensor::take_samples(std::span<double> samples_um) RT_SAFE {
  std::size_t count = 0;
  while (count < samples_um.size() && samples_.pop(samples_um[count])) ++count;
  return count;
}

}  // namespace stanok::drives
