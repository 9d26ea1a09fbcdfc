// Seeded runs with hold, resume, override and abort at random places of every kind of path: limits
// are kept, the path is never left, every abort comes to rest on the path and the next path begins
// there.
#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <set>
#include <string>

#include "tests/motion/path_samples.h"
#include "tests/motion/random_programs.h"
#include "tests/support/sanitized.h"

namespace stanok::motion::testing {
namespace {

// What stops may use of acceleration and jerk, in every other run.
constexpr double more_for_stops = 1.2;

struct Machine {
  MotionConfig config;
  std::unique_ptr<const kinematics::Scheme> scheme;
  kinematics::Transform transform;
  Point start_M{};
};

void let_stops_use(MotionConfig& config, double stop_limits) {
  for (int k = 0; k < config.axis_count; ++k) config.axes[k].stop_limits = stop_limits;
}

std::unique_ptr<const Machine> three_axis_mill(double stop_limits) {
  auto machine = std::make_unique<Machine>();
  machine->config = three_axes(channel_limits);
  let_stops_use(machine->config, stop_limits);
  kinematics::SchemeConfig cartesian;
  cartesian.type = "cartesian";
  cartesian.axes = {0, 1, 2};
  machine->scheme = kinematics::make_scheme(cartesian);
  machine->transform.scheme = machine->scheme.get();
  return machine;
}

// TCP (RTCP) through head and table: lines in W are curves of the axes.
std::unique_ptr<const Machine> five_axis_mill(double stop_limits) {
  auto machine = std::make_unique<Machine>();
  machine->config = mill(5);
  let_stops_use(machine->config, stop_limits);
  machine->scheme = head_table();
  machine->transform.scheme = machine->scheme.get();
  machine->transform.mode = kinematics::PointMode::tip;
  machine->transform.tool.nose_to_tip_mm[2] = -80.0;
  machine->start_M = {40.0, -20.0, 10.0, 25.0, 10.0};
  return machine;
}

// Changes of the settings at random cycles, and the cycle of the abort.
class Operator {
 public:
  explicit Operator(Random& random)
      : random_(random),
        changes_per_cycle_(std::pow(10.0, random.between(-2.7, -1.0))),
        abort_cycle_(static_cast<int>(std::pow(10.0, random.between(0.0, 3.3)))) {}

  [[nodiscard]] int abort_cycle() const { return abort_cycle_; }
  const FeedControl& settings() {
    if (random_.chance(changes_per_cycle_)) {
      control_.hold = random_.chance(0.25);
      control_.feed_override = random_.chance(0.3) ? 1.0 : random_.between(0.0, 2.0);
      control_.rapid_override = random_.chance(0.3) ? 1.0 : random_.between(0.0, 1.0);
      if (random_.chance(0.05)) control_.feed_override = 0.0;
    }
    return control_;
  }

