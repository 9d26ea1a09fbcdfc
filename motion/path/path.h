// The path as data: programmed blocks in, curvature-continuous segments and a jerk-limited profile
// out.
//
// A *chain* is a run of segments from rest to rest in one metric: its path coordinate s is the
// length of the tool tip's path in mm, or, when no linear word moves, of the rotary words in deg.
// Coordinates: the programmed point in W, mm and deg, in the order of the channel's axes
// (kinematics/scheme.h). All types here are plain data and cross into the real-time cycle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/axis_index.h"
#include "kinematics/scheme.h"

namespace stanok::motion {

inline constexpr int axes_max = kinematics::axes_max;
using Point = kinematics::AxisVector<double>;

// The coordinate of an axis that is known to be there (not -1).
[[nodiscard]] inline double at(const Point& point, int axis) {
  return point[axis];
}
using JetPoint = kinematics::AxisVector<kinematics::Jet>;

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

// Limits of one axis, mm or deg, per s, s^2, s^3.
struct AxisLimits {
  bool linear = true;
  double position_min = -unlimited;
  double position_max = unlimited;
  double velocity_max = unlimited;
  double acceleration_max = unlimited;
  double jerk_max = unlimited;
  double rapid_max = unlimited;
  // What a stop may use of acceleration_max and of jerk_max: 1 or more.
  double stop_limits = 1.0;

  // The highest speed in rapid travel; velocity_max bounds it, too.
  [[nodiscard]] double rapid_speed_max() const RT_SAFE { return std::min(rapid_max, velocity_max); }
};

struct MotionConfig {
  int axis_count = 0;
  AxisArray<AxisLimits> axes{};
  // Channel axes that are the X, Y, Z of the workpiece space (path length, tolerance); -1: none.
  std::array<int, 3> geometry{-1, -1, -1};
  double cycle_s = 0.001;
  double path_tolerance_mm = 0.01;
  double orientation_tolerance_deg = 0.05;
  // Straight blocks that turn by no more at a time become one smooth run; 0: every join is one of
  // its own.
  double run_turn_max_deg = 20.0;
};

// Of acceleration and jerk of the axes: those of the machine, or what stops may use
// (AxisLimits::stop_limits).
enum class UsedLimits : std::uint8_t { of_axes, of_stops };

// What stops may use of the limits of every axis: the least of them.
[[nodiscard]] inline double stop_limits_of(const MotionConfig& config) RT_SAFE {
  double least = unlimited;
  for (int k = 0; k < config.axis_count; ++k) least = std::min(least, config.axes[k].stop_limits);
  return std::isfinite(least) ? std::max(least, 1.0) : 1.0;
}

// Origin of a block, carried to status, traces and alarms.
struct BlockTag {
  std::uint32_t run = 0;    // program run of the channel
  std::uint64_t block = 0;  // running number in the run
  std::uint32_t line = 0;
  std::uint16_t file = 0;
  std::uint32_t situation = 0;  // number of what gave the words of the block their meaning
};

class FeedLaw;
enum class LawKind : std::uint8_t { none, linear, modulated, interrupted, curve };
// What a law changes besides the feed: the spindle's speed, or the cutting speed.
enum class LawSpeed : std::uint8_t { unchanged, rev_per_min, m_per_min };

// How the process moves along a block: the law of its feed, and the spindle that its feed follows.
struct BlockProcess {
  const FeedLaw* law = nullptr;  // outlives the queue; none: the feed is constant
  double path_start = 0.0;       // path of the law where the block begins, mm
  double path_length = 0.0;      // and how much of it the block is
  double path_end = unlimited;   // where the law ends
  // Feed per revolution: `feed_per_s` holds at this speed of the spindle. 0: feed per time.
  double rev_per_min = 0.0;
};

enum class BlockKind : std::uint8_t { line, arc, curve };
enum class BlockEnding : std::uint8_t { continuous, exact_stop };

// One programmed motion from the end of the one before.
struct PathBlock {
  BlockTag tag;
  BlockKind kind = BlockKind::line;
  BlockEnding ending = BlockEnding::continuous;
  bool rapid = false;
  Point end{};  // all axes
  double feed_per_s =
      0.0;  // mm/s along the tip's path; deg/s when only rotary words move; rapid: unused
  double tolerance_mm = 0.0;  // how far the path may leave the corner at the block's end; 0 = exact
                              // path (stop at corners)
  double tolerance_deg = 0.0;      // the same for rotary axes
  double straightening_mm = -1.0;  // how far corners may lie off a line that leaves them out; below
                                   // 0: most of the tolerance
  // Arc (helix): axes of the plane, centre in W, signed sweep in rad (> 0 from first towards second
  // axis), turns included. All other axes move linearly with the sweep. The radius goes linearly
  // from start radius to end radius (they differ by rounding only).
  std::array<int, 2> plane{0, 1};
  std::array<double, 2> centre{};
  double sweep_rad = 0.0;
  // Curve: the axes of the plane as polynomials of u, 0 to 1; all other axes linearly with u.
  std::array<std::array<double, 6>, 2> curve{};
  const kinematics::Transform* transform = nullptr;  // outlives the queue
  BlockProcess process;
};

enum class SegmentKind : std::uint8_t {
  line,
  arc,
  quintic,
  even  // a quintic whose parameter goes evenly with s, whatever s counts
};

// Says which axes make up the path coordinate: s is the Euclidean length of their common path.
struct PathMetric {
  int axis_count = axes_max;  // axes of the channel; components beyond stay as they start
  unsigned axes = 0b111;      // bit k: axis k counts

