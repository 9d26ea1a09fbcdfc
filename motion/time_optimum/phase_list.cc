#include "motion/time_optimum/phase_list.h"

namespace stanok::motion {
namespace {

// The part of a phase between two places.
Phase part_of_phase(const Phase& phase, double s0, double s1) {
  Phase part = phase;
  const double t0 = s0 > phase.s ? time_at(phase, s0) : 0.0;
  const double t1 = s1 < phase.s_end ? time_at(phase, s1) : phase.duration;
  if (s0 > phase.s) {
    const PathMotion motion = motion_at(phase, t0);
    part.s = s0;
    part.v = motion.v;
    part.a = motion.a;
  }
  if (s1 < phase.s_end) {
    part.s_end = s1;
    part.v_end = motion_at(phase, t1).v;
  }
  part.duration = t1 - t0;
  return part;
}

}  // namespace

PathMotion motion_in(const Phase& phase, double s) {
  if (s <= phase.s) return {phase.s, phase.v, phase.a, phase.j};
  if (s < phase.s_end) return motion_at(phase, time_at(phase, s));
  return {phase.s_end, phase.v_end, phase.a + phase.j * phase.duration, phase.j};
}

PathMotion PhaseWalk::at(double s) {
  while (place_ + 1 < phases_.size() && phases_[place_].s_end < s) ++place_;
  return motion_in(phases_[place_], s);
}

void append_between(std::span<const Phase> phases, double s0, double s1, std::vector<Phase>& to) {
  for (const Phase& phase : phases) {
    if (phase.s_end > s0 && phase.s < s1) to.push_back(part_of_phase(phase, s0, s1));
  }
}

double duration_of(std::span<const Phase> phases) {
  double sum = 0.0;
  for (const Phase& phase : phases) sum += phase.duration;
  return sum;
}

}  // namespace stanok::motion
