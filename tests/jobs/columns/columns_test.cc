// Columns of results: names, text, and rows that are taken together without losing an extreme.
#include "jobs/columns/columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

struct Reading {
  double time_s = 0.0;
  double force_n = 0.0;
};

const Columns<Reading>& reading_columns() {
  static const Columns<Reading> columns{
      {"time_s", 3, Together::first, [](const Reading& r) { return r.time_s; }},
      {"force_n", 1, Together::peak, [](const Reading& r) { return r.force_n; }},
  };
  return columns;
}

double extreme(const NumberRows& rows, std::size_t column) {
  double most = 0.0;
  for (const auto& row : rows) most = farther_from_zero(most, row[column]);
  return most;
}

// Over seeded counts of rows, bounds, and places of a single peak, also negative ones.
TEST(Columns, ThinnedRowsKeepTheExtremeOfEachColumnAndTheBound) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const std::size_t count = 1 + random() % 5000;
    const std::size_t most = 1 + random() % 1500;
    std::normal_distribution<double> noise(0.0, 10.0);
    std::vector<Reading> rows(count);
    for (std::size_t k = 0; k < count; ++k)
      rows[k] = {0.001 * static_cast<double>(k), noise(random)};
    const std::size_t at = random() % count;
    rows[at].force_n = (seed % 2 == 0 ? 1.0 : -1.0) * 3984.0;
    const NumberRows thin = thinned(rows, most, reading_columns());
    ASSERT_LE(thin.size(), most) << "seed " << seed;
    EXPECT_EQ(extreme(thin, 1), rows[at].force_n) << "seed " << seed;
    EXPECT_EQ(thin.front().front(), 0.0);
    // In the row of the rows around it: times are those of the first of each.
    for (std::size_t k = 1; k < thin.size(); ++k) ASSERT_GT(thin[k][0], thin[k - 1][0]);
  }
}

TEST(Columns, FewRowsStayAsTheyAre) {
  const std::vector<Reading> rows{{0.0, 1.5}, {0.1, -2.0}, {0.2, 0.5}};
  EXPECT_THAT(thinned(rows, 3, reading_columns()),
              ElementsAre(ElementsAre(0.0, 1.5), ElementsAre(0.1, -2.0), ElementsAre(0.2, 0.5)));
  EXPECT_THAT(thinned(rows, 2, reading_columns()),
              ElementsAre(ElementsAre(0.0, -2.0), ElementsAre(0.2, 0.5)));
  EXPECT_THAT(thinned(std::vector<Reading>{}, 5, reading_columns()), SizeIs(0));
}

// A gap in the readings hides no peak beside it.
TEST(Columns, WhatIsNoNumberIsNoPeak) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(farther_from_zero(none, -3.0), -3.0);
  EXPECT_EQ(farther_from_zero(2.0, none), 2.0);
  const std::vector<Reading> rows{{0.0, none}, {0.1, 7.0}, {0.2, none}};
  EXPECT_EQ(thinned(rows, 1, reading_columns()).front()[1], 7.0);
}

TEST(Columns, AreChosenByName) {
  EXPECT_THAT(columns_named(reading_columns(), {"force_n"}), SizeIs(1));
  EXPECT_EQ(columns_named(reading_columns(), {"force_n", "time_s"})[1].name, "time_s");
  EXPECT_THROW(static_cast<void>(columns_named(reading_columns(), {"force"})),
               std::invalid_argument);
}

TEST(Columns, WriteATableOfText) {
  const std::vector<Reading> rows{{0.0, 1.26}, {0.0015, -2.0}};
  EXPECT_EQ(csv(rows, reading_columns()), "time_s,force_n\n0.000,1.3\n0.002,-2.0\n");
}

}  // namespace
}  // namespace stanok::jobs
