// PlanTrace: what a plan asks of the machine axes ahead of the cycle, over the plan's own time.
//
// A grid of instants, evenly in the plan's time from where the trace began: velocity and
// acceleration of every axis at each of them, the least and the greatest jerk between it and the
// next one. The trace is a ring that grows ahead of the cycle, by a bounded number of evaluations
// of the path in each; what lies behind gives its room back. Real-time; memory is taken in the
// constructor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

class PlanTrace {
 public:
  static constexpr std::size_t capacity = 512;             // intervals
  static constexpr std::size_t evaluations_max = 96;       // of the path, in a cycle
  static constexpr std::size_t evaluations_interval = 32;  // of the path, in an interval

  explicit PlanTrace(const MotionConfig& config);

  // Begins anew: the plan's time counts from here.
  void begin(double step) RT_SAFE;

  // Looks ahead from the place of the cursor, in whose phase the plan has come to `elapsed`; the
  // plan's time there is `time`. `ahead`: so far, if the work of a cycle does.
  void look(const PathQueue& queue, const PathCursor& cursor, double elapsed, double time,
            double ahead) RT_SAFE;

  // What the plan asks of an axis at an instant.
  struct Asked {
    double velocity = 0.0;
    double acceleration = 0.0;
    double jerk = 0.0;
  };
  using Axes = AxisArray<Asked>;
  // The same at an instant that is so far ahead of the cycle, exactly; in a cycle that has looked.
  // False: the plan is not known so far.
  [[nodiscard]] bool measure(double ahead, Axes& axes) RT_SAFE;

  // How far the trace reaches.
  [[nodiscard]] double end() const RT_SAFE { return step_ * static_cast<double>(size_); }
  [[nodiscard]] int axes() const RT_SAFE { return config_.axis_count; }

  // Of an axis between two instants of the plan's time; both within the trace.
  struct Instant {
    std::size_t interval = 0;
    double part = 0.0;
  };
  [[nodiscard]] Instant at(double time) const RT_SAFE {
    const double steps = std::max(time * per_step_, 0.0);
    const auto interval = std::min(static_cast<std::size_t>(steps), size_ - 1);
    return {interval, std::min(steps - static_cast<double>(interval), 1.0)};
  }
  [[nodiscard]] double velocity(const Instant& at, int axis) const RT_SAFE {
    return between(node(at.interval).velocity[axis], node(at.interval + 1).velocity[axis], at.part);
  }
  [[nodiscard]] double acceleration(const Instant& at, int axis) const RT_SAFE {
    const Node& begin = node(at.interval);
    const double bend = begin.bend;
    if (at.part < bend) return between(begin.acceleration[axis], begin.bent[axis], at.part / bend);
    return between(begin.bent[axis], node(at.interval + 1).acceleration[axis],
                   (at.part - bend) / (1.0 - bend));
  }
  struct Span {
    double low = 0.0;
    double high = 0.0;
  };
  [[nodiscard]] Span jerk(const Instant& from, const Instant& to, int axis) const RT_SAFE {
    Span span = node(from.interval).jerk[axis];
    for (std::size_t k = from.interval + 1; k <= to.interval; ++k) {
      span.low = std::min(span.low, node(k).jerk[axis].low);
      span.high = std::max(span.high, node(k).jerk[axis].high);
    }
    return span;
  }

  // Evaluations of the path in the last look.
  [[nodiscard]] std::size_t evaluations() const RT_SAFE { return evaluations_; }

 private:
  struct Node {
    AxisArray<double> velocity{};
    AxisArray<double> acceleration{};
    AxisArray<Span> jerk{};  // up to the next node
    // Where the jerk changes most on the way there, as a part of it, and the acceleration then.
    double bend = 0.0;
    AxisArray<double> bent{};
  };
  // A place on the path and in the plan, the plan's time counted from the cycle.
  struct Place {
    std::size_t phase = 0;
    double phase_begin = 0.0;  // time
    std::size_t segment = 0;
    double segment_begin = 0.0;  // s
  };

  // To the next evaluation of the path.
  struct Step {
    double until = 0.0;  // time
    bool crosses = false;
    double segment_end = 0.0;  // s
  };

  static double between(double one, double other, double part) RT_SAFE {
    return one + part * (other - one);
  }
  [[nodiscard]] const Node& node(std::size_t index) const RT_SAFE {
    return nodes_[index % nodes_.size()];
  }
  [[nodiscard]] Node& node(std::size_t index) RT_SAFE { return nodes_[index % nodes_.size()]; }
  [[nodiscard]] Phase phase_at(std::size_t index) const RT_SAFE;
  [[nodiscard]] bool go_to(Place& place, double time) const RT_SAFE;
  [[nodiscard]] Step step_from(const Place& place, double t, double end) const RT_SAFE;
  void include(const Axes& axes, Node& here) const RT_SAFE;
  void begin_node(const Axes& axes, Node& here) const RT_SAFE;
  [[nodiscard]] double largest_change(const Axes& before, const Axes& axes) const RT_SAFE;
  void add(Place& place, double time) RT_SAFE;
  void rest() RT_SAFE;
  void evaluate_at(const Place& place, double time, Axes& axes) RT_SAFE;

  const MotionConfig config_;
  std::vector<Node> nodes_;
  double step_ = 0.001;  // s
  double per_step_ = 1000.0;
  std::size_t size_ = 0;  // intervals since the trace began
  std::size_t evaluations_ = 0;
  const PathQueue* queue_ = nullptr;
  double chunk_length_ = 0.0;
  std::size_t own_phases_ = 0;
  std::size_t phases_ = 0;
  std::size_t segments_ = 0;
  bool ends_at_rest_ = false;
  Place front_;  // of the cycle
};

}  // namespace stanok::motion
