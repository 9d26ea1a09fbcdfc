// The continuous law: it follows the boundary, for every gain below 1; above, its error swings.
#include "process/grinding/optimiser.h"

#include <gtest/gtest.h>

#include <cmath>

#include "process/grinding/cycle_design.h"
#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

OptimalLaw optimum(double feedback, int iterations_max = 60, bool stops = true) {
  const GrindingProcess process = petrakov::sheet();
  return optimal_law(
      process, 0.3, usual_feeds(process),
      {.feedback = feedback, .iterations_max = iterations_max, .stops_when_growing = stops}, {});
}

class Gain : public ::testing::TestWithParam<double> {};

TEST_P(Gain, BelowOneComesToTheBoundary) {
  const OptimalLaw law = optimum(GetParam());
  EXPECT_LT(law.best.rms, 0.01);
  EXPECT_LT(law.best.worst, 0.05);
  // The command at the end is that of Q_end, and the overrun its deflection and its last layer.
  const PlungeSample& end = law.run.samples.back();
  EXPECT_NEAR(end.x_mm, -0.0048, 0.0002 + 0.002);
  EXPECT_NEAR(law.run.time_s, 14.7, 0.1);
}

// Where the error is large and smooth, an iteration leaves 1 - k of it: behind 3 iterations the
// ratio of successive errors is near that.
TEST_P(Gain, ShrinksTheErrorByOneLessTheGain) {
  const double k = GetParam();
  const OptimalLaw law = optimum(k, 4);
  const double ratio = law.iterations[2].rms / law.iterations[1].rms;
  EXPECT_NEAR(ratio, 1.0 - k, 0.12) << "k_oc " << k;
}

INSTANTIATE_TEST_SUITE_P(OptimalLaw, Gain, ::testing::Values(0.1, 0.3, 0.5, 0.7, 0.9));

TEST(OptimalLaw, TakesFewerIterationsWithALargerGain) {
  EXPECT_GT(optimum(0.2).iterations.size(), optimum(0.5).iterations.size());
  EXPECT_GT(optimum(0.5).iterations.size(), optimum(0.8).iterations.size());
}

TEST(OptimalLaw, SwingsUpAgainWithAGainAboveOne) {
  const OptimalLaw law = optimum(1.5, 40, false);
  EXPECT_GT(law.iterations.back().rms, 5.0 * law.best.rms);
  EXPECT_EQ(law.settling, Settling::ran_out);
}

TEST(OptimalLaw, KeepsItsFeedsInTheRange) {
  const GrindingProcess process = petrakov::sheet();
  const FeedRange feeds{0.003, 0.02};
  const OptimalLaw law = optimal_law(process, 0.3, feeds, {.iterations_max = 8}, {});
  for (const InfeedRow& row : law.law) {
    ASSERT_GE(row.feed_mm_per_s, feeds.min_mm_per_s);
    ASSERT_LE(row.feed_mm_per_s, feeds.max_mm_per_s);
  }
}

TEST(OptimalLaw, TellsEveryIterationAsItEnds) {
  std::vector<int> told;
  OptimiserOptions options{.iterations_max = 5};
  options.on_iteration = [&](const Iteration& iteration) { told.push_back(iteration.number); };
  const OptimalLaw law =
      optimal_law(petrakov::sheet(), 0.3, usual_feeds(petrakov::sheet()), options, {});
  EXPECT_EQ(told, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(law.iterations.size(), told.size());
}

}  // namespace
}  // namespace stanok::process
