#include "motion/segments/corner_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
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

// The radius of the surroundings of a corner in which legs that are not straight may overlap, in
// reaches: at equal jerks 2^3.
constexpr double reaches_on_curves = 16.0;

bool is_line(const Segment& segment) {
  return segment.geometry.kind == SegmentKind::line;
}

bool is_line_or_arc(const Segment& segment) {
  return is_line(segment) || segment.geometry.kind == SegmentKind::arc;
}

// Machine axes per path length, at parameter `u`.
Point machine_direction(const Segment& segment, double u) {
  JetPoint point_s;
  JetPoint axes_M;
  evaluate_at_parameter(segment, u, point_s);
  to_machine(segment, point_s, axes_M);
  Point direction;
  for (std::size_t k = 0; k < axes_max; ++k) direction[k] = axes_M[k].first;
  return direction;
}

double time_of_phases(std::span<const Phase> phases) {
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
  return time_of_phases(braking) - time_of(braking, braking.back().s_end - distance);
}

double time_from_start(std::span<const Phase> starting, double distance) {
  return time_of(starting, starting.front().s + distance);
}

// The acceleration along the leg, in magnitude, at an instant or a cycle after it.
double acceleration_near(std::span<const Phase> phases, double t, double cycle_s) {
  const Moment one = moment_at(phases, std::clamp(t, 0.0, time_of_phases(phases)));
  const Moment other = moment_at(phases, std::clamp(t + cycle_s, 0.0, time_of_phases(phases)));
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

// Jets over time of the machine axes, and the speed of the path, while both legs move; `before`
// counts its way back from the corner, `behind` from there on.
struct SumOfLegs {
  JetPoint axes;
  double speed = 0.0;
};

SumOfLegs sum_of(const CurvedLegs& legs, const PathMotion& before, const PathMotion& behind,
                 int axis_count) {
  const auto on = [axis_count](const Segment& leg, double s, const PathMotion& motion) {
    JetPoint point_s;
    JetPoint point{};
    evaluate(leg, s, point_s);
    along_time(point_s, motion.v, motion.a, motion.j, axis_count, point);
    return point;
  };
  JetPoint point = on(legs.incoming, legs.incoming.length + before.s, before);
  const JetPoint next = on(legs.outgoing, behind.s, behind);
  SumOfLegs sum;
  double speed2 = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(axis_count); ++k) {
    point[k].value += next[k].value - legs.outgoing.geometry.start[k];
    point[k].first += next[k].first;
    point[k].second += next[k].second;
    point[k].third += next[k].third;
    if (legs.incoming.geometry.metric.counts(static_cast<int>(k)))
      speed2 += point[k].first * point[k].first;
  }
  to_machine(legs.incoming, point, sum.axes);
  sum.speed = std::sqrt(speed2);
  return sum;
}

