// Head-table scheme against matrix chains in long double and their central differences.
#include "kinematics/head_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/kinematics/reference.h"

namespace stanok::kinematics {
namespace {

using reference::Real;

constexpr unsigned seed = 40105;
constexpr std::array<double, 3> pivot_to_spindle{0.5, -0.25, -200.0};
constexpr std::array<double, 3> table_centre{10.0, 20.0, -400.0};

SchemeConfig table_config() {
  SchemeConfig config;
  config.type = "head_table";
  config.axes = {0, 1, 2, 3, 4};
  config.linear = {0, 1, 2};
  config.head_axis = 3;
  config.table_axis = 4;
  config.pivot_to_spindle = pivot_to_spindle;
  config.table_centre = table_centre;
  for (std::size_t k = 0; k < 3; ++k) config.zero[k] = table_centre[k] - pivot_to_spindle[k];
  return config;
}

reference::Vector exact(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

const reference::HeadTable drawing{exact(pivot_to_spindle), exact(table_centre)};

TEST(HeadTable, AgreesWithTheMatrixChainsOfTheDrawing) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  const HeadTable scheme(table_config());
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> length(-300.0, 300.0);
  std::uniform_real_distribution<double> angle(-720.0, 720.0);
  for (int i = 0; i < 20'000; ++i) {
    const AxisVector<double> point{length(engine), length(engine), length(engine), angle(engine),
                                   angle(engine)};
    const ToolVector tool{{length(engine), length(engine), length(engine)}};
    AxisVector<double> axes_M{};
    scheme.inverse(PointMode::tip, tool, point, axes_M);
    const auto pivot = drawing.pivot({point[0], point[1], point[2]}, point[3], point[4],
                                     exact(tool.nose_to_tip_mm));
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(axes_M[k], static_cast<double>(pivot[k]), 1e-11) << "axis " << k;
    }
  }
}

// The tool vertical over the centre of the table: the pivot stands pivot length + tool length above
// the point. Head at +90 deg: Ry(90) takes the tool's direction from the nose, -Z, to -X, so the
// pivot lies on the +X side of the point. Table at +90 deg: a point on +X of the workpiece stands
// on +Y of the machine.
TEST(HeadTable, PutsThePivotWhereTheDrawingShowsIt) {
  SchemeConfig config = table_config();
  config.pivot_to_spindle = {0, 0, -200};
  config.table_centre = {0, 0, 0};
  const HeadTable scheme(config);
  const ToolVector tool{{0, 0, -80}};
  AxisVector<double> axes_M{};
  const auto expect = [&](double x, double y, double z) {
    EXPECT_NEAR(axes_M[0], x, 1e-12);
    EXPECT_NEAR(axes_M[1], y, 1e-12);
    EXPECT_NEAR(axes_M[2], z, 1e-12);
  };
  scheme.inverse(PointMode::tip, tool, {10, 0, 5, 0, 0}, axes_M);
  expect(10, 0, 285);
  scheme.inverse(PointMode::tip, tool, {10, 0, 5, 90, 0}, axes_M);
  expect(290, 0, 5);
  scheme.inverse(PointMode::tip, tool, {10, 0, 5, 0, 90}, axes_M);
  expect(0, 10, 285);
}

// In the workpiece the tool points from tip to nose along o = (sinB cosC, -sinB sinC, cosB): two
// tools whose lengths differ by 1 mm, at the same machine position, have tips one o apart.
TEST(HeadTable, PointsTheToolAlongTheOrientationVector) {
  const HeadTable scheme(table_config());
  for (const double B_deg : {-75.0, 0.0, 30.0, 90.0}) {
    for (const double C_deg : {-200.0, 0.0, 45.0, 350.0}) {
      AxisVector<double> longer{};
      AxisVector<double> shorter{};
      const AxisVector<double> axes_M{40, -30, 20, B_deg, C_deg};
      scheme.forward(PointMode::tip, ToolVector{{0, 0, -81}}, axes_M, longer);
      scheme.forward(PointMode::tip, ToolVector{{0, 0, -80}}, axes_M, shorter);
      const double B = B_deg * std::acos(-1.0) / 180.0;
      const double C = C_deg * std::acos(-1.0) / 180.0;
      EXPECT_NEAR(shorter[0] - longer[0], std::sin(B) * std::cos(C), 1e-12);
      EXPECT_NEAR(shorter[1] - longer[1], -std::sin(B) * std::sin(C), 1e-12);
      EXPECT_NEAR(shorter[2] - longer[2], std::cos(B), 1e-12);
    }
  }
}

TEST(HeadTable, NamesTheSamePointInBothModesWhenHeadAndTableStandAtZero) {
  const HeadTable scheme(table_config());
  const ToolVector tool{{1, 2, -80}};
  AxisVector<double> tip{};
  AxisVector<double> axes{};
  scheme.inverse(PointMode::tip, tool, {7, 8, 9}, tip);
  scheme.inverse(PointMode::axes, tool, {7, 8, 9}, axes);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(tip[k], axes[k], 1e-12);
}

TEST(HeadTable, CountsTheAnglesFromTheRotaryZeros) {
  SchemeConfig config = table_config();
  config.zero[3] = 1.5;
  config.zero[4] = -30.0;
  const HeadTable shifted(config);
  const HeadTable straight(table_config());
  const AxisVector<double> point{7, 8, 9, 20, 50};
  AxisVector<double> axes_shifted{};
  AxisVector<double> axes_straight{};
  shifted.inverse(PointMode::tip, ToolVector{{0, 0, -80}}, point, axes_shifted);
  straight.inverse(PointMode::tip, ToolVector{{0, 0, -80}}, point, axes_straight);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(axes_shifted[k], axes_straight[k]);
  EXPECT_EQ(axes_shifted[3], 21.5);
  EXPECT_EQ(axes_shifted[4], 20.0);
}

// Cubic motions q(t) = c0 + c1 t + c2 t^2 + c3 t^3 of the programmed point.
struct CubicMotion {
  std::array<std::array<double, 4>, 5> coefficients;

