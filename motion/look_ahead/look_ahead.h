// LookAhead: segments of a chain in, committed jerk-limited profile out.
//
// How far it commits depends on content only: a chunk is committed when at least 1000 later blocks
// and the stopping distance are known, or the chain ends (docs/developer/motion.md#commit); commits
// end where a = 0. Owner: the channel's preparation.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "motion/look_ahead/delivered_chunks.h"
#include "motion/look_ahead/speed_plan.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/segments/path_builder.h"
#include "motion/threads/thread_builder.h"
#include "motion/time_optimum/plan_improvement.h"

namespace stanok::motion {

class LookAhead {
 public:
  static constexpr std::uint64_t blocks_beyond = 1000;  // known beyond what is committed
  // The queue holds several chunks of this size; one more segment may bring the phases over it.
  static constexpr std::size_t chunk_segments_max = 2048;
  static constexpr std::size_t chunk_phases_max = 8192;

  explicit LookAhead(const MotionConfig& config);

  // Takes a segment; plans and keeps committed chunks ready when content allows.
  void add(const PathBuilder::Built& built);

  // A chain that a spindle leads, whole; the chain before has ended.
  void add(ThreadChain chain);

  // Moves committed chunks into the queue, whole chunks only. Returns false when one had no room.
  // The end of a chain that the next one may overlap waits for the start of that one, which is
  // never farther away than the next end of a chain.
  [[nodiscard]] bool deliver(PathQueue& queue);

  // How long what was delivered and the consumer has not done with takes, by whole chunks.
  [[nodiscard]] double seconds_in(const PathQueue& queue) { return delivered_.seconds_in(queue); }
  [[nodiscard]] double seconds_free_in(const PathQueue& queue) {
    return delivered_.seconds_free_in(queue);
  }

  // Nothing is pending: all segments taken were committed and delivered.
  [[nodiscard]] bool is_empty() const;

  // Drops everything (abort). The next segment starts at rest.
  void clear();

 private:
  struct Committed {
    std::vector<Segment> segments;
    std::vector<Phase> phases;
    Chunk chunk;
    // The next chain may overlap the end of this chunk; how long, its start will tell.
    std::shared_ptr<const OverlapCorner> overlap;
  };
  // Segments whose phases are known, from the end of the last chunk on.
  struct Planned {
    std::vector<Segment> segments;
    std::vector<double> jerk_parts;
    std::vector<std::uint64_t> blocks;
    std::vector<Phase> phases;  // s from their start
    double length = 0.0;
  };
  // Of a chain.
  struct ChainEnd {
    std::shared_ptr<const OverlapCorner> overlap;
    double stand_mm = 0.0;
  };
  // A state with a = 0 after so many segments, s of path.
  struct RestKey {
    std::size_t segments = 0;
    double s = 0.0;
    double v = 0.0;
  };

  // What is known behind the window: more of the chain to come, or that it ends there.
  enum class Behind : std::uint8_t { more, end };

  void plan_window(Behind behind);
  void commit(std::size_t boundary, Behind behind);
  void take(std::size_t segments, std::vector<Phase>& phases);
  [[nodiscard]] std::size_t count_to_commit() const;
  void commit_chunks(std::size_t segments, Behind behind);
  [[nodiscard]] std::size_t end_of_chunk(std::size_t first, double s_first,
                                         std::size_t segments) const;
  void decide_overlap(Committed& end, const Committed& start) const;
  void run_last_plan_on(Behind behind);
  void forget(std::size_t segments, double v);

  [[nodiscard]] std::size_t last_boundary_to_commit() const;
  [[nodiscard]] std::size_t cut_at_or_before(std::size_t boundary) const;
  [[nodiscard]] std::optional<std::size_t> last_held(const KeySpan& span,
                                                     std::size_t boundary) const;
  [[nodiscard]] bool is_feed(double v, std::size_t boundary) const;
  [[nodiscard]] bool begins_at_limit(const KeySpan& span) const;
  [[nodiscard]] std::size_t start_of_last_descent() const;

  // The current chain from what is planned on: segments, their limits, and how many blocks were
  // known when each one came.
  MotionConfig config_;
  std::vector<Segment> window_;
  std::vector<SpeedSegment> speeds_;
  std::vector<double> jerk_parts_;  // of the segments, that their ramps use
  std::vector<std::uint64_t> blocks_;
  ChainEnd chain_end_;
  double v_start_ = 0.0;
  std::uint64_t plan_at_blocks_ = 2 * blocks_beyond;

  SpeedPlan plan_;
  PlanImprovement improvement_;
  std::vector<Phase> phases_;  // of the plan, s from the start of the window
  Planned planned_;
  // What the last plan held for the segments it did not commit: a way to rest, always, and the key
  // points on it.
  struct Rest {
    std::vector<Phase> phases;
    std::vector<RestKey> keys;
  };
  Rest rest_;

  std::deque<Committed> ready_;
  DeliveredChunks delivered_;
};

}  // namespace stanok::motion