// The same of legs that are not straight, at samples; the motions are those at the start.
bool keeps_limits_on_curves(const OverlapCorner& corner, const PathMotion& one,
                            const PathMotion& other, double duration, const MotionConfig& config) {
  constexpr std::size_t samples = 5;
  std::array<SumOfLegs, samples> sums;
  std::array<double, samples> values{};
  const auto most = [&](const auto& value) {
    std::ranges::transform(sums, values.begin(), value);
    return largest_with_margin(values);
  };
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = duration * static_cast<double>(i) / (samples - 1);
    sums[i] = sum_of(*corner.curved, motion_with_jerk(one, one.j, t),
                     motion_with_jerk(other, other.j, t), config.axis_count);
  }
  if (most([](const SumOfLegs& sum) { return sum.speed; }) > corner.speed_max) return false;
  for (int axis = 0; axis < config.axis_count; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const AxisLimits& limit = config.axes[k];
    const double velocity_max = corner.rapid ? limit.rapid_speed_max() : limit.velocity_max;
    if (most([k](const SumOfLegs& sum) { return sum.axes[k].first; }) > velocity_max) return false;
    if (most([k](const SumOfLegs& sum) { return sum.axes[k].second; }) > limit.acceleration_max)
      return false;
    if (most([k](const SumOfLegs& sum) { return sum.axes[k].third; }) > limit.jerk_max)
      return false;
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
  const double begin = time_of_phases(braking) - tau;
  const std::vector<double> instants = changes_of_jerk(braking, starting, tau);
  for (std::size_t k = 1; k < instants.size(); ++k) {
    const double half = 0.5 * (instants[k] - instants[k - 1]);
    const double middle = instants[k - 1] + half;
    const Moment one = moment_at(braking, begin + middle);
    const Moment other = moment_at(starting, middle);
    PathMotion before = motion_at(*one.phase, one.t - half);
    PathMotion behind = motion_at(*other.phase, other.t - half);
    before.s -= braking.back().s_end;
    behind.s -= starting.front().s;
    const bool keeps = corner.curved
                           ? keeps_limits_on_curves(corner, before, behind, 2.0 * half, config)
                           : keeps_limits(corner, before, behind, 2.0 * half, config);
    if (!keeps) return false;
  }
  return true;
}

// Curvature of a line or an arc at an end, in mm per mm^2 over the geometry axes.
double curvature_at(const Segment& segment, double u, const MotionConfig& config) {
  JetPoint point_s;
  evaluate_at_parameter(segment, u, point_s);
  double sum2 = 0.0;
  for (const int axis : config.geometry)
    if (axis >= 0) sum2 += point_s[axis].second * point_s[axis].second;
  return std::sqrt(sum2);
}

// On curves the directions of both legs differ by more than at the corner, by their curvature times
// the distance from there: the reach that keeps the tolerance is smaller.
double reach_on_curves(double reach, const Segment& incoming, const Segment& outgoing,
                       const Tolerance& tolerance, const MotionConfig& config) {
  const double curvature =
      curvature_at(incoming, 1.0, config) + curvature_at(outgoing, 0.0, config);
  return reach / (1.0 + curvature * reaches_on_curves * reach * reach / tolerance.mm);
}

}  // namespace

std::shared_ptr<const OverlapCorner> overlap_corner(const Segment& incoming,
                                                    const Segment& outgoing,
                                                    const Tolerance& tolerance,
                                                    const MotionConfig& config) {
  const bool may_overlap = is_line_or_arc(incoming) && is_line_or_arc(outgoing) &&
                           !has_singularity(incoming) && tolerance.mm > 0.0 && tolerance.deg > 0.0;
  if (!may_overlap) return nullptr;
  OverlapCorner corner{
      .reach = overlap_tolerance_used * corner_reach(incoming, outgoing, tolerance, config),
      .speed_max = std::min(incoming.feed_per_s, outgoing.feed_per_s),
      .incoming = machine_direction(incoming, 1.0),
      .outgoing = machine_direction(outgoing, 0.0),
      .rapid = incoming.rapid || outgoing.rapid};
  if (!is_line(incoming) || !is_line(outgoing) || !is_affine(incoming)) {
    corner.reach = reach_on_curves(corner.reach, incoming, outgoing, tolerance, config);
    corner.distance_max = reaches_on_curves * corner.reach;
    corner.curved = CurvedLegs{incoming, outgoing};
  }
  return std::make_shared<const OverlapCorner>(std::move(corner));
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
  double tau = std::min({time_before_end(braking, reach) + time_from_start(starting, reach),
                         time_before_end(braking, std::min(room.incoming, corner.distance_max)),
                         time_from_start(starting, std::min(room.outgoing, corner.distance_max))});
  constexpr double shorter = 0.9;
  constexpr int attempts = 24;
  for (int k = 0; k < attempts; ++k) {
    if (keeps_limits(corner, braking, starting, tau, config)) return tau;
    tau *= shorter;
  }
  return 0.0;
}

}  // namespace stanok::motion
