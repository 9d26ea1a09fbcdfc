// SpindleObserver: how a spindle turns, from the angles that its encoder gives.
//
// An encoder gives whole counts; a path that follows them needs an angle without steps, and its
// derivatives. What the spindle is commanded to do is known without an encoder; the observer fits a
// cubic in time to what it does beside that, older angles forgotten exponentially: Morrison's
// fading-memory polynomial filter of degree 3 (N. Morrison, Introduction to Sequential Smoothing
// and Prediction, 1969, section 13.4), whose four poles lie together at
// exp(-bandwidth * interval). The error of what is beside the command is its fourth derivative by
// time over bandwidth^4 (docs/developer/motion.md#threads). Angles may come in every cycle or more
// seldom; whole turns are counted. Real-time.
#pragma once

#include <cstddef>

#include "base/rt_safe.h"

namespace stanok::motion {

inline constexpr std::size_t coupled_spindles_max = 4;  // of one channel

// How a spindle turns at one instant; clockwise is positive.
struct SpindleMotion {
  double turns = 0.0;  // since power-on; whole numbers are the encoder's index pulse
  double speed = 0.0;  // turns/s
  double acceleration = 0.0;
  double jerk = 0.0;
  double speed_wanted = 0.0;  // that it is commanded to come to
};

class SpindleObserver {
 public:
  // High enough for a ripple of a few Hz, low enough for a thousand counts per turn: a step of one
  // count moves the estimated acceleration by 4 bandwidth^3 * interval counts/s^2.
  static constexpr double bandwidth = 250.0;  // rad/s

  // Time goes on by `period_s`, at the end of which the spindle is commanded to turn so; {}:
  // nothing is known of that.
  void advance(double period_s, const SpindleMotion& commanded) RT_SAFE;
  // The angle now, in deg; any whole turns.
  void observe(double angle_deg) RT_SAFE;

  [[nodiscard]] SpindleMotion now() const RT_SAFE { return ahead(0.0, commanded_); }
  // `time_s` from now, when it is commanded to turn so.
  [[nodiscard]] SpindleMotion ahead(double time_s, const SpindleMotion& commanded) const RT_SAFE;

 private:
  SpindleMotion commanded_;
  SpindleMotion beside_;  // the command
  double since_observed_s_ = 0.0;
  bool has_begun_ = false;
};

}  // namespace stanok::motion
