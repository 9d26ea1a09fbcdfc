// PowerWatch: whether the power that the sensor of block 8 gives can be trusted.
//
// Lost: not a number. Stuck: the feed per revolution has changed by a tenth in the cut, long enough
// for the sensor to show it, and the value has not changed by a bit. A steady feed gives a steady
// power and proves nothing. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::process {

enum class PowerTrust { good, lost, stuck };

class PowerWatch {
 public:
  explicit PowerWatch(const ForceControlConfig& config) : config_(config) {}

  void reset() RT_SAFE { *this = PowerWatch(config_); }
  // `feed_per_rev`: that the path goes at, mm.
  struct Inputs {
    double cycle_s = 0.001;
    double power_w = 0.0;
    double feed_per_rev = 0.0;
    double revolution_s = 0.1;
    bool cuts = false;
  };
  [[nodiscard]] PowerTrust look(const Inputs& inputs) RT_SAFE;
  // The feed has changed, and the power not yet: no reason for more of it.
  [[nodiscard]] bool is_suspicious() const RT_SAFE { return suspicion_s_ > 0.0; }

 private:
  ForceControlConfig config_;
  double power_w_ = 0.0;
  double feed_ = 0.0;         // when the power changed last
  double suspicion_s_ = 0.0;  // since the feed has left that one behind
};

}  // namespace stanok::process
