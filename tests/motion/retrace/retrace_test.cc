// A held path is run back and forwards again: on the same points, within the limits, to the very
// place where it was held.
#include "motion/retrace/retrace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "motion/interpolation/interpolator.h"
#include "motion/look_ahead/look_ahead.h"
#include "tests/motion/path_samples.h"
#include "tests/motion/random_programs.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

constexpr std::size_t enough = 8 << 20;

// A path in the cycle, with its history.
class Rig {
 public:
  Rig(const MotionConfig& config, const Program& program, std::size_t history_bytes = enough)
      : config_(config),
        history_(history_bytes),
        look_ahead_(config),
        interpolator_(config, &history_),
        retrace_(config, history_) {
    PathBuilder builder(config);
    builder.restart(program.start);
    for (const PathBlock& block : program.blocks) EXPECT_FALSE(builder.add(block));
    builder.finish();
    built_ = builder.built();
    for (std::size_t k = 0; k < built_.size(); ++k)
      by_block_[built_[k].segment.tag.block].push_back(k);
    for (std::size_t k = 0; k < axes_max; ++k) out_.axes[k] = program.start[k];
  }

  // One cycle of the path; false: it has come to its end.
  bool advance(const FeedControl& control = {}) {
    while (look_ahead_.deliver(queue_) && next_ < built_.size()) look_ahead_.add(built_[next_++]);
    const stanok::testing::NoAllocation guard;
    interpolator_.advance(queue_, control, out_);
    return next_ < built_.size() || !look_ahead_.is_empty() || !queue_.chunks.empty() ||
           out_.state != PathState::idle;
  }
  void hold() {
    advance({.hold = true});
    while (!interpolator_.at_rest()) advance({.hold = true});
  }
  void begin() {
    const auto way = interpolator_.way_into_segment(queue_);
    Point axes{};
    for (std::size_t k = 0; k < axes_max; ++k) axes[k] = out_.axes[k].value;
    retrace_.begin(way ? &queue_.segments.front() : nullptr, way.value_or(0.0), axes);
  }
  // Cycles of the retrace, each of which is looked at, until it rests.
  void run(const FeedControl& control, const std::function<void(const RetraceOutput&)>& look) {
    for (int cycle = 0; !retrace_.is_at_rest(); ++cycle) {
      ASSERT_LT(cycle, 2000000) << "it does not come to rest";
      step(control, look);
    }
  }
  void step(const FeedControl& control, const std::function<void(const RetraceOutput&)>& look) {
    RetraceOutput out;
    {
      const stanok::testing::NoAllocation guard;
      retrace_.advance(control, out);
    }
    look(out);
  }

  // Of a point from the segments of its block.
  [[nodiscard]] double distance_from_path(const RetraceOutput& out) const {
    double nearest = unlimited;
    for (const std::size_t k : by_block_.at(out.tag.block))
      nearest = std::min(nearest, distance_from(built_[k].segment, out.point));
    return nearest;
  }

  MotionConfig config_;
  PathHistory history_;
  PathQueue queue_;
  LookAhead look_ahead_;
  Interpolator interpolator_;
  Retrace retrace_;
  InterpolatorOutput out_;

 private:
  static double distance_at(const Segment& segment, double u, const JetPoint& point) {
    JetPoint here;
    evaluate_at_parameter(segment, u, here);
    double squared = 0.0;
    for (std::size_t k = 0; k < axes_max; ++k)
      squared += std::pow(here[k].value - point[k].value, 2.0);
    return std::sqrt(squared);
  }
  // A scan, then golden section about the best place.
  static double distance_from(const Segment& segment, const JetPoint& point) {
    constexpr double golden = 0.381966011250105;
    constexpr int steps = 32;
    int best = 0;
    for (int n = 1; n <= steps; ++n) {
      if (distance_at(segment, n / 32.0, point) < distance_at(segment, best / 32.0, point))
        best = n;
    }
    double low = std::max(best - 1, 0) / 32.0;
    double high = std::min(best + 1, steps) / 32.0;
    for (int n = 0; n < 90; ++n) {
      const double a = low + golden * (high - low);
      const double b = high - golden * (high - low);
      (distance_at(segment, a, point) < distance_at(segment, b, point) ? high : low) =
          distance_at(segment, a, point) < distance_at(segment, b, point) ? b : a;
    }
    return distance_at(segment, 0.5 * (low + high), point);
  }

  std::vector<PathBuilder::Built> built_;
  std::map<std::uint64_t, std::vector<std::size_t>> by_block_;
  std::size_t next_ = 0;
};

