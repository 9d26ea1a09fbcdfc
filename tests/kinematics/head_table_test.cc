// Head-table scheme against the drawing: where the pivot stands, where the tool points.
#include "kinematics/head_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/scheme.h"

namespace stanok::kinematics {
namespace {

const Vector3<double> pivot_to_spindle{0.5, -0.25, -200.0};
const Vector3<double> table_centre{10.0, 20.0, -400.0};

SchemeConfig table_config() {
  SchemeConfig config;
  config.type = "head_table";
  config.axes = {0, 1, 2, 3, 4};
  config.linear = {0, 1, 2};
  config.geometry = HeadTable::Geometry{.head_axis = 3,
                                        .table_axis = 4,
                                        .pivot_to_spindle = pivot_to_spindle,
                                        .table_centre = table_centre};
  config.zero = {9.5, 20.25, -200.0};  // table_centre - pivot_to_spindle
  return config;
}

// The tool vertical over the centre of the table: the pivot stands pivot length + tool length above
// the point. Head at +90 deg: Ry(90) takes the tool's direction from the nose, -Z, to -X, so the
// pivot lies on the +X side of the point. Table at +90 deg: a point on +X of the workpiece stands
// on +Y of the machine.
TEST(HeadTable, PutsThePivotWhereTheDrawingShowsIt) {
  SchemeConfig config = table_config();
  auto& geometry = std::get<HeadTable::Geometry>(config.geometry);
  geometry.pivot_to_spindle = {0, 0, -200};
  geometry.table_centre = {0, 0, 0};
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

// The same direction of the tool by the other branch: (B, C) and (-B, C + 180).
TEST(HeadTable, PointsTheToolTheSameWayByBothBranches) {
  const HeadTable scheme(table_config());
  const auto orientation = [&](double B_deg, double C_deg) {
    AxisVector<double> longer{};
    AxisVector<double> shorter{};
    const AxisVector<double> axes_M{40, -30, 20, B_deg, C_deg};
    scheme.forward(PointMode::tip, ToolVector{{0, 0, -1}}, axes_M, longer);
    scheme.forward(PointMode::tip, ToolVector{}, axes_M, shorter);
    return std::array{shorter[0] - longer[0], shorter[1] - longer[1], shorter[2] - longer[2]};
  };
  for (const double B : {-95.0, -20.0, 0.0, 45.0, 110.0}) {
    for (const double C : {-170.0, 0.0, 30.0, 400.0}) {
      const auto one = orientation(B, C);
      const auto other = orientation(-B, C + 180.0);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(one[k], other[k], 1e-12);
    }
  }
}

TEST(HeadTable, NamesTheRoleThatIsMissing) {
  struct Case {
    const char* name;
    void (*spoil)(SchemeConfig&, HeadTable::Geometry&);
    const char* defect;
  };
  const Case cases[] = {
      {"no Y", [](SchemeConfig& c, HeadTable::Geometry&) { c.linear[1] = -1; },
       "X, Y and Z must take part"},
      {"Z parked", [](SchemeConfig& c, HeadTable::Geometry&) { c.axes = {0, 1, 3, 4}; },
       "X, Y and Z must take part"},
      {"no head", [](SchemeConfig&, HeadTable::Geometry& g) { g.head_axis = -1; },
       "the head_axis must take part"},
      {"table parked", [](SchemeConfig& c, HeadTable::Geometry&) { c.axes = {0, 1, 2, 3}; },
       "the table_axis must take part"},
      {"head vector too long",
       [](SchemeConfig&, HeadTable::Geometry& g) { g.head_vector = {0, 1, 1}; },
       "head_vector must have the length 1"},
      {"no table vector", [](SchemeConfig&, HeadTable::Geometry& g) { g.table_vector = {0, 0, 0}; },
       "table_vector must have the length 1"},
      {"one axis for both", [](SchemeConfig&, HeadTable::Geometry& g) { g.table_axis = 3; },
       "head_axis and table_axis must differ"},
  };
  for (const Case& wrong : cases) {
    SchemeConfig config = table_config();
    wrong.spoil(config, std::get<HeadTable::Geometry>(config.geometry));
    EXPECT_EQ(scheme_defect(config), wrong.defect) << wrong.name;
    EXPECT_EQ(make_scheme(config), nullptr) << wrong.name;
  }
}

}  // namespace
}  // namespace stanok::kinematics
