// A part with known errors is cut in simulation, measured by the cycles, corrected and cut again.
//
// The errors: the part lies 0.37 and -0.21 mm beside the work offset, 0.05 mm above it and turned
// by 3 deg; the cutter is 0.025 mm thicker than the table of tools says, so that pockets become
// 0.05 mm too wide. Truth comes from the material itself, ray by ray, not from the probe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

constexpr double cut_spacing = 0.04;  // of the rays, mm
// What may be left on a wall between two positions of the cutter: along lines, and along arcs,
// which the path of a tool leaves by as much again (docs/programmer/workpiece.md).
constexpr double left_on_line = 0.1 * cut_spacing;
constexpr double left_on_arc = 0.2 * cut_spacing;
constexpr double micrometre = 1e-3;

const std::string cycles =
    "#include \"measure/features.nc\"\n#include \"measure/edges.nc\"\n#include "
    "\"measure/write.nc\"\n";
const std::string where_it_lies =
    "settable_zs (1, 2, X, 0.37);\nsettable_zs (1, 2, Y, -0.21);\nsettable_zs (1, 2, Z, 0.05);\n"
    "settable_zs (1, 2, \"R\", 3);\n";
const std::string blank = "G0 Z60\nG55\n#workpiece (0, 0.04, 0, 60, 26, 6, 30, 13, 6)\nG54\n";
// A circular pocket of 14 mm and a rectangular one of 20 x 12 mm, 4 mm deep.
const std::string pockets =
    "G0 Z50\nT1 M6\nG43\nS6000 M3\nF600\nG0 X-15 Y0 Z5\nG13 I7 Z-4 D1\nG0 Z5\n"
    "X14 Y0\nG1 Z-4\nG41 D1 G1 X24 F1200\nY6\nX4\nY-6\nX24\nY0\nG40 X14\nG0 Z50\n";
const std::string probe_in = "G53 G0 Z200\nT9 M6\nG43\nG0 Z20\n";

std::string measure_pockets(const std::string& which) {
  const auto tell = [&](const std::string& name, const std::string& result) {
    return "msg (\"" + name + which + "=\" + str (#<_measured_" + result + ">, 7));\n";
  };
  return "G0 X-15 Y0\nZ2\nmeasure_bore (14, -3.2);\n" + tell("bore", "size") + tell("bx", "x") +
         tell("by", "y") + "G0 X14 Y0\nmeasure_slot (X, 20, -3.2);\n" + tell("long", "size") +
         "measure_slot (Y, 12, -3.2);\n" + tell("wide", "size") + tell("wy", "y");
}

const std::string corner_until_it_stays =
    "num passes = 0;\ndo {\n  G0 X-30 Y-13\n  measure_outside_corner (1, 1, 5, 15, -4);\n"
    "  measure_write_offset (1);\n  passes += 1;\n} while (hypot (#<_measured_error_x>, "
    "#<_measured_error_y>) > 0.001 && passes < 6);\nmsg (\"passes=\" + str (passes));\n";

// The free stretch of a ray along X (0) or Y (1) about a place, at a height, in K.
double width_at(const simulation::Workpiece& workpiece, int axis, const simulation::Vector& at_K) {
  const simulation::Material& material = workpiece.material();
  const simulation::Grid& grid = material.grid();
  const auto index = [&](int k) {
    return static_cast<int>(std::floor((at_K[k] - grid.origin[k]) / grid.cell[k]));
  };
  const std::size_t ray = material.ray(axis, index((axis + 1) % 3), index((axis + 2) % 3));
  double below = -1e9;
  double above = 1e9;
  material.family(axis).visit(ray, [&](const simulation::Interval& piece) {
    if (piece.to <= at_K[axis]) below = std::max(below, static_cast<double>(piece.to));
    if (piece.from >= at_K[axis]) above = std::min(above, static_cast<double>(piece.from));
  });
  return above - below;
}

