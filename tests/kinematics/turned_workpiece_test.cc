// The schemes of a program on a turned workpiece: polar face (G12.1) and cylinder (G7.1).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/cylinder.h"
#include "kinematics/polar_face.h"
#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

// X Z C of a lathe, X read in diameter; C is the third axis.
SchemeConfig lathe_in_diameter() {
  SchemeConfig config;
  config.id = 3;
  config.type = "lathe";
  config.axes = {0, 1, 2};
  config.linear = {0, -1, 1};
  config.zero = {100.0, -50.0, 30.0};
  config.geometry = Lathe::Geometry{.x_reading = XReading::diameter};
  return config;
}
constexpr int lathe_C = 2;
const ToolVector tool{{-25, 0, -60}};

// x = 30, y = 40: radius 50 at atan2(40, 30) = 53.13 deg. Beyond the centre the tool stands at -50,
// with the workpiece half a turn further.
TEST(PolarFace, GoesByRadiusAndAngleOnEitherSideOfTheCentre) {
  const double angle = std::atan2(40.0, 30.0) * 180.0 / std::numbers::pi;
  AxisVector<double> axes_M{};
  PolarFace(face_scheme(lathe_in_diameter(), lathe_C, FaceSide::positive))
      .inverse(PointMode::axes, tool, {30, 7, 40}, axes_M);
  EXPECT_NEAR(axes_M[0], 100 + 2 * (50 + 25), 1e-12);
  EXPECT_EQ(axes_M[1], 17.0);
  EXPECT_NEAR(axes_M[2], 30 + angle, 1e-12);
  PolarFace(face_scheme(lathe_in_diameter(), lathe_C, FaceSide::negative))
      .inverse(PointMode::axes, tool, {30, 7, 40}, axes_M);
  EXPECT_NEAR(axes_M[0], 100 + 2 * (-50 + 25), 1e-12);
  EXPECT_NEAR(axes_M[2], 30 + angle - 180, 1e-12);
}

// A about X with Y across: y = 30 and a = 40 are the radius 50 at 53.13 deg; X goes along.
TEST(PolarFace, IsThatOfAWithYAndOfBWithZ) {
  const double angle = std::atan2(40.0, 30.0) * 180.0 / std::numbers::pi;
  SchemeConfig mill;
  mill.type = "cartesian";
  mill.axes = {0, 1, 2, 3};
  mill.linear = {0, 1, 2};
  mill.zero = {1.0, 2.0, 3.0, 10.0};
  mill.geometry = Cartesian::Geometry{};
  const PolarFace about_x(face_scheme(mill, 3, FaceSide::positive, 1));
  AxisVector<double> axes_M{};
  about_x.inverse(PointMode::axes, {}, {7, 30, 5, 40}, axes_M);
  EXPECT_EQ(axes_M[0], 8.0);
  EXPECT_NEAR(axes_M[1], 52.0, 1e-12);
  EXPECT_EQ(axes_M[2], 8.0);
  EXPECT_NEAR(axes_M[3], 10.0 + angle, 1e-12);
  AxisVector<double> point_B{};
  about_x.forward(PointMode::axes, {}, axes_M, point_B);
  EXPECT_NEAR(point_B[1], 30.0, 1e-12);
  EXPECT_NEAR(point_B[3], 40.0, 1e-12);
  const PolarFace about_y(face_scheme(mill, 3, FaceSide::negative, 2));
  about_y.inverse(PointMode::axes, {}, {7, 5, 30, 40}, axes_M);
  EXPECT_EQ(axes_M[1], 7.0);
  EXPECT_NEAR(axes_M[2], 3.0 - 50.0, 1e-12);
  EXPECT_NEAR(axes_M[3], 10.0 + angle - 180.0, 1e-12);
  SchemeConfig without_y = mill;
  without_y.linear[1] = -1;
  EXPECT_EQ(scheme_defect(face_scheme(without_y, 3, FaceSide::positive, 1)), "Y must take part");
}

