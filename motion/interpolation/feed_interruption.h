// FeedInterruption: the feed interrupted by the operator, on path that is committed already.
//
// After each L_B of real path at feed the axes rest for an equivalent dwell path L_A, as under the
// law of a block (motion/feed_laws/interrupted_law.h), but the places are found in the cycle: the
// place of the next rest is a wall for the override planner, a place on the path itself, so that
// override and hold do not move it. The first rest is as soon as the path can come to it. Rapid
// moves, threads and blocks of rotary axes alone are neither counted nor interrupted. Real-time.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/interpolation/path_sight.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

struct InterruptionLengths {
  double stand_mm = 0.0;  // L_A; 0: the feed is not interrupted
  double cut_mm = 0.0;    // L_B
  friend bool operator==(const InterruptionLengths&, const InterruptionLengths&) = default;
};

// The feed that turns the equivalent dwell path into a time.
struct StandFeed {
  double per_s = 0.0;        // mm/s
  double rev_per_min = 0.0;  // that it is planned for; 0: feed per time
};

class FeedInterruption {
 public:
  explicit FeedInterruption(const MotionConfig& config);

  // From now on, or no longer; the path moves so.
  void set(const InterruptionLengths& lengths, const PathCursor& cursor, const PathMotion& motion)
      RT_SAFE;
  [[nodiscard]] const InterruptionLengths& lengths() const RT_SAFE { return lengths_; }
  [[nodiscard]] bool is_on() const RT_SAFE { return lengths_.stand_mm > 0.0; }
  [[nodiscard]] std::uint64_t count() const RT_SAFE { return count_; }  // rests so far

  // The coordinate s counts from the start of a chunk: of a chain's first one, or of a later one
  // that lies `length` behind the one before; the end of a chain of such a length.
  void begin_chain(const PathCursor& cursor) RT_SAFE;
  void shift(double length) RT_SAFE;
  void end_chain(double length) RT_SAFE;

  // Looks for the next rest on the path that is known; once a round, before the path moves on.
  void look(const PathQueue& queue, const PathCursor& cursor, double s) RT_SAFE;
  // The path must come to rest at once: for the first time.
  [[nodiscard]] bool holds(const Segment& segment) const RT_SAFE {
    return is_first_ && is_counted(segment);
  }
  // Where the path comes to rest at the latest.
  [[nodiscard]] const PathWall& wall() const RT_SAFE { return wall_; }

  // At rest at s: whether this is the place of a rest.
  [[nodiscard]] bool is_due(const Segment& segment, double s) const RT_SAFE;
  // The rest begins; the next one is sought behind it.
  [[nodiscard]] StandFeed stand(const PathQueue& queue, const PathCursor& cursor, double s) RT_SAFE;

 private:
  [[nodiscard]] bool is_counted(const Segment& segment) const RT_SAFE;
  [[nodiscard]] double counted_until(const PathQueue& queue, const PathCursor& cursor,
                                     double s) const RT_SAFE;
  void seek(const PathCursor& cursor, double counted_mm) RT_SAFE;

  unsigned geometry_axes_ = 0;  // bit k: channel axis k
  InterruptionLengths lengths_;
  bool is_first_ = false;
  bool is_found_ = false;  // the wall is the place of the next rest, not just as far as was looked
  std::uint64_t count_ = 0;
  PathWall wall_;
  StandFeed feed_;                  // at the place found
  std::uint64_t next_segment_ = 0;  // number of the first segment that was not looked at
  double next_s_ = 0.0;             // where it begins
  double left_mm_ = 0.0;            // from there to the next rest
};

}  // namespace stanok::motion
