#include "motion/interpolation/plan_ahead.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation/pace.h"
#include "motion/profile/speed_segment.h"

namespace stanok::motion {
namespace {

// What a hold may need to come to rest, with room to spare.
constexpr double pause_time = 2.0;  // s
constexpr double pause_ramps = 2.0;

bool is_at_one_speed(const Phase& phase) RT_SAFE {
  return phase.a == 0.0 && phase.j == 0.0 && phase.v > 0.0;
}

// What a phase of ramps uses of its limits on a segment, as PaceLimits says it.
PaceLimits limits_of_ramp(const Phase& phase, const SegmentBounds& bounds) RT_SAFE {
  const double a_end = phase.a + phase.j * phase.duration;
  const double a = std::max(std::abs(phase.a), std::abs(a_end));
  const bool has_peak = phase.a > 0.0 && a_end < 0.0;
  const double peak = has_peak ? phase.v - 0.5 * phase.a * phase.a / phase.j : 0.0;
  const double v = std::max({phase.v, phase.v_end, peak});
  const double acceleration = v * v * bounds.curvature + a * bounds.tangent;
  const double jerk =
      v * (v * v * bounds.aberrancy + 3.0 * a * bounds.bend) + std::abs(phase.j) * bounds.thrust;
  return {.use = static_cast<float>(std::min(std::max(acceleration, jerk), 1.0)),
          .velocity = static_cast<float>(v * bounds.tangent),
          .thrust = static_cast<float>(v * bounds.thrust),
          .coupling = static_cast<float>(v * v * bounds.bend + a * bounds.thrust)};
}

// Goes along the segments with the phases of a plan.
class SegmentWalk {
 public:
  SegmentWalk(const PathQueue& queue, const PathCursor& cursor) RT_SAFE
      : queue_(queue),
        start_(cursor.segment_start()),
        seen_(cursor.segments_seen(queue)) {}

  // Of a phase of ramps on all segments between two places; later calls ask for later ones.
  [[nodiscard]] PaceLimits limits(const Phase& phase, double from, double to) RT_SAFE {
    while (index_ + 1 < seen_ && start_ + length() <= from) next();
    PaceLimits limits = limits_of_ramp(phase, queue_.segments[index_].bounds);
    while (index_ + 1 < seen_ && start_ + length() < to) {
      next();
      limits = highest_of(limits, limits_of_ramp(phase, queue_.segments[index_].bounds));
    }
    return limits;
  }
  [[nodiscard]] std::size_t passed() const RT_SAFE { return index_; }

 private:
  [[nodiscard]] double length() const RT_SAFE { return queue_.segments[index_].length; }
  void next() RT_SAFE {
    start_ += length();
    ++index_;
  }