  [[nodiscard]] constexpr bool counts(AxisIndex axis) const RT_SAFE {
    return (axes >> axis.place() & 1U) != 0;
  }
  friend constexpr bool operator==(const PathMetric&, const PathMetric&) = default;
};

// Geometry of a segment over its own parameter u in [0, 1]; evaluation in motion/path/geometry.h.
struct Geometry {
  SegmentKind kind = SegmentKind::line;
  PathMetric metric;
  Point start{};
  Point end{};  // stored, exact: evaluation at u = 1 returns it to the bit
  // arc
  std::array<int, 2> plane{0, 1};
  std::array<double, 2> centre{};
  double radius = 0.0;
  double radius_change = 0.0;
  double start_angle = 0.0;  // rad
  double sweep = 0.0;        // rad
  // quintic, even: coefficients of u^0..u^5 per axis; quintic: knots, s at u = k/8
  // (arc length)
  AxisArray<std::array<double, 6>> coefficients{};
  std::array<double, 9> knots{};
};

// Bounds of a segment over all axes of the machine, through the kinematics: with v, a, j along the
// path every axis keeps its limits while
//   v * velocity <= 1,   v^2 * curvature + |a| * tangent <= 1,
//   v^3 * aberrancy + 3 v |a| * bend + |j| * thrust <= 1.
// Each is the maximum over the axes of |q^(n)(s)| / limit, q the axis position as a function of s.
struct SegmentBounds {
  double velocity = 0.0;   // max |q'|   / v_max   s/mm
  double tangent = 0.0;    // max |q'|   / a_max   s^2/mm
  double thrust = 0.0;     // max |q'|   / j_max   s^3/mm
  double curvature = 0.0;  // max |q''|  / a_max   s^2/mm^2
  double bend = 0.0;       // max |q''|  / j_max   s^3/mm^2
  double aberrancy = 0.0;  // max |q'''| / j_max   s^3/mm^3
  // v * chords <= 1, too: the chords between setpoints keep what they have of the tolerance. s/mm
  double chords = 0.0;

  // The same with Euclidean lengths, where X, Y and Z alone move and have one limit each: what acts
  // along the path and what acts across it adds in squares,
  //   (v^2 * curvature)^2 + (a * tangent)^2 <= 1,
  //   v^3 * aberrancy + sqrt((3 v a * bend)^2 + (j * thrust)^2) <= 1.
  struct Euclidean {
    bool holds = false;
    double tangent = 0.0;
    double thrust = 0.0;
    double curvature = 0.0;
    double bend = 0.0;
  };
  Euclidean euclidean{};
};

// How the process moves along one segment of the block.
struct SegmentProcess {
  const FeedLaw* law = nullptr;  // not for the cycle
  LawKind kind = LawKind::none;
  LawSpeed speed = LawSpeed::unchanged;
  double path_start = 0.0;  // path of the law where the segment begins, and where it ends
  double path_stop = 0.0;
  double path_end = unlimited;
  double rev_per_min = 0.0;           // as of the block
  std::uint64_t increments = 0;       // that the law has made
  double spindle_speed = 0.0;         // that the law asks for, in its unit; 0: unchanged
  double spindle_speed_behind = 0.0;  // and behind this part of the block
};

struct Segment {
  BlockTag tag;
  Geometry geometry;
  SegmentBounds bounds;
  double length = 0.0;      // in s; > 0
  double feed_per_s = 0.0;  // programmed feed along s; infinity for rapid
  bool rapid = false;
  const kinematics::Transform* transform = nullptr;
  SegmentProcess process;
};

// How a phase may be run more slowly than planned (motion/interpolation/pace.h): bounds over all
// axes of the machine and over the phases that belong together. Stored in single precision, rounded
// up.
struct PaceLimits {
  float use = 0.0F;       // u: largest part of acceleration or jerk that the plan uses, < 1
  float velocity = 0.0F;  // P: largest |velocity| / a_max, s
  float thrust = 0.0F;    // Q: largest |velocity| / j_max, s^2
  float coupling = 0.0F;  // R: largest |acceleration| / j_max, s

