// Corners passed by overlapping two legs in time: closed forms, and on random polylines limits,
// tolerance, time and exact ends, whatever the operator does.
#include <gtest/gtest.h>

#include <numbers>

#include "motion/segments/corner_overlap.h"
#include "tests/motion/path_samples.h"
#include "tests/support/cycle.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

using Built = std::vector<PathBuilder::Built>;

using stanok::testing::cycle_s;
constexpr double tolerance_part = 0.99;  // of the tolerance, that corners use

// A polyline as programmed.
struct Polyline {
  std::vector<Point> points;
  std::vector<double> feeds;  // of the leg to each point but the first; unlimited: rapid
  double tolerance = 0.01;

  Polyline& to(double x, double y, double z = 0.0, double feed = 5000.0 / 60.0) {
    points.push_back({x, y, z});
    feeds.push_back(feed);
    return *this;
  }
};

Built build(const Polyline& line, const MotionConfig& config,
            BlockEnding ending = BlockEnding::continuous) {
  PathBuilder builder(config);
  builder.restart(line.points.front());
  Built built;
  for (std::size_t k = 1; k < line.points.size(); ++k) {
    PathBlock block;
    block.tag = {.run = 1, .block = k};
    block.end = line.points[k];
    block.rapid = line.feeds[k - 1] == unlimited;
    block.feed_per_s = line.feeds[k - 1];
    block.ending = ending;
    block.tolerance_mm = line.tolerance;
    block.tolerance_deg = line.tolerance;
    EXPECT_FALSE(builder.add(block));
  }
  builder.finish();
  built = builder.built();
  return built;
}

// The same chains with full stops between them.
Built without_overlaps(Built built) {
  for (auto& segment : built) {
    segment.overlap.reset();
    segment.jerk_part = 1.0;
  }
  return built;
}

Polyline square() {
  Polyline line;
  line.points.push_back({});
  for (int round = 0; round < 3; ++round) line.to(20, 0).to(20, 20).to(0, 20).to(0, 0);
  return line;
}

double seconds(const std::vector<Sample>& samples) {
  return cycle_s * static_cast<double>(samples.size() - 1);
}

TEST(Overlap, RightAngleSavesTheTimeOfTheClosedForm) {
  // tau = 2 (6 e / (sqrt(2) J))^(1/3), once at each of the 11 corners.
  const MotionConfig config = three_axes(channel_limits);
  const auto stopped = run_path(config, build(square(), config, BlockEnding::exact_stop));
  const auto passed = run_path(config, build(square(), config));
  const double e = tolerance_part * 0.01;
  const double tau = 2.0 * std::cbrt(6.0 * e / (std::numbers::sqrt2 * channel_limits.j));
  EXPECT_NEAR(seconds(stopped) - seconds(passed), 11.0 * tau, 0.0021);
  EXPECT_LT(seconds(passed), 3.68);
}

// The start of one chain and the end of the one before it, as look-ahead gives them.
double overlap_at_first_corner(const Built& built, const MotionConfig& config) {
  LookAhead look_ahead(config);
  for (const auto& segment : built) look_ahead.add(segment);
  PathQueue queue;
  EXPECT_TRUE(look_ahead.deliver(queue));
  return queue.chunks.front().overlap_s;
}

TEST(Overlap, UnequalJerksMeetAtTheReachOfTheTolerance) {
  // The axes allow different jerks, so that both legs are at the reach r at different shares of
  // tau: J1 x^3 / 6 = J2 y^3 / 6 = r with x + y = tau and 2 r sin(45 deg) = e.
  MotionConfig config =
      three_axes(channel_limits, 1e-6);  // nothing is lost by chords between cycles
  config.axes[1].jerk_max = 20000.0;
  Polyline line;
  line.points.push_back({});
  line.to(30, 0).to(30, 30);
  const double r = tolerance_part * 0.01 / std::numbers::sqrt2;
  const double expected = std::cbrt(6.0 * r / 50000.0) + std::cbrt(6.0 * r / 20000.0);
  EXPECT_NEAR(overlap_at_first_corner(build(line, config), config), expected, 1e-9);
}

