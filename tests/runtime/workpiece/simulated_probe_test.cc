// The simulated probe: G38 finds the faces of the virtual workpiece and of the tool setter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "runtime/log_observer.h"
#include "runtime/replay.h"
#include "tests/runtime/workpiece/measuring_bench.h"

namespace stanok::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double ray_distance = 0.1;
constexpr double ball = 2.0;
// What the ball reaches over the nearest ray, and the travel of a cycle at F60.
constexpr double late_max = ray_distance * ray_distance / (4.0 * ball) + MeasuringBench::cycle_s;

// A block of 40 x 30 x 10 with the zero in the middle of its upper face.
const std::string block_of_forty =
    "#workpiece (0, 0.1, 0, 40, 30, 10, 20, 15, 10)\nT9 M6\nG43\nF60\n";

TEST(SimulatedProbe, FindsTheFacesOfTheBlankWithBallAndTip) {
  MeasuringBench bench;
  bench.run_to_end(block_of_forty +
                   "G0 Z20\nX3.33 Y-2.22 Z2\nG38.2 Z-2\nmsg (\"z=\" + str ($probe[Z], 6));\n"
                   "G0 Z20\nX-24 Y4.44\nZ-5\nG38.2 X-15\nmsg (\"x=\" + str ($probe[X], 6));\n"
                   "G0 X-24\nZ20\nX1 Y19\nZ-4.2\nG38.2 Y10\nmsg (\"y=\" + str ($probe[Y], 6));\n"
                   "M30\n");
  EXPECT_LE(bench.found("z"), 0.0);
  EXPECT_GE(bench.found("z"), -late_max);
  EXPECT_GE(bench.found("x"), -20.0 - ball);
  EXPECT_LE(bench.found("x"), -20.0 - ball + late_max);
  EXPECT_LE(bench.found("y"), 15.0 + ball);
  EXPECT_GE(bench.found("y"), 15.0 + ball - late_max);
}

// At an edge the ball is round: h over the face, a beside it, (a² + (r - h)² = r²).
TEST(SimulatedProbe, TouchesAnEdgeWithTheRoundOfTheBall) {
  MeasuringBench bench;
  bench.run_to_end(block_of_forty +
                   "G0 Z20\nX-21.2 Y0 Z5\nG38.2 Z-4\nmsg (\"z=\" + str ($probe[Z], 6));\nM30\n");
  const double height = -(ball - std::sqrt(ball * ball - 1.2 * 1.2));
  EXPECT_LE(bench.found("z"), height + 1e-9);
  // The outermost ray lies half of the resolution inside of the edge.
  const double beside = 1.2 + ray_distance / 2.0;
  EXPECT_GE(bench.found("z"), -(ball - std::sqrt(ball * ball - beside * beside)) - late_max);
}

// Cut by a tool, then measured: a floor at -3, and a wall where the flank has been.
TEST(SimulatedProbe, FindsWhatIsLeftAfterACut) {
  MeasuringBench bench;
  bench.run_to_end(
      "#workpiece (0, 0.1, 0, 40, 30, 10, 20, 15, 10)\nT2 M6\nG43\nS3000 M3\nF3000\n"
      "G0 X-30 Y0 Z10\nZ-3\nG1 X30\nG0 Z50\nT9 M6\nG43\nF60\n"
      "G0 X0.5 Y0 Z0\nG38.2 Z-5\nmsg (\"floor=\" + str ($probe[Z], 6));\n"
      "G0 Z-2\nG38.2 Y10\nmsg (\"wall=\" + str ($probe[Y], 6));\nM30\n");
  EXPECT_LE(bench.found("floor"), -3.0 + 1e-6);
  EXPECT_GE(bench.found("floor"), -3.0 - late_max);
  EXPECT_LE(bench.found("wall"), 5.0 - ball + late_max);
  EXPECT_GE(bench.found("wall"), 5.0 - ball - 0.1 * ray_distance);
}

TEST(SimulatedProbe, CutsNothingAndIsNotSwitchedByOtherTools) {
  MeasuringBench bench;
  bench.run(
      "#workpiece (0, 0.1, 0, 40, 30, 10, 20, 15, 10)\nT2 M6\nG43\nS3000 M3\nF600\n"
      "G0 X0 Y0 Z5\nG38.3 Z-2\nmsg (\"mill=\" + str ($probe_ok ? 1 : 0));\n"
      "G0 Z50\nT9 M6\nG43\nG0 X10 Y10 Z5\n"
      "G38.2 Z-5 F60\nmsg (\"z=\" + str ($probe[Z], 6));\nM30\n");
  EXPECT_THAT(bench.alarms, IsEmpty());
  EXPECT_EQ(bench.found("mill"), 0.0);
  EXPECT_NEAR(bench.found("z"), 0.0, late_max);
}

