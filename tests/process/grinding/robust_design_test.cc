// One table for a box of processes, judged by an integrator of the test's own
// (tests/process/plunge_oracle.h).
#include "process/grinding/robust_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/process/petrakov.h"
#include "tests/process/plunge_oracle.h"

namespace stanok::process {
namespace {

DesignRequest robust_request() {
  DesignRequest request;
  request.process = petrakov::sheet();
  request.allowance_mm = 0.3;
  request.staircase.points = 3;
  request.staircase.effort = StaircaseEffort::quick;
  request.spark_out = SparkOut::found;
  return request;
}

TEST(LawFrom, BeginsWhereThePartIsTouched) {
  const InfeedLaw law{{0.3, 0.04}, {0.2, 0.04}, {0.2, 0.02}, {0.0, 0.01}};
  EXPECT_EQ(law_from(law, 0.35), (InfeedLaw{{0.35, 0.04}, {0.2, 0.04}, {0.2, 0.02}, {0.0, 0.01}}));
  EXPECT_EQ(law_from(law, 0.25), (InfeedLaw{{0.25, 0.04}, {0.2, 0.04}, {0.2, 0.02}, {0.0, 0.01}}));
  EXPECT_EQ(law_from(law, 0.1), (InfeedLaw{{0.1, 0.015}, {0.0, 0.01}}));
}

TEST(RobustDesign, KeepsQualityInEveryCornerOfTheBox) {
  const auto robust = design_robust(robust_request(),
                                    {.stiffness = 0.2, .force_factor = 0.25, .allowance_mm = 0.02});
  ASSERT_TRUE(robust.has_value());
  EXPECT_EQ(robust->corners.size(), 8U);
  for (const Finding& finding : robust->design.verification.findings)
    EXPECT_FALSE(finding.is_error()) << finding.text;
  // Also inside of the box, by another integrator.
  for (const double stiffness : {0.8, 0.93, 1.2}) {
    for (const double force : {0.75, 1.1, 1.25}) {
      for (const double allowance_mm : {0.28, 0.31, 0.32}) {
        GrindingProcess process = petrakov::sheet();
        process.stiffness_n_per_m *= stiffness;
        process.force_factor *= force;
        const auto run = testing::run_plunge(process, law_from(robust->design.law, allowance_mm),
                                             robust->design.spark_out_revolutions);
        EXPECT_LE(run.burn_ratio, 1.05 + 2e-3) << stiffness << " " << force << " " << allowance_mm;
        EXPECT_LE(run.highest_mm, 0.001 + 2e-5) << stiffness << " " << force << " " << allowance_mm;
        EXPECT_GE(run.highest_mm, -0.001 - 2e-5)
            << stiffness << " " << force << " " << allowance_mm;
      }
    }
  }
}

TEST(RobustDesign, NamesTheCornerThatFails) {
  DesignRequest request = robust_request();
  request.limits.residual_max_mm = request.limits.undersize_max_mm = 1e-6;
  const auto robust = design_robust(request, {.stiffness = 0.5});
  ASSERT_TRUE(robust.has_value());
  ASSERT_TRUE(has_errors(robust->design.verification.findings));
  bool is_named = false;
  for (const Finding& finding : robust->design.verification.findings)
    is_named = is_named || finding.text.starts_with("stiffness x ");
  EXPECT_TRUE(is_named);
}

}  // namespace
}  // namespace stanok::process
