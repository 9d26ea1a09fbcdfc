#include "motion/interpolation/stop_brake.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

// Kept of the stop limits for what lies between the instants of the trace; but at least what plans
// use of the limits is left, so that a pace that does not change is always within.
constexpr double reserve = 0.007;
constexpr double use_of_plans = 0.9985;  // more than they have where a stop begins (Optimum)
// Of the reserve, a release that was found before may use so much where it is followed.
constexpr double reserve_followed = 0.9;

// What a cycle may change of the pace, where the limits allow more: a cycle would be too coarse.
constexpr double change_step = 0.2;
constexpr double second_step = 0.01;

// Of p and p' that a last step may leave.
constexpr double pace_rounding = 1e-12;
constexpr double rate_at_rest = 1e-10;

// p'' holds for a cycle or several, so that a release has not too many steps: for this part of the
// time that an axis takes to all of its acceleration, at least; instants of the trace are closer.
constexpr double steps_of_ramp = 50.0;
constexpr double instant = 0.001;   // s
constexpr double step_max = 0.003;  // s: between its ends a step is not looked at

// A change of the pace can be needed for so many times the time that an axis takes to all of its
// acceleration.
constexpr double ramps_ahead = 2.0;
constexpr double instants_ahead = 400.0;  // at most, of the trace

double inverse_of(double limit) RT_SAFE {
  return std::isfinite(limit) ? 1.0 / limit : 0.0;
}

}  // namespace

StopBrake::StopBrake(const MotionConfig& config) : cycle_s_(config.cycle_s), trace_(config) {
  double ramp_max = 0.0;
  for (int k = 0; k < config.axis_count; ++k) {
    const AxisLimits& limits = config.axes[k];
    const double part = (1.0 - reserve) * limits.stop_limits;
    parts_.used_max = std::max(parts_.used_max, use_of_plans / part);
    parts_.acceleration[k] = inverse_of(part * limits.acceleration_max);
    parts_.jerk[k] = inverse_of(part * limits.jerk_max);
    const double ramp = limits.acceleration_max * inverse_of(limits.jerk_max);
    if (std::isfinite(ramp)) ramp_max = std::max(ramp_max, ramp);
  }
  constexpr double rounding = 1e-9;
  const double step = std::clamp(ramp_max / steps_of_ramp, instant, step_max);
  cycles_ = std::max(static_cast<int>(step / cycle_s_ + rounding), 1);
  step_s_ = cycles_ * cycle_s_;
  ahead_min_s_ = std::min(ramps_ahead * ramp_max, static_cast<double>(steps_max) * step_s_);
}

bool StopBrake::begin(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                      const Pace& pace) RT_SAFE {
  constexpr double rounding = 1e-9;
  const double instants = std::max(instant, ahead_min_s_ / instants_ahead);
  trace_.begin(step_s_ / std::max(std::ceil(step_s_ / instants - rounding), 1.0));
  time_ = 0.0;
  cycle_ = 0;
  steps_ = 0;
  look(queue, cursor, elapsed);
  followed_ = 0;
  is_on_ = trace_.end() > 0.0 && has_release(0.0, pace);
  if (is_on_) known_ = 1 - known_;
  return is_on_;
}

PaceStep StopBrake::brake(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                          const Pace& from) RT_SAFE {
  if (cycle_ == 0) {
    look(queue, cursor, elapsed);
    measure(from);
    const Range range = seconds(time_, from, ends_, 1.0);
    if (const std::optional<double> last = last_second(from, range)) {
      releases_[known_].size = followed_ = 0;
      second_ = *last;
    } else {
      second_ = hardest(from, range);
    }
  }
  return take(from);
}

PaceStep StopBrake::release(const PathQueue& queue, const PathCursor& cursor, double elapsed,
                            const Pace& from) RT_SAFE {
  if (cycle_ == 0) {
    look(queue, cursor, elapsed);
    measure(from);
    second_ = follow(from);
  }
  return take(from);
}

void StopBrake::look(const PathQueue& queue, const PathCursor& cursor, double elapsed) RT_SAFE {
  steps_ = 0;
  trace_.look(queue, cursor, elapsed, time_,
              ahead_min_s_ + step_s_ * static_cast<double>(releases_[known_].size + 2));
}