  [[nodiscard]] Jet jet(std::size_t axis) const {  // at t = 0
    const auto& c = coefficients[axis];
    return {c[0], c[1], 2.0 * c[2], 6.0 * c[3]};
  }
  [[nodiscard]] Real at(std::size_t axis, Real t) const {
    const auto& c = coefficients[axis];
    return c[0] + t * (c[1] + t * (c[2] + t * static_cast<Real>(c[3])));
  }
};

// Central differences of fourth order over seven samples.
struct Differences {
  Real first, second, third;
};

Differences central_differences(const std::array<Real, 7>& f, Real h) {
  return {
      (f[1] - 8 * f[2] + 8 * f[4] - f[5]) / (12 * h),
      (-f[1] + 16 * f[2] - 30 * f[3] + 16 * f[4] - f[5]) / (12 * h * h),
      (f[0] - 8 * f[1] + 13 * f[2] - 13 * f[4] + 8 * f[5] - f[6]) / (8 * h * h * h),
  };
}

TEST(HeadTable, VelocityAccelerationAndJerkAreTheDerivativesOfTheMatrixChain) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  const HeadTable scheme(table_config());
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> length(-100.0, 100.0);
  std::uniform_real_distribution<double> angle(-180.0, 180.0);
  std::uniform_real_distribution<double> rate(-60.0, 60.0);
  constexpr Real h = 1.0L / 256;
  for (int i = 0; i < 2000; ++i) {
    CubicMotion motion{};
    for (std::size_t axis = 0; axis < 5; ++axis) {
      motion.coefficients[axis] = {axis < 3 ? length(engine) : angle(engine), rate(engine),
                                   rate(engine), rate(engine)};
    }
    const ToolVector tool{{0, 0, -50.0 - std::abs(length(engine))}};
    AxisVector<Jet> point{};
    for (std::size_t axis = 0; axis < 5; ++axis) point[axis] = motion.jet(axis);
    AxisVector<Jet> axes_M{};
    scheme.inverse(PointMode::tip, tool, point, axes_M);

    std::array<std::array<Real, 7>, 3> samples{};
    for (std::size_t n = 0; n < 7; ++n) {
      const Real t = (static_cast<Real>(n) - 3) * h;
      const auto pivot =
          drawing.pivot({motion.at(0, t), motion.at(1, t), motion.at(2, t)}, motion.at(3, t),
                        motion.at(4, t), exact(tool.nose_to_tip_mm));
      for (std::size_t k = 0; k < 3; ++k) samples[k][n] = pivot[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Differences expected = central_differences(samples[k], h);
      const auto near = [&](double got, Real want, double scale) {
        ASSERT_NEAR(got, static_cast<double>(want), 1e-6 * std::max(scale, std::abs(got)))
            << "axis " << k << ", motion " << i;
      };
      // Derivatives that happen to vanish are judged against the size of the motion: 60 mm/s and
      // 60 deg/s on arms of some 300 mm.
      near(axes_M[k].first, expected.first, 100.0);
      near(axes_M[k].second, expected.second, 200.0);
      near(axes_M[k].third, expected.third, 500.0);
    }
  }
}

TEST(HeadTable, NamesTheRoleThatIsMissing) {
  struct Case {
    const char* name;
    void (*spoil)(SchemeConfig&);
    const char* defect;
  };
  const Case cases[] = {
      {"no Y", [](SchemeConfig& c) { c.linear[1] = -1; }, "X, Y and Z must take part"},
      {"Z parked", [](SchemeConfig& c) { c.axes = {0, 1, 3, 4}; }, "X, Y and Z must take part"},
      {"no head", [](SchemeConfig& c) { c.head_axis = -1; },
       "the head axis (about Y) must take part"},
      {"table parked", [](SchemeConfig& c) { c.axes = {0, 1, 2, 3}; },
       "the table axis (about Z) must take part"},
      {"one axis for both", [](SchemeConfig& c) { c.table_axis = 3; },
       "head axis and table axis must differ"},
  };
  for (const Case& wrong : cases) {
    SchemeConfig config = table_config();
    wrong.spoil(config);
    EXPECT_EQ(scheme_defect(config), wrong.defect) << wrong.name;
    EXPECT_EQ(make_scheme(config), nullptr) << wrong.name;
  }
}

}  // namespace
}  // namespace stanok::kinematics
