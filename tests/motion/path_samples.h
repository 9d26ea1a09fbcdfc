// Hand-made chains for tests of the planner: lines and arcs in three axes with known bounds, and a
// runner that records every cycle of the axes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "motion/interpolation/interpolator.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/segments/path_builder.h"

namespace stanok::motion::testing {

struct Limits {
  double v = 400.0;
  double a = 2000.0;
  double j = 50000.0;
};

// Of the axes of most tests, and of the linear axes that tests of channels have.
inline constexpr Limits usual_limits{};
inline constexpr Limits channel_limits{.v = 250.0, .a = 2500.0, .j = 50000.0};

inline MotionConfig three_axes(const Limits& limits, double cycle_s = 0.001) {
  MotionConfig config;
  config.axis_count = 3;
  config.geometry = {0, 1, 2};
  config.cycle_s = cycle_s;
  for (std::size_t k = 0; k < 3; ++k) {
    config.axes[k] = {.velocity_max = limits.v,
                      .acceleration_max = limits.a,
                      .jerk_max = limits.j,
                      .rapid_max = limits.v};
  }
  return config;
}

// Appends segments, each of which starts where the last one ended. Straight segments run along X,
// so that any succession of them is smooth.
class ChainMaker {
 public:
  explicit ChainMaker(const Limits& limits) : limits_(limits) {}

  // A straight segment along X.
  ChainMaker& line(double length, double feed_per_s) {
    Segment segment = next(length, feed_per_s);
    segment.geometry.end[0] += length;
    segment.bounds = {
        .velocity = 1.0 / limits_.v, .tangent = 1.0 / limits_.a, .thrust = 1.0 / limits_.j};
    return add(segment);
  }

  // The same with stricter limits of its own: the path speed is bounded by `v`, the tangential
  // acceleration and jerk by `a` and `j`.
  ChainMaker& slow_line(double length, double feed_per_s, const Limits& own) {
    line(length, feed_per_s);
    built_.back().segment.bounds = {
        .velocity = 1.0 / own.v, .tangent = 1.0 / own.a, .thrust = 1.0 / own.j};
    return *this;
  }

  // A full circle or part of it in X and Y; the path's direction jumps at its ends, which only the
  // planner's limits along s can tell.
  ChainMaker& arc(double radius, double sweep, double feed_per_s) {
    Segment segment = next(radius * std::abs(sweep), feed_per_s);
    Geometry& geometry = segment.geometry;
    geometry.kind = SegmentKind::arc;
    geometry.plane = {0, 1};
    geometry.radius = radius;
    geometry.sweep = sweep;
    geometry.start_angle = 0.0;
    geometry.centre = {geometry.start[0] - radius, geometry.start[1]};
    geometry.end[0] = geometry.centre[0] + radius * std::cos(sweep);
    geometry.end[1] = geometry.centre[1] + radius * std::sin(sweep);
    segment.bounds = {.velocity = 1.0 / limits_.v,
                      .tangent = 1.0 / limits_.a,
                      .thrust = 1.0 / limits_.j,
                      .curvature = 1.0 / radius / limits_.a,
                      .bend = 1.0 / radius / limits_.j,
                      .aberrancy = 1.0 / (radius * radius) / limits_.j};
    return add(segment);
  }

  // Rapid travel instead of the feed of the last segment.
  ChainMaker& as_rapid() {
    built_.back().segment.rapid = true;
    built_.back().segment.feed_per_s = unlimited;
    return *this;
  }

  ChainMaker& end_chain() {
    built_.back().ends_chain = true;
    return *this;
  }

  [[nodiscard]] const std::vector<PathBuilder::Built>& built() const { return built_; }
  [[nodiscard]] const Point& end() const { return built_.back().segment.geometry.end; }
  [[nodiscard]] double length() const {
    double sum = 0.0;
    for (const auto& built : built_) sum += built.segment.length;
    return sum;
  }

 private:
  Segment next(double length, double feed_per_s) {
    Segment segment;
    segment.tag = {.run = 1, .block = block_++, .line = static_cast<std::uint32_t>(block_)};
    if (!built_.empty()) segment.geometry.start = end();
    segment.geometry.end = segment.geometry.start;
    segment.length = length;
    segment.feed_per_s = feed_per_s;
    return segment;
  }
  ChainMaker& add(const Segment& segment) {
    built_.push_back({.segment = segment, .ends_chain = false});
    return *this;
  }

