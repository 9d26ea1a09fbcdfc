#include "motion/threads/synchronous_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numeric.h"
#include "base/units.h"

namespace stanok::motion {
namespace {

using kinematics::Jet;

// Frequency of the controller: that of the observer it follows.
constexpr double bandwidth = SpindleObserver::bandwidth;  // rad/s

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
constexpr double spindle_standstill =
    0.05;  // turns/s, within what the observer sees of a spindle at rest
// A spindle is told to stop somewhat early, with less than it has: so it stops where it is told to,
// though the speed of the moment is not quite known.
constexpr double stop_reserve = 1.05;
constexpr double lag_max = 1.0 / 50;  // turns off the law
constexpr double settled_lag = lag_max / 4;

// The share of jerk and acceleration with which the controller takes a large difference away.
constexpr double taken_back = 0.5;

PathMotion after(const PathMotion& m, double j, double t) RT_SAFE {
  return {.s = m.s + t * (m.v + t * (0.5 * m.a + t * j / 6.0)),
          .v = m.v + t * (m.a + t * 0.5 * j),
          .a = m.a + t * j,
          .j = j};
}

RampLimits limits_of(const SpindleCoupling::Section& section) RT_SAFE {
  return {section.acceleration_max, section.jerk_max};
}

// A spindle that brakes with all it has.
double turns_to_stop(double speed, double acceleration) RT_SAFE {
  return 0.5 * speed * speed / acceleration;
}

RampLimits scaled(const RampLimits& limits, double share) RT_SAFE {
  return {share * limits.a, share * limits.j};
}

}  // namespace

// The controller answers a step of the encoder with its gain of s; three tenths of that are enough
// (measured with 256, 1,024 and 4,096 pulses at 1 to 16 turns/s and leads of 1 to 23 mm).
double jerk_to_follow(int encoder_pulses, double cycle_s) {
  constexpr double part = 0.3;
  const double p = 1.0 - std::exp(-bandwidth * cycle_s);
  return part * std::pow(p / cycle_s, 3) / encoder_pulses;
}

// Gains that lay the three poles of the sampled loop together at exp(-bandwidth * cycle), for a
// jerk that is constant within a cycle (docs/developer/motion.md#threads).
SynchronousRun::SynchronousRun(double cycle_s) : cycle_s_(cycle_s) {
  const double T = cycle_s;
  const double p = 1.0 - std::exp(-bandwidth * T);
  gain_s_ = p * p * p / (T * T * T);
  gain_v_ = p * p * (3.0 - p) / (T * T);
  gain_a_ = p * (3.0 - p * (1.5 - p / 3.0)) / T;
}

void SynchronousRun::begin(const SpindleCoupling& coupling, double length) RT_SAFE {
  coupling_ = coupling;
  length_ = length;
  stage_ = Stage::waits;
  motion_ = {};
  order_ = {};
  is_lost_ = false;
  has_watched_ = false;
  mean_speed_ = 0.0;
  leaves_ = false;
  is_in_law_ = false;
  has_joined_ = false;
  runs_in_by_chain_ = false;
  spindle_stops_ = false;
}

PathMotion SynchronousRun::advance(const SpindleMotion& spindle, const FeedControl& control)
    RT_SAFE {
  order_ = {};
  if (stage_ == Stage::waits) {
    watch_speed(spindle);
    if (control.hold) has_watched_ = false;  // the start angle may pass meanwhile
    if (control.hold || !is_due(spindle)) return motion_;
    stage_ = Stage::goes_in;
  }
  if (control.leaves_thread) leave(spindle);
  switch (stage_) {
    case Stage::goes_in:
    case Stage::dwells:
    case Stage::returns:
      if (!leaves_) turn_spindle(spindle);
      follow(course(spindle));
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

// A tap that leaves its spindle would break: it comes to rest with it.
void SynchronousRun::leave(const SpindleMotion& spindle) RT_SAFE {
  const bool follows =
      stage_ == Stage::goes_in || stage_ == Stage::dwells || stage_ == Stage::returns;
  if (!follows) return;
  if (coupling_.kind == SpindleCoupling::Kind::tap && !stands_with(spindle)) {
    if (!leaves_) stop_spindle(turns_to_stop(spindle.speed, coupling_.spindle_acceleration));
    leaves_ = true;
    return;
  }
  leaves_ = true;
  take(shortest_way());
}

// Whether a run-in to this speed by the limits of the entry could be braked off before the first
// corner, that has no part in it then.
bool SynchronousRun::is_clear_of_corner(double speed) const RT_SAFE {
  const RampLimits limits = scaled(limits_of(coupling_.entry), run_in_share);
  return run_ins_before_corner * ramp_distance(0.0, speed, limits) <= coupling_.entry_end;
}

// Those of the run-in. With other ones it has another length and begins elsewhere: the start angle
// is to be waited for anew. So that this does not go on for ever, only a speed that is lower for
// certain leaves the limits of the chain.
void SynchronousRun::choose_limits(double speed) RT_SAFE {
  const double certain = runs_in_by_chain_ ? speed / (1.0 - change_in_run_in) : speed;
  const bool by_chain = !is_clear_of_corner(certain);
  if (by_chain != runs_in_by_chain_) has_watched_ = false;
  runs_in_by_chain_ = by_chain;
  limits_ = limits_of(by_chain ? coupling_.chain : coupling_.entry);
}

// The mean lags behind a speed that changes at a steady rate by what the rate makes of the speed
// during a run-in. At first it is zero: only a spindle that has turned for as long as that is
// known.
void SynchronousRun::watch_speed(const SpindleMotion& spindle) RT_SAFE {
  const double speed = std::abs(spindle.speed);
  choose_limits(speed);
  const double duration = ramp_duration(0.0, speed, scaled(limits_, run_in_share));
  mean_speed_ += (spindle.speed - mean_speed_) * std::min(1.0, cycle_s_ / duration);
}

// The acceleration that an encoder shows is noisy, and more so over a long run-in; the speed is
// not. Either says that the spindle keeps its speed.
bool SynchronousRun::keeps_speed(const SpindleMotion& spindle) const RT_SAFE {
  const double speed = std::abs(spindle.speed);
  const double duration = ramp_duration(0.0, speed, scaled(limits_, run_in_share));
  return std::abs(spindle.acceleration) * duration <= change_in_run_in * speed ||
         std::abs(spindle.speed - mean_speed_) <= change_in_run_in * speed;
}

// For the axes. The speed of the moment is noisy, and the more so the slower it is: its mean tells,
// once it is known. A spindle that comes down to a lesser speed is waited for.
bool SynchronousRun::is_too_fast(const SpindleMotion& spindle) RT_SAFE {
  const double speed_max = SpindleCoupling::speed_share * coupling_.speed_max;
  const double speed = std::abs(spindle.speed);
  const double wanted = std::abs(spindle.speed_wanted);
  if (speed <= speed_max) return false;
  const double mean = std::abs(mean_speed_);
  const bool has_mean = std::abs(speed - mean) <= change_in_run_in * speed;
  if (has_mean && mean <= speed_max) return false;
  const bool stays = std::abs(speed - wanted) <= at_speed * speed;
  if (has_mean && (stays || wanted > speed_max)) lose();
  return true;
}

// Whether the run-in begins within this cycle: half its turns before the start angle comes. What a
// spindle turns that has not come to its speed does not count.
bool SynchronousRun::is_due(const SpindleMotion& spindle) RT_SAFE {
  const double speed = std::abs(spindle.speed);
  const bool has_speed = speed >= turning_speed_min &&
                         std::abs(spindle.speed - spindle.speed_wanted) <= ripple_max * speed;
  if (has_speed && is_too_fast(spindle)) {
    has_watched_ = false;
    return false;
  }
  if (!has_speed || !keeps_speed(spindle)) {
    has_watched_ = false;
    return false;
  }
  const RampLimits limits = scaled(limits_, run_in_share);
  const double duration = ramp_duration(0.0, speed, limits);
  direction_ = spindle.speed < 0.0 ? -1.0 : 1.0;
  const double half = 0.5 * speed * duration;
  const double to_start =
      direction_ * (spindle.turns - coupling_.start_angle_deg / full_turn_deg) + half;
  const double whole_turns = std::floor(to_start);
  const bool is_due = has_watched_ && whole_turns > whole_turns_before_;
  has_watched_ = true;
  whole_turns_before_ = whole_turns;
  if (!is_due) return false;
  origin_ = direction_ * spindle.turns + half - (to_start - whole_turns);
  ramp_ = ramp_up(0.0, 0.0, speed, limits);
  ramp_speed_ = speed;
  return true;
}

// Where the path is to be at the setpoint: in the law, or on the ramp that leads into it. The
// ramp's time is the angle since its start over the speed it was made for.
Jet SynchronousRun::course(const SpindleMotion& spindle) RT_SAFE {
  const Jet law{direction_ * spindle.turns - origin_, direction_ * spindle.speed,
                direction_ * spindle.acceleration, direction_ * spindle.jerk};
  if (is_in_law_) return law;
  const double half = ramp_[ramp_.size() - 1].s_end;
  const Jet time{(law.value + half) / ramp_speed_, law.first / ramp_speed_,
                 law.second / ramp_speed_, law.third / ramp_speed_};
  double t = std::max(time.value, 0.0);
  std::size_t k = 0;
  while (k < ramp_.size() && t >= ramp_[k].duration) t -= ramp_[k++].duration;
  is_in_law_ = k == ramp_.size();
  if (is_in_law_) return law;
  const PathMotion m = motion_at(ramp_[k], t);
  return kinematics::compose(time, m.s, m.v, m.a, m.j);
}

// One cycle towards the course, if from there a way to rest within the chain is known; else the way
// to rest that is known from here.
void SynchronousRun::follow(const Jet& course) RT_SAFE {
  if (!changes_limits(course)) {
    lose();
    return run_brake();
  }
  const PathMotion next = after(motion_, jerk_allowed(jerk_towards(course, limits_)), cycle_s_);
  const bool goes_back = next.v < 0.0;
  const double end = goes_back ? 0.0 : length_;
  if (!comes_to_rest_before(end, next)) {
    const bool is_tap = coupling_.kind == SpindleCoupling::Kind::tap;
    const bool may_end = goes_back ? stage_ == Stage::returns : !is_tap;
    may_end ? take(way_to(end)) : lose();
    return run_brake();
  }
  motion_ = next;
  if (is_in_law_ && std::abs(course.value - motion_.s) > lag_max) lose();
}

// From the limits of the run-in, which is before the first corner, to those of the whole chain, and
// behind the last corner to those there. False: the motion stays beyond the limits of the chain.
bool SynchronousRun::changes_limits(const Jet& course) RT_SAFE {
  if (motion_.s >= coupling_.exit_begin) {
    limits_ = limits_of(coupling_.exit);
  } else if (is_in_law_ && !has_joined_) {
    return joins_chain(course);
  }
  return true;
}

// A controller that is held back by its limits overshoots: while there is time, those of the chain
// come when the path has settled in the law, first that of the acceleration and in a cycle whose
// jerk is within it that of the jerk.
bool SynchronousRun::joins_chain(const Jet& course) RT_SAFE {
  const RampLimits chain = limits_of(coupling_.chain);
  const RampLimits run_in = runs_in_by_chain_ ? chain : limits_of(coupling_.entry);
  const bool has_time = brakes_before_corner(run_in);
  const bool has_acceleration = std::abs(motion_.a) <= chain.a;
  const bool has_settled = is_settled(course, chain);
  if (has_acceleration && has_settled) limits_.a = chain.a;
  const bool is_calm = has_settled && std::abs(jerk_towards(course, chain)) <= chain.j;
  const bool has_speed =
      std::abs(eased_speed(motion_.v, motion_.a, chain.j)) <= coupling_.speed_max;
  has_joined_ = has_acceleration && has_speed && (is_calm || !has_time);
  if (has_joined_) limits_ = chain;
  if (!has_joined_ && !has_time) limits_ = run_in;
  return has_joined_ || has_time;
}

// Whether the path, with these limits, comes into the law and leaves it on its way by no more than
// a part of what may be: by what it is off now, and by what its speed is until the jerk has taken
// that away.
bool SynchronousRun::is_settled(const Jet& course, const RampLimits& limits) const RT_SAFE {
  const double j = limits.j;
  const PathMotion due = before(course);
  const double ease = std::abs(due.a - motion_.a) / j;
  const double speed = std::abs(due.v - motion_.v) + 0.5 * j * ease * ease;
  const double time = ease + 2.0 * std::sqrt(speed / j);
  return std::abs(due.s - motion_.s) + 0.5 * speed * time <= settled_lag;
}

// The acceleration of the moment follows the steps of the encoder: what is beyond the limits of the
// chain in one cycle is within them some cycles later, and there is time for that as long as the
// limits of the entry bring the path to rest before the first corner.
bool SynchronousRun::brakes_before_corner(const RampLimits& limits) const RT_SAFE {
  const double a = std::max(motion_.a, 0.0);
  const double t = cycle_s_ + a / limits.j;  // the jerk may still raise it in this cycle
  const double way = t * (motion_.v + t * (a + 0.5 * limits.j * cycle_s_));
  const double v = motion_.v + t * (a + limits.j * cycle_s_);
  return motion_.s + way + ramp_distance(0.0, v, limits) < coupling_.entry_end;
}

// Where the course, which is that of the setpoint, was at the start of its cycle.
PathMotion SynchronousRun::before(const Jet& course) const RT_SAFE {
  return after({course.value, course.first, course.second}, course.third, -cycle_s_);
}

// The jerk over the cycle up to the setpoint: that of the course, and the controller's on the
// difference at the start of the cycle. Its loops lie in each other: what the path is off asks for
// a speed, that for an acceleration, that for a jerk. A difference so large that the jerk would be
// beyond the limits is taken away as the limits can, on the curves of constant jerk v^3 ~ s^2 and
// a^2 ~ v, else a chain of three integrators swings up.
double SynchronousRun::jerk_towards(const Jet& course, const RampLimits& limits) const RT_SAFE {
  const PathMotion due = before(course);
  const double s = due.s - motion_.s;
  const double by_s =
      std::min({gain_s_ / gain_v_ * std::abs(s), std::cbrt(4.5 * taken_back * limits.j * s * s),
                std::sqrt(2.0 * taken_back * limits.a * std::abs(s))});
  const double v = due.v - motion_.v + std::copysign(by_s, s);
  const double by_v = std::min({gain_v_ / gain_a_ * std::abs(v),
                                std::sqrt(2.0 * taken_back * limits.j * std::abs(v)), limits.a});
  return course.third + gain_a_ * (due.a - motion_.a + std::copysign(by_v, v));
}

// The jerk nearest to the one wanted that keeps jerk, acceleration, and the speed at which the
// acceleration can be gone.
double SynchronousRun::jerk_allowed(double wanted) const RT_SAFE {
  const double low = std::max(-limits_.j, (-limits_.a - motion_.a) / cycle_s_);
  const double high = std::min(limits_.j, (limits_.a - motion_.a) / cycle_s_);
  // A thread does not go back.
  const bool is_tap = coupling_.kind == SpindleCoupling::Kind::tap;
  const double v_max = SpindleCoupling::speed_share * coupling_.speed_max;
  const double v_min = is_tap ? -v_max : 0.0;
  const auto eased = [&](double j) RT_SAFE {
    const PathMotion next = after(motion_, j, cycle_s_);
    return eased_speed(next.v, next.a, limits_.j);
  };
  double beyond = std::clamp(wanted, low, high);
  const double speed = eased(beyond);
  if (v_min <= speed && speed <= v_max) return beyond;
  const bool is_too_fast = speed > v_max;
  double kept = is_too_fast ? low : high;
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (kept + beyond);
    const double v = eased(middle);
    ((is_too_fast ? v <= v_max : v >= v_min) ? kept : beyond) = middle;
  }
  return kept;
}

// What a tap asks of the spindle on its way.
void SynchronousRun::turn_spindle(const SpindleMotion& spindle) RT_SAFE {
  if (coupling_.kind != SpindleCoupling::Kind::tap) return;
  if (stage_ == Stage::goes_in && !spindle_stops_) {
    // The spindle obeys in this cycle, at the end of which it is predicted.
    const double way = std::abs(spindle.speed) * cycle_s_;
    const double left = coupling_.bottom - (direction_ * spindle.turns - origin_) + way;
    const double needed = turns_to_stop(spindle.speed, coupling_.spindle_acceleration);
    if (left - way <= stop_reserve * needed) stop_spindle(std::max(left, 0.0));
  } else if (stage_ == Stage::goes_in) {
    if (!stands_with(spindle)) return;
    stage_ = Stage::dwells;
    dwell_cycles_ = ceiling(coupling_.dwell_s / cycle_s_);
  } else if (stage_ == Stage::dwells) {
    if (dwell_cycles_-- > 0) return;
    stage_ = Stage::returns;
    order_ = {.kind = SpindleOrder::Kind::turn_back,
              .spindle = coupling_.spindle,
              .factor = coupling_.return_speed_factor,
              .acceleration = coupling_.spindle_acceleration};
  }
}

void SynchronousRun::stop_spindle(double turns) RT_SAFE {
  spindle_stops_ = true;
  order_ = {.kind = SpindleOrder::Kind::stop_within, .spindle = coupling_.spindle, .turns = turns};
}

// Both, as far as the observer sees.
bool SynchronousRun::stands_with(const SpindleMotion& spindle) const RT_SAFE {
  return spindle.speed_wanted == 0.0 && std::abs(spindle.speed) < spindle_standstill &&
         std::abs(motion_.v) < spindle_standstill;
}

void SynchronousRun::lose() RT_SAFE {
  is_lost_ = true;
  leaves_ = true;
  take(shortest_way());
}

// Coordinate of a way to rest: counts from its end, in the direction of travel.
SynchronousRun::Approach SynchronousRun::approach(const PathMotion& from, double end) const
    RT_SAFE {
  Approach approach;
  const double forward = from.v < 0.0 ? -1.0 : 1.0;
  const double j = limits_.j;
  const PathMotion m{forward * (from.s - end), forward * from.v, forward * from.a, 0.0};
  approach.forward = forward;
  approach.ease = {
      .duration = std::abs(m.a) / j, .s = m.s, .v = m.v, .a = m.a, .j = m.a > 0.0 ? -j : j};
  const PathMotion eased = motion_at(approach.ease, approach.ease.duration);
  approach.ease.s_end = eased.s;
  approach.ease.v_end = eased.v;
  if (eased.v <= 0.0) return approach;
  for (const auto& [section, earliest] :
       {std::pair{coupling_.exit, forward * (coupling_.exit_begin - end)},
        std::pair{coupling_.chain, eased.s}}) {
    approach.limits = limits_of(section);
    approach.ramp_begin = -ramp_distance(eased.v, 0.0, approach.limits);
    approach.fits = approach.ramp_begin >= std::max(earliest, eased.s);
    if (approach.fits) break;
  }
  return approach;
}

// A path that is about to stand comes to rest without a ramp.
bool SynchronousRun::comes_to_rest_before(double end, const PathMotion& from) const RT_SAFE {
  const Approach way = approach(from, end);
  return way.fits || (way.ease.v_end <= 0.0 && way.ease.s <= 0.0);
}

// The acceleration is taken away, the speed held, and ramped down to the very end: behind the last
// corner, or where there is no room for that with what the whole chain allows.
SynchronousRun::WayToRest SynchronousRun::way_to(double end) const RT_SAFE {
  const Approach course = approach(motion_, end);
  if (!course.fits) return brake();
  WayToRest way;
  const double v = course.ease.v_end;
  way.phases[way.size++] = course.ease;
  way.phases[way.size++] = {.duration = (course.ramp_begin - course.ease.s_end) / v,
                            .s = course.ease.s_end,
                            .v = v,
                            .s_end = course.ramp_begin,
                            .v_end = v};
  for (const Phase& phase : ramp_down(v, 0.0, 0.0, course.limits)) way.phases[way.size++] = phase;
  for (std::size_t k = 0; k < way.size; ++k) {
    Phase& phase = way.phases[k];
    phase.s = end + course.forward * phase.s;
    phase.s_end = end + course.forward * phase.s_end;
    phase.v *= course.forward;
    phase.v_end *= course.forward;
    phase.a *= course.forward;
    phase.j *= course.forward;
  }
  way.ends_chain = true;
  return way;
}

// Wherever it ends.
SynchronousRun::WayToRest SynchronousRun::brake() const RT_SAFE {
  WayToRest way;
  for (const Phase& phase : change_speed(motion_, 0.0, limits_)) way.phases[way.size++] = phase;
  return way;
}

// The brake, or where it would end beyond the chain, the way to its end.
SynchronousRun::WayToRest SynchronousRun::shortest_way() const RT_SAFE {
  const WayToRest way = brake();
  if (way.size == 0) return way;
  const double s = way.phases[way.size - 1].s_end;
  if (s > length_) return way_to(length_);
  return s < 0.0 ? way_to(0.0) : way;
}

// From the next cycle on.
void SynchronousRun::take(const WayToRest& way) RT_SAFE {
  brake_ = way;
  brake_time_ = 0.0;
  stage_before_ = stage_;
  stage_ = Stage::comes_to_rest;
}

void SynchronousRun::run_brake() RT_SAFE {
  brake_time_ += cycle_s_;
  double t = brake_time_;
  for (std::size_t k = 0; k < brake_.size; ++k) {
    const Phase& phase = brake_.phases[k];
    if (t < phase.duration) {
      motion_ = motion_at(phase, t);
      return;
    }
    t -= phase.duration;
  }
  motion_ = {.s = brake_.size > 0 ? brake_.phases[brake_.size - 1].s_end : motion_.s};
  if (!brake_.ends_chain) {
    stage_ = leaves_ ? Stage::stands : stage_before_;
    return;
  }
  stage_ = Stage::over;
  if (coupling_.kind == SpindleCoupling::Kind::tap)
    order_ = {.kind = SpindleOrder::Kind::go_on, .spindle = coupling_.spindle};
}

}  // namespace stanok::motion
