// ChainOverlap: a chain that begins within the end of the one before it: the axes move by the sum
// of both.
//
// Whether it begins is decided once, in the first cycle that comes into the overlap; once begun it
// is run as committed. Thread: the cycle. Owner: the interpolator. Invariant: while it runs, both
// chains are run in their committed phases.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class ChainOverlap {
 public:
  [[nodiscard]] bool runs() const RT_SAFE { return state_ == State::runs; }
  [[nodiscard]] bool is_undecided() const RT_SAFE { return state_ == State::undecided; }
  [[nodiscard]] bool is_refused() const RT_SAFE { return state_ == State::refused; }

  void begin() RT_SAFE { state_ = State::runs; }
  void refuse() RT_SAFE { state_ = State::refused; }
  // The current chain is over or dropped, and the next one does not run yet.
  void forget() RT_SAFE { *this = {}; }

  // The next chain stands `begun` after the start of its phases, of which `first_phase` is the
  // first; returns the path it has come on.
  [[nodiscard]] double advance(const PathQueue& queue, std::size_t first_phase, double begun)
      RT_SAFE;
  // Adds the next chain, which is in `segment`, to the point of the current one; the speed of both.
  [[nodiscard]] double add(const Segment& segment, int axis_count, JetPoint& point) const RT_SAFE;
  // The current chain has ended: the next one is the current one, and moves so.
  [[nodiscard]] PathMotion take_over() RT_SAFE;

 private:
  enum class State : std::uint8_t { undecided, runs, refused };

  State state_ = State::undecided;
  PathMotion motion_;  // along the first chunk of the next chain
};

}  // namespace stanok::motion
