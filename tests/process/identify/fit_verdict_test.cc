// Lathes with hidden figures and sensors (tests/process/identify/bar_lathe.h): those that are
// what the fit takes them for, and those that are not; what the fit says of both.
#include "process/identify/fit_verdict.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "process/identify/turning_fit.h"
#include "tests/process/identify/bar_lathe.h"
#include "tests/support/sanitized.h"

namespace stanok::process {
namespace {

using stanok::testing::BarLathe;
using stanok::testing::LatheRow;

double uniform_between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

template <class Value, std::size_t count>
Value chosen_of(std::mt19937& random, const std::array<Value, count>& values) {
  return values[std::uniform_int_distribution<std::size_t>(0, count - 1)(random)];
}

CutRecord record_of_bar(const std::vector<LatheRow>& rows) {
  CutRecord record{.cycle_s = stanok::testing::cycle_of_lathe_s, .rows = {}};
  for (const LatheRow& row : rows) {
    record.rows.push_back({.rev_per_min = row.rev_per_min,
                           .radius_mm = row.radius_mm,
                           .depth_mm = row.depth_mm,
                           .travel_mm = row.travel_mm,
                           .z_mm = row.z_mm,
                           .power_w = row.power_w});
  }
  return record;
}

// The noise of the sensor is at least half a step, so that its rounding is noise, too; the second
// lag is a filter beside the first.
BarLathe lathe_that_fits(std::mt19937& random) {
  BarLathe lathe{.coefficient_n = uniform_between(random, 900.0, 3000.0),
                 .exponent = uniform_between(random, 0.6, 0.9),
                 .lag_s = uniform_between(random, 0.015, 0.06),
                 .idle_linear = uniform_between(random, 0.1, 0.4),
                 .idle_square = uniform_between(random, 5e-5, 3e-4),
                 .noise = uniform_between(random, 0.02, 0.09),
                 .noise_memory_s = uniform_between(random, 0.0, 0.04),
                 .step_w = chosen_of(random, std::array{1.0, 2.0, 5.0}),
                 .sampling_cycles = chosen_of(random, std::array{10, 20, 50})};
  lathe.sensor_noise_w = uniform_between(random, 0.5, 1.5) * lathe.step_w;
  lathe.age_s =
      uniform_between(random, 0.0, lathe.sampling_cycles * stanok::testing::cycle_of_lathe_s);
  lathe.second_lag_s = uniform_between(random, 0.0, 0.1) * lathe.lag_s;
  return lathe;
}

struct FigureCoverage {
  int all = 0;
  int inside = 0;
  std::vector<double> widths;  // over that of the bound