  const PathQueue& queue_;
  double start_;
  std::size_t seen_;
  std::size_t index_ = 0;
};

// In `time` from s on, at the speeds of a phase.
double place_within(const Phase& phase, double s, double time) RT_SAFE {
  return s + time * std::max(phase.v, phase.v_end);
}

}  // namespace

PaceRoom pace_room(const PathQueue& queue, const PathCursor& cursor, double s, double elapsed,
                   double time) RT_SAFE {
  constexpr std::size_t seen_max = 512;  // phases, and segments
  const Phase& current = cursor.phase(queue);
  SegmentWalk walk(queue, cursor);
  const bool has_pace = current.pace.holds();
  PaceRoom room;
  room.here =
      has_pace ? current.pace : walk.limits(current, s, place_within(current, s, 2.0 * time));
  room.ahead = room.here;
  const double soon = 2.0 * settling_time(room.here);
  const std::size_t own = cursor.phases_left();
  const std::size_t known = std::min(seen_max, cursor.chunk().last ? own : queue.phases.size());
  double passed = -elapsed;
  for (std::size_t k = 0; k < known && passed < soon && walk.passed() < seen_max; ++k) {
    const Phase& phase = queue.phases[k];
    const double offset = k < own ? 0.0 : cursor.chunk().length;
    const double from = std::max(phase.s + offset, s);
    PaceLimits limits = phase.pace;
    if (!limits.holds()) {
      limits = walk.limits(
          phase, from,
          std::min(phase.s_end + offset, place_within(phase, from, soon - std::max(passed, 0.0))));
      if (phase.a != 0.0 || phase.j != 0.0) limits.use = 1.0F;  // in places
    }
    room.ahead = highest_of(room.ahead, limits);
    passed += phase.duration;
  }
  return room;
}

double gate_ahead(const PathQueue& queue, const PathCursor& cursor, const FeedControl& control,
                  const PathMotion& motion) RT_SAFE {
  if (control.closed_from_block == FeedControl::no_gate) return unlimited;
  const RampLimits limits = speed_segment(cursor.segment(queue), 1.0).ramp;
  const double farthest =
      motion.s + pause_time * motion.v + pause_ramps * ramp_distance(motion.v, 0.0, limits);
  const std::uint32_t seen = cursor.segments_seen(queue);
  double s = cursor.segment_start();
  for (std::uint32_t k = 0; k < seen && s <= farthest; ++k) {
    if (k > 0 && queue.segments[k].tag.block >= control.closed_from_block) return s;
    s += queue.segments[k].length;
  }
  return unlimited;
}

double asked_pace(const Segment& segment, const FeedControl& asked) RT_SAFE {
  if (asked.hold) return 0.0;
  const double part =
      segment.rapid ? asked.rapid_override : asked.feed_part(segment.process.rev_per_min);
  return std::min(part, 1.0);
}

bool brakes_along_plan(const PathQueue& queue, const PathCursor& cursor, const FeedControl& asked,
                       const PathMotion& motion) RT_SAFE {
  if (!cursor.has_phase()) return false;
  const Phase& phase = cursor.phase(queue);
  if (phase.pace.holds()) return true;
  const bool is_even = phase.a == 0.0 && phase.j == 0.0;
  if (!is_even || cursor.segment(queue).geometry.kind == SegmentKind::line) return false;
  const bool knows_next = cursor.chunk().last || !queue.chunks.empty();
  return knows_next && gate_ahead(queue, cursor, asked, motion) == unlimited;
}

bool raises_feed(const Segment& segment, const FeedControl& asked) RT_SAFE {
  return !asked.hold && asked.rapid_override == 1.0 && segment.process.kind == LawKind::none &&
         asked.feed_part(segment.process.rev_per_min) >= 1.0;
}

bool holds_feed(const Phase& phase, const Segment& segment) RT_SAFE {
  return is_at_one_speed(phase) && phase.v == segment.feed_per_s;
}

double rest_distance(const PathQueue& queue, const PathCursor& cursor, double s, double v,
                     double part) RT_SAFE {
  const std::uint32_t seen = cursor.segments_seen(queue);
  RampLimits limits = speed_segment(queue.segments[0], part).ramp;
  double distance = ramp_distance(0.0, v, limits);
  double end = cursor.segment_start() + queue.segments[0].length;
  for (std::uint32_t k = 1; k < seen && s + distance > end; ++k) {
    limits = lower_of(limits, speed_segment(queue.segments[k], part).ramp);
    distance = ramp_distance(0.0, v, limits);
    end += queue.segments[k].length;
  }
  return distance;
}

PlanStart next_plan_start(const PathQueue& queue, const PathCursor& cursor, PlanKind kind, double s,
                          double farthest) RT_SAFE {
  constexpr std::size_t phases_seen = 64;
  const std::size_t own = cursor.phases_left();
  const std::size_t seen = std::min(phases_seen, cursor.chunk().last ? own : queue.phases.size());
  for (std::size_t k = 0; k < seen; ++k) {
    const Phase& phase = queue.phases[k];
    const double start = phase.s + (k < own ? 0.0 : cursor.chunk().length);
    if (start > farthest) break;
    const bool counts = phase.pace.holds() || (kind == PlanKind::every && !is_at_one_speed(phase));
    if (counts && phase.a == 0.0 && start >= s) return {.s = start, .v = phase.v};
  }
  return {};
}

}  // namespace stanok::motion
