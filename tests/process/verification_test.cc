// Verdicts on cycles: the paper's file passes, others burn, bend, chatter or stay oversize.
#include "process/grinding/verification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

TEST(Verification, HearsTheChatterOfASystemWithoutDamping) {
  GrindingProcess process = petrakov::sheet();
  process.damping_n_s_per_m = 2.0 * 0.05 * std::sqrt(25e6 * 32.0);
  const Verification result = verify_cycle(process, petrakov::table(), {}, {});
  EXPECT_THAT(codes(result.findings), ::testing::Contains("E9105"));
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
