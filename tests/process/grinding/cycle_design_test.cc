// Whole designs: times between bound and baselines, and requests that are refused with a reason.
#include "process/grinding/cycle_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/process/petrakov.h"
#include "tests/support/sanitized.h"

namespace stanok::process {
namespace {

using ::testing::HasSubstr;

DesignRequest request() {
  DesignRequest request;
  request.process = petrakov::sheet();
  request.allowance_mm = 0.3;
  return request;
}

Finding refusal(const DesignRequest& request) {
  const auto design = design_cycle(request);
  EXPECT_FALSE(design.has_value());
  return design ? Finding{} : design.error().front();
}

TEST(CycleDesign, LiesBetweenTheLeastTimeAndTheBaselines) {
  const auto design = design_cycle(request());
  ASSERT_TRUE(design.has_value());
  const double staircase_s = design->verification.run.time_s;
  EXPECT_LT(design->least_time_s, design->continuous.run.time_s);
  EXPECT_LT(design->continuous.run.time_s, staircase_s);
  EXPECT_LT(staircase_s, design->three_step_time_s);
  EXPECT_LT(design->three_step_time_s, design->constant_safe_time_s);
  EXPECT_FALSE(has_errors(design->verification.findings));
}

// The paper claims two to three times: that is less than against the constant safe feed, more than
// against three steps.
TEST(CycleDesign, SavesWhatThePaperClaimsBetweenTheTwoBaselines) {
  const auto design = design_cycle(request());
  ASSERT_TRUE(design.has_value());
  const double staircase_s = design->verification.run.time_s;
  EXPECT_GT(design->constant_safe_time_s / staircase_s, 3.0);
  EXPECT_GT(design->three_step_time_s / staircase_s, 1.5);
}

TEST(CycleDesign, HoldsForTheExactFormToo) {
  DesignRequest exact = request();
  exact.process.removal = RemovalForm::exact;
  const auto design = design_cycle(exact);
  ASSERT_TRUE(design.has_value());
  EXPECT_FALSE(has_errors(design->verification.findings));
  EXPECT_GT(design->verification.run.time_s, design->least_time_s);
}

TEST(CycleDesign, RefusesAGainOfOneUnlessItIsToBeStudied) {
  DesignRequest unstable = request();
  unstable.optimiser.feedback = 1.0;
  const Finding finding = refusal(unstable);
  EXPECT_EQ(finding.code, "E9107");
  EXPECT_THAT(finding.text, HasSubstr("k_oc is 1"));
  unstable.optimiser.stops_when_growing = false;
  unstable.optimiser.iterations_max = 5;
  EXPECT_TRUE(design_cycle(unstable).has_value());
}

TEST(CycleDesign, ReportsAProcessThatChattersBeforeItDesignsAnything) {
  DesignRequest loose = request();
  loose.process.damping_n_s_per_m = 2.0 * 0.05 * std::sqrt(25e6 * 32.0);
  const Finding finding = refusal(loose);
  EXPECT_EQ(finding.code, "E9105");
  EXPECT_THAT(finding.text, HasSubstr("25000000 N/m"));
}

TEST(CycleDesign, ReportsAnAllowanceThatNoFeedReachesInTime) {
  DesignRequest slow = request();
  slow.simulation.time_max_s = 10.0;
  const Finding finding = refusal(slow);
  EXPECT_EQ(finding.code, "E9106");
  EXPECT_THAT(finding.text, HasSubstr("13.6 s"));
}

TEST(CycleDesign, ReportsAStiffnessThatCannotCarryTheRemovalOfTheEnd) {
  DesignRequest soft = request();
  soft.process.stiffness_n_per_m = 2e6;
  const Finding finding = refusal(soft);
  EXPECT_EQ(finding.code, "E9102");
  EXPECT_THAT(finding.text, HasSubstr("removal_end is 0.05"));
}

TEST(CycleDesign, ReportsAWheelThatWearsAsFastAsItIsFed) {
  DesignRequest worn = request();
  worn.simulation.time_max_s = 60.0;
  worn.simulation.wear_rate_mm_per_s = [](double) { return 0.05; };
  EXPECT_EQ(refusal(worn).code, "E9106");
}

// What the spring gives back while the wheel stands is not fed: the part comes to size with each
// spark-out, within the decimal of the table, 0.1 um.
TEST(CycleDesign, ComesToSizeWithAnySparkOut) {
  for (const double revolutions : {0.0, 1.0, 3.0, 8.0}) {
    DesignRequest sparked = request();
    sparked.comparison = Comparison::none;
    sparked.simulation.spark_out_revolutions = revolutions;
    const auto design = design_cycle(sparked);
    ASSERT_TRUE(design.has_value());
    EXPECT_FALSE(has_errors(design->verification.findings)) << revolutions;
    EXPECT_LE(design->verification.run.residual_mm, 1e-5) << revolutions;
    EXPECT_GT(design->verification.run.residual_mm, -2e-4) << revolutions;
  }
}

TEST(CycleDesign, RefusesALeastFeedAboveTheGreatest) {
  DesignRequest wrong = request();
  wrong.feeds.min_mm_per_s = 0.5;  // the greatest is the usual one, 1.3 x 0.0313
  EXPECT_EQ(refusal(wrong).code, "E9102");
  EXPECT_THAT(refusal(wrong).text, HasSubstr("feed_min is 0.5"));
}

TEST(CycleDesign, TakesGivenSwitchPointsToTheLastDigit) {
  DesignRequest given = request();
  given.staircase.at_mm = {0.080125, 0.02};
  const auto design = design_cycle(given);
  ASSERT_TRUE(design.has_value());
  EXPECT_EQ(design->law[1].x_mm, 0.080125);
}

// Soft and stiff, slow and fast, around the example: the steps keep the boundary, come to size and
// fall, or the design says what is wrong.
TEST(CycleDesign, KeepsTheBoundaryOrSaysWhyForRandomSheets) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> of_one(-0.5, 0.5);
  int designed = 0;
  constexpr int trials = stanok::testing::cases(40);
  for (int trial = 0; trial < trials; ++trial) {
    DesignRequest drawn = request();
    drawn.comparison = Comparison::none;
    if (trial % 8 != 0) drawn.staircase.effort = StaircaseEffort::quick;  // less time for the test
    drawn.process.stiffness_n_per_m *= std::exp(3.0 * of_one(random));
    drawn.process.damping_n_s_per_m *= std::exp(3.0 * of_one(random));
    drawn.process.part_speed_rpm *= std::exp(2.0 * of_one(random));
    drawn.process.force_exponent = 0.6 + 0.6 * of_one(random);
    drawn.process.critical_allowance_mm *= std::exp(2.0 * of_one(random));
    drawn.process.removal_end_mm2_per_rad *= std::exp(3.0 * of_one(random));
    const auto design = design_cycle(drawn);
    if (!design) {
      EXPECT_FALSE(design.error().empty());
      continue;
    }
    if (has_errors(design->verification.findings)) continue;
    ++designed;
    EXPECT_LE(design->verification.boundary.ratio, 1.005) << "seed 5, trial " << trial;
    EXPECT_LE(design->verification.run.residual_mm, 1e-5) << "seed 5, trial " << trial;
    EXPECT_GT(design->verification.run.time_s, design->least_time_s) << "seed 5, trial " << trial;
    for (std::size_t k = 1; k < design->law.size(); ++k) {
      ASSERT_LE(design->law[k].x_mm, design->law[k - 1].x_mm) << "seed 5, trial " << trial;
    }
  }
  EXPECT_GT(designed, trials * 3 / 8);
}

TEST(CycleDesign, ReportsAnAllowanceThatIsGoneInOneRevolution) {
  DesignRequest thin = request();
  thin.allowance_mm = 0.012;
  thin.process.critical_allowance_mm = 0.01;
  const Finding finding = refusal(thin);  // the layer of Q_max is 0.408 / R_eq = 0.0156 mm
  EXPECT_EQ(finding.code, "E9102");
  EXPECT_THAT(finding.text, HasSubstr("0.0156 mm in a revolution"));
}

TEST(CycleDesign, RefusesSwitchPointsThatRiseOrLieOutsideTheAllowance) {
  for (const std::vector<double>& at :
       {std::vector<double>{0.05, 0.07}, {0.4}, {0.1, -0.5}, {std::nan("")}}) {
    DesignRequest wrong = request();
    wrong.staircase.at_mm = at;
    EXPECT_EQ(refusal(wrong).code, "E9102");
  }
}

}  // namespace
}  // namespace stanok::process
