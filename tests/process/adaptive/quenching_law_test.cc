// The force of the vibration law against equation (2), written out here:
// P = 1.1 (a_0 / sqrt 2) m |w_d^2 - (2 pi f)^2|.
#include "process/adaptive/quenching_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "drives/vibration_meter.h"

namespace stanok::process {
namespace {

constexpr double law_mass_kg = 2.0;
constexpr double law_hz = 4.0;
constexpr double level_um = 6.0;
constexpr double turn_rad = 2.0 * std::numbers::pi;

double force_for(double amplitude_um, double hz) {
  return 1.1 * amplitude_um * 1e-6 / std::numbers::sqrt2 * law_mass_kg *
         std::abs(std::pow(turn_rad * hz, 2) - std::pow(turn_rad * law_hz, 2));
}

class LawBench {
 public:
  LawBench() { law_.set(law_mass_kg, law_hz); }

  // The vibration as the meter tells it; what is formed is what is wanted.
  void run(double seconds, double amplitude_um, double hz) {
    for (int k = 0; k < static_cast<int>(seconds * 1000.0); ++k) advance({amplitude_um, hz});
  }
  void advance(const Vibration& sensed, bool cuts = true) {
    const bool is_above = sensed.amplitude_um > level_um;
    law_.advance({.cycle_s = 0.001,
                  .revolution_s = 0.1,
                  .above = is_above ? sensed : Vibration{},
                  .sensed = sensed,
                  .least_um = 0.8 * level_um,
                  .formed = law_.wanted(0.1),
                  .cuts = cuts});
  }
  [[nodiscard]] double force() const { return law_.wanted(0.1).force_n; }

 private:
  QuenchingLaw law_{1.1};
};

TEST(QuenchingLaw, HasTheForceOfTheVibrationThatIsThereNow) {
  LawBench bench;
  bench.run(1.0, 5.9, 100.0);
  EXPECT_EQ(bench.force(), 0.0) << "within the level";
  bench.run(1.0, 12.0, 100.0);
  EXPECT_NEAR(bench.force(), force_for(12.0, 100.0), 1e-9);
  bench.run(2.0, 20.0, 100.0);
  EXPECT_NEAR(bench.force(), force_for(20.0, 100.0), 1e-9) << "it has grown";
  bench.run(2.0, 9.0, 100.0);
  EXPECT_NEAR(bench.force(), force_for(9.0, 100.0), 1e-9) << "it has fallen";
  bench.run(2.0, 15.0, 160.0);
  EXPECT_NEAR(bench.force(), force_for(15.0, 160.0), 1e-9) << "it is another one";
  bench.run(2.0, 4.0, 160.0);
  EXPECT_EQ(bench.force(), 0.0) << "it is permitted";
}

TEST(QuenchingLaw, BeginsWithAVibrationThatGrowsOnAndFollowsIt) {
  LawBench bench;
  double amplitude = 6.5;
  for (int k = 0; k < 4000; ++k) bench.advance({amplitude *= 1.0003, 100.0});
  EXPECT_GT(bench.force(), 0.0);
  bench.run(2.0, amplitude, 100.0);
  EXPECT_NEAR(bench.force(), force_for(amplitude, 100.0), 1e-9);
}

// What it has quenched it holds, but not for ever.
TEST(QuenchingLaw, FadesWhileNothingVibratesAndEnds) {
  LawBench bench;
  bench.run(2.0, 12.0, 100.0);
  const double formed = bench.force();
  bench.run(2.0, 0.1, 100.0);
  EXPECT_EQ(bench.force(), formed);
  bench.run(5.0, 0.1, 100.0);
  EXPECT_LT(bench.force(), formed);
  EXPECT_GT(bench.force(), 0.9 * formed);
  bench.run(120.0, 0.1, 100.0);
  EXPECT_EQ(bench.force(), 0.0);
}

// Van der Pol: a^2 = a_0^2 - 2 B^2, with B = P / (m |w_d^2 - w^2|).
TEST(QuenchingLaw, FindsBackToItsForceWhenAVibrationComesThrough) {
  LawBench bench;
  bench.run(2.0, 12.0, 100.0);
  for (int k = 0; k < 60000; ++k) {
    const double moved = bench.force() / law_mass_kg /
                         std::abs(std::pow(turn_rad * 100.0, 2) - std::pow(turn_rad * law_hz, 2)) *
                         1e6;
    const double rest = 144.0 - 2.0 * moved * moved;
    bench.advance({rest > 0.0 ? std::sqrt(rest) : 0.05, 100.0});
    ASSERT_GE(bench.force(), 0.88 * force_for(12.0, 100.0)) << k;
    ASSERT_LE(bench.force(), 1.01 * force_for(12.0, 100.0)) << k;
  }
}

TEST(QuenchingLaw, EndsWithTheCut) {
  LawBench bench;
  bench.run(2.0, 12.0, 100.0);
  ASSERT_GT(bench.force(), 0.0);
  bench.advance({12.0, 100.0}, false);
  EXPECT_EQ(bench.force(), 0.0);
}

// Meter and law together on samples: noise, a second line, run-out of twice the amplitude.
TEST(QuenchingLaw, HasTheForceWithinFivePercentInNoiseBesideALineAndRunOut) {
  constexpr double rate = 4000.0;
  for (const double hz : {57.0, 113.0, 236.0}) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1.2);
    drives::VibrationMeter meter(rate);
    LawBench bench;
    for (int cycle = 0; cycle < 8000; ++cycle) {
      std::vector<double> samples;
      for (int k = 0; k < 4; ++k) {
        const double t = (4 * cycle + k) / rate;
        samples.push_back(12.0 * std::sin(turn_rad * hz * t) +
                          7.0 * std::sin(turn_rad * 187.0 * t) +
                          24.0 * std::sin(turn_rad * 10.0 * t) +
                          9.0 * std::sin(turn_rad * 30.0 * t) + noise(random));
      }
      meter.add(samples, 600.0);
      static_cast<void>(meter.work());
      bench.advance({meter.level().amplitude_um, meter.level().frequency_hz});
      if (cycle < 2500) continue;
      ASSERT_NEAR(bench.force(), force_for(12.0, hz), 0.05 * force_for(12.0, hz)) << hz << cycle;
    }
  }
}

}  // namespace
}  // namespace stanok::process