// The axes from cycle to cycle: within their limits, by their derivatives and by differences.
class LimitWatch {
 public:
  LimitWatch(const MotionConfig& config, const JetPoint& from) : config_(config), trace_(axes_max) {
    for (int n = 0; n < 4; ++n) follow(from);
  }
  void follow(const JetPoint& axes) {
    for (int k = 0; k < config_.axis_count; ++k) {
      const AxisLimits& limits = config_.axes[k];
      worst_ = std::max({worst_, std::abs(axes[k].first) / limits.velocity_max,
                         std::abs(axes[k].second) / limits.acceleration_max,
                         std::abs(axes[k].third) / limits.jerk_max});
      trace_[static_cast<std::size_t>(k)].push_back(axes[k].value);
    }
  }
  [[nodiscard]] double worst_derivative() const { return worst_; }
  [[nodiscard]] double worst_difference() const {
    double worst = 0.0;
    for (int k = 0; k < config_.axis_count; ++k) {
      const AxisLimits& limits = config_.axes[k];
      worst = std::max(
          worst, quotients_of(
                     trace_[static_cast<std::size_t>(k)],
                     {.v = limits.velocity_max, .a = limits.acceleration_max, .j = limits.jerk_max},
                     config_.cycle_s)
                     .worst());
    }
    return worst;
  }

 private:
  MotionConfig config_;
  double worst_ = 0.0;
  std::vector<std::vector<double>> trace_;
};

struct Kind {
  const char* name;
  int axes;
  bool has_tool_centre;  // X, Y, Z are those of the tool point, whatever the rotary axes do
  std::function<Program(Random&)> make;
};

class RetraceOf : public ::testing::TestWithParam<Kind> {};

TEST_P(RetraceOf, GoesBackAndForwardsOnTheSamePointsWithinTheLimits) {
  const Kind& kind = GetParam();
  const auto scheme = head_table();
  kinematics::Transform transform;
  transform.scheme = scheme.get();
  transform.mode = kinematics::PointMode::tip;
  const MotionConfig config = mill(kind.axes);
  for (unsigned seed = 1; seed <= stanok::testing::cases(30U); ++seed) {
    SCOPED_TRACE(::testing::Message() << kind.name << " seed " << seed);
    Random random(seed);
    Program program = kind.make(random);
    if (kind.has_tool_centre) {
      for (PathBlock& block : program.blocks) block.transform = &transform;
    }
    Rig rig(config, program);
    const int cycles = static_cast<int>(std::pow(10.0, random.between(0.5, 3.7)));
    for (int k = 0; k < cycles && rig.advance(); ++k) {
    }
    rig.hold();
    const JetPoint held = rig.out_.axes;
    rig.begin();
    LimitWatch watch(config, held);
    double farthest = 0.0;
    int looks = 0;
    const auto look = [&](const RetraceOutput& out) {
      watch.follow(out.axes);
      if (++looks % 11 == 0) farthest = std::max(farthest, rig.distance_from_path(out));
    };
    for (int part = 0; part < 6; ++part) {
      const RetraceWay way = random.chance(0.6) ? RetraceWay::back : RetraceWay::forward;
      const FeedControl control{.feed_override = random.between(0.2, 1.5),
                                .rapid_override = random.between(0.2, 1.0)};
      if (random.chance(0.5)) {
        rig.retrace_.go(way, random.between(0.0, 30.0));
      } else {
        rig.retrace_.go(way);
        const int lease = static_cast<int>(random.between(1.0, 600.0));
        for (int k = 0; k < lease && !rig.retrace_.is_at_rest(); ++k) rig.step(control, look);
        rig.retrace_.stop();
      }
      rig.run(control, look);
      if (HasFatalFailure()) return;
    }
    rig.retrace_.go(RetraceWay::back);
    rig.run({}, look);
    EXPECT_TRUE(rig.retrace_.is_at_end(RetraceWay::back));
    EXPECT_EQ(rig.retrace_.blocks_left(), 0U);
    rig.retrace_.go(RetraceWay::forward);
    JetPoint last{};
    rig.run({}, [&](const RetraceOutput& out) {
      look(out);
      last = out.axes;
    });
    if (HasFatalFailure()) return;
    EXPECT_TRUE(rig.retrace_.is_at_end(RetraceWay::forward));
    for (int k = 0; k < kind.axes; ++k) EXPECT_NEAR(last[k].value, held[k].value, 1e-9);
    EXPECT_GT(looks, 10);
    EXPECT_LE(farthest, 1e-9);
    EXPECT_LE(watch.worst_derivative(), 1.0 + 1e-6);
    EXPECT_LE(watch.worst_difference(), 1.0 + 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RetraceOf,
    ::testing::Values(
        Kind{"corners", 3, false, [](Random& random) { return corners(random, {}); }},
        Kind{"arcs", 3, false, [](Random& random) { return arcs(random, {}); }},
        Kind{"splines", 3, false, [](Random& random) { return splines(random, {}); }},
        Kind{"short_blocks", 3, false,
             [](Random& random) { return winding_way(random, {}, {.blocks = 800}); }},
        Kind{"five_axes", 5, false, [](Random& random) { return five_axis_moves(random, {}); }},
        Kind{"tool_centre", 5, true, [](Random& random) { return five_axis_moves(random, {}); }}),
    [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace stanok::motion::testing
