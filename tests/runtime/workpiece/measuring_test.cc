// The measuring cycles on the virtual clock: what they find against the drawing of the part.
//
// Blanks are exact: what the probe finds of them is late by the sagitta of its ball over the rays,
// resolution² / 4r, and by the travel of a cycle at the feed of the slow touches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recording/log/measurement_files.h"
#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

using ::testing::IsEmpty;

constexpr double spacing = 0.1;        // of the rays, mm
constexpr double probe_radius = 2.0;   // of tool 9
constexpr double slow_mm_per_s = 0.5;  // F30
// One touch is late by no more.
constexpr double late =
    spacing * spacing / (4.0 * probe_radius) + slow_mm_per_s * MeasuringBench::cycle_s + 1e-6;

const std::string head =
    "#include \"measure/features.nc\"\n#include \"measure/edges.nc\"\n#include "
    "\"measure/write.nc\"\n#include \"measure/tools.nc\"\n";

// Lines that tell results by their names.
std::string tell(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += "msg (\"" + name + "=\" + str (#<_measured_" + name + ">, 7));\n";
  return text;
}

struct Frame {
  const char* name;
  const char* begin;  // blocks before the blank, which lies in the frame that they make
};

// Everything is measured in the frame of the program: turned, shifted, of another work offset.
class MeasuredIn : public ::testing::TestWithParam<Frame> {
 protected:
  static std::string program(const std::string& blank, const std::string& cycles) {
    return head + GetParam().begin + blank + "T9 M6\nG43\nG0 Z30\n" + cycles + "M30\n";
  }
};

const std::string box = "#workpiece (0, 0.1, 0, 40, 30, 10, 20, 15, 10)\n";

TEST_P(MeasuredIn, Surfaces) {
  MeasuringBench bench;
  bench.run_to_end(program(
      box, "X1 Y2\nZ5\nmeasure_surface (Z, 0.3);\n" + tell({"z", "error_z"}) +
               "G0 X26 Y3\nZ-5\nmeasure_surface (X, 19);\n" + tell({"x", "error_x"}) +
               "G0 Z20\nX2 Y-20\nZ-5\nmeasure_surface (Y, -16);\n" + tell({"y", "error_y"})));
  EXPECT_NEAR(bench.found("z"), 0.0, late);
  EXPECT_NEAR(bench.found("error_z"), -0.3, late);
  EXPECT_NEAR(bench.found("x"), 20.0, late);
  EXPECT_NEAR(bench.found("error_x"), 1.0, late);
  EXPECT_NEAR(bench.found("y"), -15.0, late);
  EXPECT_NEAR(bench.found("error_y"), 1.0, late);
}

TEST_P(MeasuredIn, Webs) {
  MeasuringBench bench;
  bench.run_to_end(program(box, "X0.4 Y0.3\nZ5\nmeasure_web (X, 39.5, -5);\n" +
                                    tell({"x", "error_x", "size", "size_error"}) +
                                    "measure_web (Y, 30, -5);\nmsg (\"width=\" + str "
                                    "(#<_measured_size>, 7));\n" +
                                    tell({"y"})));
  EXPECT_NEAR(bench.found("x"), 0.0, late);
  EXPECT_NEAR(bench.found("error_x"), -0.4, late);
  EXPECT_NEAR(bench.found("size"), 40.0, 2.0 * late);
  EXPECT_NEAR(bench.found("size_error"), 0.5, 2.0 * late);
  EXPECT_NEAR(bench.found("y"), 0.0, late);
  EXPECT_NEAR(bench.found("width"), 30.0, 2.0 * late);
}

const std::string tube = "#workpiece (1, 0.1, 0, 50, 24, 12, 0, 0, 12)\n";

