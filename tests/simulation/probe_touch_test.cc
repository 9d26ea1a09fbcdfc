// What a probe and a tool setter touch, against distances of balls and discs.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulation/workpiece.h"

namespace stanok::simulation {
namespace {

constexpr double ball_radius = 1.5;
constexpr double ray_distance = 0.1;

Blank block_to_probe() {
  return {
      .kind = BlankKind::box, .size = {20.0, 16.0, 8.0}, .zero = {}, .resolution = ray_distance};
}

ToolShape probe_shape() {
  ToolShape shape;
  shape.kind = ToolKind::probe;
  shape.radius = ball_radius;
  shape.shank_diameter = 1.0;
  shape.overhang = 30.0;
  return shape;
}

// How far a point is from the block; 0: it is inside.
double distance_to(const Vector& point) {
  return (point - point.cwiseMax(Vector::Zero()).cwiseMin(Vector(20.0, 16.0, 8.0))).norm();
}

// A ball over the faces of a block: it touches where its middle is nearer than its radius. What
// lies between the two bounds is within the distance of rays: over a face resolution² / 4r, at an
// edge and at a corner, which no ray runs along, the half of a cell inside.
TEST(ProbeTouch, IsThatOfABallWithinTheDistanceOfTheRays) {
  const Blank blank = block_to_probe();
  const auto grid = grid_of(blank);
  ASSERT_TRUE(grid);
  const Workpiece workpiece(blank, *grid);
  const MillingTool tool = workpiece.milling_tool(probe_shape());
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int touched = 0;
  int free = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    // Above the block the stylus stays out of it.
    const Vector middle(-3.0 + 26.0 * part(random), -3.0 + 22.0 * part(random),
                        7.5 + 3.0 * part(random));
    const bool is_beside = middle.x() < -0.6 || middle.x() > 20.6 || middle.y() < -0.6 ||
                           middle.y() > 16.6 || middle.z() > 8.0;
    if (!is_beside) continue;
    const ToolPlace place{middle - Vector(0.0, 0.0, ball_radius), Vector::UnitZ()};
    const bool touches = workpiece.touches(tool.solid, place);
    const double distance = distance_to(middle);
    if (distance > ball_radius + 1e-5) {
      EXPECT_FALSE(touches) << middle.transpose();
      ++free;
    }
    // The block without the half of a cell at its edges: rays fill it.
    const Vector inner = middle.cwiseMax(Vector::Constant(0.05))
                             .cwiseMin(Vector(20.0, 16.0, 8.0) - Vector::Constant(0.05));
    const bool over_face = (middle - inner).cwiseAbs().maxCoeff() >= (middle - inner).norm() - 0.2;
    const double late = ray_distance * ray_distance / (4.0 * ball_radius);
    const double bound = over_face ? 0.0 : ray_distance;
    if ((middle - inner).norm() < ball_radius - 0.05 - late - bound) {
      EXPECT_TRUE(touches) << middle.transpose();
      ++touched;
    }
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(free, 1000);
}

TEST(ProbeTouch, OfAFaceComesLateByNoMoreThanTheRaysAllow) {
  const Blank blank = block_to_probe();
  const auto grid = grid_of(blank);
  ASSERT_TRUE(grid);
  const Workpiece workpiece(blank, *grid);
  const MillingTool tool = workpiece.milling_tool(probe_shape());
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double late = ray_distance * ray_distance / (4.0 * ball_radius);
  for (int trial = 0; trial < 2000; ++trial) {
    const double x = 3.0 + 14.0 * part(random);
    const double y = 3.0 + 10.0 * part(random);
    const auto at = [&](double z) { return ToolPlace{{x, y, z}, Vector::UnitZ()}; };
    EXPECT_FALSE(workpiece.touches(tool.solid, at(8.0 + 1e-5)));
    EXPECT_TRUE(workpiece.touches(tool.solid, at(8.0 - late - 1e-5)));
  }
}

TEST(ProbeTouch, IsThatOfTheStylusToo) {
  const Blank blank = block_to_probe();
  const auto grid = grid_of(blank);
  ASSERT_TRUE(grid);
  const Workpiece workpiece(blank, *grid);
  const MillingTool tool = workpiece.milling_tool(probe_shape());
  const auto beside = [&](double x) { return ToolPlace{{x, 8.0, -10.0}, Vector::UnitZ()}; };
  EXPECT_FALSE(workpiece.touches(tool.solid, beside(-0.501)));
  EXPECT_TRUE(workpiece.touches(tool.solid, beside(-0.49)));
}

// A wider probe that is free leaves room for the probe itself all round.
TEST(ProbeTouch, IsFreeWithinTheDistanceThatAWiderProbeIs) {
  const Blank blank = block_to_probe();
  const auto grid = grid_of(blank);
  ASSERT_TRUE(grid);
  const Workpiece workpiece(blank, *grid);
  const MillingTool tool = workpiece.milling_tool(probe_shape());
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int free = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const double distance = 0.5 * part(random);
    const ToolSolid wider = widened_probe(tool.solid, distance);
    const Vector tip(-4.0 + 28.0 * part(random), -4.0 + 24.0 * part(random),
                     -6.0 + 17.0 * part(random));
    if (workpiece.touches(wider, {tip, Vector::UnitZ()})) continue;
    ++free;
    const Vector way = Vector(part(random) - 0.5, part(random) - 0.5, part(random) - 0.5);
    const Vector there = tip + 0.999 * distance * way.normalized();
    EXPECT_FALSE(workpiece.touches(tool.solid, {there, Vector::UnitZ()}));
  }
  EXPECT_GT(free, 500);
}

TEST(SetterTouch, IsThatOfTheToolAtTheHeightOfTheDisc) {
  ToolShape shape;
  shape.kind = ToolKind::ball;
  shape.radius = 3.0;
  shape.flute_length = 20.0;
  const ToolSolid tool = solid_of(shape, 1e-3);
  const Disc disc{.top = {100.0, 50.0, 40.0}, .radius = 5.0, .height = 6.0};
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 20'000; ++trial) {
    const double beside = 10.0 * part(random);
    const double angle = 7.0 * part(random);
    const double z = 30.0 + 12.0 * part(random);
    const Vector tip(100.0 + beside * std::cos(angle), 50.0 + beside * std::sin(angle), z);
    // Widest where the tool is beside the disc: at the upper face, as the ball grows upwards.
    const double height = 40.0 - z;
    const double wide = height <= 0.0   ? -1.0
                        : height >= 3.0 ? 3.0
                                        : std::sqrt(9.0 - (3.0 - height) * (3.0 - height));
    const double gap = beside - 5.0 - wide;
    if (std::abs(gap) < 1e-6 || std::abs(height) < 1e-6) continue;
    EXPECT_EQ(touches(tool, {tip, Vector::UnitZ()}, disc), height > 0.0 && gap < 0.0)
        << beside << " " << z;
  }
  EXPECT_FALSE(touches(tool, {{100.0, 50.0, 39.0}, Vector::UnitX()}, disc));
}

}  // namespace
}  // namespace stanok::simulation
