// Staircases: places of least time, feeds that touch the boundary and never cross it.
#include "process/grinding/staircase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "process/grinding/cycle_design.h"
#include "process/grinding/place_search.h"
#include "tests/process/petrakov.h"
#include "tests/support/sanitized.h"

namespace stanok::process {
namespace {

Staircase staircase(const StaircaseOptions& options) {
  const GrindingProcess process = petrakov::sheet();
  return design_staircase(process, 0.3, usual_feeds(process), options, {});
}

double peak_ratio(const GrindingProcess& process, const PlungeRun& run) {
  const Boundary boundary(process);
  double peak = 0.0;
  for (const PlungeSample& sample : run.samples) {
    peak = std::max(peak, sample.removal_mm2_per_rad / boundary.at(sample.allowance_mm));
  }
  return peak;
}

bool has_decimals(double value, double quantum) {
  return std::abs(value / quantum - std::round(value / quantum)) < 1e-6;
}

TEST(BestPlaces, AreTheBestOfAllPairs) {
  const GrindingProcess process = petrakov::sheet();
  const QuasiSteadyLaw law = quasi_steady_law(process, 0.3, usual_feeds(process));
  double least_s = 1e9;
  for (std::size_t i = 1; i < law.x_mm.size(); ++i) {
    for (std::size_t j = i + 1; j < law.x_mm.size(); ++j) {
      if (law.x_mm[j] - law.x_mm.back() < law.last_step_min_mm) break;
      least_s = std::min(least_s, steps_time_s(law, {law.x_mm[i], law.x_mm[j]}));
    }
  }
  EXPECT_NEAR(steps_time_s(law, best_places(law, 2)), least_s, 1e-12);
}

TEST(BestPlaces, TakeLessTimeTheMoreThereAre) {
  const GrindingProcess process = petrakov::sheet();
  const QuasiSteadyLaw law = quasi_steady_law(process, 0.3, usual_feeds(process));
  for (int points = 1; points < 12; ++points) {
    const double fewer_s = steps_time_s(law, best_places(law, points - 1));
    EXPECT_LT(steps_time_s(law, best_places(law, points)), fewer_s) << points;
    EXPECT_GT(fewer_s, least_time_s(process, 0.3));
  }
}

class Points : public ::testing::TestWithParam<int> {};

TEST_P(Points, GiveATableThatReachesTheSizeWithoutCrossingTheBoundary) {
  const GrindingProcess process = petrakov::sheet();
  const Staircase designed = staircase({.points = GetParam()});
  // Fewer points may be better: a step shorter than a revolution tells nothing of its own.
  ASSERT_LE(designed.law.size(), 2U * (static_cast<std::size_t>(GetParam()) + 1U));
  const PlungeRun run = simulate_plunge(process, designed.law, {});
  EXPECT_LE(peak_ratio(process, run), 1.001);
  EXPECT_GT(peak_ratio(process, run), 0.97);
  EXPECT_LE(run.residual_mm, 1e-6);
  EXPECT_GT(run.residual_mm, -0.0005);
  for (const InfeedRow& row : designed.law) {
    EXPECT_TRUE(has_decimals(row.x_mm, 1e-4)) << row.x_mm;
    EXPECT_TRUE(has_decimals(row.feed_mm_per_s, 1e-4)) << row.feed_mm_per_s;
  }
}

INSTANTIATE_TEST_SUITE_P(Staircase, Points, ::testing::Values(0, 1, 2, 3, 5, 8, 12));

// Of a bowl whose bottom is known; the places stay in order.
TEST(PlaceSearch, FindsTheBottomOfABowl) {
  const std::vector<double> bottom{0.21, 0.09, 0.012};
  const auto time_s = [&](const std::vector<double>& places) {
    double time = 1.0;
    for (std::size_t k = 0; k < bottom.size(); ++k)
      time += std::pow(std::log(places[k] / bottom[k]), 2.0);
    return time;
  };
  const std::vector<double> found = search_places({0.15, 0.11, 0.02}, 0.3, 4, time_s);
  for (std::size_t k = 0; k < bottom.size(); ++k) EXPECT_NEAR(found[k] / bottom[k], 1.0, 0.03) << k;
  for (const double place : found) EXPECT_TRUE(has_decimals(place, 1e-4));
}

// More points never make the cycle longer, and no place moved alone makes it shorter by 0.5 %.
TEST(Staircase, MorePointsAreNeverSlower) {
  double before = 1e9;
  for (const int points : {1, 2, 4, 7, 12, 40}) {
    const double time = law_time_s(staircase({.points = points}).law);
    EXPECT_LE(time, before * 1.0005) << points;
    before = time;
  }
}

TEST(Staircase, NoPlaceMovedAloneIsHalfAPercentFaster) {
  for (const int points : {3, 6}) {
    const Staircase designed = staircase({.points = points});
    std::vector<double> places;
    for (std::size_t k = 2; k < designed.law.size(); k += 2) places.push_back(designed.law[k].x_mm);
    const double time = law_time_s(designed.law);
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const double factor : {0.85, 0.95, 1.05, 1.15}) {
        std::vector<double> moved = places;
        moved[k] = std::round(moved[k] * factor * 1e4) / 1e4;
        if (!std::is_sorted(moved.rbegin(), moved.rend()) || moved.front() >= 0.3) continue;
        const Staircase other = staircase({.at_mm = moved});
        EXPECT_GT(law_time_s(other.law), time * 0.995) << points << " " << k << " " << factor;
      }
    }
  }
}