// The walls of a bore are met by rays that lie side by side: the ball finds them as late.
TEST_P(MeasuredIn, BoreAndBossFromBesideTheirMiddle) {
  MeasuringBench bench;
  bench.run_to_end(program(
      tube,
      "X0.7 Y-0.5\nZ2\nmeasure_bore (24.2, -4);\n" + tell({"x", "y", "size"}) +
          "G0 X-0.6 Y0.8\nZ5\nmeasure_boss (49.7, -6);\nmsg (\"boss=\" + str "
          "(#<_measured_size>, 7));\nmsg (\"bx=\" + str (#<_measured_x>, 7));\nmsg (\"by=\" + "
          "str (#<_measured_y>, 7));\nmsg (\"bex=\" + str (#<_measured_error_x>, 7));\n"));
  EXPECT_NEAR(bench.found("x"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("y"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("size"), 24.0, 2.0 * late + 2e-4);
  EXPECT_NEAR(bench.found("bx"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("by"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("bex"), 0.6, late + 1e-4);
  EXPECT_NEAR(bench.found("boss"), 50.0, 2.0 * late + 2e-4);
}

// A ball of 16 mm of which what the probe meets is exact: a pin with the round of the ball as steps
// inside of it, the highest one flat at its top. Its middle is 8 mm below the top. The first pass
// is 0.3 mm too high.
TEST_P(MeasuredIn, ASphere) {
  MeasuringBench bench;
  std::string steps = "T2 M6\nG43\nS6000 M3\nF4000\nG0 Z5\nX-20 Y0\n";
  for (int k = 2; k < 8; ++k) {
    const double above = 8.0 - k;  // the middle
    const double radius = std::sqrt(64.0 - (above + 1.0) * (above + 1.0)) + 5.0;
    const std::string at = std::to_string(-radius);
    steps += "G1 Z" + std::to_string(-k) + "\nX" + at + "\nG2 I" + std::to_string(radius) +
             "\nG1 X-20\n";
  }
  bench.run_to_end(program("#workpiece (1, 0.1, 0, 16, 0, 20, 0, 0, 20)\n" + steps + "G0 Z30\n",
                           "X0.4 Y-0.3\nZ6\nmeasure_sphere (15.8, 0.2);\n" +
                               tell({"x", "y", "z", "error_x", "error_z", "size", "size_error"})));
  EXPECT_NEAR(bench.found("x"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("y"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("z"), -8.0, 2.0 * late);
  EXPECT_NEAR(bench.found("error_x"), -0.4, late + 1e-4);
  EXPECT_NEAR(bench.found("error_z"), -0.3, 2.0 * late);
  EXPECT_NEAR(bench.found("size"), 16.0, 2.0 * late + 2e-4);
  EXPECT_NEAR(bench.found("size_error"), 0.2, 2.0 * late + 2e-4);
}

// A slot is the inside of a pair: between the walls of the tube along X.
TEST_P(MeasuredIn, SlotAcrossY) {
  MeasuringBench bench;
  bench.run_to_end(
      program(tube, "X0 Y0.9\nZ2\nmeasure_slot (Y, 23.5, -4);\n" + tell({"y", "size"})));
  EXPECT_NEAR(bench.found("y"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("size"), 24.0, 2.0 * late + 2e-4);
}

// Seen from each corner of the block: the part lies to the other sides.
TEST_P(MeasuredIn, OutsideCorners) {
  for (const int side_x : {-1, 1}) {
    for (const int side_y : {-1, 1}) {
      MeasuringBench bench;
      const auto text = [](double value) { return std::to_string(value); };
      bench.run_to_end(
          program(box, "X" + text(-20.0 * side_x + 0.3) + " Y" + text(-15.0 * side_y - 0.2) +
                           "\nZ5\nmeasure_outside_corner (" + text(side_x) + ", " + text(side_y) +
                           ", 4, 8, -5);\n" + tell({"x", "y", "error_x", "angle"})));
      EXPECT_NEAR(bench.found("x"), -20.0 * side_x, 1.5 * late);
      EXPECT_NEAR(bench.found("y"), -15.0 * side_y, 1.5 * late);
      EXPECT_NEAR(bench.found("error_x"), -0.3, 1.5 * late);
      EXPECT_NEAR(bench.found("angle"), 0.0, late / 8.0 * 180.0 / std::numbers::pi);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Frames, MeasuredIn,
    ::testing::Values(Frame{"asItStands", "G54\n"},
                      Frame{"shifted",
                            "settable_zs (1, 2, X, 31.7);\nsettable_zs (1, 2, Y, "
                            "-12.3);\nsettable_zs (1, 2, Z, 4.5);\nG55\n"},
                      Frame{"turned",
                            "settable_zs (1, 1, X, 5.5);\nsettable_zs (1, 1, \"R\", "
                            "37);\nG54\n"},
                      Frame{"rotated", "G52 X3 Y-4\nG68 X1 Y2 R-21.5\n"}),
    [](const auto& frame) { return std::string(frame.param.name); });

// The block is turned by an angle in the table's eyes, the program does not know of it.
TEST(Measuring, FindsAngleAndCornerOfATurnedBlock) {
  constexpr double turn = 3.0;
  MeasuringBench bench;
  bench.run_to_end(
      head +
      "settable_zs (1, 2, \"R\", 3);\nsettable_zs (1, 2, X, 0.37);\nsettable_zs (1, 2, "
      "Y, -0.21);\nG55\n" +
      box +
      "G54\nT9 M6\nG43\nG0 Z30\nX-20 Y-15\nZ5\n"
      "measure_outside_corner (1, 1, 5, 16, -5);\n" +
      tell({"x", "y", "angle", "angle_y"}) +
      "G0 X-19 Y-5\nmeasure_angle (X, 1, 12, -5);\nmsg (\"edge=\" + str "
      "(#<_measured_angle>, 7));\nM30\n");
  const double c = std::cos(turn * std::numbers::pi / 180.0);
  const double s = std::sin(turn * std::numbers::pi / 180.0);
  const double angle_late = late / 12.0 * 180.0 / std::numbers::pi;
  EXPECT_NEAR(bench.found("x"), 0.37 - 20.0 * c + 15.0 * s, 2.0 * late);
  EXPECT_NEAR(bench.found("y"), -0.21 - 20.0 * s - 15.0 * c, 2.0 * late);
  EXPECT_NEAR(bench.found("angle"), turn, angle_late);
  EXPECT_NEAR(bench.found("angle_y"), turn, angle_late);
  EXPECT_NEAR(bench.found("edge"), turn, angle_late);
}

// Leaning about X by 1.5 deg (theta), and about Z first (psi), so that both slopes are there.
TEST(Measuring, FindsAPlaneThatLeans) {
  constexpr double rad = std::numbers::pi / 180.0;
  MeasuringBench bench;
  bench.run_to_end(head + box +
                   "#workpiece_pos (0, 0, 1, 30, 1.5, 0)\nT9 M6\nG43\nG0 Z30\nX-8 Y-7\nZ6\n"
                   "measure_plane (1, 14, 12);\n" +
                   tell({"z", "normal_x", "normal_y", "normal_z", "angle_x", "angle_y"}) + "M30\n");
  // Z'' of Z-X'-Z'': (sin psi sin theta, -cos psi sin theta, cos theta).
  const double n_x = std::sin(30.0 * rad) * std::sin(1.5 * rad);
  const double n_y = -std::cos(30.0 * rad) * std::sin(1.5 * rad);
  const double n_z = std::cos(1.5 * rad);
  const double slope_late = 2.0 * late / 12.0;
  EXPECT_NEAR(bench.found("normal_x"), n_x, slope_late);
  EXPECT_NEAR(bench.found("normal_y"), n_y, slope_late);
  EXPECT_NEAR(bench.found("normal_z"), n_z, slope_late);
  EXPECT_NEAR(bench.found("angle_x"), std::atan(-n_x / n_z) / rad, slope_late / rad);
  EXPECT_NEAR(bench.found("angle_y"), std::atan(-n_y / n_z) / rad, slope_late / rad);
  EXPECT_NEAR(bench.found("z"), 1.0 - (n_x * -8.0 + n_y * -7.0) / n_z, 2.0 * late);
}

// The program lies on the plane that was found: the same touches find it flat and at its height.
// The ball still touches along the normal, from the side, so its lowest point is r (1 - n_z) too
// high.
TEST(Measuring, LaysTheProgramOnThePlaneThatWasFound) {
  MeasuringBench bench;
  bench.run_to_end(head + box +
                   "#workpiece_pos (0, 0, 1, 30, 1.5, 0)\nT9 M6\nG43\nG0 Z30\nX-8 Y-7\nZ6\n"
                   "measure_plane (1.2, 14, 12);\nmeasure_write_set_up ();\n"
                   "G0 X-8 Y-7 Z6\nmeasure_plane (1.2, 14, 12);\n" +
                   tell({"error_z", "angle_x", "angle_y"}) + "M30\n");
  constexpr double rad = std::numbers::pi / 180.0;
  const double slope_late = 4.0 * late / 12.0;
  EXPECT_NEAR(bench.found("angle_x"), 0.0, slope_late / rad);
  EXPECT_NEAR(bench.found("angle_y"), 0.0, slope_late / rad);
  EXPECT_NEAR(bench.found("error_z"), probe_radius * (1.0 - std::cos(1.5 * rad)), 4.0 * late);
}

TEST(Measuring, CountsInInches) {
  MeasuringBench bench;
  bench.run_to_end(head + box +
                   "T9 M6\nG43\nG0 Z30\nX0.4 Y0.3\nZ5\nG20\nmeasure_web (X, 1.55, -0.2);\n" +
                   tell({"x", "size"}) + "G21\nM30\n");
  EXPECT_NEAR(bench.found("x"), 0.0, late / 25.4);
  EXPECT_NEAR(bench.found("size"), 40.0 / 25.4, 2.0 * late / 25.4);
}

// The modal state is the one from before, and the axes stand where they stood.
TEST(Measuring, LeavesModesAndPlaceAsTheyWere) {
  MeasuringBench bench;
  bench.run_to_end(
      head + tube +
      "T9 M6\nG43\nG0 Z30\nX0.7 Y-0.5\nZ2\nF123 G91\nmeasure_bore (24, -4);\n"
      "msg (\"g3=\" + str ($g[3]));\nmsg (\"feed=\" + str ($feed));\n"
      "msg (\"px=\" + str ($prog_pos[X], 6));\nmsg (\"pz=\" + str ($prog_pos[Z], 6));\n"
      "M30\n");
  EXPECT_EQ(bench.found("g3"), 91.0);
  EXPECT_EQ(bench.found("feed"), 123.0);
  EXPECT_NEAR(bench.found("px"), 0.7, 1e-6);
  EXPECT_NEAR(bench.found("pz"), 2.0, 1e-6);
}

// The report is in mm, whatever the units of the program.
TEST(Measuring, LeavesALineOfTheReportForEachCycle) {
  class Report final : public CycleObserver {
   public:
    void observe(const channels::CycleOutput& /*output*/) override {}
    void observe(const channels::Event& event) override {
      if (const auto one = recording::measurement_of(event.text.view())) lines.push_back(*one);
    }
    std::vector<recording::Measurement> lines;
  };
  MeasuringBench bench;
  Report report;
  bench.observers = {&report};
  bench.run_to_end(head + tube +
                   "T9 M6\nG43\nG0 Z30\nX0.7 Y-0.5\nZ2\nG20\nmeasure_bore (0.95, -0.16);\n"
                   "measure_slot (X, 0.94, -0.16);\nG21\nG0 X18 Z4\nmeasure_surface (Z, 0.1);\n"
                   "measure_plane (0, -1, 1);\nM30\n");
  ASSERT_EQ(report.lines.size(), 4U);
  EXPECT_EQ(report.lines[0].feature, "bore");
  EXPECT_NEAR(report.lines[0].values.at("size"), 24.0, 2.0 * late + 1e-3);
  EXPECT_NEAR(report.lines[0].values.at("error_size"), 24.0 - 0.95 * 25.4, 2.0 * late + 1e-3);
  EXPECT_NEAR(report.lines[0].values.at("error_x"), -0.7, late + 1e-3);
  EXPECT_EQ(report.lines[1].feature, "slot");
  EXPECT_EQ(report.lines[2].feature, "surface_z");
  EXPECT_NEAR(report.lines[2].values.at("error_z"), -0.1, late);
  EXPECT_EQ(report.lines[3].feature, "plane");
}

// What is off at the probe comes out of a ring: ball too small in the table, hanging beside.
TEST(Measuring, CalibratesTheProbeInARingAndAtAFace) {
  MeasuringBench bench;
  bench.options.file.simulation.tools.push_back(
      {.number = 9, .length = 110.042, .length_x = 0.013, .length_y = -0.021, .radius = 1.993});
  bench.run_to_end(
      head + tube +
      "T9 M6\nG43\nG0 Z30\nX0 Y0\nZ2\nmeasure_calibrate_ring (24, -4);\nG43\n"
      "G0 X0 Y0 Z4\nX18\nmeasure_calibrate_length (0);\nG43\n"
      "G0 X0 Y0 Z2\nmeasure_bore (24, -4);\n" +
      tell({"x", "y", "size"}) + "G0 X-18 Z3\nmeasure_surface (Z, 0);\n" + tell({"z"}) +
      "msg (\"radius=\" + str (gettable_tool (9, 1, \"radius\") + gettable_tool (9, 1, "
      "\"wear_radius\"), 6));\n"
      "msg (\"lx=\" + str (gettable_tool (9, 1, \"wear_length_x\"), 6));\n"
      "msg (\"ly=\" + str (gettable_tool (9, 1, \"length_y\"), 6));\n"
      "msg (\"length=\" + str (gettable_tool (9, 1, \"length\") + gettable_tool (9, 1, "
      "\"wear_length\"), 6));\nM30\n");
  EXPECT_NEAR(bench.found("radius"), 1.993, 2.0 * late);
  EXPECT_NEAR(bench.found("lx"), 0.013, late + 1e-4);
  EXPECT_NEAR(bench.found("ly"), -0.021, late + 1e-4);
  EXPECT_NEAR(bench.found("length"), 110.042, late);
  EXPECT_NEAR(bench.found("x"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("y"), 0.0, late + 1e-4);
  EXPECT_NEAR(bench.found("size"), 24.0, 4.0 * late);
  EXPECT_NEAR(bench.found("z"), 0.0, 2.0 * late);
}

TEST(Measuring, MeasuresToolsAtTheSetter) {
  MeasuringBench bench;
  bench.options.file.simulation.tools.push_back({.number = 2, .length = 75.123, .radius = 4.981});
  const double cycle = slow_mm_per_s * MeasuringBench::cycle_s + 1e-6;
  bench.run_to_end(head + "T2 M6\nG43\nG0 Z150\nX10 Y20\nmeasure_tool_length ();\n" +
                   tell({"size", "size_error"}) +
                   "measure_write_tool_length ();\nG43\n"
                   "measure_tool_radius (12, 4);\nmsg (\"radius=\" + str (#<_measured_size>, 7));\n"
                   "measure_write_tool_radius ();\n"
                   "msg (\"wl=\" + str (gettable_tool (2, 1, \"wear_length\"), 7));\n"
                   "msg (\"wr=\" + str (gettable_tool (2, 1, \"wear_radius\"), 7));\n"
                   "msg (\"broken=\" + str (measure_is_broken (0.5) ? 1 : 0));\n"
                   "msg (\"offset=\" + str ($g[12]));\nmsg (\"h=\" + str ($g[8]));\nM30\n");
  EXPECT_NEAR(bench.found("size"), 75.123, cycle);
  EXPECT_NEAR(bench.found("size_error"), 0.123, cycle);
  EXPECT_NEAR(bench.found("radius"), 4.981, cycle);
  EXPECT_NEAR(bench.found("wl"), 0.123, cycle);
  EXPECT_NEAR(bench.found("wr"), -0.019, cycle);
  EXPECT_EQ(bench.found("broken"), 0.0);
  EXPECT_EQ(bench.found("offset"), 54.0);
  EXPECT_EQ(bench.found("h"), 43.0);
}

// G37 corrects by one touch: late by the travel of a cycle at its feed of 100 mm/min.
TEST(Measuring, CorrectsTheOffsetInForceInOneBlock) {
  for (const double length : {75.123, 73.4, 76.9}) {
    SCOPED_TRACE(length);
    MeasuringBench bench;
    bench.options.file.simulation.tools.push_back({.number = 2, .length = length});
    const double cycle = 100.0 / 60.0 * MeasuringBench::cycle_s + 1e-6;
    bench.run_to_end(head +
                     "T2 M6\nG43\nG0 Z150\nG59.3 X0 Y0\nG37 Z0\n"
                     "msg (\"z=\" + str ($prog_pos[Z], 7));\nG0 Z150\nG37 Z0\nG0 Z150\n"
                     "msg (\"wl=\" + str (gettable_tool (2, 1, \"wear_length\"), 7));\nM30\n");
    EXPECT_NEAR(bench.found("wl"), length - 75.0, cycle);
    EXPECT_NEAR(bench.found("z"), 0.0, 0.02);  // with the way to rest
  }
}

TEST(Measuring, FindsABrokenTool) {
  MeasuringBench bench;
  bench.options.file.simulation.tools.push_back({.number = 2, .length = 71.0});
  bench.run_to_end(
      head +
      "T2 M6\nG43\nG0 Z150\nmsg (\"broken=\" + str (measure_is_broken (0.5) ? 1 : 0));\n"
      "msg (\"length=\" + str ($tool_length, 6));\nM30\n");
  EXPECT_EQ(bench.found("broken"), 1.0);
  EXPECT_EQ(bench.found("length"), 75.0);
}

}  // namespace
}  // namespace stanok::runtime
