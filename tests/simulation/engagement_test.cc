// Where a tool will cut, at places where the drawing tells it: a flat end mill in a slot and at a
// wall, a ball on a plane.
#include "simulation/engagement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/place.h"
#include "simulation/workpiece.h"

namespace stanok::simulation {
namespace {

constexpr double resolution = 0.2;
constexpr double top = 10.0;
constexpr double cutter_radius = 3.0;

Workpiece block() {
  const Blank blank{.kind = BlankKind::box, .size = {40.0, 30.0, top}, .resolution = resolution};
  return Workpiece(blank, *grid_of(blank));
}

ToolShape cutter(ToolKind kind) {
  ToolShape shape;
  shape.kind = kind;
  shape.radius = cutter_radius;
  shape.flute_length = 15.0;
  shape.length = 60.0;
  return shape;
}

// Cuts along X at this y and z, and looks ahead of its end.
std::vector<EngagementSlice> cut_and_look(Workpiece& part, const MillingTool& tool,
                                          const Vector& from, const Vector& to,
                                          SpindleSense sense = SpindleSense::clockwise) {
  const Vector way = to - from;
  part.mill(tool, {.tip = from}, {.tip = to}, {});
  const Vector direction = way.normalized();
  return engagement_of(part.material(), tool.solid, {.tip = to + 0.5 * resolution * direction},
                       direction, sense);
}

// Angles at which most of the depth is engaged, deg.
struct Arc {
  double from = 360.0;
  double to = 0.0;
  double depth = 0.0;  // sum of the widths
};
Arc arc_of(const std::vector<EngagementSlice>& slices) {
  Arc arc;
  for (const EngagementSlice& slice : slices) {
    arc.depth += slice.width;
    for (int n = 0; n < engagement_angles; ++n) {
      if (slice.meets[checked_size(n)] == 0) continue;
      arc.from = std::min(arc.from, 360.0 * n / engagement_angles);
      arc.to = std::max(arc.to, 360.0 * (n + 1) / engagement_angles);
    }
  }
  return arc;
}

constexpr double angle_off = 8.0;  // deg: two of the angles, and half a cell at the border

TEST(Engagement, OfASlotIsHalfATurn) {
  for (const double depth : {2.0, 1.3, 0.45}) {
    Workpiece part = block();
    const MillingTool tool = part.milling_tool(cutter(ToolKind::flat));
    const Arc arc =
        arc_of(cut_and_look(part, tool, {-5.0, 15.0, top - depth}, {20.0, 15.0, top - depth}));
    EXPECT_NEAR(arc.from, 0.0, angle_off) << depth;
    EXPECT_NEAR(arc.to, 180.0, angle_off) << depth;
    EXPECT_NEAR(arc.depth, depth, 0.5 * resolution) << depth;
  }
}

// The wall on the left of the feed: teeth enter with no chip, up to acos(1 - a/R); on its right
// they leave so. A spindle that turns the other way exchanges both.
TEST(Engagement, OfAWallIsThatOfItsWidth) {
  for (const double width : {1.0, 3.0, 4.5}) {
    const double arc_deg = std::acos(1.0 - width / cutter_radius) * 180.0 / std::numbers::pi;
    // Behind the edge of the block at y = 30, material on the right of the feed along +X.
    const double y = 30.0 + cutter_radius - width;
    for (const SpindleSense sense : {SpindleSense::clockwise, SpindleSense::counter_clockwise}) {
      Workpiece part = block();
      const MillingTool tool = part.milling_tool(cutter(ToolKind::flat));
      const Arc arc = arc_of(cut_and_look(part, tool, {-5.0, y, 8.0}, {20.0, y, 8.0}, sense));
      const bool is_down = sense == SpindleSense::clockwise;
      EXPECT_NEAR(arc.from, is_down ? 180.0 - arc_deg : 0.0, angle_off) << width;
      EXPECT_NEAR(arc.to, is_down ? 180.0 : arc_deg, angle_off) << width;
    }
  }
}

// A ball takes a segment of its circle: R^2 acos(1 - t/R) - (R - t) sqrt(2 R t - t^2).
TEST(Engagement, OfABallHasTheAreaOfTheSegment) {
  for (const double depth : {0.8, 1.5, 3.0}) {
    Workpiece part = block();
    const MillingTool tool = part.milling_tool(cutter(ToolKind::ball));
    const auto slices =
        cut_and_look(part, tool, {-5.0, 15.0, top - depth}, {20.0, 15.0, top - depth});
    double area = 0.0;
    for (const EngagementSlice& slice : slices) {
      for (int n = 0; n < engagement_angles; ++n) {
        const double angle = 2.0 * std::numbers::pi * (n + 0.5) / engagement_angles;
        area += slice.meets[checked_size(n)] * std::sin(angle) * slice.radius * slice.width * 2.0 *
                std::numbers::pi / engagement_angles;
      }
    }
    const double R = cutter_radius;
    const double expected = R * R * std::acos(1.0 - depth / R) -
                            (R - depth) * std::sqrt(2.0 * R * depth - depth * depth);
    EXPECT_NEAR(area, expected, 0.06 * expected) << depth;
  }
}

TEST(Engagement, InTheAirThereIsNone) {
  Workpiece part = block();
  const MillingTool tool = part.milling_tool(cutter(ToolKind::flat));
  EXPECT_TRUE(cut_and_look(part, tool, {-5.0, 15.0, top + 1.0}, {20.0, 15.0, top + 1.0}).empty());
  // Back in its own slot.
  static_cast<void>(cut_and_look(part, tool, {-5.0, 15.0, 8.0}, {20.0, 15.0, 8.0}));
  EXPECT_TRUE(cut_and_look(part, tool, {20.0, 15.0, 8.0}, {5.0, 15.0, 8.0}).empty());
}

}  // namespace
}  // namespace stanok::simulation
