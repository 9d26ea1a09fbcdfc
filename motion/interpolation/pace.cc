#include "motion/interpolation/pace.h"

#include <algorithm>
#include <cmath>

namespace stanok::motion {
namespace {

// What the plan leaves of the limits of acceleration and of jerk.
double acceleration_left(const PaceLimits& limits, double rate) RT_SAFE {
  return std::max(1.0 - limits.use * rate * rate, 0.0);
}
double jerk_left(const PaceLimits& limits, double rate) RT_SAFE {
  return std::max(1.0 - limits.use * rate * rate * rate, 0.0);
}

// Of what the limits alone allow, the change p' uses so much.
constexpr double change_part = 0.9;

// Where the limits allow more, a cycle would be too coarse for what p does within it.
constexpr double change_fastest = 20.0;    // 1/s
constexpr double second_fastest = 4000.0;  // 1/s^2

// How much of the jerk that is left is for 3 p p' R; the rest is for p''. So much that p'' can take
// p' away as fast as its own limit falls while the rate rises: with p' = c (1 - u p^3) / (3 R) and
// p'' = (1 - c) (1 - u p^3) / Q that is c^2 Q / (3 R^2) + c <= 1; change_part is what a cycle
// needs.
double coupling_share(const PaceLimits& limits) RT_SAFE {
  const double thrust = limits.thrust;
  const double coupling = limits.coupling;
  if (!(coupling > 0.0)) return 0.0;
  const double k = thrust / (3.0 * coupling * coupling);
  return 2.0 / (1.0 + std::sqrt(1.0 + 4.0 * k));
}

double pace_second_max(const PaceLimits& limits, double rate) RT_SAFE {
  const double left = (1.0 - coupling_share(limits)) * jerk_left(limits, rate);
  return std::min(left / limits.thrust, second_fastest);
}

// The largest |p'| at a rate; the rate in 3 p p' R counts as 1.
double pace_change_max(const PaceLimits& limits, double rate) RT_SAFE {
  const double by_acceleration = acceleration_left(limits, rate) / limits.velocity;
  const double left = coupling_share(limits) * jerk_left(limits, rate);
  const double coupling = 3.0 * limits.coupling;
  const double change = coupling * by_acceleration > left ? left / coupling : by_acceleration;
  return std::min(change_part * change, change_fastest);
}

// The largest p' > 0 at a rate that p'' takes away before the rate is `target`: p'^2 / 2 is what
// p'' takes over the rates between.
double pace_rise_max(const PaceLimits& limits, double rate, double target) RT_SAFE {
  const double gap = std::max(target - rate, 0.0);
  const double squares = (rate + target) * (rate * rate + target * target);
  const double taken = gap * std::max(1.0 - 0.25 * limits.use * squares, 0.0) / limits.thrust;
  const double energy = std::min((1.0 - coupling_share(limits)) * taken, second_fastest * gap);
  return std::min(pace_change_max(limits, rate), change_part * std::sqrt(2.0 * energy));
}

}  // namespace

bool goes_on_from(const Pace& pace, const PaceLimits& limits, double time) RT_SAFE {
  if (!(pace.rate >= 0.0 && pace.rate <= 1.0)) return false;
  if (pace.change >= 0.0) return pace.change <= pace_rise_max(limits, pace.rate, 1.0);
  if (-pace.change > pace_change_max(limits, pace.rate)) return false;
  const double falls = 0.5 * pace.change * pace.change / pace_second_max(limits, pace.rate);
  return pace.rate > falls - 2.0 * pace.change * time;
}

// Both limits fall alike with the rate, but for what a cycle is too coarse for: that counts where
// the rate is low only.
double settling_time(const PaceLimits& limits) RT_SAFE {
  const double low = pace_change_max(limits, 0.0) / pace_second_max(limits, 0.0);
  if (limits.use >= 1.0F) return low;  // at the rate 1 nothing is left for a change
  const double high = pace_change_max(limits, 1.0) / pace_second_max(limits, 1.0);
  return std::max(low, high);
}

Pace PaceStep::after(double time) const RT_SAFE {
  const double rate = from.rate + time * (from.change + 0.5 * time * second);
  return {.rate = std::clamp(rate, 0.0, 1.0),  // rounding
          .change = from.change + time * second};
}

double PaceStep::time_of(double part, double duration) const RT_SAFE {
  double low = 0.0;
  double high = duration;
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) {
    const double t = 0.5 * (low + high);
    const double advanced = t * (from.rate + t * (0.5 * from.change + t * second / 6.0));
    (advanced < part ? low : high) = t;
  }
  return high;
}

