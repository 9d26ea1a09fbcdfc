// FeedLawStage: segments of the path divided at the increments of their feed laws.
//
// Between PathBuilder and LookAhead. Each part of a segment has the feed of its stretch of the law,
// so that an increment lies on the path itself: override, hold, look-ahead and the profile cannot
// move it. Parts are made one at a time, when they are asked for. Segments without a law pass as
// they are. Owner: the channel's preparation.
#pragma once

#include <deque>

#include "motion/feed_laws/feed_law.h"
#include "motion/segments/path_builder.h"

namespace stanok::motion {

class FeedLawStage {
 public:
  void add(const PathBuilder::Built& built) { waiting_.push_back(built); }
  [[nodiscard]] bool is_empty() const { return waiting_.empty(); }

  // The next segment with one feed; the stage must not be empty.
  [[nodiscard]] PathBuilder::Built next();

  void clear();

 private:
  [[nodiscard]] PathBuilder::Built next_part();

  std::deque<PathBuilder::Built> waiting_;
  double from_ = 0.0;  // of the first waiting segment, so much is given already
  Point from_point_{};
};

// A feed in these units along the path in mm/s; a feed per revolution at `rev_per_min`.
[[nodiscard]] double feed_per_s(double feed, const LawUnits& units, double rev_per_min) RT_SAFE;

}  // namespace stanok::motion
