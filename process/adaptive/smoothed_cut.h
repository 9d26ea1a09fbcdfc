// SmoothedCut: the power of a cut and what the feed demands of it, smoothed alike and brought to
// the same time.
//
// The demand w R h^y is delayed by a whole revolution for the chip and by more than the lag of the
// sensor: it is rather late than early against the power, so that a living sensor has always
// answered. Part of the power watch of a channel, in the cycle; allocates nothing.
#pragma once

#include <cmath>

#include "base/rt_safe.h"

namespace stanok::process {

class SmoothedCut {
 public:
  static constexpr double smoothing_s = 0.15;

  struct Lags {
    double cycle_s = 0.001;
    double chip_s = 0.0;
    double sensor_s = 0.0;
  };

  // The cut begins with these.
  void begin(double demand, double power_w) RT_SAFE {
    chip_ = lagging_ = demand_ = demand;
    power_w_ = power_w;
  }
  void follow(double demand, double power_w, const Lags& lags) RT_SAFE {
    constexpr double late = 1.5;
    chip_ += (demand - chip_) * part_of(lags.cycle_s, lags.chip_s);
    lagging_ += (chip_ - lagging_) * part_of(lags.cycle_s, late * lags.sensor_s);
    demand_ += (lagging_ - demand_) * part_of(lags.cycle_s, smoothing_s);
    power_w_ += (power_w - power_w_) * part_of(lags.cycle_s, smoothing_s);
  }
  // What was before counts no more.
  void take_power(double power_w) RT_SAFE { power_w_ = power_w; }

  [[nodiscard]] double demand() const RT_SAFE { return demand_; }
  [[nodiscard]] double power_w() const RT_SAFE { return power_w_; }

 private:
  [[nodiscard]] static double part_of(double cycle_s, double lag_s) RT_SAFE {
    return lag_s > 0.0 ? 1.0 - std::exp(-cycle_s / lag_s) : 1.0;
  }

  double chip_ = 0.0;     // the demand behind the chip,
  double lagging_ = 0.0;  // and the sensor,
  double demand_ = 0.0;   // smoothed
  double power_w_ = 0.0;
};

}  // namespace stanok::process
