// Swept blocks per second of the virtual workpiece, and what its surface costs.
#include <benchmark/benchmark.h>

#include <cmath>

#include "simulation/surface_mesh.h"
#include "simulation/workpiece.h"

namespace stanok::simulation {
namespace {

// The blank and the ball mill of the impeller: 52 x 86 x 34 mm, diameter 6.
Blank impeller_blank(double resolution) {
  Blank blank;
  blank.size = {52.0, 86.0, 34.0};
  blank.resolution = resolution;
  return blank;
}

ToolShape ball_mill() {
  ToolShape tool;
  tool.kind = ToolKind::ball;
  tool.radius = 3.0;
  tool.flute_length = 15.0;
  tool.overhang = 30.0;
  tool.shank_diameter = 6.0;
  tool.holder_diameter = 40.0;
  tool.holder_length = 45.0;
  return tool;
}

// Along a bent surface in zigzag, blocks of 0.2 mm, rows 0.25 mm apart, the axis leaning with it.
ToolPlace place_on_surface(double way) {
  constexpr double row_length = 80.0;
  const double row = std::floor(way / row_length);
  const double along = way - row * row_length;
  const double y = static_cast<long>(row) % 2 == 0 ? 3.0 + along : 83.0 - along;
  const double x = std::fmod(3.0 + 0.25 * row, 46.0);
  const Vector tip(x, y, 26.0 - 0.004 * x * x - 4.0 * std::sin(y / 30.0));
  return {tip, Vector(0.2 + 0.004 * x, 0.1 * std::cos(y / 30.0), 1.0).normalized()};
}

void sweep_five_axis_blocks(benchmark::State& state) {
  const double resolution = static_cast<double>(state.range(0)) * 0.01;
  const Blank blank = impeller_blank(resolution);
  Workpiece workpiece(blank, *grid_of(blank));
  const MillingTool tool = workpiece.milling_tool(ball_mill());
  Circumstances circumstances;
  circumstances.shares = {{}};
  ToolPlace place = place_on_surface(0.0);
  double way = 0.0;
  std::uint64_t block = 0;
  for ([[maybe_unused]] auto _ : state) {
    way += 0.2;
    circumstances.shares.front().origin.block = ++block;
    const ToolPlace next = place_on_surface(way);
    workpiece.mill(tool, place, next, circumstances);
    place = next;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(sweep_five_axis_blocks)->Arg(40)->Arg(20)->Arg(10)->Iterations(60000);

void turn_a_pass(benchmark::State& state) {
  Blank blank;
  blank.kind = BlankKind::cylinder;
  blank.size = {60.0, 0.0, 100.0};
  blank.resolution = 0.2;
  Workpiece workpiece(blank, *grid_of(blank));
  ToolShape shape;
  shape.kind = ToolKind::insert;
  shape.radius = 0.8;
  shape.orientation = 2;
  const TurningTool tool = workpiece.turning_tool(shape, DirectionOfZ::same);
  Circumstances circumstances;
  circumstances.shares = {{}};
  double z = 100.0;
  double x = 29.9;
  for ([[maybe_unused]] auto _ : state) {
    workpiece.turn(tool, {}, {z, x}, {z - 0.5, x}, circumstances);
    z -= 0.5;
    if (z < 20.0) {
      z = 100.0;
      x = x > 8.0 ? x - 0.5 : 29.9;
    }
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(turn_a_pass);

void surface(benchmark::State& state) {
  const Blank blank = impeller_blank(static_cast<double>(state.range(0)) * 0.01);
  const Workpiece workpiece(blank, *grid_of(blank));
  std::size_t triangles = 0;
  for ([[maybe_unused]] auto _ : state)
    triangles = surface_of(workpiece.material()).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(surface)->Arg(40)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stanok::simulation
