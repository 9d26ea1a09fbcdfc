// Cost of planning a block and of one real-time cycle: nominal, under override, under hold.
//
// The path is dense CAM work: blocks of 0.1 mm on a curve whose curvature changes, five axes,
// several blocks a cycle. Planning is also measured where every join is a blend of its own, so that
// segments of high and low limits take turns, at a feed that the axes do not allow, and on corners.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <random>

#include "kinematics/scheme.h"
#include "motion/interpolation/interpolator.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/path/path_history.h"
#include "motion/retrace/retrace.h"
#include "motion/segments/path_builder.h"

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

constexpr int blocks = 12000;
constexpr double feed = 5000.0 / 60.0;

std::vector<PathBuilder::Built> dense_path(const MotionConfig& config, double feed_per_s) {
  PathBuilder builder(config);
  builder.restart({});
  for (int k = 1; k <= blocks; ++k) {
    const double t = 0.003 * k;
    PathBlock block;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(k)};
    block.end = {30.0 * t, 8.0 * std::sin(t) + 0.5 * std::sin(9.0 * t), 3.0 * std::sin(2.3 * t),
                 10.0 * std::sin(0.7 * t), 5.0 * t};
    block.feed_per_s = feed_per_s;
    block.tolerance_mm = 0.01;
    block.tolerance_deg = 0.05;
    block.transform = &transform();
    static_cast<void>(builder.add(block));
  }
  builder.finish();
  return builder.built();
}

// Legs of 0.5 to 5 mm with a turn of up to 57 degrees and a feed of its own each, in three axes.
std::vector<PathBuilder::Built> corners() {
  PathBuilder builder(five_axes());
  builder.restart({});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  double heading = 0.0;
  for (int k = 1; k <= blocks; ++k) {
    const double length = 0.5 * std::pow(10.0, part(random));
    heading += 2.0 * part(random) - 1.0;
    PathBlock block;
    block.tag = {.run = 1, .block = static_cast<std::uint64_t>(k)};
    block.end = builder.end();
    block.end[0] += length * std::cos(heading);
    block.end[1] += length * std::sin(heading);
    block.feed_per_s = 20.0 + 60.0 * part(random);
    block.tolerance_mm = 0.01;
    block.tolerance_deg = 0.05;
    block.transform = &transform();
    static_cast<void>(builder.add(block));
  }
  builder.finish();
  return builder.built();
}

void plan_blocks(benchmark::State& state,
                 const std::function<std::vector<PathBuilder::Built>()>& built) {
  const auto path = built();
  for ([[maybe_unused]] auto _ : state) {
    LookAhead look_ahead(five_axes());
    for (const auto& segment : path) look_ahead.add(segment);
    benchmark::DoNotOptimize(look_ahead.is_empty());
  }
  using benchmark::Counter;
  state.counters["time_per_block"] =
      Counter(blocks, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["segments_per_block"] = static_cast<double>(path.size()) / blocks;
}

MotionConfig without_runs() {
  MotionConfig config = five_axes();
  config.run_turn_max_deg = 0.0;
  return config;
}

constexpr double axis_limits = 10.0 * feed;
BENCHMARK_CAPTURE(plan_blocks, run, [] { return dense_path(five_axes(), feed); });
BENCHMARK_CAPTURE(plan_blocks, run_at_axis_limits,
                  [] { return dense_path(five_axes(), axis_limits); });
BENCHMARK_CAPTURE(plan_blocks, blends, [] { return dense_path(without_runs(), feed); });
BENCHMARK_CAPTURE(plan_blocks, blends_at_axis_limits,
                  [] { return dense_path(without_runs(), axis_limits); });
BENCHMARK_CAPTURE(plan_blocks, corners, corners);

const std::vector<PathBuilder::Built>& path_at_feed() {
  static const auto path = dense_path(five_axes(), feed);
  return path;
}

// One cycle; the path is run again and again, preparation is not timed.
void run_cycles(benchmark::State& state, const FeedControl& even, const FeedControl& odd,
                const std::vector<PathBuilder::Built>& path = path_at_feed()) {
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

// Stops where the axes limit the speed: the mean of the brake, of rest and of the way back.
void cycle_stop_at_axis_limits(benchmark::State& state) {
  static const auto path = dense_path(five_axes(), axis_limits);
  run_cycles(state, {.hold = true}, {}, path);
}
BENCHMARK(cycle_stop_at_axis_limits);

// What has been passed is noted: per segment, with the bytes that it takes, in as many axes.
void note_passed_segment(benchmark::State& state) {
  PathHistory history(std::size_t{48} << 20);
  std::vector<Segment> segments;
  for (const auto& built : path_at_feed()) {
    segments.push_back(built.segment);
    segments.back().geometry.metric.axis_count = static_cast<int>(state.range(0));
  }
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    history.note(segments[next], ChainPlace::within);
    next = (next + 1) % segments.size();
  }
  state.counters["bytes"] =
      static_cast<double>(history.newest() - history.before(history.newest()));
}
BENCHMARK(note_passed_segment)->ArgName("axes")->Arg(3)->Arg(5);

// One cycle of the way back, and forwards again.
void cycle_retrace(benchmark::State& state) {
  const MotionConfig config = five_axes();
  PathHistory history(std::size_t{48} << 20);
  for (const auto& built : path_at_feed())
    history.note(built.segment, built.ends_chain ? ChainPlace::last : ChainPlace::within);
  Retrace retrace(config, history);
  retrace.begin(nullptr, 0.0, {});
  RetraceOutput out;
  for ([[maybe_unused]] auto _ : state) {
    if (retrace.is_at_rest()) {
      retrace.go(retrace.is_at_end(RetraceWay::back) ? RetraceWay::forward : RetraceWay::back);
    }
    retrace.advance({}, out);
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(cycle_retrace);

}  // namespace
}  // namespace stanok::motion
