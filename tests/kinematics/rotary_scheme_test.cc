// Head-head and table-table schemes against the drawing, and what their configs may lack.
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/head_head.h"
#include "kinematics/scheme.h"
#include "kinematics/table_table.h"

namespace stanok::kinematics {
namespace {

constexpr int rotary_A = 3;
constexpr int rotary_C = 4;

// C turns a fork, A tilts the spindle in it: 100 mm from the axis of C down to the pivot of A,
// which lies 20 mm to the side (+X), 150 mm from there to the nose.
SchemeConfig fork_head() {
  SchemeConfig config;
  config.type = "head_head";
  config.axes = {0, 1, 2, rotary_A, rotary_C};
  config.linear = {0, 1, 2};
  config.geometry = HeadHead::Geometry{.outer_axis = rotary_C,
                                       .inner_axis = rotary_A,
                                       .outer_vector = {0, 0, 1},
                                       .inner_vector = {1, 0, 0},
                                       .pivot_to_pivot = {20, 0, -100},
                                       .pivot_to_spindle = {0, 0, -150}};
  return config;
}

// A rocks about X, 500 mm below the zero of Z; C turns the plate, whose face is 40 mm above the
// axis of A.
SchemeConfig trunnion() {
  SchemeConfig config;
  config.type = "table_table";
  config.axes = {0, 1, 2, rotary_A, rotary_C};
  config.linear = {0, 1, 2};
  config.geometry = TableTable::Geometry{.outer_axis = rotary_A,
                                         .inner_axis = rotary_C,
                                         .outer_vector = {1, 0, 0},
                                         .inner_vector = {0, 0, 1},
                                         .table_centre = {0, 0, -500},
                                         .centre_to_centre = {0, 0, 40}};
  config.zero = zero_default(config);
  return config;
}

void expect_axes(const Scheme& scheme, const AxisVector<double>& point_B,
                 const std::array<double, 3>& expected) {
  AxisVector<double> axes_M{};
  scheme.inverse(PointMode::tip, ToolVector{{0, 0, -80}}, point_B, axes_M);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(axes_M[k], expected[k], 1e-12) << "axis " << k;
}

// The base is where the nose stands when X, Y, Z read zero. Upright, the nose is one tool length
// above the tip. A at 90 deg turns the tool from -Z to +Y: the nose is 80 mm on the -Y side of the
// tip, the pivot of A 150 mm further, and at the height of the tip, so Z reads the difference of
// the heights. With C at 90 deg besides, the tool points to -X and the pivot lies 20 mm on +Y.
TEST(HeadHead, PutsTheSpindleWhereTheDrawingShowsIt) {
  const HeadHead scheme(fork_head());
  expect_axes(scheme, {10, 20, 5, 0, 0}, {10, 20, 85});
  expect_axes(scheme, {10, 20, 5, 90, 0}, {10, 20 - 230, 5 - 150});
  expect_axes(scheme, {10, 20, 5, 90, 90}, {10 + 20 + 230, 20 - 20, 5 - 150});
}

TEST(HeadHead, CountsFromItsZeroInBothModes) {
  SchemeConfig config = fork_head();
  config.zero = {100, 200, 300, 0, 0};
  const HeadHead scheme(config);
  expect_axes(scheme, {10, 20, 5, 0, 0}, {110, 220, 385});
  AxisVector<double> axes_M{};
  scheme.inverse(PointMode::axes, ToolVector{{0, 0, -80}}, {10, 20, 5, 0, 0}, axes_M);
  EXPECT_EQ(axes_M, (AxisVector<double>{110, 220, 385, 0, 0}));
}

// The base is on the face of the plate. A at 90 deg turns the plate's +Z to -Y and its +Y to +Z:
// the point (10, 20, 5) is 45 mm out along -Y and 20 mm above the axis. C at 90 deg first turns it
// to
// (-20, 10, 5).
TEST(TableTable, PutsTheWorkpieceWhereTheDrawingShowsIt) {
  const TableTable scheme(trunnion());
  expect_axes(scheme, {10, 20, 5, 0, 0}, {10, 20, -500 + 40 + 5 + 80});
  expect_axes(scheme, {10, 20, 5, 90, 0}, {10, -45, -500 + 20 + 80});
  expect_axes(scheme, {10, 20, 5, 90, 90}, {-20, -45, -500 + 10 + 80});
}

// In the workpiece the tool points along o = Rc^T Ra^T e_z = (sin A sin C, sin A cos C, cos A).
TEST(TableTable, PointsTheToolAlongTheOrientationVector) {
  const TableTable scheme(trunnion());
  for (const double A_deg : {-90.0, 0.0, 30.0}) {
    for (const double C_deg : {-200.0, 0.0, 45.0}) {
      AxisVector<double> longer{};
      AxisVector<double> shorter{};
      const AxisVector<double> axes_M{40, -30, 20, A_deg, C_deg};
      scheme.forward(PointMode::tip, ToolVector{{0, 0, -81}}, axes_M, longer);
      scheme.forward(PointMode::tip, ToolVector{{0, 0, -80}}, axes_M, shorter);
      const double a = A_deg * std::acos(-1.0) / 180.0;
      const double c = C_deg * std::acos(-1.0) / 180.0;
      EXPECT_NEAR(shorter[0] - longer[0], std::sin(a) * std::sin(c), 1e-12);
      EXPECT_NEAR(shorter[1] - longer[1], std::sin(a) * std::cos(c), 1e-12);
      EXPECT_NEAR(shorter[2] - longer[2], std::cos(a), 1e-12);
    }
  }
}

template <class Type>
void expect_defects_of_outer_and_inner_axis(const SchemeConfig& right) {
  using Geometry = typename Type::Geometry;
  struct Case {
    void (*spoil)(SchemeConfig&, Geometry&);
    const char* defect;
  };
  const Case cases[] = {
      {[](SchemeConfig& c, Geometry&) { c.linear[2] = -1; }, "X, Y and Z must take part"},
      {[](SchemeConfig&, Geometry& g) { g.outer_axis = -1; }, "the outer_axis must take part"},
      {[](SchemeConfig& c, Geometry& g) {
         c.axes.resize(4), g.inner_axis = rotary_C, g.outer_axis = rotary_A;
       },
       "the inner_axis must take part"},
      {[](SchemeConfig&, Geometry& g) { g.outer_vector = {0, 0, 2}; },
       "outer_vector must have the length 1"},
      {[](SchemeConfig&, Geometry& g) { g.inner_vector = {0, 0, 0}; },
       "inner_vector must have the length 1"},
      {[](SchemeConfig&, Geometry& g) { g.inner_axis = g.outer_axis; },
       "outer_axis and inner_axis must differ"},
  };
  for (const Case& wrong : cases) {
    SchemeConfig config = right;
    wrong.spoil(config, std::get<Geometry>(config.geometry));
    EXPECT_EQ(scheme_defect(config), wrong.defect) << right.type;
    EXPECT_EQ(make_scheme(config), nullptr);
  }
  EXPECT_NE(make_scheme(right), nullptr);
}

TEST(RotaryScheme, TypesWithOuterAndInnerAxisNameWhatIsMissing) {
  expect_defects_of_outer_and_inner_axis<HeadHead>(fork_head());
  expect_defects_of_outer_and_inner_axis<TableTable>(trunnion());
}

TEST(RotaryScheme, KnowsWhichAxesTurnTheTool) {
  EXPECT_EQ(HeadHead(fork_head()).head_axes(), 1U << rotary_A | 1U << rotary_C);
  EXPECT_EQ(TableTable(trunnion()).head_axes(), 0U);
}

}  // namespace
}  // namespace stanok::kinematics
