// SpeedPlan: the fastest jerk-limited speed along a run of segments with limits of their own.
//
// Key points are states with a = 0 at segment boundaries. Between two of them the speed ramps up,
// is held, and ramps down. Where that is too fast for a segment, the slowest such segment becomes a
// plateau between two new key points, and both sides are planned again; where no room is left to
// reach the plateau with a = 0, a stair is put below the limits instead
// (docs/developer/motion.md#profile).
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "motion/profile/profile.h"
#include "motion/profile/range_minimum.h"
#include "motion/profile/speed_segment.h"

namespace stanok::motion {

// From key point to key point: held at v0 for `hold` of length, up to `top`, held, down to v1.
struct KeySpan {
  std::size_t first = 0;  // boundary where it begins: the start of segment `first`
  std::size_t last = 0;   // boundary where it ends: the end of segment `last - 1`
  double v0 = 0.0;
  double v1 = 0.0;
  double top = 0.0;
  double wait_first = 0.0;  // length run at v0 before the ramp up
  double wait_last = 0.0;   // length run at v1 after the ramp down
  RampLimits up{};
  RampLimits down{};

  [[nodiscard]] double up_distance() const { return ramp_distance(v0, top, up); }
  [[nodiscard]] double down_distance() const { return ramp_distance(top, v1, down); }
};

class SpeedPlan {
 public:
  // Plans from speed `v_start` (a = 0) to rest at the end of the last segment. Returns false when
  // the start is too fast to stop there.
  [[nodiscard]] bool plan(const std::vector<SpeedSegment>& segments, double v_start);

  [[nodiscard]] const std::vector<KeySpan>& spans() const { return spans_; }
  // Boundary `index` in path length from the start; 0 <= index <= number of segments.
  [[nodiscard]] double boundary(std::size_t index) const { return boundaries_[index]; }

  // Appends the phases of the span, which starts where the phases before it end. Constant speed
  // goes on in the phase before when it is the same speed.
  void append_phases(const KeySpan& span, std::vector<Phase>& phases) const;

 private:
  struct Key {
    std::size_t boundary = 0;
    double v = 0.0;
    // What lies between this key point and the next one is a stair, found with the key.
    bool begins_stair = false;
    KeySpan stair{};
  };
  // A path over a key point between two others.
  struct Detour {
    Key key;
    double duration = 0.0;
    RampLimits limits{};  // of the ramp that it frees
  };
  enum class Direction { forward, backward };
  enum class Fit { fits, right_too_fast, left_too_fast };

  void take(const std::vector<SpeedSegment>& segments);
  [[nodiscard]] bool lower_left(std::vector<Key>& pending, Key& left, const Key& right);
  void accept(const KeySpan& span, Key& left, std::vector<Key>& pending);

  // Limits over the segments touched between two places or boundaries.
  [[nodiscard]] RampLimits limits_between(double s0, double s1) const;
  [[nodiscard]] RampLimits limits_over(std::size_t first, std::size_t last) const;
  [[nodiscard]] RampLimits outward_limits(std::size_t from, Direction direction, double v0,
                                          double v1) const;
  [[nodiscard]] double highest_limit(std::size_t first, std::size_t last) const;
  [[nodiscard]] double boundary_limit(std::size_t boundary) const;
  [[nodiscard]] double duration(const KeySpan& span) const;

  // The fastest span between two key points whose top is at most `v_cap`.
  [[nodiscard]] Fit fit(const Key& left, const Key& right, double v_cap, KeySpan& span) const;
  [[nodiscard]] Fit fit_peak(double v_cap, KeySpan& span) const;

  // A key point up to which it pays to go slowly, because the segments before it would spoil the
  // ramp (a blend in front of a line): at the speed of the slow end, or at one reached on the way
  // there.
  [[nodiscard]] std::optional<Key> later_start(const Key& left, const Key& right,
                                               const KeySpan& span) const;
  [[nodiscard]] std::optional<Key> earlier_end(const Key& left, const Key& right,
                                               const KeySpan& span) const;
  [[nodiscard]] std::optional<Detour> best_detour(const Key& left, const Key& right,
                                                  std::size_t boundary, Direction direction) const;
  [[nodiscard]] std::size_t behind_worst(std::size_t start, std::size_t stop, double reach,
                                         const RampLimits& limits) const;
  [[nodiscard]] std::size_t before_worst(std::size_t end, std::size_t stop, double reach,
                                         const RampLimits& limits) const;
  [[nodiscard]] double speed_across(const Key& from, std::size_t boundary) const;

  // The slowest segment that the span passes too fast; npos: none.
  [[nodiscard]] std::size_t slowest_violated(const KeySpan& span) const;

  // Puts the key points that `segment` asks for on top of `pending`; false: none, the span's top
  // is the segment's speed.
  [[nodiscard]] bool add_keys(Key& left, std::size_t segment, std::vector<Key>& pending);
  [[nodiscard]] bool add_stair(Key& left, const Key& right, std::size_t far_end,
                               Direction direction, std::vector<Key>& pending);
  [[nodiscard]] bool stair_fits(const Key& from, std::size_t end, const RampCourse& ramp,
                                double wait) const;
  [[nodiscard]] double stair_speed(const Key& from, std::size_t end) const;
  [[nodiscard]] double stair_wait(const Key& from, std::size_t end, double v,
                                  const RampLimits& limits) const;
  [[nodiscard]] Key best_stair(const Key& from, std::size_t nearest, std::size_t stop) const;
  [[nodiscard]] double distance(std::size_t from, std::size_t to) const;

  static constexpr std::size_t npos = std::numeric_limits<std::size_t>::max();

  std::vector<double> boundaries_;
  std::vector<double> v_, minus_v_, a_, j_;
  RangeMinimum slowest_, fastest_, least_a_, least_j_;
  std::vector<KeySpan> spans_;
};

}  // namespace stanok::motion
