// Infeed over position: times in closed form against numerical integration, and the walk along it.
#include "process/grinding/infeed_law.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/process/petrakov.h"

namespace stanok::process {
namespace {

// Time by the midpoint rule over X, independent of any closed form.
double integrated_time_s(const InfeedRow& begin, const InfeedRow& end) {
  constexpr int slices = 200000;
  double time_s = 0.0;
  for (int k = 0; k < slices; ++k) {
    const double part = (k + 0.5) / slices;
    const double feed = begin.feed_mm_per_s + part * (end.feed_mm_per_s - begin.feed_mm_per_s);
    time_s += (begin.x_mm - end.x_mm) / slices / feed;
  }
  return time_s;
}

TEST(InfeedLaw, TakesTheSumOfWayOverFeedWhereTheFeedIsConstant) {
  const double expected = 0.0398 / 0.0400 + 0.1709 / 0.0294 + 0.0193 / 0.0233 + 0.0200 / 0.0177 +
                          0.0300 / 0.0097 + 0.0248 / 0.0040;
  EXPECT_NEAR(law_time_s(petrakov::table()), expected, 1e-9);
}

TEST(InfeedLaw, TakesTheIntegralWhereTheFeedChangesAlongTheWay) {
  const InfeedRow fast{0.3, 0.04};
  const InfeedRow slow{0.1, 0.004};
  EXPECT_NEAR(law_time_s({fast, slow}), integrated_time_s(fast, slow), 1e-6);
}

TEST(InfeedTravel, ComesToTheSamePlaceInManySmallStepsAsInOneLargeOne) {
  const InfeedLaw law{{0.3, 0.04}, {0.2, 0.02}, {0.2, 0.03}, {0.05, 0.03}, {-0.01, 0.002}};
  std::mt19937 random(20);
  std::uniform_real_distribution<double> step(0.0, 0.02);
  InfeedTravel small(law, InfeedTravel::AtEnd::goes_on);
  double time_s = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const double next = step(random);
    small.advance(next);
    time_s += next;
    InfeedTravel large(law, InfeedTravel::AtEnd::goes_on);
    large.advance(time_s);
    ASSERT_NEAR(small.x_mm(), large.x_mm(), 1e-12) << "seed 20, step " << k;
  }
}

TEST(InfeedTravel, PassesEveryRowAtItsTime) {
  const InfeedLaw law = petrakov::table();
  InfeedTravel way(law, InfeedTravel::AtEnd::stands);
  way.advance(0.0398 / 0.0400);
  EXPECT_NEAR(way.x_mm(), 0.2602, 1e-12);
  EXPECT_NEAR(way.feed_mm_per_s(), 0.0294, 1e-12);
}

TEST(InfeedTravel, StandsAtTheEndOrGoesOnWithTheLastFeed) {
  const InfeedLaw law = constant_law(0.1, 0.0, 0.01);
  InfeedTravel standing(law, InfeedTravel::AtEnd::stands);
  standing.advance(12.0);
  EXPECT_EQ(standing.x_mm(), 0.0);
  EXPECT_EQ(standing.feed_mm_per_s(), 0.0);
  InfeedTravel going(law, InfeedTravel::AtEnd::goes_on);
  going.advance(12.0);
  EXPECT_NEAR(going.x_mm(), -0.02, 1e-12);
}

}  // namespace
}  // namespace stanok::process