// What the plan asks at both ends of the step of this cycle, exactly.
void StopBrake::measure(const Pace& from) RT_SAFE {
  const double advance = step_s_ * (from.rate + 0.5 * step_s_ * from.change);
  if (!trace_.measure(0.0, ends_[0]) || !trace_.measure(std::max(advance, 0.0), ends_[1]))
    ends_ = ends_of_step(time_, from);
}

// By what the trace tells between its instants.
StopBrake::Ends StopBrake::ends_of_step(double time, const Pace& from) const RT_SAFE {
  const PlanTrace::Instant begin = trace_.at(time);
  const PlanTrace::Instant end =
      trace_.at(time + step_s_ * std::max(from.rate + 0.5 * step_s_ * from.change, 0.0));
  Ends ends;
  for (int k = 0; k < trace_.axes(); ++k) {
    const double jerk = trace_.jerk(begin, end, k).low;
    ends[0][k] = {trace_.velocity(begin, k), trace_.acceleration(begin, k), jerk};
    ends[1][k] = {trace_.velocity(end, k), trace_.acceleration(end, k), jerk};
  }
  return ends;
}

StopBrake::Range StopBrake::seconds(double time, const Pace& from) const RT_SAFE {
  return seconds(time, from, ends_of_step(time, from), 1.0);
}

// What is left of the limits of every axis, at both ends of the step: accelerations behind it,
// jerks under the p'' that holds all over it. The end is linear in p'' but for what is of the
// second order in the change that a step makes.
StopBrake::Range StopBrake::seconds(double time, const Pace& from, const Ends& ends,
                                    double times) const RT_SAFE {
  const double t = step_s_;
  const double p0 = from.rate;
  const double d0 = from.change;
  const double p1 = std::max(p0 + t * d0, 0.0);
  const PlanTrace::Instant begin = trace_.at(time);
  const PlanTrace::Instant end = trace_.at(time + 0.5 * t * (p0 + p1));
  const double coarse = second_step / (t * t);
  Range range{std::max(-coarse, (-change_step / t - d0) / t), coarse};
  const double most0 = std::max(times, parts_.used_max * p0 * p0 * p0);
  const double most1 = std::max(times, parts_.used_max * p1 * p1 * p1);
  const double most_a = std::max(times, parts_.used_max * p1 * p1);
  const double cube0 = p0 * p0 * p0;
  const double cube1 = p1 * p1 * p1;
  for (int k = 0; k < trace_.axes(); ++k) {
    const auto& [v0, a0, j0] = ends[0][k];
    const auto& [v1, a1, j1] = ends[1][k];
    PlanTrace::Span j = trace_.jerk(begin, end, k);
    j = {std::min({j.low, j0, j1}), std::max({j.high, j0, j1})};
    const double part = parts_.jerk[k];
    const double couples0 = 3.0 * a0 * p0 * d0;
    range.keep(part * (couples0 + j.low * cube0), part * v0, -most0, unlimited);
    range.keep(part * (couples0 + j.high * cube0), part * v0, -unlimited, most0);
    const double couples1 = 3.0 * a1 * p1 * d0;
    const double slope1 = v1 + 3.0 * a1 * (0.5 * t * t * d0 + t * p1);
    const double bends = 1.5 * t * t * p1 * p1;
    range.keep(part * (couples1 + j.low * cube1), part * (slope1 + bends * j.low), -most1,
               unlimited);
    range.keep(part * (couples1 + j.high * cube1), part * (slope1 + bends * j.high), -unlimited,
               most1);
    const double other = parts_.acceleration[k];
    range.keep(other * (a1 * p1 * p1 + v1 * d0), other * t * (a1 * p1 * t + v1), -most_a, most_a);
  }
  return range;
}

// So that value + slope p'' is between two bounds.
void StopBrake::Range::keep(double value, double slope, double least, double most) RT_SAFE {
  constexpr double flat = 1e-14;
  if (std::abs(slope) < flat) {
    if (value < least || value > most) *this = {1.0, -1.0};
    return;
  }
  const double per_slope = 1.0 / slope;
  const double one = (least - value) * per_slope;
  const double other = (most - value) * per_slope;
  low = std::max(low, std::min(one, other));
  high = std::min(high, std::max(one, other));
}

PaceStep StopBrake::step(const Pace& from, double second, double time) RT_SAFE {
  PaceStep step{.from = from, .second = second, .to = {}};
  step.to = step.after(time);
  step.advance = time * (from.rate + time * (0.5 * from.change + time * second / 6.0));
  step.advance = std::max(step.advance, 0.0);
  return step;
}

