// Cost of planning a piece and of one real-time cycle: nominal, under override, under hold.
//
// The path is dense CAM work: blends of 0.1 mm on a curve whose curvature changes, five axes,
// several blocks a cycle.
#include <benchmark/benchmark.h>

#include <cmath>

#include "kinematics/scheme.h"
#include "motion/interpolator.h"
#include "motion/look_ahead.h"
#include "motion/path_builder.h"

namespace stanok::motion {
namespace {

MotionConfig five_axes() {
  MotionConfig config;
  config.axis_count = 5;
  config.geometry = {0, 1, 2};
  for (std::size_t k = 0; k < 5; ++k) {
    config.axes[k] = {.linear = k < 3,
                      .velocity_max = 400.0,
                      .acceleration_max = 4000.0,
                      .jerk_max = 100000.0,
                      .rapid_max = 400.0};
  }
  return config;
}

const kinematics::Transform& transform() {
  static const auto scheme = [] {
    kinematics::SchemeConfig config;
    config.type = "cartesian";
    config.axes = {0, 1, 2, 3, 4};
    return kinematics::make_scheme(config);
  }();
  static const kinematics::Transform transform = [] {
    kinematics::Transform made;
    made.scheme = scheme.get();
    return made;
  }();
  return transform;
}

const std::vector<PathBuilder::Built>& dense_path() {
  static const std::vector<PathBuilder::Built> path = [] {
    PathBuilder builder(five_axes());
    builder.restart({});
    for (int k = 1; k <= 12000; ++k) {
      const double t = 0.003 * k;
      PathBlock block;
      block.tag = {.run = 1, .block = static_cast<std::uint64_t>(k)};
      block.end = {30.0 * t, 8.0 * std::sin(t) + 0.5 * std::sin(9.0 * t), 3.0 * std::sin(2.3 * t),
                   10.0 * std::sin(0.7 * t), 5.0 * t};
      block.feed_per_s = 5000.0 / 60.0;
      block.tolerance_mm = 0.01;
      block.tolerance_deg = 0.05;
      block.transform = &transform();
      static_cast<void>(builder.add(block));
    }
    builder.finish();
    return builder.built();
  }();
  return path;
}

void plan_pieces(benchmark::State& state) {
  const auto& path = dense_path();
  const MotionConfig config = five_axes();
  for ([[maybe_unused]] auto _ : state) {
    LookAhead look_ahead(config);
    for (const auto& built : path) look_ahead.add(built);
    benchmark::DoNotOptimize(look_ahead.is_empty());
  }
  state.counters["time_per_piece"] = benchmark::Counter(
      static_cast<double>(path.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(plan_pieces)->Unit(benchmark::kMillisecond);

// One cycle; the path is run again and again, preparation is not timed.
void run_cycles(benchmark::State& state, const FeedControl& even, const FeedControl& odd) {
  const auto& path = dense_path();
  const MotionConfig config = five_axes();
  PathQueue queue;
  LookAhead look_ahead(config);
  Interpolator interpolator(config);
  InterpolatorOutput out;
  std::size_t next = 0;
  std::uint64_t cycle = 0;
  for ([[maybe_unused]] auto _ : state) {
    if (queue.chunks.size() < 3) {
      state.PauseTiming();
      while (look_ahead.deliver(queue)) {
        look_ahead.add(path[next]);
        next = (next + 1) % path.size();
      }
      state.ResumeTiming();
    }
    interpolator.advance(queue, cycle / 200 % 2 == 0 ? even : odd, out);
    ++cycle;
    benchmark::DoNotOptimize(out);
  }
}

void cycle_nominal(benchmark::State& state) {
  run_cycles(state, {}, {});
}
BENCHMARK(cycle_nominal);

void cycle_override_changing(benchmark::State& state) {
  run_cycles(state, {.feed_override = 0.7}, {.feed_override = 1.3});
}
BENCHMARK(cycle_override_changing);

void cycle_hold_and_resume(benchmark::State& state) {
  run_cycles(state, {.hold = true}, {});
}
BENCHMARK(cycle_hold_and_resume);

}  // namespace
}  // namespace stanok::motion
