// Estimates of feed laws against sums that are added up here, and against the table of printed and
// corrected formulas in docs/programmer/feed-laws.md.
#include "motion/feed_laws/law_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "motion/feed_laws/curve_law.h"
#include "motion/feed_laws/interrupted_law.h"
#include "motion/feed_laws/linear_law.h"
#include "motion/feed_laws/modulated_law.h"

namespace stanok::motion {
namespace {

// A row of the table: values with four decimals, as printed there.
struct Row {
  double feed, step, path_step;
  std::uint64_t count;
  double exact, printed, corrected;
};
constexpr double last_digit = 0.5e-4;

void expect_row(const TimeForms& time, const Row& row) {
  EXPECT_NEAR(time.exact, row.exact, last_digit);
  ASSERT_TRUE(time.printed && time.corrected);
  EXPECT_NEAR(*time.printed, row.printed, last_digit);
  EXPECT_NEAR(*time.corrected, row.corrected, last_digit);
}

TEST(LawEstimate, LinearTimesAreThoseOfTheTable) {
  for (const Row& row :
       {Row{60, 2, 0.5, 40, 12.8535, 12.4936, 12.8540},
        Row{60, 0.1, 0.05, 400, 15.3348, 15.2948, 15.3348},
        Row{300, -5, 0.1, 50, 2.1011, 2.0357, 2.1015}, Row{100, 50, 1, 4, 1.5400, 1.0995, 1.5591},
        Row{100, 20, 1, 1, 0.6000, 0.0, 0.6020}}) {
    SCOPED_TRACE(row.exact);
    expect_row(linear_time(row.feed, row.step, row.path_step, row.count), row);
  }
}

TEST(LawEstimate, CyclesOfModulationAreThoseOfTheTable) {
  for (const Row& row :
       {Row{60, 6, 0.25, 20, 5.4968, 5.1700, 5.4931}, Row{50, 10, 0.2, 10, 2.6437, 2.3351, 2.6367},
        Row{100, 0.1, 0.01, 100, 1.1437, 1.1323, 1.1437},
        Row{60, 60, 0.3, 2, 0.7000, 0.3296, 0.6592}, Row{600, 100, 0.05, 1, 0.0093, 0.0, 0.0092}}) {
    SCOPED_TRACE(row.exact);
    expect_row(modulation_cycle_time(row.feed, row.step, row.path_step, row.count), row);
  }
}

// The midpoint rule for 60 |dl| / S: each term is wrong by less than (q / S)^2 / 12 of itself at
// the smallest S of its interval.
TEST(LawEstimate, CorrectedTimesAreThoseOfTheMidpointRule) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int n = 0; n < 2000; ++n) {
    const double feed = 10.0 + 990.0 * part(random);
    const double step = (part(random) - 0.5) * 0.2 * feed;
    const double way = 0.001 + part(random);
    const auto room = step < 0.0 ? static_cast<std::uint64_t>(0.8 * feed / -step) : 300U;
    const std::uint64_t count = 1 + random() % std::min<std::uint64_t>(room, 300);
    double sum = 0.0;
    for (std::uint64_t k = 0; k < count; ++k)
      sum += 60.0 * way / (feed + static_cast<double>(k) * step);
    const TimeForms time = linear_time(feed, step, way, count);
    EXPECT_NEAR(time.exact, sum, 1e-12 * sum);
    const double last = feed + (static_cast<double>(count) - 1.0) * step;
    const double least = std::min(feed, last) - 0.5 * std::abs(step);
    ASSERT_TRUE(time.corrected);
    EXPECT_NEAR(*time.corrected, sum, sum * std::pow(step / least, 2) / 12.0 + 1e-12 * sum);
    // e^(q T / dl) = (S_n + (n - 1/2) q) / (S_n - q/2): n comes out S_n / (S_n - q/2) times too
    // large.
    const double due = static_cast<double>(count) * feed / (feed - 0.5 * step);
    EXPECT_NEAR(linear_increments_after(feed, step, way, *time.corrected), due, 1e-9 * due);
  }
}

TEST(LawEstimate, HasNoClosedFormWhereItsLogarithmHasNone) {
  EXPECT_FALSE(linear_time(60.0, 150.0, 1.0, 3).corrected);
  EXPECT_TRUE(linear_time(60.0, 150.0, 1.0, 3).printed);
}