TEST(Overlap, AnArcIsEnteredAsALineInItsDirection) {
  // A line along X and an arc that begins along Y: within some hundredths of a millimetre of the
  // corner an arc of 20 mm is a line but for s^2 / 2r, and tau is that of the right angle.
  const MotionConfig config = three_axes(channel_limits, 1e-6);
  const Point corner{20.0, 0.0};
  for (const bool arc_is_first : {false, true}) {
    SCOPED_TRACE(arc_is_first);
    PathBuilder builder(config);
    std::vector<PathBlock> blocks;
    if (arc_is_first) {
      builder.restart({0.0, -20.0});
      blocks.push_back(arc_to({0.0, -20.0}, {0.0, 0.0}, 0.5 * std::numbers::pi, corner, 100.0));
      blocks.push_back(line_to({50.0, 0.0}, 100.0));
    } else {
      builder.restart({-20.0, 0.0});
      blocks.push_back(line_to(corner, 100.0));
      blocks.push_back(arc_to(corner, {0.0, 0.0}, 0.5 * std::numbers::pi, {0.0, 20.0}, 100.0));
    }
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      blocks[k].tag = {.run = 1, .block = k + 1};
      ASSERT_FALSE(builder.add(blocks[k]));
    }
    builder.finish();
    const double e = tolerance_part * 0.01;
    const double tau = 2.0 * std::cbrt(6.0 * e / (std::numbers::sqrt2 * channel_limits.j));
    const double found = overlap_at_first_corner(builder.built(), config);
    EXPECT_GE(found, 0.99 * tau);
    EXPECT_LE(found, 1.06 * tau);  // with 85 % of the jerk; some of it is left for the bend
  }
}

// Distance to the nearest of the arcs about their centres, each within its sweep, or of their ends.
double distance_to_arcs(const std::vector<PathBlock>& blocks, double radius, double x, double y) {
  double nearest = unlimited;
  Point start{};
  for (const PathBlock& block : blocks) {
    const double across = x - block.centre[0];
    const double up = y - block.centre[1];
    if (std::abs(std::atan2(across, up)) <= 0.5 * std::abs(block.sweep_rad))
      nearest = std::min(nearest, std::abs(std::hypot(across, up) - radius));
    for (const Point& end : {start, block.end})
      nearest = std::min(nearest, std::hypot(x - end[0], y - end[1]));
    start = block.end;
  }
  return nearest;
}

TEST(Overlap, SmallArcsKeepTheTolerance) {
  // Half circles side by side, whose ends meet in cusps of 60 to 120 deg: on radii of a few
  // tolerances the legs bend away from each other within the overlap.
  const MotionConfig config = three_axes(channel_limits);
  int overlaps = 0;
  for (const double radius : {0.5, 1.0, 3.0, 8.0}) {
    SCOPED_TRACE(radius);
    constexpr double tolerance = 0.02;
    std::vector<PathBlock> blocks;
    Point at{};
    for (int n = 0; n < 6; ++n) {
      const double half = 0.5 + 0.1 * n;  // of the sweep
      const std::array<double, 2> centre{at[0] + radius * std::sin(half),
                                         at[1] - radius * std::cos(half)};
      blocks.push_back(arc_to(at, centre, -2.0 * half, at, 100.0));
      blocks.back().tag = {.run = 1, .block = static_cast<std::uint64_t>(n + 1)};
      blocks.back().tolerance_mm = tolerance;
      at = blocks.back().end;
    }
    PathBuilder builder(config);
    builder.restart({});
    for (const PathBlock& block : blocks) ASSERT_FALSE(builder.add(block));
    builder.finish();
    for (const auto& segment : builder.built()) overlaps += segment.overlap ? 1 : 0;
    for (const Sample& sample : run_path(config, builder.built())) {
      const auto& point = sample.out.point;
      EXPECT_LE(distance_to_arcs(blocks, radius, point[0].value, point[1].value), tolerance);
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& axis = sample.out.axes[k];
        EXPECT_LE(std::abs(axis.second), channel_limits.a * (1.0 + 1e-9));
        EXPECT_LE(std::abs(axis.third), channel_limits.j * (1.0 + 1e-9));
      }
    }
  }
  EXPECT_GE(overlaps, 8);
}

