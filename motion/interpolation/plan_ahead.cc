#include "motion/interpolation/plan_ahead.h"

#include <algorithm>

#include "motion/profile/speed_segment.h"

namespace stanok::motion {
namespace {

// What a hold may need to come to rest, with room to spare.
constexpr double pause_time = 2.0;  // s
constexpr double pause_ramps = 2.0;

bool is_even(const Phase& phase) RT_SAFE {
  return phase.a == 0.0 && phase.j == 0.0 && phase.v > 0.0;
}

}  // namespace

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

bool raises_feed(const Segment& segment, const FeedControl& asked) RT_SAFE {
  return !asked.hold && asked.rapid_override == 1.0 && segment.process.kind == LawKind::none &&
         asked.feed_part(segment.process.rev_per_min) >= 1.0;
}

bool holds_feed(const Phase& phase, const Segment& segment) RT_SAFE {
  return is_even(phase) && phase.v == segment.feed_per_s;
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
    const bool counts = phase.pace.holds() || (kind == PlanKind::every && !is_even(phase));
    if (counts && phase.a == 0.0 && start >= s) return {.s = start, .v = phase.v};
  }
  return {};
}

}  // namespace stanok::motion
