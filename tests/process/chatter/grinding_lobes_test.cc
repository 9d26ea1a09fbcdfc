// Lobes of grinding against closed forms, and against the motion in time with its two delays.
#include "process/chatter/grinding_lobes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr double k_n_per_mm = 25000.0;
constexpr double zeta = 0.05;
constexpr double layer_n_per_mm2 = 400.0;

CuttingProcess grinder() {
  CuttingProcess process;
  process.kind = CutKind::grinding;
  process.force_n_per_mm2 = layer_n_per_mm2;
  process.modes_x = {{.frequency_hz = 120.0, .damping = zeta, .stiffness_n_per_mm = k_n_per_mm}};
  process.grinding = {
      .part_radius_mm = 30.0, .wheel_radius_mm = 200.0, .wheel_rev_per_min = 1700.0};
  return process;
}

// The real part of 1/(1 - e^(-ix)) is 1/2 whatever x is, and the least real part of G is
// -1/(4 k zeta (1 + zeta)): where many waves lie on the part some speed of the wave is the right
// one.
TEST(GrindingLobes, LeastWidthIsTheClosedForm) {
  const CuttingProcess process = grinder();
  const double expected = 2.0 * k_n_per_mm * zeta * (1.0 + zeta) / layer_n_per_mm2;
  for (const double speed : {20.0, 33.0, 60.0}) {
    const auto limit = GrindingLobes(process).limit_at(speed);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(limit->depth_mm / expected, 1.0, 0.01) << speed;
    EXPECT_NEAR(limit->chatter_hz, 120.0 * std::sqrt(1.0 + 2.0 * zeta), 1.5) << speed;
  }
}

TEST(GrindingLobes, ASoftContactPermitsMoreWidth) {
  CuttingProcess process = grinder();
  process.grinding.stiffness_n_per_mm2 = 600.0;
  const double expected =
      (1.0 / (2.0 * layer_n_per_mm2) + 1.0 / 600.0) * 4.0 * k_n_per_mm * zeta * (1.0 + zeta);
  EXPECT_NEAR(GrindingLobes(process).limit_at(25.0)->depth_mm / expected, 1.0, 0.01);
}

// A fast part, as a lathe: the same equation as that of a turning cut.
TEST(GrindingLobes, WithoutContactTheyAreThoseOfTurning) {
  const CuttingProcess process = grinder();
  CuttingProcess turning = process;
  turning.kind = CutKind::turning;
  const StabilityLobes lobes(turning);
  for (const double speed : {700.0, 1500.0, 2500.0, 4000.0}) {
    const double depth = lobes.limit_at(speed)->depth_mm;
    EXPECT_NEAR(GrindingLobes(process).limit_at(speed)->depth_mm / depth, 1.0, 0.005) << speed;
  }
}

// Waves shorter than half of the contact cannot be met again: v_w / f < l / 2.
TEST(GrindingLobes, ASlowPartDoesNotChatter) {
  CuttingProcess process = grinder();
  process.grinding.length_mm = 1.0;
  // A wave of 126 Hz is 0.5 mm long at 20 rev/min, 5 mm at 200.
  const double rigid = GrindingLobes(grinder()).limit_at(20.0)->depth_mm;
  const auto slow = GrindingLobes(process).limit_at(20.0);
  EXPECT_TRUE(!slow || slow->depth_mm > 4.0 * rigid);
  const auto fast = GrindingLobes(process).limit_at(200.0);
  ASSERT_TRUE(fast);
  EXPECT_LT(fast->depth_mm, 1.2 * rigid);
}

// What was left on a surface, for a turn and half of the contact back. The contact is an odd number
// of steps long.
class Surface {
 public:
  Surface(double turn_s, double contact_s, double step_s)
      : turn_(std::lround(turn_s / step_s)),
        half_(std::max(0L, std::lround((contact_s / step_s - 1.0) / 2.0))),
        left_(checked_size(turn_ + half_ + 1), 0.0) {}

  // The mean over the contact, a turn before `now`.
  [[nodiscard]] double met_again(std::int64_t now) const {
    double sum = 0.0;
    for (std::int64_t k = -half_; k <= half_; ++k) sum += at(now - turn_ + k);
    return sum / static_cast<double>(2 * half_ + 1);
  }
  void leave(std::int64_t now, double depth) { left_[place(now)] = depth; }
  void roughen(std::mt19937& random) {
    std::normal_distribution<double> gauss(0.0, 1.0);
    for (double& depth : left_) depth = gauss(random);
  }

 private:
  [[nodiscard]] double at(std::int64_t time) const { return left_[place(time)]; }
  [[nodiscard]] std::size_t place(std::int64_t time) const {
    const std::int64_t size = std::ssize(left_);
    return checked_size((time % size + size) % size);
  }

  std::int64_t turn_;
  std::int64_t half_;
  std::vector<double> left_;
};

// Part and wheel as surfaces, the mode by the leap-frog scheme: by how much the force has grown
// from one stretch of time to the next.
class TimeRun {
 public:
  TimeRun(const CuttingProcess& process, double part_rev_per_min, double width_mm)
      : part_(60.0 / part_rev_per_min,
              process.grinding.length_mm / part_speed(process, part_rev_per_min), step_s),
        wheel_(60.0 / process.grinding.wheel_rev_per_min,
               process.grinding.length_mm / wheel_speed(process), step_s),
        stiffness_n_per_mm_(layer_n_per_mm2 * width_mm) {
    const GrindingContact& contact = process.grinding;
    if (contact.grinding_ratio > 0.0) {
      wheel_part_ =
          part_speed(process, part_rev_per_min) / (contact.grinding_ratio * wheel_speed(process));
    }
    if (contact.stiffness_n_per_mm2 > 0.0) soft_ = layer_n_per_mm2 / contact.stiffness_n_per_mm2;
    std::mt19937 random(7);
    part_.roughen(random);
  }

