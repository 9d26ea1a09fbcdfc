// Blocks to samples by their count, and the statistics of a stretch.
#include "drives/vibration.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/place.h"

namespace stanok::drives {

VibrationReader::VibrationReader(const VibrationSensorConfig& config) : config_(config) {
  fresh_.reserve(checked_size(config.count));
}

// All samples of the first block are new.
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
    : rate_hz_(rate_hz), stretch_(checked_size(std::max(2.0, std::round(rate_hz * stretch_s)))) {}

void VibrationMeter::add(std::span<const double> samples_um) RT_SAFE {
  for (const double sample : samples_um) {
    stretch_[count_++] = sample;
    if (count_ == stretch_.size()) measure();
  }
}

void VibrationMeter::measure() RT_SAFE {
  const auto count = static_cast<double>(stretch_.size());
  double sum = 0.0;
  for (const double sample : stretch_) sum += sample;
  const double mean = sum / count;
  double power = 0.0;
  for (const double sample : stretch_) power += (sample - mean) * (sample - mean);
  level_.amplitude_um = std::sqrt(2.0 * power / count);
  level_.frequency_hz = frequency(mean);
  count_ = 0;
}

double VibrationMeter::frequency(double mean) const RT_SAFE {
  int changes = 0;
  double first = 0.0;  // in samples
  double last = 0.0;
  for (std::size_t k = 1; k < stretch_.size(); ++k) {
    const double before = stretch_[k - 1] - mean;
    const double now = stretch_[k] - mean;
    if ((before < 0.0) == (now < 0.0)) continue;
    last = static_cast<double>(k) - now / (now - before);
    if (++changes == 1) first = last;
  }
  return changes < 2 ? 0.0 : 0.5 * (changes - 1) * rate_hz_ / (last - first);
}

}  // namespace stanok::drives
