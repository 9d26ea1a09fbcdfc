#include "motion/segments/corner_overlap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/path/deviation.h"
#include "motion/path/geometry.h"
#include "motion/path/sampling.h"
#include "motion/profile/profile.h"

namespace stanok::motion {
namespace {

// Part of the tolerance that overlaps use; the rest is for sum_rounding of every kind.
constexpr double overlap_tolerance_used = 0.99;

// Sums of limits that hold exactly may exceed 1 by their sum_rounding.
constexpr double sum_rounding = 1e-12;

// Machine axes per path length.
Point machine_direction(const Segment& line) {
  JetPoint point_s;
  JetPoint axes_M;
  evaluate_at_parameter(line, 0.0, point_s);
  to_machine(line, point_s, axes_M);
  Point direction;
  for (std::size_t k = 0; k < axes_max; ++k) direction[k] = axes_M[k].first;
  return direction;
}

double duration_of(std::span<const Phase> phases) {
  double sum = 0.0;
  for (const Phase& phase : phases) sum += phase.duration;
  return sum;
}

// A phase of a run of phases, and the time within it.
struct Moment {
  const Phase* phase = nullptr;
  double t = 0.0;
};

Moment moment_at(std::span<const Phase> phases, double t) {
  for (const Phase& phase : phases.first(phases.size() - 1)) {
    if (t < phase.duration) return {&phase, t};
    t -= phase.duration;
  }
  return {&phases.back(), t};
}

// When the phases come to `s`; s grows with the time.
double time_of(std::span<const Phase> phases, double s) {
  double time = 0.0;
  for (const Phase& phase : phases) {
    if (s <= phase.s) return time;
    if (s < phase.s_end) return time + time_at(phase, s);
    time += phase.duration;
  }
  return time;
}

// How long before its end a braking is still `distance` from there.
double time_before_end(std::span<const Phase> braking, double distance) {
  return duration_of(braking) - time_of(braking, braking.back().s_end - distance);
}

double time_from_start(std::span<const Phase> starting, double distance) {
  return time_of(starting, starting.front().s + distance);
}

// The acceleration along the leg, in magnitude, at an instant or a cycle after it.
double acceleration_near(std::span<const Phase> phases, double t, double cycle_s) {
  const Moment one = moment_at(phases, std::clamp(t, 0.0, duration_of(phases)));
  const Moment other = moment_at(phases, std::clamp(t + cycle_s, 0.0, duration_of(phases)));
  return std::max(std::abs(motion_at(*one.phase, one.t).a),
                  std::abs(motion_at(*other.phase, other.t).a));
}

// The chord between two setpoints passes the corner farther off than the axes do, by a T^2 / 8:
// how much of the reach that takes.
double chord_share(double reach, std::span<const Phase> braking, std::span<const Phase> starting,
                   double cycle_s) {
  const double before = time_of(braking, braking.back().s_end - reach);
  const double after = time_from_start(starting, reach);
  return 0.125 * cycle_s * cycle_s *
         std::max(acceleration_near(braking, before - cycle_s, cycle_s),
                  acceleration_near(starting, after, cycle_s));
}

// The largest |v + a t + j t^2 / 2| over a duration.
double peak(double v, double a, double j, double duration) {
  const auto value = [=](double t) { return std::abs(v + t * (a + 0.5 * t * j)); };
  const double crest = j != 0.0 ? -a / j : -1.0;
  const double ends = std::max(value(0.0), value(duration));
  return crest > 0.0 && crest < duration ? std::max(ends, value(crest)) : ends;
}

// Whether the sum of two motions along the legs, of constant jerk for `duration`, keeps the limits.
bool keeps_limits(const OverlapCorner& corner, const PathMotion& one, const PathMotion& other,
                  double duration, const MotionConfig& config) {
  constexpr double allowed = 1.0 + sum_rounding;
  if (peak(one.v + other.v, one.a + other.a, one.j + other.j, duration) >
      corner.speed_max * allowed) {
    return false;
  }
  for (int k = 0; k < config.axis_count; ++k) {
    const AxisLimits& limit = config.axes[k];
    const double velocity_max = corner.rapid ? limit.rapid_speed_max() : limit.velocity_max;
    const double v = one.v * corner.incoming[k] + other.v * corner.outgoing[k];
    const double a = one.a * corner.incoming[k] + other.a * corner.outgoing[k];
    const double j = one.j * corner.incoming[k] + other.j * corner.outgoing[k];
    const double a_max = std::max(std::abs(a), std::abs(a + j * duration));
    if (peak(v, a, j, duration) > velocity_max * allowed) return false;
    if (a_max > limit.acceleration_max * allowed) return false;
    if (std::abs(j) > limit.jerk_max * allowed) return false;
  }
  return true;
}

// Instants within an overlap of `tau`, counted from its start, at which a jerk changes.
std::vector<double> changes_of_jerk(std::span<const Phase> braking, std::span<const Phase> starting,
                                    double tau) {
  std::vector<double> instants{0.0, tau};
  double before_end = 0.0;
  for (std::size_t k = braking.size(); k > 0; --k) {
    before_end += braking[k - 1].duration;
    if (before_end < tau) instants.push_back(tau - before_end);
  }
  double after_start = 0.0;
  for (const Phase& phase : starting) {
    after_start += phase.duration;
    if (after_start < tau) instants.push_back(after_start);
  }
  std::ranges::sort(instants);
  return instants;
}

bool keeps_limits(const OverlapCorner& corner, std::span<const Phase> braking,
                  std::span<const Phase> starting, double tau, const MotionConfig& config) {
  const double begin = duration_of(braking) - tau;
  const std::vector<double> instants = changes_of_jerk(braking, starting, tau);
  for (std::size_t k = 1; k < instants.size(); ++k) {
    const double half = 0.5 * (instants[k] - instants[k - 1]);
    const double middle = instants[k - 1] + half;
    const Moment one = moment_at(braking, begin + middle);
    const Moment other = moment_at(starting, middle);
    if (!keeps_limits(corner, motion_at(*one.phase, one.t - half),
                      motion_at(*other.phase, other.t - half), 2.0 * half, config)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<OverlapCorner> overlap_corner(const Segment& incoming, const Segment& outgoing,
                                            const Tolerance& tolerance,
                                            const MotionConfig& config) {
  const bool straight = incoming.geometry.kind == SegmentKind::line &&
                        outgoing.geometry.kind == SegmentKind::line && is_affine(incoming);
  if (!straight || tolerance.mm <= 0.0 || tolerance.deg <= 0.0) return std::nullopt;
  return OverlapCorner{
      .reach = overlap_tolerance_used * corner_reach(incoming, outgoing, tolerance, config),
      .speed_max = std::min(incoming.feed_per_s, outgoing.feed_per_s),
      .incoming = machine_direction(incoming),
      .outgoing = machine_direction(outgoing),
      .rapid = incoming.rapid || outgoing.rapid};
}

double jerk_part_allowed(const OverlapCorner& corner, double jerk_incoming, double jerk_outgoing,
                         const MotionConfig& config) {
  double part = 1.0;
  for (int k = 0; k < config.axis_count; ++k) {
    const double sum =
        std::abs(jerk_incoming * corner.incoming[k] + jerk_outgoing * corner.outgoing[k]);
    if (sum * part > config.axes[k].jerk_max) part = config.axes[k].jerk_max / sum;
  }
  return part;
}

std::span<const Phase> last_ramp(std::span<const Phase> phases) {
  std::size_t first = phases.size();
  const auto brakes = [](const Phase& phase) {
    return phase.a < 0.0 || (phase.a == 0.0 && phase.j < 0.0);
  };
  while (first > 0 && brakes(phases[first - 1])) --first;
  return phases.subspan(first);
}

std::span<const Phase> first_ramp(std::span<const Phase> phases) {
  std::size_t count = 0;
  const auto starts = [](const Phase& phase) {
    return phase.a > 0.0 || (phase.a == 0.0 && phase.j > 0.0);
  };
  while (count < phases.size() && starts(phases[count])) ++count;
  return phases.first(count);
}

double overlap_duration(const OverlapCorner& corner, std::span<const Phase> braking,
                        std::span<const Phase> starting, const OverlapRoom& room,
                        const MotionConfig& config) {
  if (braking.empty() || starting.empty()) return 0.0;
  const double reach = corner.reach - chord_share(corner.reach, braking, starting, config.cycle_s);
  if (reach <= 0.0) return 0.0;
  double tau =
      std::min({time_before_end(braking, reach) + time_from_start(starting, reach),
                time_before_end(braking, room.incoming), time_from_start(starting, room.outgoing)});
  constexpr double shorter = 0.9;
  constexpr int attempts = 24;
  for (int k = 0; k < attempts; ++k) {
    if (keeps_limits(corner, braking, starting, tau, config)) return tau;
    tau *= shorter;
  }
  return 0.0;
}

}  // namespace stanok::motion
