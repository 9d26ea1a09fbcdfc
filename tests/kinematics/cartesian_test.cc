// The shift of the cartesian scheme: zero, tool length, parked axes.
#include "kinematics/cartesian.h"

#include <gtest/gtest.h>

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

SchemeConfig vise() {
  SchemeConfig config;
  config.type = "cartesian";
  config.axes = {0, 1, 2};
  config.linear = {0, 1, 2};
  config.zero = {100.0, -50.0, 30.0, 5.0, 6.0};
  return config;
}

TEST(Cartesian, LiftsTheSpindleNoseByTheToolLength) {
  const Cartesian scheme(vise());
  AxisVector<double> axes_M{};
  scheme.inverse(PointMode::axes, ToolVector{{0, 0, -80}}, {1, 2, 3, 4, 5}, axes_M);
  EXPECT_EQ(axes_M, (AxisVector<double>{101, -48, 113, 4, 5}));
}

TEST(Cartesian, IsTheSameInBothPointModes) {
  const Cartesian scheme(vise());
  const ToolVector tool{{1, 2, -80}};
  AxisVector<double> axes{};
  AxisVector<double> tip{};
  scheme.inverse(PointMode::axes, tool, {1, 2, 3, 4, 5}, axes);
  scheme.inverse(PointMode::tip, tool, {1, 2, 3, 4, 5}, tip);
  EXPECT_EQ(axes, tip);
  AxisVector<double> point_B{};
  scheme.forward(PointMode::tip, tool, tip, point_B);
  EXPECT_EQ(point_B, (AxisVector<double>{1, 2, 3, 4, 5}));
}

TEST(Cartesian, KeepsTheDerivativesOfThePath) {
  const Cartesian scheme(vise());
  AxisVector<Jet> axes_M{};
  scheme.inverse(PointMode::axes, ToolVector{{0, 0, -80}}, {Jet(1, 2, 3, 4)}, axes_M);
  EXPECT_EQ(axes_M[0].value, 101.0);
  EXPECT_EQ(axes_M[0].first, 2.0);
  EXPECT_EQ(axes_M[0].second, 3.0);
  EXPECT_EQ(axes_M[0].third, 4.0);
}

// A lathe has no Y: the tool's Y component then goes nowhere, and X and Z keep theirs.
TEST(Cartesian, LeavesOutGeometryAxesTheChannelLacks) {
  SchemeConfig config;
  config.type = "cartesian";
  config.axes = {0, 1};
  config.linear = {0, -1, 1};
  const Cartesian scheme(config);
  AxisVector<double> axes_M{};
  scheme.inverse(PointMode::axes, ToolVector{{10, 20, -80}}, {1, 2}, axes_M);
  EXPECT_EQ(axes_M, (AxisVector<double>{-9, 82}));
}

TEST(Cartesian, NeedsAnAxis) {
  SchemeConfig config = vise();
  config.axes.clear();
  EXPECT_EQ(make_scheme(config), nullptr);
  EXPECT_EQ(scheme_defect(config), "no axis takes part");
}

}  // namespace
}  // namespace stanok::kinematics
