// ThreadBuilder: blocks of a thread to a chain whose path coordinate counts turns of the spindle.
//
// Each block is a line over its turns, its length over its lead. Between two blocks the thread does
// not stop and does not change its speed: the derivative by the turns goes from one lead and
// direction d1 to the other d2 with a constant third derivative, over h turns on each side,
//   q = q0 + h (d1 u + (d2 - d1) u^3 / 6)        0 <= u <= 1, before the corner, mirrored behind
//   it,
// which leaves the programmed corner by h |d2 - d1| / 6. An axis whose share of the lead is the
// same in both blocks goes on evenly: so does Z where a taper begins
// (docs/developer/motion.md#threads). Owner: the channel's preparation.
#pragma once

#include <optional>
#include <vector>

#include "motion/bounds/segment_bounds.h"
#include "motion/path/geometry.h"
#include "motion/path/path.h"

namespace stanok::motion {

struct ThreadBlock {
  BlockTag tag;
  Point end{};           // all axes, in W
  double lead_mm = 0.0;  // per turn, along the path
  double tolerance_mm = 0.0;
  // The corner at its start and end leaves the blocks by no more than the tolerance; else by more
  // where the axes need it at this speed.
  bool keeps_tolerance = false;
  // Out of the thread: there is no accuracy to keep on the way to its end. Where the axes cannot
  // take its corner at this speed, it begins earlier and is as much flatter.
  bool runs_out = false;
  const kinematics::Transform* transform = nullptr;  // outlives the queue
};

// Why a block of a thread cannot be cut.
struct ThreadFault {
  enum class Kind {
    unreachable,
    axis_too_slow,
    corner_too_sharp,
    too_many_blocks,
    encoder_too_coarse
  };
  Kind kind = Kind::unreachable;
  int axis = 0;            // unreachable, axis_too_slow
  double value = 0.0;      // position; speed of the axis, per s
  double limit = 0.0;      // of it
  double speed_max = 0.0;  // of the spindle, turns/s, with which the block could be cut
  double lead_max = 0.0;   // encoder_too_coarse: mm, that could be followed
};

struct ThreadChain {
  std::vector<Segment> segments;  // lengths in turns
  SpindleCoupling coupling;
};

class ThreadBuilder {
 public:
  explicit ThreadBuilder(const MotionConfig& config) : config_(config) {}

  [[nodiscard]] bool is_empty() const { return blocks_.empty(); }

  // A new chain at `start`, with these axes as X, Y and Z. `speed`: of the spindle, turns/s, as
  // programmed; 0: not known. `jerk_to_follow`: along a block, for its encoder. What
  // the axes allow is added to the coupling.
  void begin(const Point& start, const std::array<int, 3>& geometry,
             const SpindleCoupling& coupling, double speed, double jerk_to_follow = 0.0);
  // The spindle may turn at `speed` within the chain, turns/s, if that is faster: corners are made
  // anew. A fault changes nothing.
  [[nodiscard]] std::optional<ThreadFault> turn_faster(double speed);
  // A fault adds nothing to the chain.
  [[nodiscard]] std::optional<ThreadFault> add(const ThreadBlock& block);
  // The only block of a tap: the path goes on behind its end for what the spindle overruns. The
  // spindle turns back no faster than the axes can be led.
  [[nodiscard]] std::optional<ThreadFault> add_tap(const ThreadBlock& block);
  // The chain as it is; empty afterwards.
  [[nodiscard]] ThreadChain finish();
  void clear() { blocks_.clear(); }

 private:
  struct Corner {
    Segment before;
    Segment behind;
    double turns = 0.0;  // of each
    SegmentBounds bounds;
  };
  struct Straight {
    Segment whole;
    Point per_turn{};        // q'
    double tolerance = 0.0;  // mm
    bool keeps_tolerance = false;
    bool runs_out = false;
    double from = 0.0;  // turns that the corner at its start has taken
    Point from_point{};
    std::optional<Corner> corner;  // at its end
  };

  [[nodiscard]] Straight straight(const ThreadBlock& block, const Point& start) const;
  [[nodiscard]] std::optional<ThreadFault> fault_of(const Straight& block, double lead_mm) const;
  [[nodiscard]] Corner corner(const Straight& one, const Straight& next, double turns) const;
  [[nodiscard]] std::optional<ThreadFault> join(Straight& one, Straight& next, double part) const;
  [[nodiscard]] std::optional<ThreadFault> add_where_it_is(const ThreadBlock& block);
  [[nodiscard]] bool add_earlier(ThreadBlock block);
  [[nodiscard]] std::optional<ThreadFault> append(const Straight& next);
  [[nodiscard]] std::optional<ThreadFault> connect(Straight next);
  [[nodiscard]] std::optional<ThreadFault> round_corners_anew();
  void set_speed(double speed);
  [[nodiscard]] double change_of_lead(const Straight& one, const Straight& next) const;
  [[nodiscard]] SegmentBounds bounds_of_chain() const;
  [[nodiscard]] static SegmentLimits limits_at(const SegmentBounds& bounds, double speed);
  [[nodiscard]] static bool leaves_jerk(const SegmentBounds& bounds, double speed, double jerk);
  [[nodiscard]] double speed_that_leaves_jerk(const SegmentBounds& bounds) const;

  MotionConfig config_;
  SpindleCoupling coupling_;
  double speed_ = 0.0;
  double jerk_to_follow_ = 0.0;
  SegmentBounds straights_;  // largest of all blocks, and of the one that is being added
  Point end_{};
  std::vector<Straight> blocks_;
};

}  // namespace stanok::motion
