// Retrace: leads the axes of a held path back along what they passed, and forwards again as far as
// where the path is held.
//
// It runs on the pieces of a track by the override planner, so that every limit holds; the path
// itself keeps its place and is not told. Going back, a piece is run through from its end: where
// the axes are is found from the segment itself, so that the points are those of the way forwards.
// Where the axes rested between chains they rest again. docs/developer/motion.md#retrace.
// Real-time; memory is taken in the constructor. Owner: the axes' motion of a channel.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/rt_safe.h"
#include "motion/interpolation/axes_place.h"
#include "motion/interpolation/override_planner.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path.h"
#include "motion/path/path_history.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"
#include "motion/retrace/retrace_feed.h"
#include "motion/retrace/retrace_track.h"

namespace stanok::motion {

struct RetraceOutput {
  JetPoint point{};      // programmed point in W
  JetPoint axes{};       // machine axes
  BlockTag tag;          // of the block in which they are
  double s_speed = 0.0;  // mm/s, > 0 whichever way
};

class Retrace {
 public:
  // `history` and `lengths` outlive the retrace; `lengths` count for transforms that were made
  // before them, nullptr: none do.
  explicit Retrace(const MotionConfig& config, const PathHistory& history,
                   const kinematics::LengthChanges* lengths = nullptr);

  // The path is held here: `way` into `held`, or, nullptr, between two chains. The axes stand at
  // `axes_M`.
  void begin(const Segment* held, double way, const Point& axes_M) RT_SAFE;
  // The path has the axes again, or is gone.
  void end() RT_SAFE;

  // Goes that way by `length`, or until it is stopped, as far as there is a way. While it moves by
  // a length, it goes so much farther, or less far; else only at rest. An override of 0 stops it:
  // it does not go on by itself when that is raised.
  void go(RetraceWay way, double length = unlimited) RT_SAFE;
  void stop() RT_SAFE { stops_ = true; }
  // Of what it was to go, so much is left at most; not less than it needs to come to rest.
  void keep_to(double length) RT_SAFE { left_ = std::min(left_, length); }

  [[nodiscard]] bool is_on() const RT_SAFE { return is_on_; }
  [[nodiscard]] bool is_at_rest() const RT_SAFE { return stops_ && motion::is_at_rest(motion_); }
  // It comes to rest, whatever is left.
  [[nodiscard]] bool is_stopping() const RT_SAFE { return stops_ && !motion::is_at_rest(motion_); }
  [[nodiscard]] double speed() const RT_SAFE { return motion_.v; }  // > 0 whichever way
  [[nodiscard]] RetraceWay way() const RT_SAFE { return way_; }
  // Nothing is left that way; forwards: the axes are where the path is held.
  [[nodiscard]] bool is_at_end(RetraceWay way) const RT_SAFE;
  // Blocks that the axes can go back, the current one included.
  [[nodiscard]] std::uint64_t blocks_left() const RT_SAFE;

  // One cycle, of which `out` says where the axes are.
  void advance(const FeedControl& control, RetraceOutput& out) RT_SAFE;

 private:
  void begin_course(RetraceWay way) RT_SAFE;
  void enter() RT_SAFE;
  [[nodiscard]] PathWall wall() RT_SAFE;
  [[nodiscard]] double run(const FeedControl& control, double time) RT_SAFE;
  [[nodiscard]] bool finish_chunk() RT_SAFE;
  void find_piece() RT_SAFE;
  void report(RetraceOutput& out) RT_SAFE;

  const MotionConfig& config_;
  RetraceTrack track_;
  RetraceFeed feed_;
  PathCursor cursor_;
  OverridePlanner planner_;
  AxesPlace place_;
  bool is_on_ = false;
  bool stops_ = true;
  RetraceWay way_ = RetraceWay::back;
  PathMotion motion_;           // along the current chunk, or, before one, of its start
  double left_ = 0.0;           // of what it shall go
  RetraceTrack::Place at_ = 0;  // where the current piece begins
  TrackPiece piece_;            // the current one
  double s_ = 0.0;              // how far it is into that, from its own start
  std::uint64_t number_ = 0;    // of its segment in the queue
};

}  // namespace stanok::motion