TEST(Overlap, IsNoLongerThanTheRampsOfSlowLegs) {
  // F60: a ramp lasts 2 sqrt(v / J), less than the tolerance would allow.
  const MotionConfig config = three_axes(channel_limits);
  Polyline line;
  line.tolerance = 0.5;
  line.points.push_back({});
  line.to(5, 0, 0, 1.0).to(5, 5, 0, 1.0);
  const auto samples = run_path(config, build(line, config));
  for (const Sample& sample : samples) EXPECT_LE(sample.out.s_speed, 1.0 + 1e-9);
}

TEST(Overlap, ExactPathAndExactStopHaveNone) {
  const MotionConfig config = three_axes(channel_limits);
  Polyline exact = square();
  exact.tolerance = 0.0;
  for (const auto& built : {build(exact, config), build(square(), config, BlockEnding::exact_stop)})
    for (const auto& segment : built) EXPECT_FALSE(segment.overlap);
}

TEST(Overlap, EndOfAChainWaitsForTheStartOfTheNext) {
  const MotionConfig config = three_axes(channel_limits);
  const Built built = build(square(), config);
  LookAhead look_ahead(config);
  PathQueue queue;
  ASSERT_TRUE(built[0].ends_chain && built[0].overlap);
  look_ahead.add(built[0]);
  ASSERT_TRUE(look_ahead.deliver(queue));
  EXPECT_TRUE(queue.chunks.empty());
  EXPECT_FALSE(look_ahead.is_empty());
  look_ahead.add(built[1]);
  ASSERT_TRUE(look_ahead.deliver(queue));
  EXPECT_EQ(queue.chunks.size(), 1U);
  EXPECT_GT(queue.chunks.front().overlap_s, 0.015);
}

TEST(Overlap, StopsAtTheCornerItselfBeforeAGate) {
  const MotionConfig config = three_axes(channel_limits);
  const Polyline line = square();
  const auto samples = run_path(
      config, build(line, config), [](int) { return FeedControl{.closed_from_block = 3}; }, 2000);
  EXPECT_TRUE(samples.back().out.at_gate);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(samples.back().out.axes[k].value, line.points[2][k]);
}

TEST(Overlap, CycleUsesNoHeap) {
  const MotionConfig config = three_axes(channel_limits);
  LookAhead look_ahead(config);
  for (const auto& segment : build(square(), config)) look_ahead.add(segment);
  PathQueue queue;
  ASSERT_TRUE(look_ahead.deliver(queue));
  Interpolator interpolator(config);
  InterpolatorOutput out;
  const stanok::testing::NoAllocation guard;
  for (int k = 0; k < 4000; ++k) interpolator.advance(queue, {}, out);
}

// Random polylines.

struct PolylineOnMachine {
  MotionConfig config;
  Polyline line;
};

PolylineOnMachine random_machine(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto log_between = [&](double low, double high) {
    return low * std::pow(high / low, part(random));
  };
  PolylineOnMachine machine{three_axes(channel_limits), {}};
  const double hardness = log_between(20.0, 1000.0);  // jerk by acceleration, 1/s
  for (std::size_t k = 0; k < 3; ++k) {
    AxisLimits& axis = machine.config.axes[k];
    axis.acceleration_max = log_between(1000.0, 5000.0);
    axis.jerk_max = hardness * axis.acceleration_max;
    axis.rapid_max = 200.0;
  }
  Polyline& line = machine.line;
  line.tolerance = log_between(0.002, 0.2);
  const bool flat = part(random) < 0.5;
  const bool square_corners = part(random) < 0.2;
  Point at{};
  line.points.push_back(at);
  double feed = log_between(10.0, 200.0);
  double heading = square_corners ? 0.0 : 6.28 * part(random);
  for (int leg = 0; leg < 12; ++leg) {
    const double turn = square_corners ? 90.0 : 20.0 + 130.0 * part(random);
    heading += (part(random) < 0.5 ? -1.0 : 1.0) * turn * std::numbers::pi / 180.0;
    const double length = log_between(0.5, 50.0);
    if (part(random) < 0.2) feed = log_between(10.0, 200.0);
    at[0] += length * std::cos(heading);
    at[1] += length * std::sin(heading);
    if (!flat) at[2] += length * (part(random) - 0.5);
    line.to(at[0], at[1], at[2], part(random) < 0.15 ? unlimited : feed);
  }
  return machine;
}

