// Decimation for pictures: bounded, and what the eye looks for stays.
#include "recording/format/plot_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/plot/gnuplot.h"

namespace stanok::recording {
namespace {

TEST(PeakSeries, KeepsASinglePeakAmongAMillionValues) {
  PeakSeries series;
  for (int k = 0; k < 1'000'000; ++k)
    series.add(k * 1e-3, k == 777'777 ? 42.0 : std::sin(k * 0.01));
  const auto points = series.points();
  EXPECT_LE(points.size(), 4 * PeakSeries::bins_max);
  const auto peak = std::max_element(points.begin(), points.end(),
                                     [](auto& a, auto& b) { return a.value < b.value; });
  EXPECT_EQ(peak->value, 42.0);
  EXPECT_EQ(peak->time, 777'777 * 1e-3);
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                             [](auto& a, auto& b) { return a.time < b.time; }));
  EXPECT_EQ(points.back().time, 999'999 * 1e-3);
}

TEST(ThinnedPath, StaysBoundedWithoutLargeGaps) {
  constexpr double radius = 50.0;
  ThinnedPath path;
  for (int k = 0; k < 300'000; ++k) {
    const double angle = k * 1e-3;
    path.add({radius * std::cos(angle), radius * std::sin(angle), 0.001 * k},
             ThinnedPath::Joint::continues);
  }
  const auto stretches = path.stretches();
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_LE(stretches[0].size(), ThinnedPath::points_max);
  // Eight times the mean distance of points_max points on the whole length.
  const double gap_max = 8.0 * std::hypot(300.0 * radius, 300.0) / ThinnedPath::points_max;
  for (std::size_t k = 1; k < stretches[0].size(); ++k) {
    const PlotPoint& a = stretches[0][k - 1];
    const PlotPoint& b = stretches[0][k];
    ASSERT_LE(std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]), gap_max);
  }
}

TEST(ThinnedPath, IsBoundedEvenWhenEveryPointBeginsAStretch) {
  ThinnedPath path;
  for (int k = 0; k < 100'000; ++k) path.add({1.0 * k, 0, 0}, ThinnedPath::Joint::begins_stretch);
  EXPECT_LE(path.stretches().size(), ThinnedPath::points_max);
}

TEST(ThinnedPath, LeavesOutWhatIsNoCoordinate) {
  ThinnedPath path;
  path.add({0, 0, 0}, ThinnedPath::Joint::begins_stretch);
  path.add({std::numeric_limits<double>::quiet_NaN(), 0, 0}, ThinnedPath::Joint::continues);
  path.add({1e300, 0, 0}, ThinnedPath::Joint::continues);
  path.add({5, 0, 0}, ThinnedPath::Joint::continues);
  EXPECT_EQ(path.stretches().at(0).size(), 2U);
}

TEST(GnuplotText, CannotLeaveItsQuotes) {
  EXPECT_EQ(gnuplot_text("a'; system 'x"), "'a''; system ''x'");
  EXPECT_EQ(gnuplot_text("a\nb"), "'a b'");
}

}  // namespace
}  // namespace stanok::recording
