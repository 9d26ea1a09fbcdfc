// Counting, latching and switching.
#include "plant/mechanics/measuring_system.h"

#include <algorithm>
#include <cmath>

namespace stanok::plant {

MeasuringSystem::MeasuringSystem(const ReferenceConfig& config, double start)
    : config_(config), zero_(config.absolute_encoder ? 0.0 : start), motor_(start), load_(start) {}

void MeasuringSystem::take(double position) RT_SAFE {
  latch_index(motor_, position);
  motor_ = position;
  const double play = 0.5 * config_.backlash;
  load_ = std::clamp(load_, position - play, position + play);
}

void MeasuringSystem::place(double position) RT_SAFE {
  load_ += position - motor_;
  motor_ = position;
}

void MeasuringSystem::restart() RT_SAFE {
  if (!config_.absolute_encoder) zero_ = motor_;
  index_position_ = 0.0;
  index_count_ = 0;
}

// The last pulse on the way is kept; pulses stand at index_position + k index_pitch. Upwards a way
// contains its end, downwards its beginning.
void MeasuringSystem::latch_index(double from, double to) RT_SAFE {
  if (config_.index_pitch <= 0.0) return;
  const double pitch = config_.index_pitch;
  const double before = std::floor((from - config_.index_position) / pitch);
  const double after = std::floor((to - config_.index_position) / pitch);
  if (before == after) return;
  const double pulses = std::fabs(after - before);
  const double place = after > before ? after : after + 1.0;
  index_position_ = config_.index_position + place * pitch - zero_;
  index_count_ = static_cast<std::uint16_t>(index_count_ + std::fmod(pulses, 65536.0));
}

bool MeasuringSystem::on_home_switch() const RT_SAFE {
  return load_ >= config_.home_switch_from && load_ <= config_.home_switch_to;
}

bool MeasuringSystem::on_limit_negative() const RT_SAFE {
  return load_ <= config_.limit_negative;
}

bool MeasuringSystem::on_limit_positive() const RT_SAFE {
  return load_ >= config_.limit_positive;
}

}  // namespace stanok::plant
