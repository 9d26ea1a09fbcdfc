#include "motion/interpolation/path_brake.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/path/geometry.h"
#include "motion/path/sampling.h"

namespace stanok::motion {
namespace {

// Of the tangential limits, from attempt to attempt.
constexpr std::array parts{0.97, 0.6, 0.35, 0.2};
// Places that are proved are no farther from each other than this, nor than a part of a segment,
// and none is passed over.
constexpr double sample_time = 0.002;  // s
constexpr double sample_part = 1.0 / 12.0;
constexpr double use_max = 0.98;  // what the spacing, which is not even, may hide is less
constexpr std::size_t samples_max = 400;
constexpr double brake_rounding = 1e-9;

}  // namespace

std::optional<PhaseRun> PathBrake::find(const PathQueue& queue, const PathCursor& cursor,
                                        double wall, const PathMotion& from, UsedLimits used)
    RT_SAFE {
  queue_ = &queue;
  times_ = used == UsedLimits::of_stops ? stop_limits_ : 1.0;
  start_ = cursor.segment_start();
  seen_ = cursor.segments_seen(queue);
  const PhaseRun run = draft(from, times_ * parts[attempt_ % parts.size()]);
  ++attempt_;
  if (run.size() == 0 || run[run.size() - 1].s_end > wall) return std::nullopt;
  Place place{.start = start_};
  std::size_t samples = 0;
  for (const Phase& phase : run) {
    if (!keeps_limits(phase, place, samples)) return std::nullopt;
  }
  return run;
}

// Under a part of the tangential limits of the segments that it touches.
PhaseRun PathBrake::draft(const PathMotion& from, double part) const RT_SAFE {
  const auto limits_of = [&](std::size_t k) RT_SAFE {
    const SegmentBounds& bounds = queue_->segments[k].bounds;
    return RampLimits{.a = part / bounds.tangent, .j = part / bounds.thrust};
  };
  RampLimits limits = limits_of(0);
  if (eased_speed(from.v, from.a, limits.j) < 0.0) return {};
  PhaseRun run = change_speed(from, 0.0, limits);
  std::size_t last = 0;
  double end = start_ + queue_->segments[0].length;
  while (run.size() > 0 && run[run.size() - 1].s_end > end) {
    if (++last == seen_) return {};
    end += queue_->segments[last].length;
    const RampLimits lower = lower_of(limits, limits_of(last));
    if (lower.a == limits.a && lower.j == limits.j) continue;
    limits = lower;
    if (eased_speed(from.v, from.a, limits.j) < 0.0) return {};
    run = change_speed(from, 0.0, limits);
  }
  return run;
}

bool PathBrake::keeps_limits(const Phase& phase, Place& place, std::size_t& samples) const RT_SAFE {
  std::array<Uses, 3> uses;
  if (!sample(motion_at(phase, 0.0), place, uses[0])) return false;
  double t = 0.0;
  for (std::size_t k = 1; t < phase.duration; ++k) {
    if (++samples > samples_max) return false;
    const PathMotion motion = motion_at(phase, t);
    const double length = queue_->segments[place.segment].length;
    const double to_end = std::max(place.start + length - motion.s, brake_rounding * length);
    const double at_speed = std::min(
        sample_time, std::min(sample_part * length, to_end) / std::max(motion.v, brake_rounding));
    const double gained = std::max({motion.a, motion.a + phase.j * at_speed, 0.0}) * at_speed;
    const double slower = motion.v > 0.0 ? motion.v / (motion.v + gained) : 1.0;
    // No step is much shorter than the one before it for the end of the phase alone.
    const double left = phase.duration - t;
    const double step = std::min(slower * at_speed, 0.5 * phase.duration);
    t = step < left ? t + left / std::ceil(left / step - brake_rounding) : phase.duration;
    if (!sample(motion_at(phase, t), place, uses[k % 3])) return false;
    uses[k % 3].t = t;
    if (k < 2) continue;
    if (largest(uses[(k - 2) % 3], uses[(k - 1) % 3], uses[k % 3]) > use_max) return false;
  }
  return true;
}

// False: faster than the segment allows.
bool PathBrake::sample(const PathMotion& motion, Place& place, Uses& uses) const RT_SAFE {
  while (place.segment + 1 < seen_ &&
         motion.s >= place.start + queue_->segments[place.segment].length) {
    place.start += queue_->segments[place.segment++].length;
  }
  const Segment& segment = queue_->segments[place.segment];
  const double v_max = std::min(segment.feed_per_s, 1.0 / segment.bounds.chords);
  if (motion.v > v_max * (1.0 + brake_rounding)) return false;
  JetPoint point_s;
  JetPoint point;
  JetPoint axes;
  // The stored ends of a segment have no derivatives of their own: just beside them.
  constexpr double beside = 1e-12;
  evaluate(
      segment,
      std::clamp(motion.s - place.start, beside * segment.length, (1.0 - beside) * segment.length),
      point_s);
  along_time(point_s, motion.v, motion.a, motion.j, config_.axis_count, point);
  to_machine(segment, point, axes);
  for (int k = 0; k < config_.axis_count; ++k) {
    const AxisLimits& limits = config_.axes[k];
    const double speed_max = segment.rapid ? limits.rapid_speed_max() : limits.velocity_max;
    uses.velocity[k] = use_max * axes[k].first / (speed_max * (1.0 + brake_rounding));
    uses.acceleration[k] = axes[k].second / (times_ * limits.acceleration_max);
    uses.jerk[k] = axes[k].third / (times_ * limits.jerk_max);
  }
  return true;
}

// With what may lie between the three instants, by the parabola through them.
double PathBrake::largest(const Uses& before, const Uses& at, const Uses& behind) const RT_SAFE {
  const double h1 = at.t - before.t;
  const double h2 = behind.t - at.t;
  const double widest = std::max(h1, h2);
  const auto peak = [&](double f0, double f1, double f2) RT_SAFE {
    const double bends = 2.0 * std::abs((f2 - f1) / h2 - (f1 - f0) / h1) / (h1 + h2);
    return std::max({std::abs(f0), std::abs(f1), std::abs(f2)}) +
           between_samples * widest * widest * bends;
  };
  double use = 0.0;
  for (int k = 0; k < config_.axis_count; ++k) {
    use = std::max({use, peak(before.velocity[k], at.velocity[k], behind.velocity[k]),
                    peak(before.acceleration[k], at.acceleration[k], behind.acceleration[k]),
                    peak(before.jerk[k], at.jerk[k], behind.jerk[k])});
  }
  return use;
}

}  // namespace stanok::motion
