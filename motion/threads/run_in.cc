// Speeds at which a run-in may begin, and its instant (motion/threads/run_in.h).
#include "motion/threads/run_in.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/threads/section_limits.h"

namespace stanok::motion {
namespace {

// Shares of the limits that the run-in uses at the speed it begins with; the rest is for a spindle
// that turns up to 20 % faster meanwhile (1.2^3 = 1.73) and for the controller.
constexpr double run_in_share = 0.45;
// The share of its speed by which a spindle may change during the run-in.
constexpr double change_in_run_in = 0.25;

// Lengths of run-in up to the first corner, within which the run-in and a brake from 1.4 times its
// speed have room.
constexpr double run_ins_before_corner = 3.0;

// A spindle that is farther from the speed it is commanded to has not come to it.
constexpr double ripple_max = 0.3;
constexpr double at_speed = 0.05;          // within that it has come to it for certain
constexpr double turning_speed_min = 0.1;  // turns/s; slower ones do not turn

RampLimits scaled(const RampLimits& limits, double share) RT_SAFE {
  return {share * limits.a, share * limits.j};
}

}  // namespace

void RunIn::begin(const SpindleCoupling& coupling) RT_SAFE {
  coupling_ = coupling;
  is_by_chain_ = false;
  mean_speed_ = 0.0;
  has_watched_ = false;
}

// Whether a run-in to this speed by the limits of the entry could be braked off before the first
// corner, that has no part in it then.
bool RunIn::is_clear_of_corner(double speed) const RT_SAFE {
  const RampLimits limits = scaled(limits_of(coupling_.entry), run_in_share);
  return run_ins_before_corner * ramp_distance(0.0, speed, limits) <= coupling_.entry_end;
}

// With other limits the run-in has another length and begins elsewhere: the start angle is to be
// waited for anew. So that this does not go on for ever, only a speed that is lower for certain
// leaves the limits of the chain.
void RunIn::choose_limits(double speed) RT_SAFE {
  const double certain = is_by_chain_ ? speed / (1.0 - change_in_run_in) : speed;
  const bool by_chain = !is_clear_of_corner(certain);
  if (by_chain != is_by_chain_) has_watched_ = false;
  is_by_chain_ = by_chain;
  limits_ = limits_of(by_chain ? coupling_.chain : coupling_.entry);
}

// The mean lags behind a speed that changes at a steady rate by what the rate makes of the speed
// during a run-in. At first it is zero: only a spindle that has turned for as long as that is
// known.
void RunIn::watch(const SpindleMotion& spindle) RT_SAFE {
  const double speed = std::abs(spindle.speed);
  choose_limits(speed);
  const double duration = ramp_duration(0.0, speed, scaled(limits_, run_in_share));
  mean_speed_ += (spindle.speed - mean_speed_) * std::min(1.0, cycle_s_ / duration);
}

// The acceleration that an encoder shows is noisy, and more so over a long run-in; the speed is
// not. Either says that the spindle keeps its speed.
bool RunIn::keeps_speed(const SpindleMotion& spindle) const RT_SAFE {
  const double speed = std::abs(spindle.speed);
  const double duration = ramp_duration(0.0, speed, scaled(limits_, run_in_share));
  return std::abs(spindle.acceleration) * duration <= change_in_run_in * speed ||
         std::abs(spindle.speed - mean_speed_) <= change_in_run_in * speed;
}

// For the axes. The speed of the moment is noisy, and the more so the slower it is: its mean tells,
// once it is known. A spindle that comes down to a lesser speed is waited for.
RunIn::Answer RunIn::judge_speed(const SpindleMotion& spindle) const RT_SAFE {
  const double speed_max = SpindleCoupling::speed_share * coupling_.speed_max;
  const double speed = std::abs(spindle.speed);
  const double wanted = std::abs(spindle.speed_wanted);
  if (speed <= speed_max) return Answer::begins;
  const double mean = std::abs(mean_speed_);
  const bool has_mean = std::abs(speed - mean) <= change_in_run_in * speed;
  if (has_mean && mean <= speed_max) return Answer::begins;
  const bool stays = std::abs(speed - wanted) <= at_speed * speed;
  return has_mean && (stays || wanted > speed_max) ? Answer::too_fast : Answer::waits;
}

// What a spindle turns that has not come to its speed does not count.
RunIn::Answer RunIn::advance(const SpindleMotion& spindle) RT_SAFE {
  const double speed = std::abs(spindle.speed);
  const bool has_speed = speed >= turning_speed_min &&
                         std::abs(spindle.speed - spindle.speed_wanted) <= ripple_max * speed;
  const Answer answer = has_speed ? judge_speed(spindle) : Answer::waits;
  if (answer != Answer::begins || !keeps_speed(spindle)) {
    has_watched_ = false;
    return answer == Answer::too_fast ? answer : Answer::waits;
  }
  return is_due(spindle) ? Answer::begins : Answer::waits;
}

// Whether the run-in begins within this cycle: half its turns before the start angle comes.
bool RunIn::is_due(const SpindleMotion& spindle) RT_SAFE {
  const double speed = std::abs(spindle.speed);
  const RampLimits limits = scaled(limits_, run_in_share);
  const double duration = ramp_duration(0.0, speed, limits);
  const double direction = spindle.speed < 0.0 ? -1.0 : 1.0;
  const double half = 0.5 * speed * duration;
  const double to_start =
      direction * (spindle.turns - coupling_.start_angle_deg / full_turn_deg) + half;
  const double whole_turns = std::floor(to_start);
  const bool is_due = has_watched_ && whole_turns > whole_turns_before_;
  has_watched_ = true;
  whole_turns_before_ = whole_turns;
  if (!is_due) return false;
  start_ = {.direction = direction,
            .origin = direction * spindle.turns + half - (to_start - whole_turns),
            .ramp = ramp_up(0.0, 0.0, speed, limits),
            .ramp_speed = speed};
  return true;
}

}  // namespace stanok::motion
