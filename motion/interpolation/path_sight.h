// PathSight: the limits of the segments that lie ahead, as the cycle sees them.
//
// Two caps of speed for each segment: the *hard* one, which the axes and the programmed feed (at
// the highest override that may still be in the speed) allow and for which the limits of
// acceleration and jerk hold, and the *asked* one, which the override asks for now. Limits are
// worked out once for a segment and kept. Real-time; memory is taken in the constructor.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

// A place at which the path comes to rest, on a segment that is known: s along the current chunk.
struct PathWall {
  static constexpr std::uint64_t no_segment = ~std::uint64_t{0};
  std::uint64_t segment = no_segment;  // number of the segment that holds it
  double s = unlimited;
};

class PathSight {
 public:
  static constexpr std::size_t segments_max = 2048;  // seen at a time; farther is a wall

  PathSight();

  // From where the present speed may come: the highest override, at least 1, and the highest speed
  // of the spindle that a feed per revolution followed.
  struct Reach {
    double feed_override = 1.0;
    double rev_per_min = 0.0;
    double controlled_per_s = 0.0;  // and the highest feed of force control
    double stop_limits = 1.0;       // what a stop may use of the limits of acceleration and jerk
    friend bool operator==(const Reach&, const Reach&) = default;
  };

  // Looks along the path from the current segment as far as the wall, once a cycle. A gate ahead is
  // a wall, too.
  void look(const PathQueue& queue, const PathCursor& cursor, const FeedControl& control,
            const Reach& reach, const PathWall& wall) RT_SAFE;

  [[nodiscard]] std::size_t size() const RT_SAFE { return size_; }
  // Where segment `index` starts and ends along the current chunk; index < size().
  [[nodiscard]] double start(std::size_t index) RT_SAFE;
  [[nodiscard]] double end(std::size_t index) RT_SAFE {
    return std::min(start(index + 1), wall_s_);
  }
  [[nodiscard]] double hard_speed(std::size_t index) RT_SAFE { return limits_of(index).v; }
  [[nodiscard]] double asked_speed(std::size_t index) RT_SAFE;
  [[nodiscard]] const RampLimits& ramp(std::size_t index) RT_SAFE { return limits_of(index).ramp; }

  // The segment that contains s, from segment `from` on.
  [[nodiscard]] std::size_t segment_at(double s, std::size_t from) RT_SAFE;

 private:
  struct Limits {
    std::uint64_t number = ~std::uint64_t{0};  // of the segment
    Reach reach;
    double length = 0.0;
    double feed = 0.0;  // programmed; of a rapid segment what its axes allow
    double v = 0.0;
    RampLimits ramp;
    double rev_per_min = 0.0;  // that a feed per revolution was planned for
    unsigned working_axes = 0;
    bool rapid = false;
    bool has_law = false;
  };
  [[nodiscard]] bool is_controlled(unsigned axes) const RT_SAFE {
    return (axes & control_.controlled_axes) != 0;
  }
  [[nodiscard]] double highest_part(const Segment& segment) const RT_SAFE;
  [[nodiscard]] const Limits& limits_of(std::size_t index) RT_SAFE;

  const PathQueue* queue_ = nullptr;
  FeedControl control_;
  Reach reach_;
  std::uint64_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t starts_known_ = 0;
  double wall_s_ = unlimited;
  std::array<double, segments_max + 1> starts_{};
  std::vector<Limits> kept_;
};

}  // namespace stanok::motion