 private:
  Random& random_;
  double changes_per_cycle_;
  int abort_cycle_;
  FeedControl control_;
};

Point values_of(const JetPoint& jets) {
  Point values;
  for (std::size_t k = 0; k < axes_max; ++k) values[k] = jets[k].value;
  return values;
}

// What aborts met: kinds of segment on which they came to rest.
using Places = std::map<SegmentKind, int>;

// Of every bit of the setpoints, for builds by other compilers (tools/same-setpoints.sh): FNV-1a.
class SetpointDigest {
 public:
  void add(const Sample& sample, std::size_t axes) {
    for (std::size_t k = 0; k < axes; ++k) {
      const auto& axis = sample.out.axes[k];
      for (const double value : {axis.value, axis.first, axis.second, axis.third})
        state_ = (state_ ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    }
  }
  [[nodiscard]] std::string text() const { return std::to_string(state_); }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

// A channel of the machine from preparation to setpoints.
class Run {
 public:
  explicit Run(const Machine& machine)
      : machine_(machine),
        builder_(machine.config),
        look_ahead_(machine.config),
        interpolator_(machine.config) {
    interpolator_.stand_at(machine.start_M, machine.transform);
    cycle({});
  }

  [[nodiscard]] Point standing_W() const { return values_of(samples_.back().out.point); }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

  void begin(const Program& program, const Tolerance& tolerance) {
    program_ = program;
    allowed_ = {.mm = std::max(tolerance.mm, exact_path),
                .deg = std::max(tolerance.deg, exact_path)};
    ++run_;
    builder_.restart(program.start);
    for (PathBlock& block : program_.blocks) {
      block.tag.run = run_;
      block.tolerance_mm = tolerance.mm;
      block.tolerance_deg = tolerance.deg;
      block.transform = &machine_.transform;
      EXPECT_FALSE(builder_.add(block).has_value());
    }
    builder_.finish();
    built_.swap(builder_.built());
    next_ = 0;
  }

  // One cycle; false when the program has ended.
  bool step(const FeedControl& control) {
    while (look_ahead_.deliver(queue_) && next_ < built_.size()) look_ahead_.add(built_[next_++]);
    cycle(control);
    return next_ < built_.size() || !look_ahead_.is_empty() || !queue_.chunks.empty() ||
           samples_.back().out.state != PathState::idle;
  }

  // As a channel does it at a reset: to rest along the path, then what is left of it is dropped.
  void abort(FeedControl control, Places& places) {
    control.hold = true;
    constexpr int cycles_max = 1000;
    for (int k = 0; !interpolator_.at_rest(); ++k) {
      ASSERT_LT(k, cycles_max);
      cycle(control);
    }
    const InterpolatorOutput stopped = samples_.back().out;
    if (stopped.state != PathState::idle) ++places[queue_.segments.front().geometry.kind];
    look_ahead_.clear();
    builder_.restart({});
    builder_.built().clear();
    interpolator_.drop_path(queue_);
    built_.clear();
    next_ = 0;
    EXPECT_FALSE(step(control));
    expect_standing_at(stopped);
    interpolator_.stand_at(values_of(stopped.axes), machine_.transform);
    step(control);
    expect_standing_at(stopped);
  }

  // The way from start to end of all that was programmed ends where it should.
  void expect_end() const {
    const InterpolatorOutput& out = samples_.back().out;
    for (std::size_t k = 0; k < axis_count(); ++k) {
      EXPECT_EQ(out.point[k].value, program_.end()[k]) << "axis " << k;
      EXPECT_EQ(out.axes[k].first, 0.0);
    }
  }

  void add_to(SetpointDigest& digest) const {
    for (const Sample& sample : samples_) digest.add(sample, axis_count());
  }

  void expect_limits() const {
    for (std::size_t k = 0; k < axis_count(); ++k) {
      const AxisLimits& axis = machine_.config.axes[k];
      const Limits limits{.v = axis.velocity_max,
                          .a = axis.stop_limits * axis.acceleration_max,
                          .j = axis.stop_limits * axis.jerk_max};
      EXPECT_LE(columns_of(samples_, k, limits).worst(), 1.0 + 1e-9) << "axis " << k;
      EXPECT_LE(quotients_of(axis_of(samples_, k), limits, machine_.config.cycle_s).worst(),
                1.0 + 1e-6)
          << "axis " << k;
    }
  }

 private:
  // What exact path mode leaves to joins (docs/developer/motion.md), and rounding.
  static constexpr double exact_path = 2e-9;

  [[nodiscard]] std::size_t axis_count() const {
    return static_cast<std::size_t>(machine_.config.axis_count);
  }
  void cycle(const FeedControl& control) {
    Sample sample;
    interpolator_.advance(queue_, control, sample.out);
    samples_.push_back(sample);
    expect_on_path(sample.out);
  }
  void expect_on_path(const InterpolatorOutput& out) const {
    if (out.tag.run != run_ || run_ == 0) return;
    ASSERT_LE(misfit(program_, out.tag.block, values_of(out.point), allowed_), 1.0)
        << "block " << out.tag.block;
  }
  void expect_standing_at(const InterpolatorOutput& stopped) const {
    const InterpolatorOutput& out = samples_.back().out;
    EXPECT_EQ(out.state, PathState::idle);
    for (std::size_t k = 0; k < axis_count(); ++k) {
      EXPECT_EQ(out.axes[k].value, stopped.axes[k].value) << "axis " << k;
      EXPECT_EQ(out.axes[k].first, 0.0);
      EXPECT_EQ(out.axes[k].second, 0.0);
    }
  }

  const Machine& machine_;
  PathBuilder builder_;
  LookAhead look_ahead_;
  Interpolator interpolator_;
  PathQueue queue_;
  Program program_;
  Tolerance allowed_;
  std::uint32_t run_ = 0;
  std::vector<PathBuilder::Built> built_;
  std::size_t next_ = 0;
  std::vector<Sample> samples_;
};

struct AbortScene {
  const char* name;
  std::unique_ptr<const Machine> (*machine)(double stop_limits);
  Program (*program)(Random& random, const Point& start);
  bool exact_path;
  std::set<SegmentKind> kinds;  // on which aborts come to rest
};

// Up to three programs that are aborted, and one that is run to its end.
void run_seed(const AbortScene& scene, std::uint64_t seed, Places& places, SetpointDigest& digest) {
  const auto machine = scene.machine(seed % 2 == 0 ? more_for_stops : 1.0);
  constexpr int aborts = 3;
  constexpr int busy_cycles = 6000;  // then the operator lets the last program run on
  Random random(seed);
  Run run(*machine);
  for (int n = 0; n <= aborts; ++n) {
    const double tolerance = scene.exact_path ? 0.0 : std::pow(10.0, random.between(-2.5, -1.5));
    run.begin(scene.program(random, run.standing_W()),
              {.mm = tolerance, .deg = scene.exact_path ? 0.0 : 0.05});
    Operator settings(random);
    const int last = n < aborts ? settings.abort_cycle() : 200000;
    bool runs = true;
    for (int k = 0; runs && k < last && !::testing::Test::HasFatalFailure(); ++k)
      runs = run.step(k < busy_cycles ? settings.settings() : FeedControl{});
    if (::testing::Test::HasFatalFailure()) return;
    if (runs) {
      run.abort(settings.settings(), places);
      ASSERT_LT(n, aborts) << "the last program did not end";
    } else {
      run.expect_end();
    }
  }
  run.expect_limits();
  run.add_to(digest);
}

class OperatorRuns : public ::testing::TestWithParam<AbortScene> {
 protected:
  static void run_seeds(std::uint64_t first, std::uint64_t last) {
    const AbortScene& scene = GetParam();
    Places places;
    SetpointDigest digest;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
      SCOPED_TRACE(::testing::Message() << scene.name << " seed " << seed);
      run_seed(scene, seed, places, digest);
      if (HasFatalFailure()) return;
    }
    RecordProperty("setpoints", digest.text());
    for (const SegmentKind kind : scene.kinds) {
      EXPECT_GT(places[kind], 0) << "no abort came to rest on segment kind "
                                 << static_cast<int>(kind);
    }
  }
};

TEST_P(OperatorRuns, KeepLimitsAndPathAndRestWhereTheyAreAborted) {
  run_seeds(1, stanok::testing::is_sanitized ? 5 : 10);
}

// With the ten above these are 504 runs.
TEST_P(OperatorRuns, KeepThemInFiveHundredRunsFullSize) {
  run_seeds(11, 84);
}

Program smooth_runs(Random& random, const Point& start) {
  return winding_way(random, start, {.blocks = static_cast<int>(random.between(80.0, 250.0))});
}

Program lines_and_arcs(Random& random, const Point& start) {
  return random.chance(0.5) ? corners(random, start) : arcs(random, start);
}

// Paths of several chunks: aborts fall near the ends of chunks, and chunks are dropped unseen.
TEST(OperatorRunsOverChunks, KeepLimitsAndPathAndRestWhereTheyAreAborted) {
  const auto many_short_blocks = [](Random& random, const Point& start) {
    return winding_way(random, start, {.blocks = 3500, .length_max = 0.1});
  };
  const AbortScene scene{"chunks", three_axis_mill, many_short_blocks, false, {}};
  Places places;
  SetpointDigest digest;
  for (std::uint64_t seed = 1; seed <= stanok::testing::cases(4U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    run_seed(scene, seed, places, digest);
  }
  RecordProperty("setpoints", digest.text());
}

INSTANTIATE_TEST_SUITE_P(
    All, OperatorRuns,
    ::testing::Values(
        AbortScene{
            "corners", three_axis_mill, corners, false, {SegmentKind::line, SegmentKind::quintic}},
        AbortScene{"arcs", three_axis_mill, arcs, false, {SegmentKind::arc}},
        AbortScene{"splines", three_axis_mill, splines, false, {SegmentKind::quintic}},
        AbortScene{"smooth_runs", three_axis_mill, smooth_runs, false, {SegmentKind::quintic}},
        AbortScene{"five_axes",
                   five_axis_mill,
                   five_axis_moves,
                   false,
                   {SegmentKind::line, SegmentKind::quintic}},
        AbortScene{"exact_path",
                   three_axis_mill,
                   lines_and_arcs,
                   true,
                   {SegmentKind::line, SegmentKind::arc}}),
    [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace stanok::motion::testing