  double growth(double seconds) {
    const double before = run(seconds);
    return run(seconds) / before;
  }

 private:
  static constexpr double step_s = 1e-4;
  static double part_speed(const CuttingProcess& process, double rev_per_min) {
    return 2.0 * std::numbers::pi * process.grinding.part_radius_mm * rev_per_min / 60.0;
  }
  static double wheel_speed(const CuttingProcess& process) {
    return 2.0 * std::numbers::pi * process.grinding.wheel_radius_mm *
           process.grinding.wheel_rev_per_min / 60.0;
  }
  // Root mean square of the force over the last half of the time.
  double run(double seconds) {
    const double omega = 2.0 * std::numbers::pi * 120.0;
    const double mass = k_n_per_mm / (omega * omega);
    const double damping = 2.0 * zeta * mass * omega;
    const auto steps = static_cast<int>(seconds / step_s);
    double power = 0.0;
    for (int n = 0; n < steps; ++n, ++now_) {
      // The place of the wheel: -x, less what it wore, less what the contact gives way.
      const double part_before = part_.met_again(now_);
      const double wheel_before = wheel_.met_again(now_);
      const double layer = (-x_ - part_before - wheel_before) / (1.0 + soft_ + wheel_part_);
      const double force = stiffness_n_per_mm_ * layer;
      part_.leave(now_, part_before + layer);
      wheel_.leave(now_, wheel_before + wheel_part_ * layer);
      const double next = ((2.0 * mass - k_n_per_mm * step_s * step_s) * x_ -
                           (mass - 0.5 * damping * step_s) * x_old_ + force * step_s * step_s) /
                          (mass + 0.5 * damping * step_s);
      x_old_ = x_;
      x_ = next;
      if (2 * n >= steps) power += force * force;
    }
    return std::sqrt(power);
  }

  Surface part_;
  Surface wheel_;
  double stiffness_n_per_mm_;
  double wheel_part_ = 0.0;
  double soft_ = 0.0;
  double x_ = 0.0;
  double x_old_ = 0.0;
  std::int64_t now_ = 0;
};

TEST(GrindingLobes, AreThoseOfTheMotionInTime) {
  struct Case {
    double speed;
    int contact_steps;  // of the run in time
    double stiffness;
  };
  for (const Case& at :
       {Case{120.0, 1, 0.0}, Case{120.0, 27, 0.0}, Case{90.0, 35, 800.0}, Case{240.0, 27, 0.0}}) {
    CuttingProcess process = grinder();
    process.grinding.length_mm =
        at.contact_steps * 1e-4 * 2.0 * std::numbers::pi * 30.0 * at.speed / 60.0;
    process.grinding.stiffness_n_per_mm2 = at.stiffness;
    const auto limit = GrindingLobes(process).limit_at(at.speed);
    ASSERT_TRUE(limit) << at.speed;
    EXPECT_LT(TimeRun(process, at.speed, 0.97 * limit->depth_mm).growth(40.0), 1.0)
        << at.speed << " " << at.contact_steps;
    EXPECT_GT(TimeRun(process, at.speed, 1.03 * limit->depth_mm).growth(40.0), 1.0)
        << at.speed << " " << at.contact_steps;
  }
}

// A wheel that wears: its waves are longer than the contact, and hold the limit down where the part
// alone would be stable at any width.
TEST(GrindingLobes, AWheelThatWearsIsMetAgainToo) {
  CuttingProcess process = grinder();
  process.grinding.length_mm = 2.0;
  process.grinding.grinding_ratio = 2.0;  // soft: its waves grow within seconds
  const double speed = 60.0;
  const auto limit = GrindingLobes(process).limit_at(speed);
  ASSERT_TRUE(limit);
  EXPECT_LT(TimeRun(process, speed, 0.95 * limit->depth_mm).growth(60.0), 1.0);
  EXPECT_GT(TimeRun(process, speed, 1.05 * limit->depth_mm).growth(60.0), 1.0);
}

// Waves of the wheel have narrow lobes at its orders: 1/(1 - e^(-ix)) takes any imaginary part
// there, so that the part alone gives the real one, 1 where its waves are evened out, and
// b = -1/(k' Re G) at the worst order.
TEST(GrindingLobes, WavesOfTheWheelAreMetAgainAtItsOrders) {
  CuttingProcess process = grinder();
  process.grinding.length_mm = 1.0;
  process.grinding.grinding_ratio = 0.5;
  process.grinding.wheel_rev_per_min = 1500.0;  // 25 Hz
  const double speed = 7.0;                     // 0.17 mm of wave: evened out to 0.06 or less
  double expected = 1e9;
  for (double hz = 75.0; hz < 360.0; hz += 25.0) {
    const double real = receptance(process.modes_x, 2.0 * std::numbers::pi * hz).real();
    if (real < 0.0) expected = std::min(expected, -1.0 / (layer_n_per_mm2 * real));
  }
  const auto limit = GrindingLobes(process).limit_at(speed);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->depth_mm / expected, 1.0, 0.08);
  EXPECT_NEAR(limit->chatter_hz, 125.0, 0.1);
}

}  // namespace
}  // namespace stanok::process
