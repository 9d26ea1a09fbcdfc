// Cost of path geometry: evaluation in the cycle, blocks to segments in preparation.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "kinematics/scheme.h"
#include "motion/bounds/segment_bounds.h"
#include "motion/path/arc_length.h"
#include "motion/path/geometry.h"
#include "motion/path/shape.h"
#include "motion/segments/path_builder.h"

namespace {

using namespace stanok;
using motion::Segment;

constexpr motion::PathMetric five_axes{5, 0b111};

motion::MotionConfig mill() {
  motion::MotionConfig config;
  config.axis_count = 5;
  config.geometry = {0, 1, 2};
  for (std::size_t k = 0; k < 5; ++k) {
    config.axes[k] = {.linear = k < 3,
                      .position_min = k < 3 ? -1000.0 : -motion::unlimited,
                      .position_max = k < 3 ? 1000.0 : motion::unlimited,
                      .velocity_max = 400.0,
                      .acceleration_max = 4000.0,
                      .jerk_max = 100000.0,
                      .rapid_max = 400.0};
  }
  return config;
}

std::unique_ptr<const kinematics::Scheme> head_table() {
  kinematics::SchemeConfig config;
  config.type = "head_table";
  config.axes = {0, 1, 2, 3, 4};
  config.linear = {0, 1, 2};
  config.geometry = kinematics::HeadTable::Geometry{
      .head_axis = 3, .table_axis = 4, .pivot_to_spindle = {0.0, 0.0, -120.0}};
  return kinematics::make_scheme(config);
}

Segment segment_of(const motion::Shape& shape) {
  Segment segment;
  segment.geometry = shape.geometry;
  segment.length = shape.length;
  return segment;
}

Segment right_angle() {
  motion::Contact from;
  motion::Contact to;
  from.position = {-1.0, 0.0, 0.0, -2.0, 1.0};
  from.tangent = {1.0, 0.0, 0.0, 2.0, -1.0};
  to.position = {0.0, 1.0, 0.0, 1.0, 0.5};
  to.tangent = {0.0, 1.0, 0.0, 1.0, 0.5};
  return segment_of(motion::blend_curve(five_axes, from, to, 1.0));
}

void evaluate_all_along(benchmark::State& state, const Segment& segment) {
  motion::JetPoint point;
  double x = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    x += 0.618033988749895;
    if (x > 1.0) x -= 1.0;
    motion::evaluate(segment, x * segment.length, point);
    benchmark::DoNotOptimize(point);
  }
}

void evaluate_line(benchmark::State& state) {
  evaluate_all_along(state, segment_of(motion::line(five_axes, {}, {1.0, 2.0, 3.0, 4.0, 5.0})));
}
BENCHMARK(evaluate_line);

void evaluate_arc(benchmark::State& state) {
  motion::PathBlock block;
  block.end = {-10.0, 0.0, 3.0, 4.0, 5.0};
  block.sweep_rad = std::numbers::pi;
  evaluate_all_along(state, segment_of(motion::arc(five_axes, {10.0}, block)));
}
BENCHMARK(evaluate_arc);

void evaluate_arc_with_rounded_end(benchmark::State& state) {
  motion::PathBlock block;
  block.end = {-10.0004, 0.0, 3.0, 4.0, 5.0};
  block.sweep_rad = std::numbers::pi;
  evaluate_all_along(state, segment_of(motion::arc(five_axes, {10.0}, block)));
}
BENCHMARK(evaluate_arc_with_rounded_end);

void evaluate_quintic(benchmark::State& state) {
  evaluate_all_along(state, right_angle());
}
BENCHMARK(evaluate_quintic);

// One block of a dense five-axis path per iteration.
void build_five_axis_blocks(benchmark::State& state) {
  const auto scheme = head_table();
  kinematics::Transform transform;
  transform.scheme = scheme.get();
  transform.mode = state.range(0) == 1 ? kinematics::PointMode::tip : kinematics::PointMode::axes;
  transform.tool.nose_to_tip_mm = {0.0, 0.0, -80.0};
  motion::PathBuilder builder(mill());
  motion::PathBlock block;
  block.feed_per_s = 50.0;
  block.tolerance_mm = 0.01;
  block.tolerance_deg = 0.05;
  block.transform = &transform;
  builder.restart({50.0, 0.0, 0.0, 20.0, 0.0});
  int n = 0;
  for ([[maybe_unused]] auto _ : state) {
    const double angle = 0.004 * ++n;
    block.end = {50.0 * std::cos(angle), 50.0 * std::sin(angle), 3.0 * std::sin(0.3 * angle),
                 20.0 + 5.0 * std::sin(0.7 * angle), 20.0 * angle};
    if (builder.add(block)) state.SkipWithError("unreachable");
    builder.built().clear();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(build_five_axis_blocks)->ArgName("tip")->Arg(0)->Arg(1);

void bounds_of_a_blend(benchmark::State& state) {
  const auto scheme = head_table();
  kinematics::Transform transform;
  transform.scheme = scheme.get();
  transform.mode = state.range(0) == 1 ? kinematics::PointMode::tip : kinematics::PointMode::axes;
  Segment segment = right_angle();
  segment.transform = &transform;
  const motion::MotionConfig config = mill();
  for ([[maybe_unused]] auto _ : state) {
    const motion::SegmentBounds bounds = motion::segment_bounds(segment, config);
    benchmark::DoNotOptimize(bounds);
  }
}
BENCHMARK(bounds_of_a_blend)->ArgName("tip")->Arg(0)->Arg(1);

}  // namespace
