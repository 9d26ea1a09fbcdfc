// FeedController, block 14: changes the feed until the deviation of the power is zero.
//
// The force follows the feed per revolution h as P_z = C t h^y, so ln h is integrated:
// d(ln h)/dt = -K ln(1 + U/N_z) / y. The loop then has the same gain whatever depth and hardness
// are. Its dead time is that of the chip, which is as thick as the tool went in the last revolution
// (half a revolution in the mean), and the lag of the sensor; K = gain / dead time. In rapid, in
// the air and where the path does not go at the feed asked for, the controller is held (no
// wind-up); out of the cut it goes back to the feed at which the force was last held. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::process {

// What the controller gets in one cycle.
struct FeedControllerInputs {
  double cycle_s = 0.001;
  double revolution_s = 0.1;
  double deviation = 0.0;  // U / N_z
  bool cuts = false;       // at working feed, with power enough to be in the workpiece
  bool follows = false;    // the path goes at the feed asked for
  double feed_min = 0.0;   // clamps, mm per revolution
  double feed_max = 0.0;
  double delay_s = 0.0;  // of the deviation, beyond chip and sensor
};

class FeedController {
 public:
  explicit FeedController(const ForceControlConfig& config) : config_(config) {}

  // Forgets the feed; it begins with the first one that is programmed.
  void reset() RT_SAFE;
  void begin_with(double feed_per_rev) RT_SAFE;
  // The feed for another force: blocks 21, 12 and 22 ahead of the controller, which then waits
  // until the power shows it.
  void scale(double factor) RT_SAFE;
  void advance(const FeedControllerInputs& inputs) RT_SAFE;

  [[nodiscard]] bool has_feed() const RT_SAFE { return feed_ > 0.0; }
  [[nodiscard]] double feed_per_rev() const RT_SAFE { return feed_; }  // h, mm
  [[nodiscard]] bool is_at_minimum() const RT_SAFE { return is_at_minimum_; }

 private:
  ForceControlConfig config_;
  double feed_ = 0.0;
  double feed_held_ = 0.0;  // at which the force was held last; 0: not yet in this cut
  double cutting_s_ = 0.0;
  double following_s_ = 0.0;
  bool is_scaled_ = false;
  double scaled_s_ = 0.0;  // since
  bool is_at_minimum_ = false;
};

}  // namespace stanok::process
