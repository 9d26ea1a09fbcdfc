// Feed laws along the path, run through the real chain of builder, stage, look-ahead and cycle,
// against sums over the increments that are made here by adding them up one after another.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "motion/feed_laws/curve_law.h"
#include "motion/feed_laws/interrupted_law.h"
#include "motion/feed_laws/linear_law.h"
#include "motion/feed_laws/modulated_law.h"
#include "motion/interpolation/interpolator.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/segments/feed_law_stage.h"
#include "tests/motion/path_fixture.h"
#include "tests/support/cycle.h"

namespace stanok::motion {
namespace {

using stanok::testing::cycle_s;
using stanok::testing::increment_mm;

// Axes so strong that the laws are exact.
MotionConfig strong_mill() {
  MotionConfig config = mill(3);
  for (AxisLimits& axis : config.axes) {
    axis.velocity_max = 1e5;
    axis.acceleration_max = 1e9;
    axis.jerk_max = 1e13;
    axis.rapid_max = 1e5;
  }
  return config;
}

// One stretch of constant feed, or of standing, of what a law should do.
struct Step {
  double way = 0.0;
  double feed = 0.0;   // mm/min
  double stand = 0.0;  // mm of equivalent dwell path at `feed`, at its end
};

struct Sample {
  double time = 0.0;
  double way = 0.0;
  double feed = 0.0;
  SegmentProcess process;
  JetPoint axes{};
};

struct Travel {
  std::vector<Sample> samples;
  double time = 0.0;  // until the axes stand, to the fraction of a cycle
  double way = 0.0;
};

// What the operator does in a run: the control of each cycle.
using Operator = std::function<FeedControl(double time)>;

Travel run_blocks(const std::vector<PathBlock>& blocks, const MotionConfig& config,
                  const Operator& control = nullptr) {
  PathBuilder builder(config);
  builder.restart({});
  FeedLawStage stage;
  LookAhead look_ahead(config);
  auto queue = std::make_unique<PathQueue>(1 << 16);
  auto interpolator = std::make_unique<Interpolator>(config);
  for (const PathBlock& block : blocks) EXPECT_FALSE(builder.add(block));
  builder.finish();
  for (const auto& built : builder.built()) stage.add(built);
  Travel run;
  InterpolatorOutput out;
  constexpr int cycles_max = 3'000'000;
  for (int n = 0; n < cycles_max; ++n) {
    while (!stage.is_empty()) {
      if (!look_ahead.deliver(*queue) || queue->chunks.size() > 200) break;
      look_ahead.add(stage.next());
    }
    static_cast<void>(look_ahead.deliver(*queue));
    interpolator->advance(*queue, control ? control(n * cycle_s) : FeedControl{}, out);
    run.way += out.path_advanced;
    run.time = (n + 1) * cycle_s;
    run.samples.push_back({run.time, run.way, out.feed_commanded, out.process, out.axes});
    if (out.state == PathState::idle && stage.is_empty() && look_ahead.is_empty()) {
      run.time -= out.cycle_left;
      return run;
    }
  }
  ADD_FAILURE() << "the path does not end";
  return run;
}

double time_of(const std::vector<Step>& steps) {
  double time = 0.0;
  for (const Step& step : steps) time += 60.0 * (step.way + step.stand) / step.feed;
  return time;
}

// Path travelled after `time`.
double way_after(const std::vector<Step>& steps, double time) {
  double way = 0.0;
  for (const Step& step : steps) {
    const double cuts = 60.0 * step.way / step.feed;
    if (time <= cuts) return way + time * step.feed / 60.0;
    way += step.way;
    time -= cuts + 60.0 * step.stand / step.feed;
    if (time <= 0.0) return way;
  }
  return way;
}

// The feed in force at a place of the path; at an increment either one.
bool is_feed_at(const std::vector<Step>& steps, double way, double feed) {
  double start = 0.0;
  for (const Step& step : steps) {
    const double end = start + step.way;
    if (way >= start - increment_mm && way <= end + increment_mm &&
        std::abs(feed - step.feed / 60.0) < 1e-9)
      return true;
    start = end;
  }
  return false;
}

// How the path of 0 to `length` looks: a line, an arc of many radii, a curve.
enum class Way { line, arc, spline };

std::vector<PathBlock> block_of(Way way, double length) {
  if (way == Way::line) return {line_to({length, 0.0, 0.0})};
  if (way == Way::arc) {
    const double radius = 0.3 * length;
    return {arc_to({}, {0.0, radius}, length / radius, {})};
  }
  PathBlock curve = line_to({0.8 * length, 0.2 * length, 0.0});
  curve.kind = BlockKind::curve;
  curve.curve[0] = {0.0, 0.5 * length, 0.5 * length, -0.2 * length};
  curve.curve[1] = {0.0, 0.0, 0.9 * length, -0.7 * length};
  return {curve};
}

Shape shape_of(const PathBlock& block, const Point& start) {
  const PathMetric metric{3, 0b111};
  if (block.kind == BlockKind::line) return line(metric, start, block.end);
  if (block.kind == BlockKind::arc) return arc(metric, start, block);
  return curve(metric, start, block);
}

double length_of(const std::vector<PathBlock>& blocks) {
  double length = 0.0;
  Point start{};
  for (const PathBlock& block : blocks) {
    const Shape shape = shape_of(block, start);
    length += shape.length;
    start = block.end;
  }
  return length;
}

// Puts a law on the blocks: over all of them, from their start to their end.
void put_law(const FeedLaw& law, double feed_max, std::vector<PathBlock>& blocks) {
  double way = 0.0;
  Point start{};
  const double total = length_of(blocks);
  for (PathBlock& block : blocks) {
    const Shape shape = shape_of(block, start);
    block.process = {
        .law = &law, .path_start = way, .path_length = shape.length, .path_end = total};
    block.feed_per_s = feed_max / 60.0;
    way += shape.length;
    start = block.end;
  }
}

// What the axes lose at increments, for they are strong but not infinitely so: a ramp between rest
// and the feed, 2 sqrt(v / J) long at the highest jerk that a profile uses, is half its length
// behind.
double way_lost(const std::vector<Step>& steps) {
  constexpr double jerk = 1e12;
  double lost = 0.0;
  for (const Step& step : steps) {
    const double v = step.feed / 60.0;
    if (step.stand > 0.0) lost += 2.0 * v * std::sqrt(v / jerk);
  }
  return lost;
}

void expect_run(const Travel& run, const std::vector<Step>& steps, double increments) {
  double way = 0.0;
  for (const Step& step : steps) way += step.way;
  EXPECT_NEAR(run.way, way, 1e-6);
  EXPECT_NEAR(run.time, time_of(steps), cycle_s);
  const double tolerance = increment_mm + way_lost(steps);
  for (const Sample& sample : run.samples) {
    if (sample.time > run.time) break;
    EXPECT_NEAR(sample.way, way_after(steps, sample.time), tolerance) << "at " << sample.time;
    EXPECT_TRUE(is_feed_at(steps, sample.way, sample.feed))
        << sample.feed * 60.0 << " at " << sample.way << " mm";
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(static_cast<double>(run.samples.back().process.increments), increments);
}

struct LinearCase {
  double length;
  double feed;
  double step;  // signed
  double path_step;
  Way way = Way::line;
};

class LinearFeed : public ::testing::TestWithParam<LinearCase> {};

TEST_P(LinearFeed, RunsByTheSumOverItsIncrements) {
  const LinearCase& c = GetParam();
  std::vector<PathBlock> blocks = block_of(c.way, c.length);
  const double length = length_of(blocks);
  std::vector<Step> steps;
  double feed = c.feed;
  double way = 0.0;
  double increments = 0.0;
  for (int n = 1; n * c.path_step < length - 1e-9; ++n) {
    steps.push_back({c.path_step, feed});
    way += c.path_step;
    feed += c.step;
    increments += 1.0;
  }
  steps.push_back({length - way, feed});
  const LinearLaw law({}, {.feed_first = c.feed, .feed_step = c.step, .path_step_mm = c.path_step});
  put_law(law, std::max(c.feed, feed), blocks);
  expect_run(run_blocks(blocks, strong_mill()), steps, increments);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, LinearFeed,
    ::testing::Values(
        LinearCase{10.0, 60.0, 0.1, 0.05}, LinearCase{10.0, 60.0, -0.1, 0.05},
        LinearCase{5.0, 300.0, 10.0, 0.1}, LinearCase{5.0, 300.0, -3.0, 0.1},
        LinearCase{20.0, 1200.0, 0.5, 0.01}, LinearCase{20.0, 3000.0, -1.0, 0.01},
        LinearCase{1.0, 600.0, 0.1, 0.001}, LinearCase{0.5, 30.0, 5.0, 0.2},
        LinearCase{3.3, 100.0, 20.0, 0.7}, LinearCase{2.0, 100.0, 0.3, 3.0},
        LinearCase{8.0, 120.0, 2.0, 0.25, Way::arc}, LinearCase{8.0, 400.0, -4.0, 0.125, Way::arc},
        LinearCase{12.0, 900.0, 0.2, 0.02, Way::arc}, LinearCase{9.0, 250.0, 1.0, 0.1, Way::spline},
        LinearCase{15.0, 800.0, -0.7, 0.05, Way::spline},
        LinearCase{6.0, 2000.0, 10.0, 0.03, Way::spline}, LinearCase{4.0, 12.0, 0.1, 0.5},
        // Several in one cycle.
        LinearCase{8.0, 3000.0, 0.5, 0.004, Way::arc},
        LinearCase{8.0, 3000.0, -0.5, 0.002, Way::arc},
        LinearCase{8.0, 2400.0, 0.3, 0.003, Way::spline}));

struct ModulatedCase {
  double length;
  double feed_min;
  double step;
  double path_step;
  std::uint64_t steps;
  Way way = Way::line;
};

class ModulatedFeed : public ::testing::TestWithParam<ModulatedCase> {};

TEST_P(ModulatedFeed, RisesAndFallsByTheSumOverItsIncrements) {
  const ModulatedCase& c = GetParam();
  std::vector<PathBlock> blocks = block_of(c.way, c.length);
  const double length = length_of(blocks);
  std::vector<Step> steps;
  double feed = c.feed_min;
  double way = 0.0;
  double increments = 0.0;
  double direction = 1.0;  // the sign of the buffer cell of dl in the seed
  std::uint64_t left = c.steps;
  for (int n = 1; n * c.path_step < length - 1e-9; ++n) {
    steps.push_back({c.path_step, feed});
    way += c.path_step;
    feed += direction * c.step;
    increments += 1.0;
    if (--left == 0) {
      direction = -direction;
      left = c.steps;
    }
  }
  steps.push_back({length - way, feed});
  const ModulatedLaw law(
      {},
      {.feed_min = c.feed_min, .feed_step = c.step, .path_step_mm = c.path_step, .steps = c.steps});
  put_law(law, c.feed_min + static_cast<double>(c.steps) * c.step, blocks);
  expect_run(run_blocks(blocks, strong_mill()), steps, increments);
}

INSTANTIATE_TEST_SUITE_P(Cases, ModulatedFeed,
                         ::testing::Values(ModulatedCase{10.0, 50.0, 10.0, 0.2, 10},
                                           ModulatedCase{10.0, 50.0, 1.0, 0.02, 40},
                                           ModulatedCase{5.0, 100.0, 0.1, 0.01, 100},
                                           ModulatedCase{5.0, 600.0, 100.0, 0.05, 1},
                                           ModulatedCase{7.0, 60.0, 60.0, 0.3, 2},
                                           ModulatedCase{3.0, 1000.0, 50.0, 0.004, 20},
                                           ModulatedCase{20.0, 2000.0, 10.0, 0.1, 30},
                                           ModulatedCase{1.0, 20.0, 5.0, 0.1, 3},
                                           ModulatedCase{4.0, 90.0, 9.0, 1.5, 5},
                                           ModulatedCase{2.0, 90.0, 9.0, 0.001, 50},
                                           ModulatedCase{8.0, 120.0, 20.0, 0.25, 6, Way::arc},
                                           ModulatedCase{8.0, 300.0, 3.0, 0.02, 25, Way::arc},
                                           ModulatedCase{12.0, 900.0, 30.0, 0.06, 15, Way::arc},
                                           ModulatedCase{9.0, 150.0, 15.0, 0.15, 8, Way::spline},
                                           ModulatedCase{14.0, 500.0, 5.0, 0.03, 60, Way::spline},
                                           ModulatedCase{6.0, 1500.0, 250.0, 0.2, 4, Way::spline}));

struct InterruptedCase {
  double length;
  double feed;
  double stand;
  double cut;
  Way way = Way::line;
};

class InterruptedFeed : public ::testing::TestWithParam<InterruptedCase> {};

TEST_P(InterruptedFeed, StandsForTheTimeOfItsEquivalentDwellPath) {
  const InterruptedCase& c = GetParam();
  std::vector<PathBlock> blocks = block_of(c.way, c.length);
  const double length = length_of(blocks);
  std::vector<Step> steps;
  double way = 0.0;
  double increments = 0.0;
  while (way + c.cut < length - 1e-9) {
    steps.push_back({c.cut, c.feed, c.stand});
    way += c.cut;
    increments += 1.0;
  }
  steps.push_back({length - way, c.feed});  // no stand behind the end of the block
  const InterruptedLaw law(c.stand, c.cut);
  put_law(law, c.feed, blocks);
  expect_run(run_blocks(blocks, strong_mill()), steps, increments);
}

INSTANTIATE_TEST_SUITE_P(Cases, InterruptedFeed,
                         ::testing::Values(InterruptedCase{10.0, 120.0, 0.4, 2.0},
                                           InterruptedCase{10.0, 60.0, 0.1, 0.5},
                                           InterruptedCase{6.0, 300.0, 1.0, 0.25},
                                           InterruptedCase{6.0, 600.0, 0.05, 0.1},
                                           InterruptedCase{20.0, 1500.0, 2.0, 5.0},
                                           InterruptedCase{3.0, 90.0, 0.001, 0.3},
                                           InterruptedCase{3.0, 45.0, 0.5, 3.0},
                                           InterruptedCase{3.0, 45.0, 0.5, 1.0},
                                           InterruptedCase{2.0, 200.0, 0.02, 0.013},
                                           InterruptedCase{1.0, 30.0, 0.3, 7.0},
                                           InterruptedCase{8.0, 150.0, 0.2, 0.7, Way::arc},
                                           InterruptedCase{8.0, 480.0, 0.6, 0.2, Way::arc},
                                           InterruptedCase{12.0, 240.0, 0.9, 2.5, Way::arc},
                                           InterruptedCase{9.0, 180.0, 0.3, 1.1, Way::spline},
                                           InterruptedCase{14.0, 700.0, 0.15, 0.4, Way::spline},
                                           InterruptedCase{6.0, 2400.0, 1.2, 0.9, Way::spline}));

// Two blocks with a corner that is rounded: the law's path goes on through the blend.
TEST(FeedLaw, GoesOnAcrossBlocks) {
  std::vector<PathBlock> blocks{line_to({4.0, 0.0, 0.0}), line_to({4.0, 6.0, 0.0})};
  for (PathBlock& block : blocks) block.tolerance_mm = 0.2;
  const LinearLaw law({}, {.feed_first = 120.0, .feed_step = 1.0, .path_step_mm = 0.05});
  put_law(law, 320.0, blocks);
  const Travel run = run_blocks(blocks, strong_mill());
  EXPECT_EQ(run.samples.back().process.increments, 199U);
  std::uint64_t made = 0;
  for (const Sample& sample : run.samples) {
    const double rounded = 0.5;  // the blend is shorter than the corner by less
    EXPECT_NEAR(sample.way, 0.05 * static_cast<double>(sample.process.increments), rounded);
    EXPECT_NEAR(60.0 * sample.feed * (sample.feed > 0.0 ? 1.0 : 0.0),
                sample.feed > 0.0 ? 120.0 + static_cast<double>(sample.process.increments) : 0.0,
                1e-9);
    EXPECT_GE(sample.process.increments, made);
    made = sample.process.increments;
  }
}

MotionConfig real_mill() {
  MotionConfig config = mill(3);
  for (AxisLimits& axis : config.axes) {
    axis.velocity_max = 250.0;
    axis.acceleration_max = 2500.0;
    axis.jerk_max = 50000.0;
    axis.rapid_max = 250.0;
  }
  return config;
}

// Every increment that the path has passed is made, and none ahead of it.
void expect_increments_in_place(const Travel& run, const FeedLaw& law) {
  for (const Sample& sample : run.samples) {
    const auto made = sample.process.increments;
    EXPECT_LE(sample.way, law.stretch(made).end_mm + 1e-6);
    if (made > 0) {
      EXPECT_GE(sample.way, law.stretch(made - 1).end_mm - 1e-6);
    }
    if (::testing::Test::HasFailure()) return;
  }
}

void expect_limits_kept(const Travel& run, const MotionConfig& config) {
  for (const Sample& sample : run.samples) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(sample.axes[k].first), config.axes[k].velocity_max * (1.0 + 1e-9));
      EXPECT_LE(std::abs(sample.axes[k].second), config.axes[k].acceleration_max * (1.0 + 1e-9));
      EXPECT_LE(std::abs(sample.axes[k].third), config.axes[k].jerk_max * (1.0 + 1e-9));
    }
    if (::testing::Test::HasFailure()) return;
  }
}