Point position(const Sample& sample) {
  Point p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = sample.out.axes[k].value;
  return p;
}

// Largest distance of the trace from the polyline, in order, and of the corners from the trace.
double deviation(const std::vector<Sample>& samples, const Polyline& line) {
  double worst = 0.0;
  std::size_t leg = 1;
  double corner = unlimited;  // of the current leg from the trace
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Point before = position(samples[i - 1]);
    const Point here = position(samples[i]);
    corner = std::min(corner, distance_to_leg(line.points[leg], before, here));
    double off = distance_to_leg(here, line.points[leg - 1], line.points[leg]);
    if (leg + 1 < line.points.size()) {
      const double next = distance_to_leg(here, line.points[leg], line.points[leg + 1]);
      if (next < off && distance(here, line.points[leg]) > 2.0 * line.tolerance) {
        worst = std::max(worst, corner);
        corner = unlimited;
        ++leg;
      }
      off = std::min(off, next);
    }
    worst = std::max(worst, off);
  }
  EXPECT_GE(leg + 1, line.points.size());
  return worst;
}

// Largest share of the limits of velocity, acceleration and jerk in the analytic derivatives.
double share_of_limits(const std::vector<Sample>& samples, const MotionConfig& config) {
  double worst = 0.0;
  for (const Sample& sample : samples) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& jet = sample.out.axes[k];
      worst = std::max({worst, std::abs(jet.first) / config.axes[k].velocity_max,
                        std::abs(jet.second) / config.axes[k].acceleration_max,
                        std::abs(jet.third) / config.axes[k].jerk_max});
    }
  }
  return worst;
}

// Positions against velocities by Simpson's rule over two cycles, in units of j T^3. A step of jerk
// in the middle of a cycle leaves 2/81 of its height.
double residual(const std::vector<Sample>& samples, const MotionConfig& config) {
  double worst = 0.0;
  const double T = config.cycle_s;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& a = samples[i - 2].out.axes[k];
      const auto& b = samples[i - 1].out.axes[k];
      const auto& c = samples[i].out.axes[k];
      const double way = T / 3.0 * (a.first + 4.0 * b.first + c.first);
      worst = std::max(worst,
                       std::abs(c.value - a.value - way) / (config.axes[k].jerk_max * T * T * T));
    }
  }
  return worst;
}

constexpr double residual_max = 8.0 * 2.0 / 81.0 + 0.01;  // eight full steps in two cycles

class RandomOverlaps : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomOverlaps, KeepLimitsToleranceAndEndAndSaveTime) {
  int overlaps = 0;
  for (unsigned seed = GetParam(); seed < GetParam() + stanok::testing::cases(50U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const PolylineOnMachine machine = random_machine(seed);
    const Built built = build(machine.line, machine.config);
    for (std::size_t k = 0; k < built.size(); ++k) {
      if (!built[k].overlap) continue;
      ++overlaps;
      EXPECT_EQ(built[k].segment.geometry.kind, SegmentKind::line);
      EXPECT_EQ(built[k + 1].segment.geometry.kind, SegmentKind::line);
    }
    const auto samples = run_path(machine.config, built);
    EXPECT_LE(share_of_limits(samples, machine.config), 1.0 + 1e-9);
    EXPECT_LE(deviation(samples, machine.line), machine.line.tolerance);
    EXPECT_LE(residual(samples, machine.config), residual_max);
    const double feed_max = *std::ranges::max_element(machine.line.feeds);
    for (const Sample& sample : samples) EXPECT_LE(sample.out.s_speed, feed_max * (1.0 + 1e-9));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(samples.back().out.axes[k].value, machine.line.points.back()[k]);
    const auto stopped = run_path(machine.config, without_overlaps(built));
    // The choice is made by an estimate from the two legs.
    EXPECT_LE(static_cast<double>(samples.size()), 1.01 * static_cast<double>(stopped.size()));
  }
  EXPECT_GT(overlaps, stanok::testing::cases(100));
}

FeedControl random_control(std::mt19937_64& random, const FeedControl& now) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  if (part(random) > 0.02) return now;
  FeedControl control;
  control.hold = part(random) < 0.4;
  if (part(random) < 0.4) control.feed_override = 2.0 * part(random);
  if (part(random) < 0.2) control.rapid_override = part(random);
  return control;
}

