// SynchronousRun: the motion along a chain that a spindle leads.
//
// The path coordinate s counts turns of the spindle: the law of the thread is
//   s = +-(turns of the spindle - turns at the start),
// the start being at the start angle of every pass, so that all passes cut one helix at any speed.
// Run-in: from rest the path comes into the law by a ramp that is played by the angle of the
// spindle, not by time, and ends half its turns after s = 0 (RunIn, ThreadLaw). In the law a
// controller of third order gives the jerk of each cycle from the predicted angle and its
// derivatives (CourseController); what the axes allow bounds it, and there is always a way to rest
// within the chain (ChainBrake). Run-out: such a way, to the very end. A tap stops the spindle for
// the bottom, turns it back and follows it to where it began (TapReversal;
// docs/developer/motion.md#threads). Thread: the cycle. Owner: the interpolator. Invariant: of the
// parts only one moves the path in a cycle, by the stage.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"
#include "motion/threads/chain_brake.h"
#include "motion/threads/course_controller.h"
#include "motion/threads/run_in.h"
#include "motion/threads/spindle_observer.h"
#include "motion/threads/tap_reversal.h"
#include "motion/threads/thread_law.h"

namespace stanok::motion {

class SynchronousRun {
 public:
  explicit SynchronousRun(double cycle_s);

  // The chain begins, at rest at s = 0, or where a tap stands in its hole.
  void begin(const SpindleCoupling& coupling, double length) RT_SAFE;

  // The state at the next setpoint; `spindle` is predicted for its instant. Before the run-in a
  // hold keeps the path at rest; later only `leaves_thread` brings it to rest within the chain: a
  // thread at once, a tap together with its spindle.
  PathMotion advance(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE;

  [[nodiscard]] const PathMotion& motion() const RT_SAFE { return motion_; }
  // A tap has left its start, and is not back there.
  [[nodiscard]] bool is_in_hole() const RT_SAFE {
    return tap_.is_tap() && stage_ != Stage::over && motion_.s > 0.0;
  }
  // At rest at the end; of a tap, where it began.
  [[nodiscard]] bool is_over() const RT_SAFE { return stage_ == Stage::over; }
  // The axes could not follow the spindle: the path comes to rest, the chain is never over.
  [[nodiscard]] bool is_lost() const RT_SAFE { return is_lost_; }
  // Asked for in the latest cycle.
  [[nodiscard]] const SpindleOrder& order() const RT_SAFE { return order_; }

 private:
  enum class Stage : std::uint8_t { waits, follows, comes_to_rest, stands, over };

  void wait(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE;
  void turn_out(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE;
  void follow(const kinematics::Jet& course) RT_SAFE;
  void leave(const SpindleMotion& spindle) RT_SAFE;
  void lose() RT_SAFE;
  void brake() RT_SAFE;
  void run_brake() RT_SAFE;
  [[nodiscard]] bool changes_limits(const kinematics::Jet& course) RT_SAFE;
  [[nodiscard]] bool joins_chain(const kinematics::Jet& course) RT_SAFE;
  [[nodiscard]] bool brakes_before_corner(const RampLimits& limits) const RT_SAFE;
  [[nodiscard]] CourseController::SpeedRange speeds() const RT_SAFE;

  double cycle_s_;
  CourseController controller_;
  RunIn run_in_;
  ThreadLaw law_;
  TapReversal tap_;
  ChainBrake brake_;

  SpindleCoupling coupling_;
  Stage stage_ = Stage::over;
  RampLimits limits_;  // the current ones
  PathMotion motion_;
  SpindleOrder order_;
  bool has_joined_ = false;  // the law, with the limits of the chain
  bool is_lost_ = false;
  bool leaves_ = false;  // the chain will not be over
};

}  // namespace stanok::motion