TEST(MeasuredCut, IsRightWhenItIsCutAgainWithWhatWasMeasuredFullSize) {
  MeasuringBench bench;
  bench.real_radius(1, 3.025);
  bench.options.workpieces = std::make_shared<SimulatedWorkpieces>(
      bench.options.file, simulation::memory_default,
      [](int, const std::string& code, const std::string& text) {
        ADD_FAILURE() << code << " " << text;
      });
  bench.run_to_end(
      cycles + where_it_lies + blank + probe_in + "X-20 Y-5\nZ3\nmeasure_surface (Z, 0);\n" +
      "measure_write_offset (1);\n" + corner_until_it_stays +
      "msg (\"x=\" + str (gettable_zs (1, 1, X), 7));\nmsg (\"y=\" + str (gettable_zs (1, 1, Y), "
      "7));\nmsg (\"z=\" + str (gettable_zs (1, 1, Z), 7));\nmsg (\"turn=\" + str (gettable_zs (1, "
      "1, \"R\"), 7));\n" +
      pockets + probe_in + measure_pockets("1") +
      "G0 X-15 Y0\nmeasure_bore (14, -3.2);\nmeasure_write_wear_radius (1);\n" +
      "msg (\"wear=\" + str (gettable_tool (1, 1, \"wear_radius\"), 7));\n" + blank + pockets +
      probe_in + measure_pockets("2") + "M30\n");

  // The offset: touches are late by the travel of a cycle at F30, half a micrometre, and the corner
  // hangs on two of them 15 mm apart, seen from up to 33 mm.
  constexpr double turn_off = 0.6 * micrometre / 15.0;
  EXPECT_NEAR(bench.found("turn"), 3.0, turn_off * 180.0 / std::numbers::pi);
  EXPECT_NEAR(bench.found("x"), 0.37, micrometre + 33.0 * turn_off);
  EXPECT_NEAR(bench.found("y"), -0.21, micrometre + 33.0 * turn_off);
  EXPECT_NEAR(bench.found("z"), 0.05, micrometre);
  EXPECT_LE(bench.found("passes"), 3.0);

  // The first part, wrong as the drawing of the errors says: 0.05 mm too wide.
  EXPECT_NEAR(bench.found("bore1"), 14.05, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(bench.found("long1"), 20.05, micrometre + 2.0 * left_on_line);
  EXPECT_NEAR(bench.found("wide1"), 12.05, micrometre + 2.0 * left_on_line);
  EXPECT_NEAR(bench.found("wear"), 0.025, micrometre + left_on_arc);

  // The second one is right, as the probe sees it ...
  EXPECT_NEAR(bench.found("bore2"), 14.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(bench.found("long2"), 20.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(bench.found("wide2"), 12.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(bench.found("bx2"), -15.0, micrometre + left_on_arc);
  EXPECT_NEAR(bench.found("by2"), 0.0, micrometre + left_on_arc);
  EXPECT_NEAR(bench.found("wy2"), 0.0, micrometre + left_on_line);

  // ... and as it is: what a ray through it finds.
  const auto& parts = bench.options.workpieces->feeds()[0]->follower().workpieces();
  ASSERT_EQ(parts.size(), 2U);
  bench.options.workpieces->feeds()[0]->follower().flush();
  const simulation::Vector in_bore(15.0, 13.0, 5.0);
  const simulation::Vector in_pocket(44.0, 13.0, 5.0);
  EXPECT_NEAR(width_at(*parts[0], 0, in_bore), 14.05, micrometre + 2.0 * left_on_arc);
  // The path itself is up to 1.8 um outside of the circle where the arc that leads in meets it,
  // within its tolerance; the probe finds what is there.
  EXPECT_LE(bench.found("bore1"), width_at(*parts[0], 0, in_bore) + micrometre);
  EXPECT_NEAR(width_at(*parts[1], 0, in_bore), 14.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(width_at(*parts[1], 1, in_bore), 14.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(width_at(*parts[1], 0, in_pocket), 20.0, micrometre + 2.0 * left_on_arc);
  EXPECT_NEAR(width_at(*parts[1], 1, in_pocket), 12.0, micrometre + 2.0 * left_on_arc);
}

// The walls of a pocket met from inside, near a corner that the cutter has rounded.
TEST(MeasuredCut, InsideCornersOfAPocketAreWhereItsWallsMeet) {
  MeasuringBench bench;
  bench.run_to_end(cycles + blank + pockets + probe_in +
                   "G0 X24 Y6\nZ4\nmeasure_inside_corner (-1, -1, 6, 0, -3.2);\n"
                   "msg (\"x=\" + str (#<_measured_x>, 7));\nmsg (\"y=\" + str (#<_measured_y>, "
                   "7));\nM30\n");
  EXPECT_NEAR(bench.found("x"), 24.0, micrometre + left_on_line);
  EXPECT_NEAR(bench.found("y"), 6.0, micrometre + left_on_line);
}

// A face that is milled at 25 deg is measured in the tilted plane, and in one of 26 deg, where it
// leans by 1 deg: about X, so that it rises along Y.
TEST(MeasuredCut, ATiltedPlaneIsMeasuredInItsOwnFrame) {
  MeasuringBench bench("trunnion.toml");
  bench.options.file.machine.channels[0].probe_input = 5;
  channels::ToolEdge probe;
  probe.number = 9;
  probe.kind = "probe";
  probe.length = 120.0;
  probe.radius = 2.0;
  probe.overhang = 60.0;
  bench.options.file.machine.tables.tools.push_back(probe);
  const auto plane = [](const std::string& angle) {
    return "G53 G0 Z0\nG68.2 X0 Y-30 Z0 I0 J" + angle + " K0\nG53.1\n";
  };
  const std::string probed = "G0 X-8 Y-10 Z30\nZ5\nmeasure_plane (0, 14, 7);\n";
  bench.run_to_end(cycles + "G54\n" +
                   "#workpiece (0, 0.1, 0, 40, 80, 60, 20, 40, 60)\nT2 M6\nS6000 M3\nG43\n" +
                   plane("25") +
                   "G0 X-30 Y-6 Z40\nG1 Z0 F2000\nX30\nG0 Z2\nY-14\nX-30\nG1 Z0\nX30\nG0 Z40\n"
                   "G69\nG53 G0 Z0\nT9 M6\nG43\n" +
                   plane("25") + probed +
                   "msg (\"z=\" + str (#<_measured_z>, 6));\nmsg (\"x25=\" + str "
                   "(#<_measured_angle_x>, 6));\nmsg (\"y25=\" + str (#<_measured_angle_y>, "
                   "6));\nG0 Z40\nG69\n" +
                   plane("26") + probed +
                   "msg (\"x26=\" + str (#<_measured_angle_x>, 6));\nmsg (\"y26=\" + str "
                   "(#<_measured_angle_y>, 6));\nG0 Z40\nG69\nM30\n");
  constexpr double floor_off = 0.01 + 2.0 * micrometre;  // a tenth of the resolution
  const double angle_off = floor_off / 7.0 * 180.0 / std::numbers::pi;
  EXPECT_NEAR(bench.found("z"), 0.0, floor_off);
  EXPECT_NEAR(bench.found("x25"), 0.0, angle_off);
  EXPECT_NEAR(bench.found("y25"), 0.0, angle_off);
  EXPECT_NEAR(bench.found("x26"), 0.0, angle_off);
  EXPECT_NEAR(bench.found("y26"), -1.0, angle_off);
}

// A floor that is too deep was made by a tool that is longer than the table says.
TEST(MeasuredCut, AFloorCorrectsTheLengthOfItsTool) {
  MeasuringBench bench;
  bench.options.file.simulation.tools.push_back({.number = 1, .length = 60.03});
  const std::string floor = "G0 X-15 Y0\nZ1\nmeasure_surface (Z, -4);\n";
  bench.run_to_end(cycles + blank + pockets + probe_in + floor +
                   "msg (\"z1=\" + str (#<_measured_z>, 7));\nmeasure_write_wear_length (1);\n"
                   "msg (\"wear=\" + str (gettable_tool (1, 1, \"wear_length\"), 7));\n" +
                   blank + pockets + probe_in + floor +
                   "msg (\"z2=\" + str (#<_measured_z>, 7));\nM30\n");
  EXPECT_NEAR(bench.found("z1"), -4.03, micrometre);
  EXPECT_NEAR(bench.found("wear"), 0.03, micrometre);
  EXPECT_NEAR(bench.found("z2"), -4.0, 2.0 * micrometre);
}

}  // namespace
}  // namespace stanok::runtime
