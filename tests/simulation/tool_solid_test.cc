// Lines through tools against points that are asked one by one.
#include "simulation/tool_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulation/swept_section.h"

namespace stanok::simulation {
namespace {

struct Case {
  const char* name;
  ToolShape shape;
};

ToolShape shape(ToolKind kind, double radius, double corner = 0.0, double taper = 0.0) {
  ToolShape tool;
  tool.kind = kind;
  tool.radius = radius;
  tool.corner_radius = corner;
  tool.taper_angle = taper;
  tool.flute_length = 12.0;
  tool.overhang = 20.0;
  tool.shank_diameter = 2.0 * radius;
  tool.holder_diameter = 20.0;
  tool.holder_length = 10.0;
  return tool;
}

// Radius of the cutting part at a height over the tip, by the drawing of the tool.
double drawn_radius(const ToolShape& tool, double height) {
  const double r = tool.radius;
  const double c = tool.corner_radius;
  switch (tool.kind) {
    case ToolKind::ball:
      return height < r ? std::sqrt(r * r - (r - height) * (r - height)) : r;
    case ToolKind::bull:
      return height < c ? r - c + std::sqrt(c * c - (c - height) * (c - height)) : r;
    case ToolKind::drill:
      return std::min(r, height * std::tan(59.0 * 3.14159265358979 / 180.0));
    case ToolKind::taper:
      return r + height * std::tan(tool.taper_angle * 3.14159265358979 / 180.0);
    default:
      return r;
  }
}

class ToolSolidTest : public ::testing::TestWithParam<Case> {};

TEST_P(ToolSolidTest, HasTheRadiusOfTheDrawing) {
  constexpr double deviation = 0.01;
  const ToolSolid solid = solid_of(GetParam().shape, deviation);
  for (const ProfileSegment& segment : solid.bodies.front().segments) {
    for (int i = 1; i < 10; ++i) {
      const double height = segment.from + (segment.to - segment.from) * i / 10.0;
      // A chord is off by `deviation` across it, by more along the radius where it lies flat.
      EXPECT_NEAR(segment.radius_at(height), drawn_radius(GetParam().shape, height), 0.15)
          << height;
      const double drawn_above = drawn_radius(GetParam().shape, height + 2.0 * deviation);
      EXPECT_LE(segment.radius_at(height), drawn_above + 2.0 * deviation) << height;
    }
  }
  EXPECT_DOUBLE_EQ(solid.bodies.front().top(), 12.0);
  ASSERT_EQ(solid.bodies.size(), 3U);
  EXPECT_DOUBLE_EQ(solid.bodies[1].top(), 20.0);
  EXPECT_DOUBLE_EQ(solid.bodies[2].top(), 30.0);
}

bool is_inside(const Body& body, const ToolPlace& place, const Vector& point) {
  const Vector from_tip = point - place.tip;
  const double height = from_tip.dot(place.axis);
  const double distance = (from_tip - height * place.axis).norm();
  for (const ProfileSegment& segment : body.segments) {
    if (height >= segment.from && height <= segment.to && distance <= segment.radius_at(height))
      return true;
  }
  return false;
}

TEST_P(ToolSolidTest, IsMetByLinesWhereItsPointsAre) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> offset(-8.0, 8.0);
  const ToolSolid solid = solid_of(GetParam().shape, 0.02);
  int met = 0;
  for (int trial = 0; trial < 600; ++trial) {
    ToolPlace place{{offset(random), offset(random), offset(random)},
                    Vector(normal(random), normal(random), normal(random)).normalized()};
    if (trial % 4 == 0) place.axis = Vector::Unit(trial / 4 % 3);
    for (const Body& body : solid.bodies) {
      const int axis = trial % 3;
      const Vector through =
          place.at(body.bottom() + (body.top() - body.bottom()) * (trial % 10) / 10.0) +
          Vector(normal(random), normal(random), normal(random)) * solid.radius;
      const BodySection section(body, place, axis);
      double from = 0.0;
      double to = 0.0;
      const bool meets = section.meet(through[(axis + 1) % 3], through[(axis + 2) % 3], from, to);
      double row_from = 0.0;
      double row_to = 0.0;
      const bool has_row = section.row(through[(axis + 2) % 3], row_from, row_to);
      const Bounds bounds = bounds_of(body, place);
      for (int i = 0; i <= 400; ++i) {
        Vector point = through;
        point[axis] = place.tip[axis] - 40.0 + 0.2 * i;
        const bool inside = is_inside(body, place, point);
        const bool near_end =
            meets && (std::abs(point[axis] - from) < 1e-6 || std::abs(point[axis] - to) < 1e-6);
        if (near_end) continue;
        EXPECT_EQ(inside, meets && point[axis] > from && point[axis] < to)
            << trial << " " << point.transpose();
        if (!inside) continue;
        ++met;
        EXPECT_TRUE(has_row && through[(axis + 1) % 3] >= row_from - 1e-9 &&
                    through[(axis + 1) % 3] <= row_to + 1e-9);
        EXPECT_TRUE((point.array() >= bounds.low.array() - 1e-9).all());
        EXPECT_TRUE((point.array() <= bounds.high.array() + 1e-9).all());
      }
    }
  }
  EXPECT_GT(met, 1000);
}

// What many places of a body on its way cover of a line, and its two ends of that alone.
struct CoveredByPlaces {
  double low = 1e9;
  double high = -1e9;
  double ends_low = 1e9;
  double ends_high = -1e9;

