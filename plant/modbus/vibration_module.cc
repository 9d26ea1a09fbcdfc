// Sampling of the vibration, and the registers that hold the newest samples.
#include "plant/modbus/vibration_module.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::plant {

VibrationModule::VibrationModule(const drives::VibrationSensorConfig& config)
    : config_(config),
      registers_(modbus_mapping_new(0, 0, config.first_register + 1 + config.count, 0)),
      samples_(checked_size(config.count)) {
  STANOK_ASSERT(registers_ != nullptr);
}

void VibrationModule::advance(const ProcessLoad& load, double dt_s) {
  constexpr double full_turn = 2.0 * std::numbers::pi;
  due_ += dt_s * config_.rate_hz;
  for (; due_ >= 1.0; due_ -= 1.0) {
    phase_ = std::fmod(phase_ + full_turn * load.vibration_hz / config_.rate_hz, full_turn);
    const double increments = config_.scale * load.vibration_um * std::sin(phase_);
    samples_[next_] =
        static_cast<std::int16_t>(std::clamp(std::round(increments), -32768.0, 32767.0));
    next_ = (next_ + 1) % samples_.size();
    ++taken_;
  }
}

modbus_mapping_t* VibrationModule::registers() {
  std::uint16_t* const block = registers_->tab_registers + config_.first_register;
  block[0] = taken_;
  for (std::size_t k = 0; k < samples_.size(); ++k)
    block[k + 1] = std::bit_cast<std::uint16_t>(samples_[(next_ + k) % samples_.size()]);
  return registers_.get();
}

}  // namespace stanok::plant
