// Verdicts on cycles: the paper's file passes, others burn, bend, chatter or stay oversize.
#include "process/grinding/verification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> codes(const Findings& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

Verification verified(const InfeedLaw& law, const VerificationLimits& limits = {}) {
  return verify_cycle(petrakov::sheet(), law, {}, limits);
}

TEST(Verification, PassesThePapersFileAndReportsItsPlungeIn) {
  const Verification result = verified(petrakov::table());
  EXPECT_THAT(codes(result.findings), ElementsAre("W911", "W910"));
  EXPECT_FALSE(has_errors(result.findings));
  EXPECT_NEAR(result.run.time_s, 18.059, 0.001);
  // Its last feed is 0.0040 where Q_end permits 0.05 / (R_eq tau) = 0.003833.
  EXPECT_NEAR(result.burn.ratio, 0.0040 / 0.0038333, 0.001);
  EXPECT_LT(std::abs(result.run.residual_mm), 0.001);
}

TEST(Verification, FindsThePlungeInAtTheEndOfTheFirstFeed) {
  const Verification result = verified(petrakov::table());
  EXPECT_GT(result.boundary.ratio, 1.05);
  EXPECT_NEAR(result.boundary.x_mm, 0.2602, 0.002);
  EXPECT_LT(result.boundary_settled.ratio, 1.05);
}

TEST(Verification, HoldsTheFileToTheBurnLineWhenThereIsNoMargin) {
  const Verification result = verified(petrakov::table(), {.burn_margin = 0.0});
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9103"));
}

// The slow feeds begin too late: removal 0.38 where the line permits less.
TEST(Verification, CallsRemovalAboveTheBurnLineABurn) {
  const InfeedLaw law{{0.3, 0.03}, {0.02, 0.03}, {0.02, 0.0038}, {-0.005, 0.0038}};
  const Verification result = verified(law);
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9103"));
  EXPECT_GT(result.burn.ratio, 2.0);
  EXPECT_LT(result.burn.x_mm, 0.03);
}

TEST(Verification, TellsADeflectionThatStaysFromThatOfThePlungeIn) {
  InfeedLaw law = petrakov::table();
  law[2].feed_mm_per_s = law[3].feed_mm_per_s = 0.0340;  // steady: 1.09 Q_max, far above H_crit
  EXPECT_THAT(codes(verified(law).findings), ::testing::Contains("E9104"));
}

TEST(Verification, NamesWhatIsLeftOfTheAllowance) {
  InfeedLaw law = petrakov::table();
  law.back().x_mm = 0.0;  // no overrun: deflection and last layer stay
  const Verification result = verified(law);
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9106"));
  const double force = 72.0 * std::pow(0.05217 * 22.619, 0.56);
  EXPECT_NEAR(result.run.residual_mm, force / 25000.0 + 0.002, 0.0001);
}

TEST(Verification, DoesNotSimulateATableWithoutEnd) {
  const Verification result = verified(constant_law(0.3, 0.0, 1e-9));
  EXPECT_THAT(codes(result.findings), ElementsAre("E9106"));
}

// 2 C zeta (1 + zeta) over alpha P/a at Q_end: 1.15 with a damping ratio of 0.372.
TEST(Verification, WarnsOfAMarginThatIsSmall) {
  GrindingProcess process = petrakov::sheet();
  process.damping_n_s_per_m *= 0.372 / 0.9;
  const Verification result = verify_cycle(process, petrakov::table(), {}, {});
  EXPECT_THAT(codes(result.findings), ::testing::Contains("W913"));
  EXPECT_THAT(codes(result.findings), ::testing::Not(::testing::Contains("E9109")));
}

TEST(Verification, HearsTheChatterOfASystemWithoutDamping) {
  GrindingProcess process = petrakov::sheet();
  process.damping_n_s_per_m = 2.0 * 0.05 * std::sqrt(25e6 * 32.0);
  const Verification result = verify_cycle(process, petrakov::table(), {}, {});
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9105"));
}

// 50 um further than the paper's last X: all of it is taken too much, but for 0.36 um that are left
// there. At the end of the cycle the feed is steady, so that nothing else changes.
TEST(Verification, FindsAnUndersizePart) {
  InfeedLaw law = petrakov::table();
  law.back().x_mm -= 0.050;
  const Verification result = verified(law);
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9108"));
  EXPECT_TRUE(has_errors(result.findings));
  EXPECT_NEAR(result.run.residual_mm, 0.00036 - 0.050, 0.0001);
  EXPECT_THAT(codes(verified(law, {.undersize_max_mm = 0.060}).findings),
              ::testing::Not(::testing::Contains("E9108")));
}

TEST(Verification, HoldsTheSizeToItsToleranceOnBothSides) {
  for (const double offset_mm : {-0.0030, -0.0005, 0.0, 0.0005, 0.0030}) {
    InfeedLaw law = petrakov::table();
    law.back().x_mm += offset_mm;
    const std::vector<std::string> found = codes(verified(law).findings);
    EXPECT_EQ(std::ranges::count(found, "E9108"), offset_mm < -0.001 ? 1 : 0) << offset_mm;
    EXPECT_EQ(std::ranges::count(found, "E9106"), offset_mm > 0.001 ? 1 : 0) << offset_mm;
  }
}

