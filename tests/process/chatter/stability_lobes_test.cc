// Stability lobes against closed forms, and two methods that know nothing of each other against
// one another.
#include "process/chatter/stability_lobes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/chatter/semi_discretisation.h"

namespace stanok::process {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

CuttingProcess turning() {
  return {.kind = CutKind::turning,
          .force_n_per_mm2 = 2000.0,
          .modes_x = {{.frequency_hz = 150.0, .damping = 0.035, .stiffness_n_per_mm = 12000.0}},
          .modes_y = {}};
}

CuttingProcess slot() {
  return {.kind = CutKind::milling,
          .force_n_per_mm2 = 796.0,
          .radial_ratio = 0.21,
          .teeth = 3,
          .modes_x = {{.frequency_hz = 603.0, .damping = 0.039, .stiffness_n_per_mm = 5590.0}},
          .modes_y = {{.frequency_hz = 666.0, .damping = 0.035, .stiffness_n_per_mm = 5720.0}}};
}

// b_min = 2 k zeta (1 + zeta) / K at the frequency omega_n sqrt(1 + 2 zeta) (Tlusty 2000, ch. 9).
TEST(StabilityLobes, LeastDepthOfATurningCutIsTheClosedForm) {
  const CuttingProcess process = turning();
  const double zeta = 0.035;
  const auto least = StabilityLobes(process).least_limit();
  ASSERT_TRUE(least);
  const double expected = 2.0 * 12000.0 * zeta * (1.0 + zeta) / 2000.0;
  EXPECT_NEAR(least->depth_mm / expected, 1.0, 1e-5);
  EXPECT_NEAR(least->chatter_hz, 150.0 * std::sqrt(1.0 + 2.0 * zeta), 0.02);
}

// At the frequency w, phase from tan(theta / 2) = -Re G / Im G, depth -1 / (2 K Re G): every point
// of a lobe in closed form.
TEST(StabilityLobes, TurningLobesAreTheClosedForm) {
  const CuttingProcess process = turning();
  const StabilityLobes lobes(process);
  for (const double hz : {152.0, 155.0, 158.0, 163.0, 170.0}) {
    const std::complex<double> g = receptance(process.modes_x, two_pi * hz);
    const double depth = -1.0 / (2.0 * 2000.0 * g.real());
    double theta = 2.0 * std::atan(-g.real() / g.imag());
    if (theta < 0.0) theta += two_pi;
    for (const int waves : {0, 1, 2, 5}) {
      const double speed = 60.0 * hz * two_pi / (theta + two_pi * waves);
      const auto limit = lobes.limit_at(speed);
      ASSERT_TRUE(limit);
      // Another lobe may be lower at this speed.
      EXPECT_LE(limit->depth_mm, depth * 1.0005) << hz << " " << waves;
      if (limit->waves == waves && std::abs(limit->chatter_hz - hz) < 1.0) {
        EXPECT_NEAR(limit->depth_mm / depth, 1.0, 5e-4) << hz << " " << waves;
      }
    }
  }
}

TEST(StabilityLobes, TurningAgreesWithTheMotionItself) {
  const CuttingProcess process = turning();
  const StabilityLobes lobes(process);
  const SemiDiscretisation motion(process);
  for (const double speed : {1500.0, 2600.0, 3700.0, 4800.0, 7000.0, 11000.0}) {
    const auto limit = lobes.limit_at(speed);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(motion.limit_at(speed, 3.0 * limit->depth_mm) / limit->depth_mm, 1.0, 0.01)
        << speed;
  }
}

// Many teeth in a full slot: the coefficients hardly change over a tooth period, so that their mean
// is exact.
TEST(StabilityLobes, MillingWithManyTeethAgreesWithTheMotionItself) {
  CuttingProcess process = slot();
  process.teeth = 12;
  const StabilityLobes lobes(process);
  const SemiDiscretisation motion(process);
  for (const double speed : {1500.0, 2000.0, 2700.0, 3300.0}) {
    const auto limit = lobes.limit_at(speed);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(motion.limit_at(speed, 3.0 * limit->depth_mm) / limit->depth_mm, 1.0, 0.02)
        << speed;
  }
}

TEST(StabilityLobes, SlotWithThreeTeethIsNearTheMotionItself) {
  const CuttingProcess process = slot();
  const StabilityLobes lobes(process);
  const SemiDiscretisation motion(process);
  for (const double speed : {3000.0, 5000.0, 9000.0, 12000.0, 14000.0}) {
    const auto limit = lobes.limit_at(speed);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(motion.limit_at(speed, 3.0 * limit->depth_mm) / limit->depth_mm, 1.0, 0.12)
        << speed;
  }
}

// At no speed a lobe is left out.
TEST(StabilityLobes, SlotIsNearTheMotionItselfAtAnySpeed) {
  const CuttingProcess process = slot();
  const StabilityLobes lobes(process);
  const SemiDiscretisation motion(process);
  for (double speed = 4900.0; speed < 5000.0; speed += 7.0) {
    const auto limit = lobes.limit_at(speed);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(motion.limit_at(speed, 2.0) / limit->depth_mm, 1.0, 0.15) << speed;
  }
}

// Coefficients in proportion: twice the force halves the depth, and a mode of twice the stiffness
// doubles it.
TEST(StabilityLobes, DepthIsInProportion) {
  CuttingProcess process = slot();
  const auto least = StabilityLobes(process).least_limit();
  process.force_n_per_mm2 *= 2.0;
  EXPECT_NEAR(StabilityLobes(process).least_limit()->depth_mm, 0.5 * least->depth_mm, 1e-12);
  process.modes_x[0].stiffness_n_per_mm *= 2.0;
  process.modes_y[0].stiffness_n_per_mm *= 2.0;
  EXPECT_NEAR(StabilityLobes(process).least_limit()->depth_mm, least->depth_mm, 1e-12);
}

TEST(SemiDiscretisation, WavesGrowAboveTheLimitAndNotBelow) {
  const SemiDiscretisation motion(slot());
  const double limit = motion.limit_at(9000.0, 5.0);
  EXPECT_LT(motion.growth(9000.0, 0.98 * limit), 1.0);
  EXPECT_GT(motion.growth(9000.0, 1.02 * limit), 1.0);
}

// What does not cut does not vibrate: the decay of the least damped mode over a tooth period.
TEST(SemiDiscretisation, WithoutACutModesDecay) {
  const CuttingProcess process = slot();
  const double speed = 6000.0;
  const double period = 60.0 / (3.0 * speed);
  const double expected = std::max(std::exp(-0.039 * two_pi * 603.0 * period),
                                   std::exp(-0.035 * two_pi * 666.0 * period));
  EXPECT_NEAR(SemiDiscretisation(process).growth(speed, 0.0), expected, 1e-6);
}

// The case by which such methods are compared: one mode along the feed, a full slot with two teeth
// at 5000 rev/min. Converged growths of Y. Ding, L. Zhu, X. Zhang, H. Ding, A full-discretization
// method for prediction of milling stability, Int. J. Mach. Tools Manuf. 50 (2010) 502.
TEST(SemiDiscretisation, GrowsAsPublished) {
  constexpr double mass_kg = 0.03993;
  constexpr double hz = 922.0;
  CuttingProcess process;
  process.force_n_per_mm2 = 600.0;
  process.radial_ratio = 200.0 / 600.0;
  process.teeth = 2;
  process.modes_x = {{.frequency_hz = hz,
                      .damping = 0.011,
                      .stiffness_n_per_mm = mass_kg * two_pi * hz * two_pi * hz * 1e-3}};
  const SemiDiscretisation motion(process);
  struct Published {
    double depth_mm;
    double growth;
  };
  for (const auto& [depth_mm, growth] :
       {Published{0.2, 0.8192}, {0.5, 1.0726}, {0.7, 1.2197}, {1.0, 1.4040}})
    EXPECT_NEAR(motion.growth(5000.0, depth_mm) / growth, 1.0, 0.005) << depth_mm;
}

TEST(Engagement, OfAnEndMill) {
  CuttingProcess process = slot();
  engage(process, MillingSense::up, 0.5);
  EXPECT_NEAR(process.entry_rad, 0.0, 1e-12);
  EXPECT_NEAR(process.exit_rad, 0.5 * std::numbers::pi, 1e-12);
  engage(process, MillingSense::down, 0.05);
  EXPECT_NEAR(process.exit_rad, std::numbers::pi, 1e-12);
  EXPECT_NEAR(std::numbers::pi - process.entry_rad, std::acos(0.9), 1e-12);
}

}  // namespace
}  // namespace stanok::process
