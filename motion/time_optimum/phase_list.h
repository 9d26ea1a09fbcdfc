// Phases one after another: what they do at a place, and between two places.
#pragma once

#include <span>
#include <vector>

#include "motion/profile/profile.h"

namespace stanok::motion {

// The motion at `s`, which lies within the phase or at its ends.
[[nodiscard]] PathMotion motion_in(const Phase& phase, double s);

// Walks along phases towards larger s.
class PhaseWalk {
 public:
  explicit PhaseWalk(std::span<const Phase> phases) : phases_(phases) {}
  // The motion at `s`, not before the last one asked for.
  [[nodiscard]] PathMotion at(double s);

 private:
  std::span<const Phase> phases_;
  std::size_t place_ = 0;
};

// Appends what phases do between two places; phases that reach beyond are cut.
void append_between(std::span<const Phase> phases, double s0, double s1, std::vector<Phase>& to);

[[nodiscard]] double duration_of(std::span<const Phase> phases);

}  // namespace stanok::motion