// Down on the part at rapid is a finding of its block, once; back from a touch at rapid, which
// begins on the part, is none.
TEST(SimulatedProbe, TellsOfAProbeThatMeetsThePartAtRapid) {
  MeasuringBench bench;
  bench.options.workpieces = std::make_shared<SimulatedWorkpieces>(
      bench.options.file, simulation::memory_default,
      [](int, const std::string& code, const std::string& text) {
        ADD_FAILURE() << code << " " << text;
      });
  bench.run(block_of_forty + "G0 Z20\nX3 Y2 Z2\nG38.2 Z-2\nG0 Z20\nG0 Z-1\nG0 Z20\nM30\n");
  EXPECT_THAT(bench.alarms, ElementsAre("E4326"));
  const auto& workpieces = bench.options.workpieces->feeds()[0]->follower().workpieces();
  ASSERT_EQ(workpieces.size(), 1U);
  const auto findings = workpieces[0]->report().findings();
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(simulation::code_of(findings[0].kind), "W927");
  EXPECT_EQ(findings[0].origin.line, 9U);
  EXPECT_EQ(findings[0].tool, 9);
  EXPECT_LT(findings[0].place_K.z(), 10.0);
  EXPECT_GT(findings[0].place_K.z(), 9.0);
  EXPECT_GT(findings[0].time_s, 1.0);
}

TEST(SimulatedProbe, WithoutAPartNeverTouches) {
  MeasuringBench bench;
  bench.run("T9 M6\nG43\nG0 Z5\nG38.2 Z-5 F600\nM30\n");
  EXPECT_THAT(bench.alarms, ElementsAre("E4320"));
}

// The drives lag behind their setpoints: what touches is the ball where they really stand.
TEST(SimulatedProbe, TouchesWhereTheDrivesStand) {
  MeasuringBench bench;
  bench.options.drives = DriveChoice::simulated;
  bench.run_to_end(block_of_forty +
                   "G0 Z20\nX3 Y2 Z2\nG38.2 Z-2\nmsg (\"z=\" + str ($probe[Z], 6));\nM30\n");
  EXPECT_LE(bench.found("z"), 1e-6);
  EXPECT_GE(bench.found("z"), -late_max);
}

TEST(SimulatedProbe, IsTheSameToTheBitEachTimeAndInTheReplayOfItsLog) {
  MeasuringBench first;
  MeasuringBench second;
  const std::string program = block_of_forty +
                              "G0 Z20\nX-24 Y4.44\nZ-5\nG38.2 X-15\n"
                              "msg (\"x=\" + str ($probe[X]));\nM30\n";
  const std::filesystem::path log = first.folder.path() / "run.lcm";
  LogObserver recorder(first.options.file, setup_of(first.options), log, "test");
  first.observers = {&recorder};
  first.run_to_end(program);
  ASSERT_EQ(recorder.close(), "");
  second.run_to_end(program);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(first.found("x")),
            std::bit_cast<std::uint64_t>(second.found("x")));
  EXPECT_EQ(first.result.cycles, second.result.cycles);
  const ReplayResult replayed = replay(log, {});
  EXPECT_TRUE(replayed.is_same());
  EXPECT_GT(replayed.setpoints, 1000);
}

// The setter: its upper face is at Z30 of the machine, and tools are as long as they really are.
TEST(SimulatedProbe, SetterFindsTheRealLengthAndRadiusOfATool) {
  MeasuringBench bench;
  bench.options.file.simulation.tools.push_back({.number = 2, .length = 75.031, .radius = 4.987});
  bench.run_to_end(
      "T2 M6\nG0 X200 Y100 Z110\nG38.2 Z100 F60\nmsg (\"z=\" + str ($probe[Z], 6));\n"
      "G0 Z120\nX185\nZ102\nG38.2 X200\nmsg (\"x=\" + str ($probe[X], 6));\nM30\n");
  EXPECT_LE(bench.found("z"), 30.0 + 75.031);
  EXPECT_GE(bench.found("z"), 30.0 + 75.031 - MeasuringBench::cycle_s);
  EXPECT_GE(bench.found("x"), 200.0 - 6.0 - 4.987);
  EXPECT_LE(bench.found("x"), 200.0 - 6.0 - 4.987 + MeasuringBench::cycle_s);
}

// What a program writes of a tool that really is as it is changes nothing of it.
TEST(SimulatedProbe, RealToolsStayWhatTheyAre) {
  MeasuringBench bench;
  bench.real_radius(9, 2.5);
  bench.run_to_end(block_of_forty +
                   "settable_tool (9, 1, \"radius\", 1);\nsettable_tool (9, 1, \"wear_radius\", "
                   "0.3);\nG0 Z20\nX-24 Y0\nZ-5\nG38.2 X-15\nmsg (\"x=\" + str ($probe[X], 6));\n"
                   "M30\n");
  EXPECT_GE(bench.found("x"), -20.0 - 2.5);
  EXPECT_LE(bench.found("x"), -20.0 - 2.5 + late_max);
}

}  // namespace
}  // namespace stanok::runtime
