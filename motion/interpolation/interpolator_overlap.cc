// Chains that begin within the end of the one before them: the axes move by the sum of both.
#include <cmath>

#include "motion/interpolation/interpolator.h"
#include "motion/path/geometry.h"

namespace stanok::motion {
namespace {

// State `t` after the start of the phases from `first` on.
PathMotion motion_after(const PathQueue& queue, std::size_t first, double t) RT_SAFE {
  while (first + 1 < queue.phases.size() && t >= queue.phases[first].duration) {
    t -= queue.phases[first++].duration;
  }
  return motion_at(queue.phases[first], t);
}

}  // namespace

// Runs the next chain as far as it overlaps the end of the current one. It begins in the first
// cycle that comes into the overlap, or not at all; once begun it is run as committed.
void Interpolator::run_overlap(const PathQueue& queue, const FeedControl& control,
                               std::uint64_t chunk_limit) RT_SAFE {
  const double overlap = cursor_.chunk().overlap_s;
  if (overlap <= 0.0 || !is_nominal_ || overlap_ == Overlap::refused) return;
  const double begun = overlap - time_to_end(queue, overlap);
  if (begun <= 0.0) return;
  if (overlap_ == Overlap::undecided) {
    const bool begins = control.is_nominal() && may_enter(queue, control, chunk_limit);
    overlap_ = begins ? Overlap::runs : Overlap::refused;
    if (!begins) return;
  }
  const PathMotion motion = motion_after(queue, cursor_.phases_left(), begun);
  advanced_ += motion.s - next_motion_.s;
  next_motion_ = motion;
}

// Time that the committed phases of the current chunk still take, or more than `farthest`.
double Interpolator::time_to_end(const PathQueue& queue, double farthest) const RT_SAFE {
  if (!cursor_.has_phase()) return 0.0;
  double time = -(phase_time_first_ + phase_cycles_ * cycle_s_);
  for (std::uint32_t k = 0; k < cursor_.phases_left() && time <= farthest; ++k) {
    time += queue.phases[k].duration;
  }
  return time;
}

// The current chain has ended, the next one runs already.
void Interpolator::enter_overlapped(PathQueue& queue) RT_SAFE {
  phase_time_first_ = cursor_.chunk().overlap_s;
  phase_cycles_ = 0.0;
  interruption_.end_chain(cursor_.chunk().length);
  cursor_.leave(queue);
  ++chunks_done_;
  cursor_.enter(queue);
  interruption_.begin_chain(cursor_);
  motion_ = next_motion_;
  next_motion_ = {};
  overlap_ = Overlap::undecided;
}

// The axes move by the sum of both chains: the end of one segment is the start of the other.
void Interpolator::add_next_chain(const PathQueue& queue, InterpolatorOutput& out) const RT_SAFE {
  const Segment& segment = queue.segments[cursor_.segments_left()];
  const PathMetric& metric = segment.geometry.metric;
  JetPoint point_s;
  JetPoint next{};
  evaluate(segment, next_motion_.s, point_s);
  along_time(point_s, next_motion_.v, next_motion_.a, next_motion_.j, axis_count_, next);
  double speed2 = 0.0;
  for (int k = 0; k < axis_count_; ++k) {
    kinematics::Jet& sum = out.point[k];
    sum.value += next[k].value - segment.geometry.start[k];
    sum.first += next[k].first;
    sum.second += next[k].second;
    sum.third += next[k].third;
    if (metric.counts(k)) speed2 += sum.first * sum.first;
  }
  out.s_speed = std::sqrt(speed2);
}

}  // namespace stanok::motion