struct AnyLaw {
  const char* name;
  std::function<std::unique_ptr<FeedLaw>()> make;
  double feed_max;
};

std::vector<AnyLaw> all_laws() {
  return {{"linear up",
           [] {
             return std::make_unique<LinearLaw>(
                 LawUnits{},
                 LinearLawParameters{.feed_first = 600.0, .feed_step = 25.0, .path_step_mm = 0.25});
           },
           2600.0},
          {"linear down",
           [] {
             return std::make_unique<LinearLaw>(
                 LawUnits{}, LinearLawParameters{
                                 .feed_first = 2600.0, .feed_step = -25.0, .path_step_mm = 0.25});
           },
           2600.0},
          {"modulated",
           [] {
             return std::make_unique<ModulatedLaw>(
                 LawUnits{},
                 ModulatedLawParameters{
                     .feed_min = 200.0, .feed_step = 50.0, .path_step_mm = 0.05, .steps = 20});
           },
           1200.0},
          {"interrupted", [] { return std::make_unique<InterruptedLaw>(0.4, 2.0); }, 1000.0},
          {"curve",
           [] {
             return std::make_unique<CurveLaw>(
                 LawUnits{},
                 std::vector<CurveLawPoint>{{.feed = 300.0},
                                            {.path_mm = 6.0, .feed = 1500.0},
                                            {.path_mm = 15.0, .feed = 200.0}},
                 5.0, increment_mm);
           },
           1500.0}};
}

