#include "motion/interpolation/chain_overlap.h"

#include <cmath>

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

double ChainOverlap::advance(const PathQueue& queue, std::size_t first_phase, double begun)
    RT_SAFE {
  const double before = motion_.s;
  motion_ = motion_after(queue, first_phase, begun);
  return motion_.s - before;
}

PathMotion ChainOverlap::take_over() RT_SAFE {
  const PathMotion motion = motion_;
  motion_ = {};
  state_ = State::undecided;
  return motion;
}

// The end of one segment is the start of the other.
double ChainOverlap::add(const Segment& segment, int axis_count, JetPoint& point) const RT_SAFE {
  JetPoint point_s;
  JetPoint next{};
  evaluate(segment, motion_.s, point_s);
  along_time(point_s, motion_.v, motion_.a, motion_.j, axis_count, next);
  double speed2 = 0.0;
  for (int k = 0; k < axis_count; ++k) {
    kinematics::Jet& sum = point[k];
    sum.value += next[k].value - segment.geometry.start[k];
    sum.first += next[k].first;
    sum.second += next[k].second;
    sum.third += next[k].third;
    if (segment.geometry.metric.counts(k)) speed2 += sum.first * sum.first;
  }
  return std::sqrt(speed2);
}

}  // namespace stanok::motion