TEST_P(RandomOverlaps, KeepLimitsToleranceAndEndWhateverTheOperatorDoes) {
  for (unsigned seed = GetParam(); seed < GetParam() + stanok::testing::cases(25U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const PolylineOnMachine machine = random_machine(seed);
    std::mt19937_64 random(seed);
    FeedControl control;
    const auto samples = run_path(machine.config, build(machine.line, machine.config), [&](int k) {
      control = k < 20000 ? random_control(random, control) : FeedControl{};
      return control;
    });
    EXPECT_EQ(samples.back().out.state, PathState::idle);
    EXPECT_LE(share_of_limits(samples, machine.config), 1.0 + 1e-8);
    EXPECT_LE(deviation(samples, machine.line), machine.line.tolerance);
    EXPECT_LE(residual(samples, machine.config), residual_max);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(samples.back().out.axes[k].value, machine.line.points.back()[k]);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomOverlaps, ::testing::Values(0U, 1000U, 2100U));

// Under this operator the path rests 18 nm before a blend, where a cycle at full jerk is too long.
TEST(Overlap, RestCloseBeforeABlendIsLeftAgain) {
  const PolylineOnMachine machine = random_machine(10118);
  std::mt19937_64 random(70827);
  FeedControl control;
  const auto samples = run_path(
      machine.config, build(machine.line, machine.config),
      [&](int) { return control = random_control(random, control); }, 30000);
  EXPECT_EQ(samples.back().out.state, PathState::idle);
  EXPECT_EQ(samples.back().out.axes[0].value, machine.line.points.back()[0]);
}

TEST(Overlap, HoldInAnyCycleAroundACornerComesToRestOnThePath) {
  const MotionConfig config = three_axes(channel_limits);
  const Polyline line = square();
  const Built built = build(line, config);
  for (int at = 280; at < 340; ++at) {
    SCOPED_TRACE(::testing::Message() << "hold in cycle " << at);
    const auto samples = run_path(
        config, built, [&](int k) { return FeedControl{.hold = k >= at && k < at + 200}; });
    EXPECT_EQ(samples[static_cast<std::size_t>(at) + 199].out.s_speed, 0.0);
    EXPECT_LE(share_of_limits(samples, config), 1.0 + 1e-9);
    EXPECT_LE(deviation(samples, line), line.tolerance);
    EXPECT_LE(residual(samples, config), residual_max);
  }
}

TEST(Overlap, SetpointsDoNotDependOnHowFarPreparationIsAhead) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const PolylineOnMachine machine = random_machine(seed);
    const Built built = build(machine.line, machine.config);
    const auto far = run_path(machine.config, built);
    PathQueue queue;
    LookAhead look_ahead(machine.config);
    Interpolator interpolator(machine.config);
    std::size_t next = 0;
    for (std::size_t k = 1; k < far.size(); ++k) {
      // No more than the current chunk needs.
      while (queue.chunks.size() < 3 && next < built.size()) {
        look_ahead.add(built[next++]);
        ASSERT_TRUE(look_ahead.deliver(queue));
      }
      InterpolatorOutput out;
      interpolator.advance(queue, {}, out);
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_EQ(out.axes[axis].value, far[k].out.axes[axis].value);
    }
  }
}

}  // namespace
}  // namespace stanok::motion::testing