TEST(Staircase, OfThePaperIsBeatenAtItsOwnPlacesAndByBetterOnes) {
  const double paper_s = law_time_s(petrakov::table());
  const Staircase at_places = staircase({.at_mm = {0.2602, 0.0893, 0.0700, 0.0500, 0.0200}});
  const Staircase chosen = staircase({.points = 5});
  EXPECT_LT(law_time_s(at_places.law), paper_s);
  EXPECT_LT(law_time_s(chosen.law), law_time_s(at_places.law));
  EXPECT_EQ(at_places.law[1].x_mm, 0.2602);
  EXPECT_EQ(at_places.law[9].x_mm, 0.0200);
}

TEST(Staircase, EndsAsThePapersFileEnds) {
  for (const std::optional<int> points : {std::optional<int>(), std::optional<int>(5)}) {
    const InfeedRow end = staircase({.points = points}).law.back();
    EXPECT_NEAR(end.feed_mm_per_s, 0.0040, 0.0004);
    EXPECT_NEAR(end.x_mm, -0.0048, 0.0020);
  }
}

TEST(Staircase, IsWrittenWithTwoDigitsOfTheLastFeedAtLeast) {
  GrindingProcess process = petrakov::sheet();
  EXPECT_EQ(usual_decimals(process), 4);  // 0.0038
  process.removal_end_mm2_per_rad = 0.005;
  EXPECT_EQ(usual_decimals(process), 5);  // 0.00038
}

TEST(Staircase, NeverCrossesTheBoundaryForRandomProcesses) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> of_one(0.0, 1.0);
  for (int trial = 0; trial < stanok::testing::cases(12); ++trial) {
    GrindingProcess process = petrakov::sheet();
    process.stiffness_n_per_m = 25e6 * (0.8 + 1.5 * of_one(random));
    process.part_speed_rpm = 80.0 + 160.0 * of_one(random);
    process.force_exponent = 0.5 + 0.4 * of_one(random);
    process.critical_allowance_mm = 0.05 + 0.1 * of_one(random);
    process.removal_end_mm2_per_rad = 0.1 * Boundary(process).removal_max();
    const auto effort = trial % 4 == 0 ? StaircaseEffort::thorough : StaircaseEffort::quick;
    const Staircase designed =
        design_staircase(process, 0.3, usual_feeds(process),
                         {.points = 4, .at_mm = {}, .decimals = 5, .effort = effort}, {});
    ASSERT_TRUE(designed.is_reachable);
    const PlungeRun run = simulate_plunge(process, designed.law, {});
    EXPECT_LE(peak_ratio(process, run), 1.002) << "seed 11, trial " << trial;
    EXPECT_LE(run.residual_mm, 1e-5) << "seed 11, trial " << trial;
    EXPECT_GT(run.time_s, least_time_s(process, 0.3)) << "seed 11, trial " << trial;
  }
}

}  // namespace
}  // namespace stanok::process