  // Phases that are made under limits constant along each segment have none.
  [[nodiscard]] bool holds() const RT_SAFE { return use > 0.0F; }
};

[[nodiscard]] constexpr PaceLimits highest_of(const PaceLimits& one, const PaceLimits& other) {
  return {.use = std::max(one.use, other.use),
          .velocity = std::max(one.velocity, other.velocity),
          .thrust = std::max(one.thrust, other.thrust),
          .coupling = std::max(one.coupling, other.coupling)};
}

// Axes whose travel counts as that of a working feed, bit k: channel axis k; 0 in rapid.
[[nodiscard]] inline unsigned working_axes(const Segment& segment) RT_SAFE {
  return segment.rapid ? 0U : segment.geometry.metric.axes;
}

// Constant jerk along s for `duration`: s(t) = s + v t + a t^2/2 + j t^3/6. `s` counts from the
// start of the chunk's span.
struct Phase {
  double duration = 0.0;  // s
  double s = 0.0;
  double v = 0.0;
  double a = 0.0;
  double j = 0.0;
  double s_end = 0.0;  // state at the end, stored: the next phase starts here to the bit
  double v_end = 0.0;
  PaceLimits pace{};
};

// A chain that a spindle leads: its path coordinate s counts turns of the spindle from the start of
// the thread, its segments are lines and even quintics, it has no phases
// (motion/threads/synchronous_run.h).
struct SpindleCoupling {
  // tap_out: a tap that stands in its hole, from there back to s = 0.
  enum class Kind : std::uint8_t { none, thread, tap, tap_out };
  Kind kind = Kind::none;
  std::int32_t spindle = 0;      // index in the channel
  double start_angle_deg = 0.0;  // of the spindle at s = 0
  // What the axes allow along s: turns per s, s^2, s^3.
  double speed_max = 0.0;
  // Kept of it: a bound in steps of cycles passes it by jerk * cycle^2 / 8.
  static constexpr double speed_share = 0.99;
  struct Section {
    double acceleration_max = 0.0;
    double jerk_max = 0.0;
  };
  Section entry{};  // up to the first corner
  Section chain{};  // all over it
  Section exit{};   // from the last corner on
  double entry_end = 0.0;
  double exit_begin = 0.0;
  // Tap: the spindle turns back at `bottom`; the path reaches farther, for what a spindle overruns.
  // tap_out: the path begins there.
  double bottom = 0.0;
  double lead_mm = 0.0;               // of a tap, along the path
  double out_speed = 0.0;             // tap_out: of the spindle, turns/s, clockwise > 0
  double spindle_acceleration = 0.0;  // turns/s^2, with which it shall turn back
  double return_speed_factor = 1.0;
  double dwell_s = 0.0;
};

// A committed stretch of a chain: the next `segments` and `phases` of their rings. Chunks of a
// chain meet in one state (s, v, a), to the bit.
struct Chunk {
  std::uint32_t segments = 0;
  std::uint32_t phases = 0;
  bool last = false;  // the chain ends at rest at the end of this chunk
  double length = 0.0;
  double time_s = 0.0;         // that it takes without an override; 0: a spindle leads it
  double overlap_s = 0.0;      // the next chain may begin so long before this one has ended; s
  double stand_mm = 0.0;       // equivalent dwell path at the end of the chain: the axes rest
  std::uint64_t sequence = 0;  // counts all chunks of the channel
  std::uint32_t lookahead_blocks = 0;  // blocks known behind its first one when it was committed
  SpindleCoupling coupling{};          // of a chain that is one chunk
};

}  // namespace stanok::motion