  Limits limits_;
  std::uint64_t block_ = 1;
  std::vector<PathBuilder::Built> built_;
};

// Blocks that start at the origin, through the builder.
inline std::vector<PathBuilder::Built> built_from(const MotionConfig& config,
                                                  const std::vector<PathBlock>& blocks) {
  PathBuilder builder(config);
  builder.restart({});
  for (const PathBlock& block : blocks) EXPECT_FALSE(builder.add(block));
  builder.finish();
  return builder.built();
}

// What one cycle gave.
struct Sample {
  double s = 0.0;  // path length travelled since the start
  InterpolatorOutput out;
};

// Runs everything that `built` holds through look-ahead and interpolator; preparation is always as
// far ahead as the queue allows. `control` names the operator's settings of a cycle, `act` is what
// an operator does before it. Ends when all chains are done, or after `cycles_max`.
inline std::vector<Sample> run_path(
    const MotionConfig& config, const std::vector<PathBuilder::Built>& built,
    const std::function<FeedControl(int)>& control = [](int) { return FeedControl{}; },
    int cycles_max = 200000,
    const std::function<void(int, Interpolator&)>& act = [](int, Interpolator&) {}) {
  PathQueue queue;
  LookAhead look_ahead(config);
  Interpolator interpolator(config);
  std::size_t next = 0;
  std::vector<Sample> samples;
  samples.push_back({});
  if (!built.empty()) {
    for (std::size_t k = 0; k < axes_max; ++k) {
      samples[0].out.axes[k].value = built.front().segment.geometry.start[k];
    }
  }
  for (int cycle = 0; cycle < cycles_max; ++cycle) {
    while (look_ahead.deliver(queue) && next < built.size()) look_ahead.add(built[next++]);
    Sample sample;
    act(cycle, interpolator);
    interpolator.advance(queue, control(cycle), sample.out);
    sample.s = samples.back().s + sample.out.path_advanced;
    samples.push_back(sample);
    if (next == built.size() && look_ahead.is_empty() && queue.chunks.empty() &&
        sample.out.state == PathState::idle) {
      break;
    }
  }
  return samples;
}

// The largest ratio of difference quotients of the path length travelled, and of the columns v, a,
// j of axis X, to the limits. Rounding of s is taken off.
struct Ratios {
  double v = 0.0;
  double a = 0.0;
  double j = 0.0;
  [[nodiscard]] double worst() const { return std::max({v, a, j}); }
};

inline Ratios quotients_of(const std::vector<double>& q, const Limits& limits, double cycle_s) {
  Ratios worst;
  double q_max = 0.0;
  for (const double x : q) q_max = std::max(q_max, std::abs(x));
  const double floor = 4.0 * 2.2e-16 * q_max;
  for (std::size_t k = 3; k < q.size(); ++k) {
    const double d1 = q[k] - q[k - 1];
    const double d2 = d1 - (q[k - 1] - q[k - 2]);
    const double d3 = d2 - (q[k - 1] - 2.0 * q[k - 2] + q[k - 3]);
    const double t = cycle_s;
    worst.v = std::max(worst.v, (std::abs(d1) - floor) / t / limits.v);
    worst.a = std::max(worst.a, (std::abs(d2) - 2.0 * floor) / (t * t) / limits.a);
    worst.j = std::max(worst.j, (std::abs(d3) - 4.0 * floor) / (t * t * t) / limits.j);
  }
  return worst;
}

inline Ratios columns_of(const std::vector<Sample>& samples, std::size_t axis,
                         const Limits& limits) {
  Ratios worst;
  for (const Sample& sample : samples) {
    const auto& jet = sample.out.axes[axis];
    worst.v = std::max(worst.v, std::abs(jet.first) / limits.v);
    worst.a = std::max(worst.a, std::abs(jet.second) / limits.a);
    worst.j = std::max(worst.j, std::abs(jet.third) / limits.j);
  }
  return worst;
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Of a point from the straight path between two others, in X, Y, Z.
inline double distance_to_leg(const Point& p, const Point& a, const Point& b) {
  double along = 0.0;
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    squared += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double u = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  Point foot{};
  for (std::size_t k = 0; k < 3; ++k) foot[k] = a[k] + u * (b[k] - a[k]);
  return distance(p, foot);
}

inline std::vector<double> axis_of(const std::vector<Sample>& samples, std::size_t axis) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const Sample& sample : samples) values.push_back(sample.out.axes[axis].value);
  return values;
}

}  // namespace stanok::motion::testing
