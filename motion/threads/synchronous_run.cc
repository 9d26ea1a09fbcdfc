// Stages of a chain that a spindle leads (motion/threads/synchronous_run.h).
#include "motion/threads/synchronous_run.h"

#include <algorithm>
#include <cmath>

#include "motion/threads/section_limits.h"

namespace stanok::motion {

using kinematics::Jet;

SynchronousRun::SynchronousRun(double cycle_s)
    : cycle_s_(cycle_s), controller_(cycle_s), run_in_(cycle_s), tap_(cycle_s), brake_(cycle_s) {}

void SynchronousRun::begin(const SpindleCoupling& coupling, double length) RT_SAFE {
  coupling_ = coupling;
  run_in_.begin(coupling);
  tap_.begin(coupling);
  brake_.begin(coupling, length);
  stage_ = Stage::waits;
  motion_ = {.s = tap_.is_taken_out() ? coupling.bottom : 0.0};
  order_ = {};
  has_joined_ = false;
  is_lost_ = false;
  leaves_ = false;
}

PathMotion SynchronousRun::advance(const SpindleMotion& spindle, const FeedControl& control)
    RT_SAFE {
  order_ = {};
  if (stage_ == Stage::waits) {
    if (tap_.is_taken_out()) {
      turn_out(spindle, control);
    } else {
      wait(spindle, control);
    }
    if (stage_ != Stage::follows) return motion_;
  }
  if (control.leaves_thread) leave(spindle);
  switch (stage_) {
    case Stage::follows:
      if (!leaves_) order_ = tap_.advance(spindle, law_.place(spindle), motion_);
      follow(law_.advance(spindle));
      break;
    case Stage::comes_to_rest:
      run_brake();
      break;
    case Stage::waits:
    case Stage::stands:
    case Stage::over:
      break;
  }
  return motion_;
}

// At rest, until the run-in begins.
void SynchronousRun::wait(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE {
  run_in_.watch(spindle);
  limits_ = run_in_.limits();
  if (control.hold) return run_in_.forget_angle();
  switch (run_in_.advance(spindle)) {
    case RunIn::Answer::waits:
      break;
    case RunIn::Answer::too_fast:
      lose();
      break;
    case RunIn::Answer::begins:
      law_.begin(run_in_.start());
      stage_ = Stage::follows;
      break;
  }
}

// The thread of the hole and the tap that stands in it are what there is of a law, once the spindle
// stands, too.
void SynchronousRun::turn_out(const SpindleMotion& spindle, const FeedControl& control) RT_SAFE {
  if (control.hold || !TapReversal::stand(spindle, motion_)) return;
  law_.begin_at(motion_.s, spindle.turns, coupling_.out_speed);
  has_joined_ = true;
  limits_ = limits_of(coupling_.chain);
  stage_ = Stage::follows;
}

// A tap that leaves its spindle would break: it comes to rest with it.
void SynchronousRun::leave(const SpindleMotion& spindle) RT_SAFE {
  if (stage_ != Stage::follows) return;
  const bool left_before = leaves_;
  leaves_ = true;
  if (!tap_.is_tap() || TapReversal::stand(spindle, motion_)) return brake();
  if (!left_before) order_ = tap_.stop_at_once(spindle);
}

// One cycle towards the course, if from there a way to rest within the chain is known; else the way
// to rest that is known from here.
void SynchronousRun::follow(const Jet& course) RT_SAFE {
  if (!changes_limits(course)) {
    lose();
    return run_brake();
  }
  const PathMotion next = controller_.advance(motion_, course, limits_, speeds());
  const bool goes_back = next.v < 0.0;
  const double end = goes_back ? 0.0 : brake_.length();
  if (!brake_.comes_to_rest_before(end, next, limits_)) {
    const bool may_end = goes_back ? tap_.returns() : !tap_.is_tap();
    if (may_end) {
      brake_.brake_at(end, motion_, limits_);
      stage_ = Stage::comes_to_rest;
    } else {
      lose();
    }
    return run_brake();
  }
  motion_ = next;
  if (law_.is_in_law() && std::abs(course.value - motion_.s) > CourseController::lag_max) lose();
}

// A thread does not go back.
CourseController::SpeedRange SynchronousRun::speeds() const RT_SAFE {
  const double v_max = SpindleCoupling::speed_share * coupling_.speed_max;
  return {.min = tap_.is_tap() ? -v_max : 0.0, .max = v_max};
}

// From the limits of the run-in, which is before the first corner, to those of the whole chain, and
// behind the last corner to those there. False: the motion stays beyond the limits of the chain.
bool SynchronousRun::changes_limits(const Jet& course) RT_SAFE {
  if (motion_.s >= coupling_.exit_begin) {
    limits_ = limits_of(coupling_.exit);
  } else if (law_.is_in_law() && !has_joined_) {
    return joins_chain(course);
  }
  return true;
}

// A controller that is held back by its limits overshoots: while there is time, those of the chain
// come when the path has settled in the law, first that of the acceleration and in a cycle whose
// jerk is within it that of the jerk.
bool SynchronousRun::joins_chain(const Jet& course) RT_SAFE {
  const RampLimits chain = limits_of(coupling_.chain);
  const bool has_time = brakes_before_corner(run_in_.limits());
  const bool has_acceleration = std::abs(motion_.a) <= chain.a;
  const bool has_settled = controller_.is_settled(motion_, course, chain);
  if (has_acceleration && has_settled) limits_.a = chain.a;
  const bool is_calm =
      has_settled && std::abs(controller_.jerk_towards(motion_, course, chain)) <= chain.j;
  const bool has_speed =
      std::abs(eased_speed(motion_.v, motion_.a, chain.j)) <= coupling_.speed_max;
  has_joined_ = has_acceleration && has_speed && (is_calm || !has_time);
  if (has_joined_) limits_ = chain;
  if (!has_joined_ && !has_time) limits_ = run_in_.limits();
  return has_joined_ || has_time;
}

// The acceleration of the moment follows the steps of the encoder: what is beyond the limits of the
// chain in one cycle is within them some cycles later, and there is time for that as long as the
// limits of the entry bring the path to rest before the first corner.
bool SynchronousRun::brakes_before_corner(const RampLimits& limits) const RT_SAFE {
  const double a = std::max(motion_.a, 0.0);
  const double t = cycle_s_ + a / limits.j;  // the jerk may still raise it in this cycle
  const double distance = t * (motion_.v + t * (a + 0.5 * limits.j * cycle_s_));
  const double v = motion_.v + t * (a + limits.j * cycle_s_);
  return motion_.s + distance + ramp_distance(0.0, v, limits) < coupling_.entry_end;
}

void SynchronousRun::lose() RT_SAFE {
  is_lost_ = true;
  leaves_ = true;
  brake();
}

// From the next cycle on.
void SynchronousRun::brake() RT_SAFE {
  brake_.brake(motion_, limits_);
  stage_ = Stage::comes_to_rest;
}

// A brake that does not end the chain leaves the path to the spindle again, if it may go on.
void SynchronousRun::run_brake() RT_SAFE {
  switch (brake_.advance(motion_)) {
    case ChainBrake::Answer::moves:
      break;
    case ChainBrake::Answer::at_rest:
      stage_ = leaves_ ? Stage::stands : Stage::follows;
      break;
    case ChainBrake::Answer::at_end_of_chain:
      stage_ = Stage::over;
      if (tap_.is_tap()) order_ = tap_.go_on();
      break;
  }
}

}  // namespace stanok::motion
