// MissingForce: how long a tool at working feed has had less force than its setpoint although the
// feed can give no more: it is in the air, or the feed is S_max.
//
// For as long as the air cut in front of a workpiece takes, that is as it must be. Beyond it the
// tool is broken, there is no workpiece, or the idle power is wrong. Rapid moves end an air cut;
// while the path stands the time stands. Part of the force control of a channel, in the cycle.
#pragma once

#include "base/rt_safe.h"

namespace stanok::process {

class MissingForce {
 public:
  struct Inputs {
    double cycle_s = 0.001;
    bool is_rapid = false;
    bool feeds = false;   // at working feed and full override
    bool is_low = false;  // in the air, or too low at S_max
  };
  // True in the cycle in which the time is over; once until the force has been there again.
  [[nodiscard]] bool look(const Inputs& inputs, double air_time_s) RT_SAFE {
    if (inputs.is_rapid || (inputs.feeds && !inputs.is_low)) low_s_ = 0.0;
    if (!inputs.feeds || !inputs.is_low) return false;
    const bool was_over = low_s_ > air_time_s;
    low_s_ += inputs.cycle_s;
    return !was_over && low_s_ > air_time_s;
  }
  void reset() RT_SAFE { low_s_ = 0.0; }

 private:
  double low_s_ = 0.0;
};

}  // namespace stanok::process
