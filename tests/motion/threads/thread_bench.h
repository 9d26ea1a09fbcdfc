// ThreadBench: threads on two axes of a lathe, led by a spindle that is a formula of time.
//
// The path sees the spindle only through an encoder, one cycle late. All setpoints are watched:
// limits, and that positions and derivatives belong together.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "motion/interpolation/interpolator.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/threads/thread_builder.h"
#include "tests/support/cycle.h"
#include "tests/support/helix.h"
#include "tests/support/no_allocation.h"

namespace stanok::motion::testing {

using stanok::testing::cycle_s;
using stanok::testing::increment_mm;
using stanok::testing::steady;
using stanok::testing::Turning;
using stanok::testing::with_ripple;

inline constexpr double rounding = 1e-12;  // of what is used of a limit
inline constexpr int encoder_lines = 4096;
inline constexpr std::size_t X = 0;
inline constexpr std::size_t Z = 1;

inline MotionConfig lathe_axes() {
  MotionConfig config;
  config.axis_count = 2;
  config.geometry = {0, -1, 1};
  config.cycle_s = cycle_s;
  for (std::size_t k = 0; k < 2; ++k) {
    config.axes[k].velocity_max = 250.0;
    config.axes[k].acceleration_max = 2500.0;
    config.axes[k].jerk_max = 50000.0;
    config.axes[k].position_min = -300.0;
    config.axes[k].position_max = 300.0;
    config.axes[k].rapid_max = 250.0;
  }
  return config;
}

inline Point at(double x, double z) {
  Point point{};
  point[X] = x;
  point[Z] = z;
  return point;
}

// One setpoint.
struct ThreadSample {
  double t = 0.0;
  double x = 0.0;
  double z = 0.0;
  double v_z = 0.0;
};

inline SpindleCoupling thread_from(double angle_deg) {
  SpindleCoupling coupling;
  coupling.kind = SpindleCoupling::Kind::thread;
  coupling.start_angle_deg = angle_deg;
  return coupling;
}

inline ThreadBlock block_to(const Point& end, double lead_mm) {
  ThreadBlock block;
  block.tag = {1, 1, 1, 0};
  block.end = end;
  block.lead_mm = lead_mm;
  block.tolerance_mm = 0.01;
  return block;
}

// Where a thread begins, at which angle of its spindle, and the speed that is programmed.
struct ThreadStart {
  Point point{};
  double angle_deg = 0.0;
  double speed = 0.0;           // turns/s
  double jerk_to_follow = 0.0;  // for its encoder
};

class ThreadBench {
 public:
  explicit ThreadBench(Turning turning, double speed_wanted, const Point& start = {})
      : turning_(std::move(turning)),
        speed_wanted_(speed_wanted),
        look_ahead_(config_),
        interpolator_(config_) {
    interpolator_.stand_at(start, {});
  }

  MotionConfig& config() { return config_; }
  FeedControl& control() { return control_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const InterpolatorOutput& output() const { return output_; }

  // As the command of an override does.
  void want_speed(double turns_per_s) { speed_wanted_ = turns_per_s; }

  // Counts of a turn that the encoder gives.
  void see_through(int lines) { lines_ = lines; }

  // The spindle turns, nothing is to be cut.
  void idle(double seconds) {
    const int cycles = static_cast<int>(seconds / cycle_s);
    for (int n = 0; n < cycles; ++n) cycle();
  }

  // A thread of these blocks, all of which can be cut.
  void send(const ThreadStart& start, const std::vector<ThreadBlock>& blocks) {
    ThreadBuilder builder(config_);
    builder.begin(start.point, config_.geometry, thread_from(start.angle_deg), start.speed,
                  start.jerk_to_follow);
    for (const ThreadBlock& block : blocks) ASSERT_FALSE(builder.add(block));
    send(builder);
  }

  void send(ThreadBuilder& builder) { send(builder.finish()); }

  void send(ThreadChain chain) {
    look_ahead_.add(std::move(chain));
    ASSERT_TRUE(look_ahead_.deliver(queue_));
  }

  // At rest within a chain: what is left of it is forgotten, and so is that its spindle led it.
  void drop_chain() {
    interpolator_.drop_path(queue_);
    control_ = {};
  }

  // Until the chain is over; the samples of all its setpoints.
  std::vector<ThreadSample> cut(double seconds_max = 30.0) {
    const std::uint64_t done = output_.chunks_done;
    std::vector<ThreadSample> samples;
    while (output_.chunks_done == done && time_ < seconds_max) {
      cycle();
      samples.push_back(
          {time_, output_.axes[X].value, output_.axes[Z].value, output_.axes[Z].first});
    }
    EXPECT_GT(output_.chunks_done, done) << "the chain is not over after " << time_ << " s";
    return samples;
  }

  void cycle() {
    observer_.advance(cycle_s, command(0.0));
    observer_.observe(stanok::testing::encoder_deg(turning_(time_), lines_));
    interpolator_.see_spindle(0, observer_.ahead(cycle_s, command(cycle_s)));
    {
      stanok::testing::NoAllocation guard;
      interpolator_.advance(queue_, control_, output_);
    }
    if (obey_) obey_(output_.spindle_order);
    time_ += cycle_s;
    watch_limits();
  }

  [[nodiscard]] double used() const { return used_; }  // of the limits, at most
  // A spindle that obeys a tap, in every cycle, and how it is commanded to turn some time later.
  void spindle_obeys(std::function<void(const SpindleOrder&)> obey,
                     std::function<SpindleMotion(double)> commands) {
    obey_ = std::move(obey);
    commands_ = std::move(commands);
  }

 private:
  // Without an obedient spindle only the speed is known that it shall have.
  [[nodiscard]] SpindleMotion command(double later) const {
    return commands_ ? commands_(later) : SpindleMotion{.speed_wanted = speed_wanted_};
  }

  // Setpoints by their derivatives, and the speed between them by differences.
  void watch_limits() {
    for (std::size_t k = 0; k < 2; ++k) {
      const AxisLimits& limits = config_.axes[k];
      const kinematics::Jet& q = output_.axes[k];
      used_ = std::max({used_, std::abs(q.first) / limits.velocity_max,
                        std::abs(q.second) / limits.acceleration_max,
                        std::abs(q.third) / limits.jerk_max});
      if (before_) {
        // Between two setpoints at most one change of jerk within the limits: both ends of the
        // cycle tell where the other one is, to J T^3 / 6.
        const kinematics::Jet& p = (*before_)[k];
        const double due = p.value + cycle_s * (p.first + 0.5 * cycle_s * p.second);
        EXPECT_NEAR(q.value, due, limits.jerk_max * std::pow(cycle_s, 3) / 6.0 + 1e-9);
        EXPECT_LE(std::abs(q.second - p.second), limits.jerk_max * cycle_s * (1.0 + 1e-9));
      }
    }
    before_ = output_.axes;
  }

  MotionConfig config_ = lathe_axes();
  Turning turning_;
  int lines_ = encoder_lines;
  std::function<void(const SpindleOrder&)> obey_;
  std::function<SpindleMotion(double)> commands_;
  double speed_wanted_;
  LookAhead look_ahead_;
  PathQueue queue_;
  Interpolator interpolator_;
  SpindleObserver observer_;
  FeedControl control_;
  InterpolatorOutput output_;
  double time_ = 0.0;
  double used_ = 0.0;
  std::optional<JetPoint> before_;
};

}  // namespace stanok::motion::testing