// The change behind a step, of a rate that is `distance` from its target and comes nearer by
// `change`, so that steps of at most `braking` in p'' bring it to rest there. From n on, whatever
// n is, they need no more than n^2 / 2 braking + n time / 2.
double change_that_stops(double distance, double change, double braking, double time) RT_SAFE {
  const double least = braking * time;
  // With two more steps: what is left behind this one is what the last one takes.
  const double before_last = distance / time - 0.5 * change;
  if (before_last >= 0.0 && before_last <= least && std::abs(before_last - change) <= least)
    return before_last;
  const double squared = least * least + braking * (2.0 * distance - change * time);
  return -least + std::sqrt(std::max(squared, 0.0));
}

PaceStep step_pace(const Pace& from, double target, const PaceLimits& limits,
                   const PaceLimits& ahead, double time) RT_SAFE {
  const double gap = target - from.rate;
  PaceStep step{.from = from, .to = {}};
  // Mirrored, so that it rises towards the target.
  const double sign = gap > 0.0 || (gap == 0.0 && from.change > 0.0) ? 1.0 : -1.0;
  const double change = sign * from.change;
  const double distance = std::abs(gap);
  // The limits fall with the rate: those of the highest rate that the step can come to.
  const double rise =
      std::max(from.change, sign > 0.0 ? pace_rise_max(ahead, from.rate, target) : 0.0);
  const double highest = std::min(from.rate + rise * time, 1.0);
  const double second_max = pace_second_max(limits, highest);
  // The rate comes to rest at the target under the second derivative that is allowed there.
  const double braking = std::min(second_max, pace_second_max(limits, std::max(target, from.rate)));
  const double least = braking * time;
  constexpr double rounding = 1e-12;
  constexpr double part_unseen = 1e-6;  // of what a step can do
  const bool is_last =
      std::abs(distance - 0.5 * change * time) <= rounding + part_unseen * least * time &&
      std::abs(change) <= least + rounding;
  if (is_last) {
    step.second = -from.change / time;
    step.to = {.rate = target};
    step.advance = time * (from.rate + from.change * time / 3.0);
    return step;
  }
  const double stops = change_that_stops(distance, change, braking, time);
  // Farther from the target, what p'' may take away at the rates between; a step is fine enough
  // for that where p' is several times what it takes.
  constexpr double steps_min = 5.0;
  const double rising = sign > 0.0 ? pace_rise_max(ahead, highest, target) : 0.0;
  const double farther = rising > steps_min * least ? std::max(stops, rising) : stops;
  const double wanted = std::min(farther, pace_change_max(ahead, highest));
  const double next = std::clamp(wanted, change - second_max * time, change + second_max * time);
  step.second = sign * (next - change) / time;
  step.to = step.after(time);
  step.to.change = sign * next;
  step.advance = time * (from.rate + time * (0.5 * from.change + time * step.second / 6.0));
  step.advance = std::max(step.advance, 0.0);
  return step;
}

PaceStep keep_pace(const Pace& pace, double time) RT_SAFE {
  return {.from = pace, .to = {.rate = pace.rate}, .advance = time * pace.rate};
}

PathMotion at_pace(const PathMotion& planned, const Pace& pace, double second) RT_SAFE {
  const double p = pace.rate;
  const double d = pace.change;
  return {.s = planned.s,
          .v = p * planned.v,
          .a = p * p * planned.a + d * planned.v,
          .j = p * (p * p * planned.j + 3.0 * d * planned.a) + second * planned.v};
}

}  // namespace stanok::motion
