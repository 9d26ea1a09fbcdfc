// Interpolator: runs the committed path, cycle by cycle. Real-time; allocates nothing.
//
// Nominal run: the committed phases are evaluated at cycle instants in the chain's own clock; the
// fraction of a cycle that a chain leaves over is carried into the next one, and a chain that may
// overlap the end of the one before begins within it: the axes then move by the sum of both. Under
// hold, resume and override the plan is run at another pace (docs/developer/motion.md#pace) where
// it leaves room for that, else a bounded one-dimensional profile is planned in the cycle on the
// same path (docs/developer/motion.md#override); the path is never left, the limits are kept, and
// there is always a way to rest. A chain that a spindle leads has no phases: there the spindle is
// followed (motion/threads/synchronous_run.h), whatever the overrides are. Thread: the cycle.
// Owner: the axes' motion of a channel. Invariant: of the parts (NominalRun, OverridePlanner,
// SynchronousRun, DwellPath) one moves the path at a time; the cursor stands where the motion is.
#pragma once

#include <optional>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "motion/interpolation/axes_place.h"
#include "motion/interpolation/chain_overlap.h"
#include "motion/interpolation/dwell_path.h"
#include "motion/interpolation/feed_interruption.h"
#include "motion/interpolation/override_planner.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/interpolation/plan_ahead.h"
#include "motion/interpolation/plan_run.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"
#include "motion/threads/spindle_observer.h"
#include "motion/threads/synchronous_run.h"

namespace stanok::motion {

enum class PathState : std::uint8_t {
  idle,  // no chunk: standing
  moving,
  holding,   // at rest on the path by hold or override 0
  starved,   // at rest on the path: the next chunk of the chain did not arrive in time
  standing,  // on an equivalent dwell path, which a feed law or an interruption puts in
};

// A tap as the path has it.
struct TapOnPath {
  enum class Place : std::uint8_t { none, before, in_hole };
  Place place = Place::none;
  std::int32_t spindle = 0;  // index in the channel
  double lead_mm = 0.0;
};

struct InterpolatorOutput {
  PathState state = PathState::idle;
  BlockTag tag;          // of the current segment, or the last one
  JetPoint point{};      // programmed point in W with time derivatives, mm, mm/s, ...
  JetPoint axes{};       // machine axes M with time derivatives, through the segment's transform
  double s_speed = 0.0;  // path speed, mm/s
  double feed_commanded =
      0.0;              // programmed feed of the segment in mm/s before override, 0 in rapid
  bool on_arc = false;  // the current segment is an arc or a helix
  // Axes whose travel counts as that of a working feed, bit k: channel axis k; 0 in rapid, in
  // threads and without a path.
  unsigned working_axes = 0;
  SegmentProcess process;         // of the current segment, or the last one
  double path_advanced = 0.0;     // path length travelled in this cycle, mm (or deg)
  bool at_gate = false;           // at rest before a gate of FeedControl
  std::uint64_t chunks_done = 0;  // chunks finished or dropped since construction
  bool chain_ended =
      false;  // a chain came to its end in this cycle; `cycle_left` of the cycle is unused
  double cycle_left = 0.0;     // s
  SpindleOrder spindle_order;  // of a tap, from this cycle on
  TapOnPath tap;
  bool is_led_by_spindle = false;  // the path moves as a spindle turns
  bool has_lost_spindle = false;   // the axes could not follow; the chain will not come to its end
};

class Interpolator {
 public:
  static constexpr std::uint64_t no_chunk_limit = ~std::uint64_t{0};

  // Both outlive the interpolator: `history` is told of the path that lies behind, and `lengths`
  // count for transforms that were made before them.
  explicit Interpolator(const MotionConfig& config, PathHistory* history = nullptr,
                        const kinematics::LengthChanges* lengths = nullptr);

  // Sets where the axes stand; only at rest. `transform` gives the programmed point that belongs to
  // `axes_M`.
  void stand_at(const Point& axes_M, const kinematics::Transform& transform) RT_SAFE;

  // The feed is interrupted from now on, or no longer.
  void interrupt(const InterruptionLengths& lengths) RT_SAFE;
  [[nodiscard]] const FeedInterruption& interruption() const RT_SAFE { return interruption_; }

  // How spindle `index` of the channel turns at the setpoint to come.
  void see_spindle(std::size_t index, const SpindleMotion& motion) RT_SAFE {
    spindles_[index] = motion;
  }

  // Advances by one cycle on `queue`. A chain is entered only when its next chunk is known too (or
  // it is the chain's last one), so that what the override planner may see depends on content, not
  // on timing. A chain that ends within the cycle leaves the rest of it to the next chain, if that
  // one is in the queue and may be entered: only chains that begin with a chunk of a sequence
  // number below `chunk_limit` may.
  void advance(PathQueue& queue, const FeedControl& control, InterpolatorOutput& out,
               std::uint64_t chunk_limit = no_chunk_limit) RT_SAFE;