TEST(FeedLaw, KeepsItsPlacesAndTheLimitsOfRealAxes) {
  for (const AnyLaw& any : all_laws()) {
    for (const Way way : {Way::line, Way::arc, Way::spline}) {
      SCOPED_TRACE(any.name);
      const auto law = any.make();
      std::vector<PathBlock> blocks = block_of(way, 20.0);
      put_law(*law, any.feed_max, blocks);
      const Travel run = run_blocks(blocks, real_mill());
      EXPECT_NEAR(run.way, length_of(blocks), 1e-6);
      expect_increments_in_place(run, *law);
      expect_limits_kept(run, real_mill());
    }
  }
}

TEST(FeedLaw, IsMovedNeitherByOverrideNorByHold) {
  const auto override_changes = [](double time) {
    FeedControl control;
    if (time > 0.3) control.feed_override = 0.5;
    if (time > 0.9) control.feed_override = 1.2;
    control.hold = time > 1.3 && time < 1.8;
    if (time > 2.2) control.feed_override = 1.0;
    return control;
  };
  for (const AnyLaw& any : all_laws()) {
    for (const Way way : {Way::line, Way::arc, Way::spline}) {
      SCOPED_TRACE(any.name);
      const auto law = any.make();
      std::vector<PathBlock> blocks = block_of(way, 20.0);
      put_law(*law, any.feed_max, blocks);
      const Travel run = run_blocks(blocks, real_mill(), override_changes);
      EXPECT_NEAR(run.way, length_of(blocks), 1e-6);
      expect_increments_in_place(run, *law);
      expect_limits_kept(run, real_mill());
    }
  }
}