// zeta for which 2 C zeta (1 + zeta) is 0.9 of the stiffness of the cut at Q_end,
// k = alpha C_p B (Q_end V)^alpha / a with a = Q_end (R + R_w) / (R R_w) and V = 2 pi R n / 1000.
TEST(Verification, FindsAStabilityMarginBelowOne) {
  const double layer_mm = 0.050 * 230.0 / (30.0 * 200.0);
  const double speed = 2.0 * std::numbers::pi * 30.0 * 120.0 / 1000.0;
  const double cut = 0.56 * 3.6 * 20.0 * std::pow(0.050 * speed, 0.56) / layer_mm;
  for (const double margin : {0.9, 1.1}) {
    const double zeta = 0.5 * (std::sqrt(1.0 + 2.0 * margin * cut / 25000.0) - 1.0);
    GrindingProcess process = petrakov::sheet();
    process.damping_n_s_per_m = 2.0 * zeta * std::sqrt(25e6 * 32.0);
    const std::vector<std::string> found =
        codes(verify_cycle(process, petrakov::table(), {}, {}).findings);
    const bool is_told =
        std::ranges::count(found, "E9109") + std::ranges::count(found, "E9105") == 1;
    EXPECT_EQ(is_told, margin < 1.0) << margin;
  }
}

// 0.0048 mm/s leave a step of 2.4 um, more than the 2 um between the limits of the size.
TEST(Verification, TellsAGreatStepAlsoWhereNoRoundnessIsAskedFor) {
  InfeedLaw law = petrakov::table();
  law[10].feed_mm_per_s = law[11].feed_mm_per_s = 0.0048;
  EXPECT_THAT(codes(verified(law).findings), ::testing::Contains("W912"));
  EXPECT_THAT(codes(verified(petrakov::table()).findings),
              ::testing::Not(::testing::Contains("W912")));
}

// The step of the spiral without spark-out: the infeed of a revolution, 0.0040 mm/s times 0.5 s.
// With it C y_n = c (y_{n-1} - y_n)^alpha, solved here by bisection, tells the layer of each
// revolution and so how many there must be.
TEST(Verification, FindsASparkOutTooShortForTheRoundness) {
  const Verification without = verified(petrakov::table(), {.roundness_max_mm = 0.0010});
  EXPECT_THAT(codes(without.findings), ::testing::Contains("E9110"));
  EXPECT_NEAR(without.run.out_of_roundness_mm(), 0.0040 * 0.5, 0.00005);

  const double speed = 2.0 * std::numbers::pi * 30.0 * 120.0 / 1000.0;
  const double c = 3.6 * 20.0 * std::pow(speed * 30.0 * 200.0 / 230.0, 0.56);
  double y_mm = c * std::pow(0.0020, 0.56) / 25000.0;
  int needed = 0;
  for (double layer_mm = 0.0020; layer_mm > 0.0003; ++needed) {
    double low = 0.0;
    double high = y_mm;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (25000.0 * (y_mm - middle) > c * std::pow(middle, 0.56) ? low : high) = middle;
    }
    layer_mm = low;
    y_mm -= layer_mm;
  }
  const VerificationLimits limits{.undersize_max_mm = 0.01, .roundness_max_mm = 0.0003};
  for (const int revolutions : {needed - 1, needed + 1}) {
    const Verification result =
        verify_cycle(petrakov::sheet(), petrakov::table(),
                     {.spark_out_revolutions = static_cast<double>(revolutions)}, limits);
    EXPECT_EQ(std::ranges::count(codes(result.findings), "E9110"), revolutions < needed ? 1 : 0)
        << revolutions << " of " << needed << ": " << result.run.out_of_roundness_mm();
  }
}

// At the end the deflection P/C is 3.16 um; half the stiffness doubles it, one and a half leaves
// two thirds. The force of the end hardly depends on the stiffness: the feed commands the removal.
TEST(Verification, GivesTheSizeErrorOfAnotherStiffness) {
  const Verification result = verified(petrakov::table());
  ASSERT_EQ(result.size_errors.size(), 2U);
  const double deflection_mm = result.run.samples.back().deflection_mm;
  EXPECT_EQ(result.size_errors[0].factor, 0.5);
  EXPECT_NEAR(result.size_errors[0].error_mm, deflection_mm, 0.05 * deflection_mm);
  EXPECT_EQ(result.size_errors[1].factor, 1.5);
  EXPECT_NEAR(result.size_errors[1].error_mm, -deflection_mm / 3.0, 0.05 * deflection_mm);
}

// Half the stiffness leaves deflection_mm more; the last feed takes it off in deflection_mm / V.
TEST(Verification, GivesTheTimeWithAGaugeThatTakesTheSizeErrorAway) {
  const Verification result = verified(petrakov::table());
  const double more_mm = result.size_errors[0].error_mm + result.run.residual_mm;
  ASSERT_TRUE(result.size_errors[0].gauged_time_s.has_value());
  EXPECT_NEAR(*result.size_errors[0].gauged_time_s, result.run.time_s + more_mm / 0.0040, 0.02);
  EXPECT_LT(*result.size_errors[1].gauged_time_s, result.run.time_s);
}

}  // namespace
}  // namespace stanok::process
