// IdlePowerCompensator, block 9: keeps the power that the spindle draws without cutting.
//
// N_x is taken anew after each start of the spindle, and after each change of its speed that comes
// to rest: at speed, settled, with no feed, as a mean. Between captures it is scaled with the
// speed, N_x(n) = N_0 (k r + (1 - k) r^2) with r = n / n_0: Coulomb and viscous friction.
// Real-time.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::process {

class IdlePowerCompensator {
 public:
  explicit IdlePowerCompensator(const ForceControlConfig& config) : config_(config) {}

  void advance(const motion::CutState& cut) RT_SAFE;

  // N_x of the running spindle is known, for this start and the speed it was brought to.
  [[nodiscard]] bool is_captured() const RT_SAFE { return is_captured_; }
  // It is known at all since the latest start, if for another speed.
  [[nodiscard]] bool is_known() const RT_SAFE { return rev_per_min_ > 0.0; }
  // N_x at this speed, W.
  [[nodiscard]] double power_w(double rev_per_min) const RT_SAFE;
  [[nodiscard]] std::uint32_t captures() const RT_SAFE { return captures_; }

 private:
  void begin() RT_SAFE;

  ForceControlConfig config_;
  bool is_captured_ = false;
  double power_w_ = 0.0;      // N_0
  double rev_per_min_ = 0.0;  // n_0; 0: nothing is known
  std::uint32_t captures_ = 0;
  std::uint32_t starts_seen_ = 0;
  double speed_seen_ = 0.0;
  double settled_s_ = 0.0;  // at speed, and not cutting
  double sum_w_ = 0.0;
  std::int64_t count_ = 0;
};

}  // namespace stanok::process
