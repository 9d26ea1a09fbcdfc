// Blocks to samples by their count, and the statistics of a stretch.
#include "drives/vibration.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace stanok::drives {

VibrationReader::VibrationReader(const VibrationSensorConfig& config) : config_(config) {
  fresh_.reserve(static_cast<std::size_t>(config.count));
}

// Of the first block all samples are new.
std::span<const double> VibrationReader::take(std::span<const std::uint16_t> block) {
  fresh_.clear();
  const std::uint16_t taken = block.front();
  const std::span<const std::uint16_t> values = block.subspan(1);
  const auto passed = static_cast<std::uint16_t>(taken - seen_);
  const std::size_t wanted = has_seen_ ? passed : std::min<std::size_t>(taken, values.size());
  const std::size_t count = std::min(wanted, values.size());
  lost_ += wanted - count;
  samples_ += count;
  for (const std::uint16_t value : values.last(count))
    fresh_.push_back(std::bit_cast<std::int16_t>(value) / config_.scale);
  seen_ = taken;
  has_seen_ = true;
  return fresh_;
}

VibrationMeter::VibrationMeter(double rate_hz, double stretch_s)
    : rate_hz_(rate_hz),
      length_(static_cast<std::size_t>(std::max(2.0, std::round(rate_hz * stretch_s)))) {
  stretch_.reserve(length_);
}

void VibrationMeter::add(std::span<const double> samples_um) {
  for (const double sample : samples_um) {
    stretch_.push_back(sample);
    if (stretch_.size() == length_) measure();
  }
}

void VibrationMeter::measure() {
  const auto count = static_cast<double>(stretch_.size());
  const double mean = std::accumulate(stretch_.begin(), stretch_.end(), 0.0) / count;
  double power = 0.0;
  int changes = 0;
  for (std::size_t k = 0; k < stretch_.size(); ++k) {
    const double value = stretch_[k] - mean;
    power += value * value;
    if (k > 0 && (value < 0.0) != (stretch_[k - 1] - mean < 0.0)) ++changes;
  }
  level_.amplitude_um = std::sqrt(2.0 * power / count);
  level_.frequency_hz = 0.5 * changes * rate_hz_ / (count - 1.0);
  stretch_.clear();
}

}  // namespace stanok::drives
