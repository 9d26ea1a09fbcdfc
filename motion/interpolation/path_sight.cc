#include "motion/interpolation/path_sight.h"

#include <algorithm>

#include "motion/profile/speed_segment.h"

namespace stanok::motion {
namespace {

// How many of the first `count` segments lie before block `closed`; blocks ascend.
std::size_t open_segments(const PathQueue& queue, std::size_t count, std::uint64_t closed) RT_SAFE {
  std::size_t first = 0;
  while (first < count) {
    const std::size_t middle = first + (count - first) / 2;
    if (queue.segments[middle].tag.block < closed) {
      first = middle + 1;
    } else {
      count = middle;
    }
  }
  return first;
}

}  // namespace

PathSight::PathSight() : kept_(2 * segments_max) {}

void PathSight::look(const PathQueue& queue, const PathCursor& cursor, const FeedControl& control,
                     const Reach& reach, const PathWall& wall) RT_SAFE {
  queue_ = &queue;
  control_ = control;
  reach_ = reach;
  first_ = cursor.segment_number();
  size_ = std::min<std::size_t>(cursor.segments_seen(queue), segments_max);
  if (control.closed_from_block != FeedControl::no_gate) {
    size_ = std::max<std::size_t>(open_segments(queue, size_, control.closed_from_block), 1);
  }
  if (wall.segment != PathWall::no_segment) {
    const std::uint64_t behind = wall.segment >= first_ ? wall.segment - first_ + 1 : 1;
    size_ = std::min<std::size_t>(size_, behind);
  }
  wall_s_ = wall.s;
  starts_[0] = cursor.segment_start();
  starts_known_ = 0;
}

double PathSight::start(std::size_t index) RT_SAFE {
  while (starts_known_ < index) {
    starts_[starts_known_ + 1] = starts_[starts_known_] + limits_of(starts_known_).length;
    ++starts_known_;
  }
  return starts_[index];
}

// The part of the programmed feed that the present speed may come from.
double PathSight::highest_part(const Segment& segment) const RT_SAFE {
  double part = 1.0;
  const double rev_per_min = segment.process.rev_per_min;
  if (rev_per_min > 0.0) part = std::max(part, reach_.rev_per_min / rev_per_min);
  if (reach_.controlled_per_s > 0.0 && is_controlled(working_axes(segment)))
    part = std::max(part, reach_.controlled_per_s / segment.feed_per_s);
  return reach_.feed_override * part;
}

const PathSight::Limits& PathSight::limits_of(std::size_t index) RT_SAFE {
  const std::uint64_t number = first_ + index;
  Limits& kept = kept_[number % kept_.size()];
  if (kept.number == number && kept.reach == reach_) return kept;
  const Segment& segment = queue_->segments[index];
  const SpeedSegment nominal = speed_segment(segment, 1.0);
  const double part = highest_part(segment);
  const double own_part = part > 1.0 && !segment.rapid ? part : 1.0;
  const SpeedSegment limits = reach_.stop_limits > 1.0
                                  ? speed_segment_of_stop(segment, own_part, reach_.stop_limits)
                              : own_part > 1.0 ? speed_segment(segment, own_part)
                                               : nominal;
  kept = {.number = number,
          .reach = reach_,
          .length = segment.length,
          .feed = segment.rapid ? nominal.v : segment.feed_per_s,
          .v = limits.v,
          .ramp = limits.ramp,
          .rev_per_min = segment.process.rev_per_min,
          .working_axes = working_axes(segment),
          .rapid = segment.rapid,
          .has_law = segment.process.kind != LawKind::none};
  return kept;
}

double PathSight::asked_speed(std::size_t index) RT_SAFE {
  const Limits& limits = limits_of(index);
  if (control_.controlled_per_s > 0.0 && is_controlled(limits.working_axes)) {
    const double spindle = control_.spindle_part(limits.rev_per_min);
    const double law = limits.has_law ? spindle * limits.feed : unlimited;
    return std::min(limits.v, control_.feed_override * control_.law_part *
                                  std::min(control_.controlled_per_s, law));
  }
  const double part =
      limits.rapid ? control_.rapid_override : control_.feed_part(limits.rev_per_min);
  return std::min(limits.v, part * limits.feed);
}

std::size_t PathSight::segment_at(double s, std::size_t from) RT_SAFE {
  std::size_t index = from;
  while (index + 1 < size_ && s >= end(index)) ++index;
  return index;
}

}  // namespace stanok::motion
