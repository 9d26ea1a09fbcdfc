// The lathe's map of X: radius or diameter, turret behind or in front.
#include "kinematics/lathe.h"

#include <gtest/gtest.h>

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

// X Z C, without Y; the X axis reads 200 with the nose on the centre of the workpiece.
SchemeConfig lathe_with(XReading x_reading, Turret turret) {
  SchemeConfig config;
  config.type = "lathe";
  config.axes = {0, 1, 2};
  config.linear = {0, -1, 1};
  config.zero = {200.0, -50.0, 30.0};
  config.geometry = Lathe::Geometry{.x_reading = x_reading, .turret = turret};
  return config;
}

// A point at radius 30 and Z 7 with C at 90, cut by a tool that hangs 25 mm towards the workpiece
// and 60 mm towards the chuck: the nose stands at radius 55 and Z 67.
struct LatheCase {
  const char* name;
  XReading x_reading;
  Turret turret;
  double x_M;
};

TEST(Lathe, ReadsXAsItsMachineCountsIt) {
  const LatheCase cases[] = {
      {"radius, behind", XReading::radius, Turret::rear, 200 + 55},
      {"diameter, behind", XReading::diameter, Turret::rear, 200 + 2 * 55},
      {"radius, in front", XReading::radius, Turret::front, 200 - 55},
      {"diameter, in front", XReading::diameter, Turret::front, 200 - 2 * 55},
  };
  const ToolVector tool{{-25, 99, -60}};  // there is no Y for the 99
  for (const LatheCase& each : cases) {
    const Lathe scheme(lathe_with(each.x_reading, each.turret));
    AxisVector<double> axes_M{};
    AxisVector<double> point_B{};
    scheme.inverse(PointMode::axes, tool, {30, 7, 90}, axes_M);
    EXPECT_EQ(axes_M, (AxisVector<double>{each.x_M, 17, 120})) << each.name;
    scheme.inverse(PointMode::tip, tool, {30, 7, 90}, axes_M);
    EXPECT_EQ(axes_M, (AxisVector<double>{each.x_M, 17, 120})) << each.name;
    scheme.forward(PointMode::axes, tool, axes_M, point_B);
    EXPECT_EQ(point_B, (AxisVector<double>{30, 7, 90})) << each.name;
  }
}

TEST(Lathe, MirrorsYWithTheTurretButNeverDoublesIt) {
  SchemeConfig config = lathe_with(XReading::diameter, Turret::front);
  config.axes = {0, 1, 2};
  config.linear = {0, 1, 2};
  config.zero = {};
  const Lathe scheme(config);
  AxisVector<Jet> axes_M{};
  scheme.inverse(PointMode::axes, ToolVector{{-25, 1, -60}},
                 {Jet(30, 1, 2, 3), Jet(4, 5, 6, 7), Jet(7, 8, 9, 10)}, axes_M);
  EXPECT_EQ(axes_M[0].value, -110.0);
  EXPECT_EQ(axes_M[0].third, -6.0);
  EXPECT_EQ(axes_M[1].value, -3.0);
  EXPECT_EQ(axes_M[1].first, -5.0);
  EXPECT_EQ(axes_M[2].value, 67.0);
  EXPECT_EQ(axes_M[2].second, 9.0);
}

TEST(Lathe, NeedsXAndZ) {
  for (const std::size_t missing : {0U, 2U}) {
    SchemeConfig config = lathe_with(XReading::radius, Turret::rear);
    config.linear[missing] = -1;
    EXPECT_EQ(scheme_defect(config), "X and Z must take part");
    EXPECT_EQ(make_scheme(config), nullptr);
  }
  SchemeConfig config = lathe_with(XReading::radius, Turret::rear);
  EXPECT_EQ(scheme_defect(config), "");
  config.axes = {0, 2};
  EXPECT_EQ(scheme_defect(config), "X and Z must take part");
}

}  // namespace
}  // namespace stanok::kinematics