  void take(const Estimate& estimate, double truth, double least_deviation) {
    constexpr double normal_95 = 1.96;
    ++all;
    inside += estimate.contains(truth) ? 1 : 0;
    widths.push_back(estimate.half_width() / (normal_95 * least_deviation));
  }
  [[nodiscard]] double part() const { return static_cast<double>(inside) / all; }
  [[nodiscard]] double median_width() {
    std::ranges::sort(widths);
    return widths[widths.size() / 2];
  }
};

Estimate estimate_of_logarithm(const Estimate& estimate) {
  return {.value = std::log(estimate.value),
          .low = std::log(estimate.low),
          .high = std::log(estimate.high)};
}

// FigureCoverage of 93 % and more, a median width of at most 1.5 times the bound of Cramer and Rao,
// and at most 2 % that are refused though they fit.
void look_at_lathes_that_fit(int lathes, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::array<FigureCoverage, 5> figures;
  int refused = 0;
  for (int n = 0; n < lathes; ++n) {
    const BarLathe lathe = lathe_that_fits(random);
    const auto fit = fit_turning(record_of_bar(stanok::testing::cut_bar(lathe, random)));
    if (!fit || fit->verdict.is_refused()) {
      ++refused;
      continue;
    }
    const stanok::testing::LeastDeviations least = stanok::testing::least_deviations(lathe);
    figures[0].take(estimate_of_logarithm(fit->coefficient_n), std::log(lathe.coefficient_n),
                    least.ln_coefficient);
    figures[1].take(fit->exponent, lathe.exponent, least.exponent);
    figures[2].take(fit->lag_s, lathe.lag_s + lathe.second_lag_s, least.lag_s);
    figures[3].take(fit->idle_linear, lathe.idle_linear, least.idle_linear);
    figures[4].take(*fit->idle_square, lathe.idle_square, least.idle_square);
  }
  EXPECT_LE(refused, lathes * 2 / 100);
  ::testing::Test::RecordProperty("refused", std::to_string(refused));
  const std::array<std::string, 5> names{"coefficient", "exponent", "lag", "idle_linear",
                                         "idle_square"};
  for (std::size_t k = 0; k < figures.size(); ++k) {
    EXPECT_GE(figures[k].part(), 0.93) << names[k] << ", seed " << seed;
    EXPECT_LE(figures[k].median_width(), 1.5) << names[k] << ", seed " << seed;
    ::testing::Test::RecordProperty(names[k] + "_coverage", std::to_string(figures[k].part()));
    ::testing::Test::RecordProperty(names[k] + "_width", std::to_string(figures[k].median_width()));
  }
}

TEST(FitVerdict, FullSizeIntervalsHoldAThousandLathesThatFit) {
  look_at_lathes_that_fit(1000, 20268);
}

// As above; of sixty lathes, five may be missed by chance.
TEST(FitVerdict, IntervalsHoldLathesThatFit) {
  std::mt19937 random(20269);
  const int lathes = stanok::testing::cases(60);
  int inside = 0;
  int refused = 0;
  for (int n = 0; n < lathes; ++n) {
    const BarLathe lathe = lathe_that_fits(random);
    const auto fit = fit_turning(record_of_bar(stanok::testing::cut_bar(lathe, random)));
    const bool has_figures = fit && !fit->verdict.is_refused();
    refused += has_figures ? 0 : 1;
    inside += has_figures && fit->exponent.contains(lathe.exponent) ? 1 : 0;
  }
  EXPECT_LE(refused, 1);
  EXPECT_GE(inside, lathes * 55 / 60);
}

double greatest_power_w(const BarLathe& lathe, std::mt19937& random) {
  double most = 0.0;
  for (const LatheRow& row : stanok::testing::cut_bar(lathe, random))
    if (std::isfinite(row.power_w)) most = std::max(most, row.power_w);
  return most;
}

constexpr std::array kinds_that_do_not_fit{Misfit::steps,     Misfit::dead_sensor, Misfit::drift,
                                           Misfit::saturated, Misfit::coarse,      Misfit::open};

// Steps of hardness of 10 to 30 %; no power for the first 0.5 to 7 s; a force that grows by 10 to
// 40 %; a sensor that ends at 40 to 70 % of the greatest power; steps of the readings of 8 to 20 %
// of it; feeds that differ by less than 8 %.
BarLathe lathe_that_does_not_fit(Misfit kind, std::mt19937& random) {
  BarLathe lathe = lathe_that_fits(random);
  const auto in_steps = [&](double power_w) {
    return std::max(1.0, std::round(power_w / lathe.step_w)) * lathe.step_w;
  };
  switch (kind) {
    case Misfit::steps: {
      const double z = uniform_between(random, -15.0, -4.0);
      const double sign = uniform_between(random, -1.0, 1.0) < 0.0 ? -1.0 : 1.0;
      lathe.sections = {{.z_mm = z, .force = 1.0 + sign * uniform_between(random, 0.1, 0.3)}};
      if (uniform_between(random, -1.0, 1.0) < 0.0)
        lathe.sections.push_back({.z_mm = z - uniform_between(random, 2.0, 4.0), .force = 1.0});
      break;
    }
    case Misfit::dead_sensor:
      lathe.dead_until_s = uniform_between(random, 0.5, 7.0);
      break;
    case Misfit::drift:
      lathe.wear = uniform_between(random, 0.1, 0.4);
      break;
    case Misfit::saturated:
      lathe.power_max_w =
          in_steps(uniform_between(random, 0.4, 0.7) * greatest_power_w(lathe, random));
      break;
    case Misfit::coarse:
      lathe.step_w = in_steps(uniform_between(random, 0.08, 0.2) * greatest_power_w(lathe, random));
      break;
    default: {
      const double feed = uniform_between(random, 0.15, 0.3);
      lathe.feeds_mm = {feed, feed * (1.0 + uniform_between(random, 0.0, 0.08))};
    }
  }
  return lathe;
}

// Without a verdict of its own, the record lacks so much that nothing is fitted.
bool is_kind(const Expected<TurningFit, std::string>& fit, Misfit kind) {
  if (fit) return fit->verdict.kind == kind;
  const auto says = [&](const char* text) { return fit.error().find(text) != std::string::npos; };
  return kind == Misfit::open          ? says("one feed only")
         : kind == Misfit::dead_sensor ? says("the power stands at")
                                       : kind == Misfit::coarse && says("the power has steps");
}

void look_at_lathes_that_do_not_fit(int lathes, std::uint32_t seed) {
  std::mt19937 random(seed);
  int reported = 0;
  int right = 0;
  for (int n = 0; n < lathes; ++n) {
    const Misfit kind =
        kinds_that_do_not_fit[static_cast<std::size_t>(n) % kinds_that_do_not_fit.size()];
    const auto fit = fit_turning(
        record_of_bar(stanok::testing::cut_bar(lathe_that_does_not_fit(kind, random), random)));
    reported += !fit || fit->verdict.state != FitState::fits ? 1 : 0;
    right += is_kind(fit, kind) ? 1 : 0;
  }
  EXPECT_GE(reported, lathes * 95 / 100) << "seed " << seed;
  EXPECT_GE(right, lathes * 80 / 100) << "seed " << seed;
  ::testing::Test::RecordProperty("reported", std::to_string(reported));
  ::testing::Test::RecordProperty("right_kind", std::to_string(right));
}

TEST(FitVerdict, FullSizeAHundredLathesThatDoNotFitAreReported) {
  look_at_lathes_that_do_not_fit(100, 20270);
}

TEST(FitVerdict, LathesThatDoNotFitAreReported) {
  look_at_lathes_that_do_not_fit(stanok::testing::cases(24), 20271);
}

// An edge as blunt as none that cuts well; a sharper one is hidden by another exponent.
TEST(FitVerdict, AForceOfTheEdgeIsToldFromTheLaw) {
  std::mt19937 random(3);
  BarLathe lathe{.noise = 0.01};
  lathe.edge_n_per_mm = 500.0;
  const auto fit = fit_turning(record_of_bar(stanok::testing::cut_bar(lathe, random)));
  ASSERT_TRUE(fit.has_value()) << fit.error();
  EXPECT_EQ(fit->verdict.kind, Misfit::force_law) << fit->verdict.reason;
  // The true exponent lies in the widened interval, or there is none.
  EXPECT_TRUE(fit->verdict.is_refused() || fit->exponent.contains(lathe.exponent));
}

// A filter half as slow as the drive.
TEST(FitVerdict, ASecondLagIsToldFromTheFirst) {
  std::mt19937 random(4);
  BarLathe lathe{.noise = 0.01};
  lathe.lag_s = 0.04;
  lathe.second_lag_s = 0.02;
  const auto fit = fit_turning(record_of_bar(stanok::testing::cut_bar(lathe, random)));
  ASSERT_TRUE(fit.has_value()) << fit.error();
  EXPECT_EQ(fit->verdict.kind, Misfit::lag) << fit->verdict.reason;
  EXPECT_FALSE(fit->verdict.is_refused());
  EXPECT_TRUE(fit->exponent.contains(lathe.exponent));
}

// The lag cannot be told better than the age of a reading.
TEST(FitVerdict, TheLagIsAsOpenAsTheSensorIsSlow) {
  std::mt19937 random(5);
  BarLathe lathe{.lag_s = 0.02, .noise = 0.0};
  lathe.sampling_cycles = 50;
  for (const double age_s : {0.0, 0.025, 0.05}) {
    lathe.age_s = age_s;
    const auto fit = fit_turning(record_of_bar(stanok::testing::cut_bar(lathe, random)));
    ASSERT_TRUE(fit.has_value()) << fit.error();
    EXPECT_TRUE(fit->lag_s.contains(0.02)) << age_s;
    EXPECT_NEAR(fit->sampling_s, 0.05, 1e-9);
  }
}

// With the hardness of the stock the same cut fits.
TEST(FitVerdict, StepsThatTheStockNamesAreNoMisfit) {
  std::mt19937 random(6);
  BarLathe lathe;
  lathe.sections = {{.z_mm = -5.0, .force = 1.25}, {.z_mm = -11.0, .force = 0.9}};
  CutRecord record = record_of_bar(stanok::testing::cut_bar(lathe, random));
  const auto without = fit_turning(record);
  ASSERT_TRUE(without.has_value()) << without.error();
  EXPECT_EQ(without->verdict.kind, Misfit::steps);
  EXPECT_TRUE(without->verdict.is_refused());
  for (CutRow& row : record.rows)
    row.hardness_factor = row.z_mm <= -11.0 ? 0.9 : row.z_mm <= -5.0 ? 1.25 : 1.0;
  const auto with = fit_turning(record);
  ASSERT_TRUE(with.has_value()) << with.error();
  EXPECT_EQ(with->verdict.state, FitState::fits) << with->verdict.reason;
  EXPECT_TRUE(with->coefficient_n.contains(lathe.coefficient_n));
  EXPECT_TRUE(with->exponent.contains(lathe.exponent));
}

TEST(FitVerdict, SaysWhyAndWhatHelps) {
  const FitVerdict said = verdict(FitState::refused, Misfit::steps, "the force changes at Z -20");
  EXPECT_EQ(said.reason, "the model does not fit because the force changes at Z -20");
  EXPECT_NE(said.remedy.find("hardness"), std::string::npos);
  EXPECT_EQ(name_of(said.kind), "steps");
}

}  // namespace
}  // namespace stanok::process