// Also where the feed falls in steps that are smaller than what a cycle of braking takes away.
TEST(FeedLaw, TakesItsTimeUnderAConstantOverride) {
  for (const double part : {0.5, 0.9, 1.2}) {
    for (const double step : {2.0, -2.0}) {
      SCOPED_TRACE(::testing::Message() << part << ", " << step);
      const LinearLaw law({}, {.feed_first = 200.0, .feed_step = step, .path_step_mm = 0.1});
      std::vector<PathBlock> blocks{line_to({5.0, 0.0, 0.0})};
      put_law(law, std::max(200.0, 200.0 + 49.0 * step), blocks);
      double wanted = 0.0;
      for (int k = 0; k < 50; ++k) wanted += 60.0 * 0.1 / (part * (200.0 + k * step));
      const auto overridden = [part](double) { return FeedControl{.feed_override = part}; };
      const Travel run = run_blocks(blocks, strong_mill(), overridden);
      // Where it changes within a cycle, the cycle has the smaller of the two feeds.
      const double late = cycle_s * std::abs(std::log((200.0 + 49.0 * step) / 200.0));
      EXPECT_NEAR(run.time, wanted, cycle_s + late);
    }
  }
}

// The equivalent dwell path counts down at the feed under override, and not at all in a hold.
TEST(FeedLaw, StandsLongerUnderOverrideAndHold) {
  const InterruptedLaw law(2.0, 2.0);  // at 600 mm/min: 0.2 s each
  std::vector<PathBlock> blocks{line_to({4.0, 0.0, 0.0})};
  put_law(law, 600.0, blocks);
  const double plain = run_blocks(blocks, strong_mill()).time;
  EXPECT_NEAR(plain, 0.6, cycle_s);
  const auto half = [](double time) {
    FeedControl control;
    if (time > 0.2005 && time < 0.3) control.feed_override = 0.5;
    return control;
  };
  EXPECT_NEAR(run_blocks(blocks, strong_mill(), half).time, 0.6 + 0.05, 2.5 * cycle_s);
  const auto held = [](double time) {
    FeedControl control;
    control.hold = time > 0.25 && time < 0.35;
    return control;
  };
  EXPECT_NEAR(run_blocks(blocks, strong_mill(), held).time, 0.7, 2.5 * cycle_s);
}