// Drafts a release.
bool StopBrake::has_release(double time, const Pace& from) RT_SAFE {
  Release& draft = releases_[1 - known_];
  draft.size = 0;
  Pace pace = from;
  while (pace.change != 0.0) {
    if (draft.size == steps_max || time + step_s_ * pace.rate > trace_.end()) return false;
    ++steps_;
    const Range range = seconds(time, pace);
    if (range.is_empty()) return false;
    const double wanted = -pace.change / step_s_;
    const double second =
        pace.change < 0.0 ? std::min(range.high, wanted) : std::max(range.low, wanted);
    if (!range.holds(second) || !stays_within(pace, second)) return false;
    const PaceStep next = step(pace, second, step_s_);
    draft.seconds[draft.size++] = second;
    time += next.advance;
    pace = next.to;
    if (std::abs(pace.change) < pace_rounding) pace.change = 0.0;
  }
  return true;
}

// Whether the rate is between 0 and 1 behind a step.
bool StopBrake::stays_within(const Pace& from, double second) const RT_SAFE {
  const double rate = from.rate + step_s_ * (from.change + 0.5 * step_s_ * second);
  return rate >= 0.0 && rate <= 1.0;
}

bool StopBrake::has_release_behind(const Pace& from, double second) RT_SAFE {
  const PaceStep next = step(from, second, step_s_);
  return stays_within(from, second) && has_release(time_ + next.advance, next.to);
}

// Two steps that end at rest, or the second of them.
std::optional<double> StopBrake::last_second(const Pace& from, const Range& range) const RT_SAFE {
  const double t = step_s_;
  const double one = -from.change / t;
  if (std::abs(from.rate + 0.5 * t * from.change) < pace_rounding && range.holds(one)) return one;
  const double first = -(from.rate + 1.5 * t * from.change) / (t * t);
  if (!range.holds(first)) return std::nullopt;
  const PaceStep next = step(from, first, step_s_);
  const double second = -next.to.change / t;
  const double time = time_ + next.advance;
  if (next.to.change > 0.0 || time + t * next.to.rate > trace_.end()) return std::nullopt;
  return seconds(time, next.to).holds(second) ? std::optional(first) : std::nullopt;
}

// The most negative p'' behind which there is a release, and that release.
double StopBrake::hardest(const Pace& from, const Range& range) RT_SAFE {
  const double known = known_second(from);
  double fails = range.low;
  if (range.is_empty() || fails >= known) return follow(from);
  double found = known;
  bool has_found = false;
  for (int tried = 0; tried < tries_max; ++tried) {
    const double second = tried == 0 ? fails : 0.5 * (fails + found);
    if (has_release_behind(from, second)) {
      has_found = true;
      found = second;
      known_ = 1 - known_;
      followed_ = 0;
      if (tried == 0) break;
    } else {
      fails = second;
    }
  }
  return has_found ? found : follow(from);
}

// Of the release that is known.
double StopBrake::known_second(const Pace& from) const RT_SAFE {
  const Release& known = releases_[known_];
  if (followed_ < known.size) return known.seconds[followed_];
  return -from.change / step_s_;
}

// The release that is known. What the trace does not tell between its instants is taken off, where
// there is a release behind that, too.
double StopBrake::follow(const Pace& from) RT_SAFE {
  const double second = known_second(from);
  if (followed_++ >= releases_[known_].size) return second;
  constexpr double times = (1.0 - (1.0 - reserve_followed) * reserve) / (1.0 - reserve);
  const Range range = seconds(time_, from, ends_, times);
  if (range.is_empty() || range.holds(second)) return second;
  const double kept = std::clamp(second, range.low, range.high);
  if (!has_release_behind(from, kept)) return second;
  known_ = 1 - known_;
  followed_ = 0;
  return kept;
}

// The next cycle of the step.
PaceStep StopBrake::take(const Pace& from) RT_SAFE {
  PaceStep next = step(from, second_, cycle_s_);
  cycle_ = (cycle_ + 1) % cycles_;
  if (cycle_ == 0) {
    if (std::abs(next.to.change) < pace_rounding) next.to.change = 0.0;
    if (next.to.change == 0.0 && next.to.rate < rate_at_rest) next.to.rate = 0.0;
  }
  time_ += next.advance;
  return next;
}

}  // namespace stanok::motion