  // Abort after standstill: forgets the rest of the path; the producer has stopped, the queue is
  // emptied here.
  void drop_path(PathQueue& queue) RT_SAFE;

  [[nodiscard]] bool at_rest() const RT_SAFE;
  // Within a chain: how far its current segment was passed. Between chains: none.
  [[nodiscard]] std::optional<double> way_into_segment(const PathQueue& queue) const RT_SAFE;
  // A spindle leads the current chain, whether the axes follow it yet or not.
  [[nodiscard]] bool is_synchronous() const RT_SAFE {
    return cursor_.has_chunk() && cursor_.chunk().coupling.kind != SpindleCoupling::Kind::none;
  }

 private:
  [[nodiscard]] bool may_enter(const PathQueue& queue, const FeedControl& control,
                               std::uint64_t chunk_limit) const RT_SAFE;
  // Runs for `time` within the current chunk, or, under override, beyond its end; returns what is
  // left of it.
  [[nodiscard]] double run(PathQueue& queue, const FeedControl& control, double time) RT_SAFE;
  void enter(PathQueue& queue) RT_SAFE;
  double follow_spindle(PathQueue& queue, const FeedControl& control) RT_SAFE;
  [[nodiscard]] bool has_run_chunk() const RT_SAFE;
  [[nodiscard]] bool knows_next(const PathQueue& queue) const RT_SAFE;
  void run_overlap(const PathQueue& queue, const FeedControl& control, std::uint64_t chunk_limit)
      RT_SAFE;
  void enter_overlapped(PathQueue& queue) RT_SAFE;
  [[nodiscard]] bool is_interrupted(const PathQueue& queue) const RT_SAFE;
  void begin_interruption(const PathQueue& queue) RT_SAFE;
  [[nodiscard]] bool wants_nominal(const PathQueue& queue, const FeedControl& asked) const RT_SAFE;
  [[nodiscard]] bool may_keep_plan(const PathQueue& queue, const FeedControl& asked) const RT_SAFE;
  [[nodiscard]] bool keeps_plan(const PathQueue& queue, const FeedControl& asked) const RT_SAFE;
  void rejoin_plan(PathQueue& queue, const FeedControl& asked) RT_SAFE;
  [[nodiscard]] double approach_plan(PathQueue& queue, FeedControl& asked, double time) RT_SAFE;
  [[nodiscard]] PlanStart plan_to_approach(const PathQueue& queue, const FeedControl& asked,
                                           double while_s) const RT_SAFE;
  [[nodiscard]] double run_plan(PathQueue& queue, const FeedControl& asked, double time) RT_SAFE;
  [[nodiscard]] std::optional<double> run_stop(PathQueue& queue, const FeedControl& asked,
                                               double time) RT_SAFE;
  [[nodiscard]] UsedLimits limits_for(const PathQueue& queue, const FeedControl& asked) const
      RT_SAFE;
  void look_for_raise(const PathQueue& queue, const FeedControl& asked) RT_SAFE;
  [[nodiscard]] bool leaves_plan(const PathQueue& queue, const FeedControl& asked) RT_SAFE;
  [[nodiscard]] double run_under_override(PathQueue& queue, const FeedControl& asked, double time)
      RT_SAFE;
  [[nodiscard]] bool finish_chunk(PathQueue& queue, const FeedControl& control,
                                  InterpolatorOutput& out) RT_SAFE;
  [[nodiscard]] bool is_next_segment_closed(const PathQueue& queue,
                                            const FeedControl& control) const RT_SAFE;
  [[nodiscard]] bool stands_at_gate(const PathQueue& queue, const FeedControl& control) const
      RT_SAFE;
  void stand_here(const PathQueue& queue) RT_SAFE;
  void report(const PathQueue& queue, const FeedControl& control, InterpolatorOutput& out) RT_SAFE;
  void report_standing(const FeedControl& control, InterpolatorOutput& out) const RT_SAFE;
  void turns_to_path(const Segment& segment, const JetPoint& point_s, InterpolatorOutput& out) const
      RT_SAFE;
  [[nodiscard]] PathState state(const PathQueue& queue, const FeedControl& control) const RT_SAFE;

  double cycle_s_;
  int axis_count_;
  PathCursor cursor_;
  PathMotion motion_;  // along the current chunk
  PlanRun plan_;
  bool is_on_plan_ = true;  // committed phases are being run, not what the override planner found
  ChainOverlap overlap_;    // the next chain within the end of the current one
  OverridePlanner planner_;
  FeedInterruption interruption_;
  DwellPath dwell_;
  SynchronousRun synchronous_;
  NumberedArray<SpindleMotion, coupled_spindles_max> spindles_{};
  AxesPlace place_;
  std::uint64_t chunks_done_ = 0;
  double advanced_ = 0.0;  // in this cycle
};

}  // namespace stanok::motion