TEST(LawEstimate, AddsUpALinearLaw) {
  const LinearLaw law({}, {.feed_first = 120.0, .feed_step = 0.5, .path_step_mm = 0.1});
  const auto found = estimate(law, {.to_mm = 20.04});
  ASSERT_TRUE(found);
  double sum = 60.0 * 0.04 / (120.0 + 200.0 * 0.5);
  for (int k = 0; k < 200; ++k) sum += 60.0 * 0.1 / (120.0 + k * 0.5);
  EXPECT_EQ(found->increments, 200U);
  EXPECT_EQ(found->feed_first, 120.0);
  EXPECT_EQ(found->feed_last, 220.0);
  EXPECT_NEAR(found->time_s, sum, 1e-9);
  ASSERT_TRUE(found->closed_form_s);
  EXPECT_NEAR(*found->closed_form_s, sum, 1e-5);
  // An increment at the very end has no path.
  EXPECT_EQ(estimate(law, {.to_mm = 20.0})->increments, 199U);
}

// A modal law, some way on: the part begins within a stretch, and no closed form fits it.
TEST(LawEstimate, AddsUpAPartOfALaw) {
  const LinearLaw law({}, {.feed_first = 60.0, .feed_step = 6.0, .path_step_mm = 1.0});
  const auto found = estimate(law, {.from_mm = 2.5, .to_mm = 4.25});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time_s, 60.0 * (0.5 / 72.0 + 1.0 / 78.0 + 0.25 / 84.0), 1e-9);
  EXPECT_EQ(found->increments, 2U);
  EXPECT_EQ(found->feed_first, 72.0);
  EXPECT_EQ(found->feed_last, 84.0);
  EXPECT_FALSE(found->closed_form_s);
}

TEST(LawEstimate, AddsUpFeedsPerRevolution) {
  const LinearLaw law({.per_revolution = true},
                      {.feed_first = 0.1, .feed_step = 0.01, .path_step_mm = 0.5});
  EXPECT_FALSE(estimate(law, {.to_mm = 2.0})) << "no speed is known";
  const auto found = estimate(law, {.to_mm = 2.0, .rev_per_min = 600.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time_s, 0.5 * (1.0 + 60.0 / 66.0 + 60.0 / 72.0 + 60.0 / 78.0), 1e-9);
  const LinearLaw with_speed({.per_revolution = true, .speed = LawSpeed::rev_per_min},
                             {.feed_first = 0.1,
                              .feed_step = 0.01,
                              .path_step_mm = 0.5,
                              .speed_first = 600.0,
                              .speed_step = -100.0});
  const auto stepped = estimate(with_speed, {.to_mm = 1.5});
  ASSERT_TRUE(stepped);
  EXPECT_NEAR(stepped->time_s, 0.5 * (1.0 + 60.0 / 55.0 + 60.0 / 48.0), 1e-9);
  EXPECT_FALSE(stepped->closed_form_s);
}

TEST(LawEstimate, OfModulationTellsItsCycleAndDepth) {
  const ModulatedLaw law({},
                         {.feed_min = 60.0, .feed_step = 6.0, .path_step_mm = 0.25, .steps = 20});
  const auto found = estimate(law, {.to_mm = 30.0});  // three cycles of 10 mm
  ASSERT_TRUE(found && found->cycle && found->closed_form_s);
  EXPECT_NEAR(found->time_s, 3.0 * found->cycle->exact, 1e-9);
  EXPECT_NEAR(*found->closed_form_s, 3.0 * 60.0 * 2.0 * 0.25 / 6.0 * std::log(3.0), 1e-9);
  EXPECT_NEAR(*found->modulation_depth, 1.0 / 3.0, 1e-15);
  EXPECT_EQ(found->increments, 119U);
}

// 0.2 mm/rev: L_A = 0.4 mm is two revolutions long, L_B = 2 mm ten.
TEST(LawEstimate, OfInterruptionsTellsTheirDurationAndSpacing) {
  const InterruptedLaw law(0.4, 2.0);
  const auto found = estimate(law, {.to_mm = 10.0, .feed_per_s = 2.0, .rev_per_min = 600.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->increments, 4U);
  EXPECT_NEAR(found->time_s, 5.0 + 4.0 * 0.2, 1e-9);
  EXPECT_NEAR(found->closed_form_s.value_or(0.0), 5.8, 1e-9);
  EXPECT_NEAR(found->duration_rev.value_or(0.0), 2.0, 1e-12);
  EXPECT_NEAR(found->spacing_rev.value_or(0.0), 10.0, 1e-12);
  EXPECT_FALSE(estimate(law, {.to_mm = 10.0, .feed_per_s = 2.0})->duration_rev);
}

TEST(LawEstimate, AddsUpACurve) {
  const CurveLaw law({}, {{.feed = 60.0}, {.path_mm = 4.0, .feed = 64.0}}, 1.0, 0.001);
  const auto found = estimate(law, {.to_mm = 6.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time_s, 1.0 + 60.0 / 61.0 + 60.0 / 62.0 + 60.0 / 63.0 + 120.0 / 64.0, 1e-9);
  EXPECT_FALSE(found->closed_form_s);
}

}  // namespace
}  // namespace stanok::motion
