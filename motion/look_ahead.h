// LookAhead: pieces of a chain in, committed jerk-limited profile out.
//
// How far it commits depends on content only: a chunk is committed when at least 1000 later blocks
// and the stopping distance are known, or the chain ends (docs/motion.md#commit). Chunks meet where
// a = 0. Owner: the channel's preparation.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "motion/path.h"
#include "motion/path_builder.h"
#include "motion/path_queue.h"

namespace stanok::motion {

class LookAhead {
 public:
  explicit LookAhead(const MotionConfig& config);

  // Takes a piece; plans and keeps committed chunks ready when content allows.
  void add(const PathBuilder::Built& built);

  // Moves committed chunks into the queue, whole chunks only. Returns false when one had no room.
  [[nodiscard]] bool deliver(PathQueue& queue);

  // Nothing is pending: all pieces taken were committed and delivered.
  [[nodiscard]] bool is_empty() const;

  // Drops everything (abort). The next piece starts at rest.
  void clear();

 private:
  // (implementation members follow here)
};

}  // namespace stanok::motion
