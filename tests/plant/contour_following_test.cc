// A circle R20 on simulated servo axes: what each term of the position controller is worth, and
// what differences of integer positions cost. Expected values are those of the transfer functions.
#include "tests/support/contour_following.h"

#include <gtest/gtest.h>

#include <complex>

namespace stanok::plant {
namespace {

using stanok::testing::circle_cycle_s;
using stanok::testing::CircleTask;
using stanok::testing::follow_circle;
using stanok::testing::following_error_rms;
using stanok::testing::inverting_gains;
using stanok::testing::RateSource;
using stanok::testing::roughness;

constexpr double kp = 40.0;

enum Terms { none, with_kv, with_ka, with_kr };

motion::ControllerGains gains_with(Terms terms, const VelocityLoopConfig& loop) {
  motion::ControllerGains gains = inverting_gains(kp, loop);
  if (terms < with_kr) gains.kr = 0.0;
  if (terms < with_ka) gains.ka = 0.0;
  if (terms < with_kv) gains.kv = 0.0;
  return gains;
}

class Circle : public ::testing::TestWithParam<double> {
 protected:
  [[nodiscard]] double rms(Terms terms, RateSource source = RateSource::interpolator) const {
    return following_error_rms(follow_circle(task_, gains_with(terms, task_.loop), source));
  }
  [[nodiscard]] double roughness_of(Terms terms, RateSource source) const {
    return roughness(follow_circle(task_, gains_with(terms, task_.loop), source));
  }

  CircleTask task_{.feed_per_s = GetParam() / 60.0};
};

// Each axis runs a sine of amplitude R, so that the error of both together has a constant length:
// R |1 - P F| / |1 + kp P Z|, with P the drive from U to position, F the terms fed forward, and Z
// the half cycle for which a held U is late in the loop.
TEST_P(Circle, FollowingErrorIsThatOfTheTransferFunctions) {
  using Complex = std::complex<double>;
  const double w = 2.0 * std::numbers::pi * task_.loop.bandwidth_hz;
  const double d = task_.loop.damping;
  const double r = 2.0 * std::numbers::pi * task_.loop.resonance_hz;
  const double h = task_.loop.resonance_damping;
  const Complex s{0.0, task_.feed_per_s / task_.radius};
  const Complex loop = w * w / (s * s + 2.0 * d * w * s + w * w);
  const Complex spring = (2.0 * h * r * s + r * r) / (s * s + 2.0 * h * r * s + r * r);
  const Complex drive = loop * spring / s;
  for (const Terms terms : {none, with_kv, with_ka}) {
    const auto gains = gains_with(terms, task_.loop);
    const Complex fed_forward = s * (gains.kv + gains.ka * s + gains.kr * s * s);
    const Complex held = std::exp(-s * circle_cycle_s / 2.0);
    const double expected =
        task_.radius * std::abs((1.0 - drive * fed_forward) / (1.0 + kp * drive * held));
    // Rounding of positions to 1 um adds some 0.1 um.
    EXPECT_NEAR(rms(terms), expected, 0.01 * expected + 1e-4) << "terms up to " << terms;
  }
}

TEST_P(Circle, EveryTermFedForwardLowersTheFollowingError) {
  EXPECT_LT(rms(with_kv), rms(none) / 10.0);
  EXPECT_LT(rms(with_ka), rms(with_kv) / 10.0);
  EXPECT_LE(rms(with_kr), rms(with_ka));
}

TEST_P(Circle, AnalyticRatesLeaveUFarSmootherThanDifferencesOfIntegerPositions) {
  const struct {
    Terms terms;
    double ratio;
  } cases[] = {{with_kv, 20.0}, {with_ka, 100.0}, {with_kr, 500.0}};
  for (const auto& [terms, ratio] : cases) {
    EXPECT_GT(roughness_of(terms, RateSource::differences),
              ratio * roughness_of(terms, RateSource::interpolator))
        << "terms up to " << terms;
  }
}

// With rounding independent from cycle to cycle, of variance z^2 / 12, the third difference of the
// codes has the variance (1 + 9 + 9 + 1) z^2 / 12; kv V is its second difference over T.
TEST_P(Circle, RoughnessOfDifferencedVelocityIsThatOfRoundingNoise) {
  const double expected = std::sqrt(20.0 / 12.0) * task_.resolution / circle_cycle_s;
  EXPECT_NEAR(roughness_of(with_kv, RateSource::differences), expected, 0.1 * expected);
}

INSTANTIATE_TEST_SUITE_P(Feeds, Circle, ::testing::Values(6000.0, 12000.0), [](const auto& feed) {
  return "F" + std::to_string(static_cast<int>(feed.param));
});

}  // namespace
}  // namespace stanok::plant
