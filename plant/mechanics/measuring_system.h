// What a feed axis has to find its reference: encoder with index pulses, home switch, limit
// switches. Positions are those of the machine, mm or deg.
//
// The encoder counts from the place where the machine is when its power comes on, or, an absolute
// one, from machine zero; it sits on the motor. The switches sit on the load, which follows the
// motor with the play of the backlash. An index pulse is latched at its exact place, as the counter
// of a drive does in hardware.
#pragma once

#include <cstdint>
#include <limits>

#include "base/rt_safe.h"
#include "plant/mechanics/plant_config.h"

namespace stanok::plant {

class MeasuringSystem {
 public:
  MeasuringSystem(const ReferenceConfig& config, double start);

  // The motor has moved to `position`.
  void take(double position) RT_SAFE;
  // The measuring system counts on from elsewhere: the motor is at `position`, no pulse is passed.
  void place(double position) RT_SAFE;
  // Power has come back: an incremental encoder counts from here.
  void restart() RT_SAFE;

  // Counted position = position of the machine - zero.
  [[nodiscard]] double zero() const RT_SAFE { return zero_; }

  [[nodiscard]] bool is_absolute() const RT_SAFE { return config_.absolute_encoder; }
  [[nodiscard]] bool on_home_switch() const RT_SAFE;
  [[nodiscard]] bool on_limit_negative() const RT_SAFE;
  [[nodiscard]] bool on_limit_positive() const RT_SAFE;

  // The position as counted; 0 before the first pulse.
  [[nodiscard]] double index_position() const RT_SAFE { return index_position_; }
  [[nodiscard]] std::uint16_t index_count() const RT_SAFE { return index_count_; }

 private:
  void latch_index(double from, double to) RT_SAFE;

  ReferenceConfig config_;
  double zero_;
  double motor_;
  double load_;
  double index_position_ = 0.0;
  std::uint16_t index_count_ = 0;
};

}  // namespace stanok::plant