TEST(FeedLaw, OfACurvePassesItsPointsWithinOneIncrement) {
  const std::vector<CurveLawPoint> points{{.feed = 100.0, .speed = 500.0},
                                          {.path_mm = 3.0, .feed = 137.0, .speed = 800.0},
                                          {.path_mm = 3.5, .feed = 90.0, .speed = 800.0},
                                          {.path_mm = 9.0, .feed = 91.0, .speed = 400.0}};
  const LawUnits units{.speed = LawSpeed::rev_per_min};
  const CurveLaw law(units, points, 0.5, increment_mm);
  for (int n = 0; n < 324; ++n) {
    const double way = 0.0371 * n;
    std::size_t k = 0;
    while (k + 2 < points.size() && way > points[k + 1].path_mm) ++k;
    const double part =
        std::min(1.0, (way - points[k].path_mm) / (points[k + 1].path_mm - points[k].path_mm));
    const LawStretch stretch = law.stretch(law.increments_at(way));
    const double steepest = (137.0 - 90.0) / 0.5 * increment_mm;
    EXPECT_NEAR(stretch.feed, points[k].feed + part * (points[k + 1].feed - points[k].feed),
                0.5 + steepest);
    EXPECT_NEAR(stretch.speed, points[k].speed + part * (points[k + 1].speed - points[k].speed),
                5.0);
    EXPECT_GT(stretch.end_mm, way);
  }
}

}  // namespace
}  // namespace stanok::motion