// Along a circle round the centre only C moves, by v / r; along a ray only X.
TEST(PolarFace, TurnsOnCirclesAndStandsOnRays) {
  const PolarFace scheme(face_scheme(lathe_in_diameter(), lathe_C, FaceSide::positive));
  AxisVector<Jet> axes_M{};
  // 20 mm out on the x axis, 5 mm/s across: centripetal acceleration v^2 / r keeps it on the
  // circle.
  scheme.inverse(PointMode::axes, {}, {Jet(20, 0, -25.0 / 20, 0), Jet(), Jet(0, 5, 0, -0.3125)},
                 axes_M);
  EXPECT_NEAR(axes_M[0].first, 0, 1e-15);
  EXPECT_NEAR(axes_M[0].second, 0, 1e-15);
  EXPECT_NEAR(axes_M[0].third, 0, 1e-15);
  EXPECT_NEAR(axes_M[2].first, 5.0 / 20 * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(axes_M[2].second, 0, 1e-12);
  EXPECT_NEAR(axes_M[2].third, 0, 1e-12);
  scheme.inverse(PointMode::axes, {}, {Jet(3, 0.6, 1.2, 3), Jet(), Jet(4, 0.8, 1.6, 4)}, axes_M);
  EXPECT_NEAR(axes_M[0].first, 2 * 1.0, 1e-12);  // in diameter
  EXPECT_NEAR(axes_M[0].second, 2 * 2.0, 1e-12);
  EXPECT_NEAR(axes_M[0].third, 2 * 5.0, 1e-12);
  EXPECT_NEAR(axes_M[2].first, 0, 1e-12);
  EXPECT_NEAR(axes_M[2].second, 0, 1e-12);
}

TEST(PolarFace, StandsAtTheZeroOfItsAngleOnThePole) {
  for (const FaceSide side : {FaceSide::positive, FaceSide::negative}) {
    const PolarFace scheme(face_scheme(lathe_in_diameter(), lathe_C, side));
    AxisVector<Jet> axes_M{};
    scheme.inverse(PointMode::axes, tool, {Jet(0, 5, 6, 7), Jet(7, 1, 1, 1), Jet(0, 8, 9, 10)},
                   axes_M);
    EXPECT_EQ(axes_M[0].value, 100 + 2 * 25);
    EXPECT_EQ(axes_M[2].value, 30.0);
    for (const int axis : {0, lathe_C}) {
      EXPECT_EQ(axes_M[static_cast<std::size_t>(axis)].first, 0.0);
      EXPECT_EQ(axes_M[static_cast<std::size_t>(axis)].second, 0.0);
      EXPECT_EQ(axes_M[static_cast<std::size_t>(axis)].third, 0.0);
    }
    EXPECT_EQ(axes_M[1].first, 1.0);  // Z goes on
    AxisVector<double> values{};
    scheme.inverse(PointMode::axes, tool, {0, 7, 0}, values);
    EXPECT_EQ(values, (AxisVector<double>{150, 17, 30}));
  }
}

TEST(PolarFace, KnowsItsWindingAxisAndItsDistanceFromThePole) {
  const PolarFace face(face_scheme(lathe_in_diameter(), lathe_C, FaceSide::positive));
  EXPECT_EQ(face.winding_axes(), 1U << lathe_C);
  EXPECT_EQ(face.distance_to_singularity({3, 100, -4}), 5.0);
  const Lathe plain(lathe_in_diameter());
  EXPECT_EQ(plain.winding_axes(), 0U);
  EXPECT_EQ(plain.distance_to_singularity({0, 0, 0}), std::numeric_limits<double>::infinity());
}

// Radius 30: a quarter of the circumference is 15 pi mm, two circumferences are 720 deg.
TEST(Cylinder, RollsTheDevelopedLengthRoundTheAxis) {
  const Cylinder scheme(cylinder_scheme(lathe_in_diameter(), lathe_C, 30.0));
  constexpr double circumference = 60.0 * std::numbers::pi;
  AxisVector<double> axes_M{};
  scheme.inverse(PointMode::axes, tool, {28, 7, circumference / 4}, axes_M);
  EXPECT_EQ(axes_M[0], 100 + 2 * (28.0 + 25));
  EXPECT_NEAR(axes_M[2], 30 + 90, 1e-12);
  scheme.inverse(PointMode::axes, tool, {28, 7, -2 * circumference}, axes_M);
  EXPECT_NEAR(axes_M[2], 30 - 720, 1e-12);
  EXPECT_EQ(scheme.winding_axes(), 0U);
}

TEST(TurnedWorkpiece, KeepsIdFileAndParkingOfTheActiveScheme) {
  SchemeConfig active = lathe_in_diameter();
  active.file = "lathe.toml";
  active.parking = {{.axis = 3}};
  for (const SchemeConfig& config :
       {face_scheme(active, lathe_C, FaceSide::negative), cylinder_scheme(active, lathe_C, 12.0)}) {
    EXPECT_EQ(config.id, 3);
    EXPECT_EQ(config.file, "lathe.toml");
    EXPECT_EQ(config.parking.size(), 1U);
    if (const auto* const face = std::get_if<PolarFace::Geometry>(&config.geometry))
      EXPECT_EQ(face->base_type, "lathe");
    else
      EXPECT_EQ(std::get<Cylinder::Geometry>(config.geometry).base_type, "lathe");
    EXPECT_NE(make_scheme(config), nullptr);
  }
}

TEST(TurnedWorkpiece, NamesWhatIsMissing) {
  const auto on = [](const char* type) {
    SchemeConfig active = lathe_in_diameter();
    active.type = type;
    if (active.type != Lathe::type_name) active.geometry = find_scheme_type(type)->geometry;
    return active;
  };
  SchemeConfig without_x = lathe_in_diameter();
  without_x.axes = {1, 2};
  SchemeConfig parked_c = lathe_in_diameter();
  parked_c.axes = {0, 1};
  struct Case {
    SchemeConfig config;
    const char* defect;
  };
  const Case cases[] = {
      {face_scheme(on("head_table"), lathe_C, FaceSide::positive),
       "it rides on a cartesian or lathe scheme, not on 'head_table'"},
      {face_scheme(face_scheme(lathe_in_diameter(), lathe_C, FaceSide::positive), lathe_C,
                   FaceSide::positive),
       "it rides on a cartesian or lathe scheme, not on 'polar_face'"},
      {face_scheme(without_x, lathe_C, FaceSide::positive), "X must take part"},
      {face_scheme(parked_c, lathe_C, FaceSide::positive), "the rotary axis must take part"},
      {face_scheme(lathe_in_diameter(), -1, FaceSide::positive), "the rotary axis must take part"},
      {face_scheme(lathe_in_diameter(), 1, FaceSide::positive),
       "the rotary axis must be none of X, Y, Z"},
      {cylinder_scheme(lathe_in_diameter(), 0, 5.0), "the rotary axis must be none of X, Y, Z"},
      {cylinder_scheme(lathe_in_diameter(), lathe_C, 0.0),
       "the radius of the cylinder must be above 0"},
      {cylinder_scheme(lathe_in_diameter(), lathe_C, -3.0),
       "the radius of the cylinder must be above 0"},
      {cylinder_scheme(lathe_in_diameter(), lathe_C, std::nan("")),
       "the radius of the cylinder must be above 0"},
      {face_scheme(on("cartesian"), lathe_C, FaceSide::positive), ""},
      {cylinder_scheme(on("cartesian"), lathe_C, 5.0), ""},
  };
  for (const Case& each : cases) {
    EXPECT_EQ(scheme_defect(each.config), each.defect);
    EXPECT_EQ(make_scheme(each.config) == nullptr, *each.defect != '\0') << each.defect;
  }
}

}  // namespace
}  // namespace stanok::kinematics