  CoveredByPlaces(const Body& body, const ToolPlace& begin, const Vector& way, int places, int axis,
                  double first, double second) {
    for (int i = 0; i <= places; ++i) {
      const ToolPlace place{begin.tip + static_cast<double>(i) / places * way, begin.axis};
      double from = 0.0;
      double to = 0.0;
      if (!BodySection(body, place, axis).meet(first, second, from, to)) continue;
      low = std::min(low, from);
      high = std::max(high, to);
      if (i > 0 && i < places) continue;
      ends_low = std::min(ends_low, from);
      ends_high = std::max(ends_high, to);
    }
  }
};

// The interval of a swept body is the hull of those of many bodies on the way; the ends of the way
// and the places between two of them are hulls of less.
TEST_P(ToolSolidTest, SweepsWhatItCoversOnTheWay) {
  constexpr int places = 1000;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const ToolSolid solid = solid_of(GetParam().shape, 0.02);
  int met = 0;
  int wider_than_both_ends = 0;
  for (int trial = 0; trial < 400; ++trial) {
    ToolPlace place{Vector(normal(random), normal(random), normal(random)),
                    Vector(normal(random), normal(random), normal(random)).normalized()};
    Vector way(normal(random), normal(random), normal(random));
    way *= solid.radius;
    if (trial % 3 == 0) place.axis = Vector::UnitZ();
    if (trial % 6 == 0) way.z() = 0.0;
    if (trial % 6 == 3) way = Vector(0.0, 0.0, way.z());
    const int axis = trial % 7 % 3;
    for (const Body& body : solid.bodies) {
      const Vector through =
          place.at(body.bottom() + (body.top() - body.bottom()) * part(random)) +
          part(random) * way +
          Vector(normal(random), normal(random), normal(random)) * solid.radius / 2.0;
      const double first = through[(axis + 1) % 3];
      const double second = through[(axis + 2) % 3];
      const CoveredByPlaces covered(body, place, way, places, axis, first, second);
      double from = 0.0;
      double to = 0.0;
      const SweptSection swept(body, place, way, axis);
      const bool meets = swept.meet(first, second, from, to);
      if (covered.low > covered.high) {
        // A line that only grazes the body may be found by the exact one alone.
        EXPECT_TRUE(!meets || to - from < 0.2) << trial;
        continue;
      }
      ASSERT_TRUE(meets) << trial;
      EXPECT_LE(from, covered.low + 1e-9) << trial;
      EXPECT_GE(to, covered.high - 1e-9) << trial;
      // Between two of the places a round flank goes on by less than half a step at the rim.
      EXPECT_NEAR(to - from, covered.high - covered.low, 4.0 * way.norm() / places + 0.02) << trial;
      double row_from = 0.0;
      double row_to = 0.0;
      EXPECT_TRUE(swept.row(second, row_from, row_to)) << trial;
      EXPECT_LE(row_from, first) << trial;
      EXPECT_GE(row_to, first) << trial;
      ++met;
      if (to - from > covered.ends_high - covered.ends_low + 0.1) ++wider_than_both_ends;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(wider_than_both_ends, 20);
}

TEST_P(ToolSolidTest, KeepsItsCoreWithin) {
  constexpr double set_back = 0.3;
  const ToolSolid solid = solid_of(GetParam().shape, 0.01);
  const ToolSolid core = solid_of(GetParam().shape, 0.01, set_back);
  ASSERT_EQ(core.bodies.size(), solid.bodies.size());
  for (std::size_t i = 0; i < solid.bodies.size(); ++i) {
    EXPECT_GE(core.bodies[i].bottom(), solid.bodies[i].bottom() + set_back - 1e-9);
    EXPECT_LE(core.bodies[i].top(), solid.bodies[i].top() - set_back + 1e-9);
    for (const ProfileSegment& segment : core.bodies[i].segments) {
      const double height = (segment.from + segment.to) / 2.0;
      const ToolPlace upright;
      const Vector at(segment.radius_at(height), 0.0, height);
      EXPECT_TRUE(is_inside(solid.bodies[i], upright, at)) << height;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ToolSolidTest,
                         ::testing::Values(Case{"flat", shape(ToolKind::flat, 3.0)},
                                           Case{"ball", shape(ToolKind::ball, 3.0)},
                                           Case{"bull", shape(ToolKind::bull, 4.0, 1.0)},
                                           Case{"drill", shape(ToolKind::drill, 2.5)},
                                           Case{"taper", shape(ToolKind::taper, 1.0, 0.0, 10.0)}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(ToolShape, SaysWhatItLacks) {
  EXPECT_EQ(defect_of(shape(ToolKind::flat, 0.0)), "its radius is 0");
  EXPECT_NE(defect_of(shape(ToolKind::taper, 2.0)), "");
  EXPECT_NE(defect_of(shape(ToolKind::insert, 0.4)), "");
  EXPECT_EQ(defect_of(shape(ToolKind::ball, 3.0)), "");
  EXPECT_FALSE(tool_kind_named("hammer"));
}

}  // namespace
}  // namespace stanok::simulation
