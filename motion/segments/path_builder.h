// PathBuilder: programmed blocks to a chain of segments with continuous curvature, within
// tolerance.
//
// Corners (line-line, line-arc, arc-arc, tangent joins with a step of curvature too) are replaced
// by quintic blends in all axes together, so that rotary axes stay synchronous; the deviation from
// the programmed path never exceeds the block's tolerance. Where a blend is not possible or not
// allowed the chain stops. docs/developer/motion.md#blends. Owner: the channel's preparation.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"
#include "motion/segments/corner_curve.h"
#include "motion/segments/corner_overlap.h"
#include "motion/segments/smooth_run.h"
#include "motion/segments/straightening.h"

namespace stanok::motion {

// A point of the path that the machine cannot reach: named by block, axis and limit.
struct Unreachable {
  BlockTag tag;
  int axis = 0;
  double position = 0.0;  // NaN: the pose does not exist in the scheme
  double limit = 0.0;
};

class PathBuilder {
 public:
  explicit PathBuilder(const MotionConfig& config);

  // Stands at `point` with nothing pending; the next block starts there. To be called after
  // finish() whenever the transform changes: a chain has one transform.
  void restart(const Point& point) { restart(point, config_.geometry); }
  // The same, with other axes as X, Y and Z of the workpiece space from here on.
  void restart(const Point& point, const std::array<int, 3>& geometry);

  // Takes the next block. Segments that are final now are appended to `out`; a segment with
  // `ends_chain` set closes a chain at rest. An unreachable pose is reported and the block is not
  // taken.
  [[nodiscard]] std::optional<Unreachable> add(const PathBlock& block);

  // Something happens at the end of the last block: it stays a point of the path.
  void keep_end();

  // No block follows for now: what is pending becomes final and the chain ends at rest.
  void finish();

  // A final segment, in path order.
  struct Built {
    Segment segment;
    bool ends_chain = false;  // the path stands still at the end of this segment
    // The next chain follows, and may begin before this one has ended.
    std::shared_ptr<const OverlapCorner> overlap = nullptr;
    double jerk_part = 1.0;  // of the jerk the axes allow, that the profile may use on the segment
    double stand_mm = 0.0;   // Chunk::stand_mm
    bool counts_as_block = false;  // for look-ahead: a part that a feed law made of a block
  };
  // Final segments not yet taken; the caller empties it.
  [[nodiscard]] std::vector<Built>& built() { return built_; }

  // End of the last block taken, in W.
  [[nodiscard]] const Point& end() const { return end_; }

 private:
  // The last block taken: its end still waits for the join with the next one.
  struct Pending {
    Segment whole;  // the programmed block
    Tolerance tolerance;
    // Corners that a straight line leaves out may be so far off it, and these and blends together
    // so far.
    Tolerance programmed{};
    Tolerance corner{};
    Tolerance total{};
    bool keeps_end = false;
    bool keeps_clear = false;  // of the soft limits, by its tolerance
    double from = 0.0;         // path length already taken by the blend at its start
    Point from_point{};
    double jerk_part = 1.0;  // up to its middle (Built)
    double straight = 0.0;   // at its start, that no blend may take: it overlaps the block before
  };

  [[nodiscard]] const Point& programmed_end() const;
  [[nodiscard]] std::optional<Unreachable> stand(const PathBlock& block);
  [[nodiscard]] Pending pending_from(const PathBlock& block) const;
  void take(const Pending& next);
  [[nodiscard]] bool may_straighten(const Pending& line, const Pending& next) const;
  [[nodiscard]] bool straighten(const Pending& next);
  void settle_line();
  void settle(const Pending& next);
  [[nodiscard]] bool belong_together(const Pending& one, const Pending& next) const;
  [[nodiscard]] bool stands_alone(const Pending& one, const Pending& next,
                                  const Tolerance& tolerance) const;
  void open_run(const Pending& next);
  void close_run(SmoothRun::End end);
  void emit_run();
  void join(const Pending& next);
  void join_corner(Pending& next);
  void take(const CornerCurve& curve, Pending& next);
  void emit_pending(double to, const Point& to_point, double jerk_part_at_end = 1.0);
  void emit_part(double from, const Point& from_point, double to, const Point& to_point,
                 double jerk_part);
  void stop();
  void stand_at_programmed_end();
  void stop_with_overlap(const std::shared_ptr<const OverlapCorner>& overlap, double jerk_part,
                         Pending& next);
  void append(const Segment& segment, double jerk_part = 1.0);
  void append_blend(Segment segment, const Pending& next, double reach);
  void end_chain();

  MotionConfig config_;
  Point end_{};
  std::optional<PathBlock> standing_;  // the last block, where it did not move
  bool stands_ = true;                 // the last segment ended a chain, or there is none
  // Either the last block is pending, or it is the last one of an open run.
  std::optional<Pending> pending_;
  Pending last_of_run_;
  std::optional<Pending> line_;  // the last block, where it is a line that may still grow
  Straightening straightening_;
  SmoothRun run_;
  std::vector<Segment> smoothed_;
  std::vector<Built> built_;
};

}  // namespace stanok::motion
