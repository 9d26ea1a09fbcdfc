// Blocks to samples by their count.
#include "drives/vibration.h"

#include <algorithm>
#include <bit>

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

}  // namespace stanok::drives
