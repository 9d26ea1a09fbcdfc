// Blanks from STL files through the whole chain: found beneath the program root, cut in a
// simulation, touched by the simulated probe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "lang/contract/blank_file.h"
#include "lang/program/compile.h"
#include "runtime/program_files.h"
#include "simulation/removed_volume.h"
#include "tests/runtime/workpiece/measuring_bench.h"
#include "tests/support/stl_text.h"

namespace stanok::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace stanok::testing;

class StlBlank : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) {
    std::filesystem::create_directories((bench.folder.path() / name).parent_path());
    std::ofstream(bench.folder.path() / name, std::ios::binary) << bytes;
  }
  void cut_in_simulation() {
    bench.options.workpieces = std::make_shared<SimulatedWorkpieces>(
        bench.options.file, simulation::memory_default,
        [this](int, const std::string& code, const std::string& text) {
          complaints.push_back(code + " " + text);
        });
  }
  [[nodiscard]] const simulation::Workpiece& part() {
    return *bench.options.workpieces->feeds()[0]->follower().workpieces().at(0);
  }
  // What a program is refused for when it is loaded, with its place; "" is loaded.
  [[nodiscard]] std::string refusal(const std::string& line) {
    write("refused.nc", line + "\nM30\n");
    const ProgramFiles files({bench.folder.path()}, {.bytes_max = 1 << 20, .encoding = ""});
    Diagnostics warnings;
    const auto program = lang::compile("refused.nc", files, nullptr, warnings);
    if (program) return "";
    const Diagnostic& first = program.error().front();
    return first.code + " " + std::to_string(first.place.line) + ":" +
           std::to_string(first.place.column) + " " + first.message +
           (first.help.empty() ? "" : " | " + first.help.front());
  }

  MeasuringBench bench;
  std::vector<std::string> complaints;
};

constexpr const char* slot_at_minus_3 =
    "T2 M6\nG43\nS3000 M3\nF3000\nG0 X-30 Y0 Z10\nZ-3\nG1 X30\nG0 Z50\nM30\n";

// A slot of the width of tool 2, 10 mm, over 40 mm, 3 mm deep; what the file says is a box of
// 40 x 30 x 10, its zero in the middle of the upper face.
TEST_F(StlBlank, IsCutAsABoxOfItsSizeIs) {
  write("blanks/box.stl", binary_stl(stl_box({0.0, 0.0, 0.0}, {40.0, 30.0, 10.0})));
  cut_in_simulation();
  bench.run_to_end(std::string("#workpiece (2, 0.1, 0, \"blanks/box.stl\", 20, 15, 10)\n") +
                   slot_at_minus_3);
  EXPECT_THAT(complaints, IsEmpty());
  EXPECT_NEAR(volume_of(part().blank()), 12000.0, 1e-6);
  EXPECT_NEAR(simulation::removal_of(part()).volume_mm3, 40.0 * 10.0 * 3.0, 0.5);
}

// Through the middle of a cylinder of radius 20: the area of the slot is that of the circle
// between y = -5 and 5, 2 (y sqrt(r² - y²) + r² asin (y / r)).
TEST_F(StlBlank, IsCutAsACylinderIs) {
  write("round.stl", ascii_stl(stl_cylinder(20.0, 0.0, 10.0, 720)));
  cut_in_simulation();
  bench.run_to_end(std::string("#workpiece (2, 0.1, 0, \"round.stl\", 0, 0, 10)\n") +
                   slot_at_minus_3);
  EXPECT_THAT(complaints, IsEmpty());
  EXPECT_NEAR(volume_of(part().blank()), std::numbers::pi * 400.0 * 10.0, 1.0);
  const double area = 2.0 * (5.0 * std::sqrt(400.0 - 25.0) + 400.0 * std::asin(0.25));
  EXPECT_NEAR(simulation::removal_of(part()).volume_mm3, 3.0 * area, 1e-3 * 3.0 * area);
}

// A file in inches, on a program in inches: zero counts in inches, the scale in mm.
TEST_F(StlBlank, TakesItsScaleAndTheUnitsOfTheProgram) {
  write("inch.stl", binary_stl(stl_box({0.0, 0.0, 0.0}, {2.0, 2.0, 1.0})));
  cut_in_simulation();
  bench.run_to_end(
      "G20\n#workpiece (2, 0.2, 0, \"inch.stl\", 1, 1, 1, 25.4)\nG21\nT2 M6\nG43\nS3000 M3\nF3000\n"
      "G0 X-40 Y0 Z10\nZ-3\nG1 X40\nG0 Z50\nM30\n");
  EXPECT_THAT(complaints, IsEmpty());
  EXPECT_NEAR(simulation::removal_of(part()).volume_mm3, 50.8 * 10.0 * 3.0, 1.0);
}

TEST_F(StlBlank, IsTouchedByTheSimulatedProbe) {
  write("box.stl", binary_stl(stl_box({0.0, 0.0, 0.0}, {40.0, 30.0, 10.0})));
  bench.run_to_end(
      "#workpiece (2, 0.1, 0, \"box.stl\", 20, 15, 10)\nT9 M6\nG43\nF60\nG0 Z20\nX3.33 Y-2.22 Z2\n"
      "G38.2 Z-2\nmsg (\"z=\" + str ($probe[Z], 6));\nG0 Z20\nX-24 Y4.44\nZ-5\nG38.2 X-15\n"
      "msg (\"x=\" + str ($probe[X], 6));\nM30\n");
  // The ball has 2 mm; late by resolution² / (4 radius) and by the travel of a cycle at F60.
  const double late = 0.1 * 0.1 / 8.0 + MeasuringBench::cycle_s;
  EXPECT_NEAR(bench.found("z"), 0.0, late);
  EXPECT_NEAR(bench.found("x"), -22.0, late);
}

TEST_F(StlBlank, IsRefusedWithItsPlaceWhenTheProgramIsLoaded) {
  StlTriangles open = stl_box({0.0, 0.0, 0.0}, {40.0, 30.0, 10.0});
  open.pop_back();
  write("open.stl", binary_stl(open));
  write("text.stl", "G0 X1\n");
  std::filesystem::create_directory(bench.folder.path() / "folder.stl");
  std::filesystem::create_symlink("/etc/hostname", bench.folder.path() / "out.stl");
  const auto named = [&](const std::string& name) {
    return refusal("G0 X1\n#workpiece (2, 0.5, 0, \"" + name + "\", 0, 0, 0)");
  };
  EXPECT_THAT(named("missing.stl"), HasSubstr("E7001 2:24 the file was not found: missing.stl"));
  EXPECT_THAT(named("open.stl"), HasSubstr("E7021 2:24 open.stl: the surface is not closed"));
  EXPECT_THAT(named("open.stl"), HasSubstr("| repair the file"));
  EXPECT_THAT(named("text.stl"), HasSubstr("E7020 2:24"));
  EXPECT_THAT(named("folder.stl"), HasSubstr("E7003 2:24"));
  EXPECT_THAT(named("/tmp/box.stl"), HasSubstr("E7002 2:24"));
  EXPECT_THAT(named("../box.stl"), HasSubstr("E7002 2:24"));
  EXPECT_THAT(named("out.stl"), HasSubstr("E7002 2:24 out.stl leads outside the program root"));
  EXPECT_THAT(named("refused.nc"), HasSubstr("E7020 2:24"));
  write("OPEN2.STL", binary_stl(stl_box({0.0, 0.0, 0.0}, {40.0, 30.0, 10.0})));
  EXPECT_EQ(named("OPEN2.STL"), "");
}

// Longer than any STL file may be, and not read for it.
TEST_F(StlBlank, IsRefusedByItsSize) {
  write("large.stl", "solid");
  std::filesystem::resize_file(bench.folder.path() / "large.stl", simulation::stl_bytes_max + 1);
  EXPECT_THAT(refusal("#workpiece (2, 0.5, 0, \"large.stl\", 0, 0, 0)"),
              HasSubstr("E7023 1:24 large.stl: the file has 161 MiB, at most 160 are allowed"));
}

// In metres: 0.04 mm if nothing says so.
TEST_F(StlBlank, OfAnotherUnitIsToldApart) {
  write("metres.stl", binary_stl(stl_box({0.0, 0.0, 0.0}, {0.04, 0.03, 0.01})));
  bench.run("#workpiece (2, 0.5, 0, \"metres.stl\", 0, 0, 0)\nM30\n");
  ASSERT_EQ(bench.result.alarms.size(), 1U);
  const Diagnostic& alarm = bench.result.alarms[0].diagnostic;
  EXPECT_EQ(alarm.code, "E3021");
  EXPECT_THAT(alarm.message, HasSubstr("0.04 x 0.03 x 0.01 mm"));
  ASSERT_FALSE(alarm.help.empty());
  EXPECT_THAT(alarm.help.front(), HasSubstr("1000 for m"));
  bench.run_to_end("#workpiece (2, 0.5, 0, \"metres.stl\", 0, 0, 0, 1000)\nM30\n");
}

// A file that is another one when the program runs is not what the program was checked with.
TEST_F(StlBlank, ThatHasChangedSinceTheLoadIsNotCut) {
  write("box.stl", binary_stl(stl_box({0.0, 0.0, 0.0}, {40.0, 30.0, 10.0})));
  cut_in_simulation();
  channels::CycleOutput output;
  output.channel_count = 1;
  output.channels[0].id = 1;
  output.channels[0].axis_count = 3;
  channels::Workpiece& workpiece = output.channels[0].workpiece;
  workpiece.announcements = workpiece.shapes = 1;
  workpiece.has_shape = true;
  workpiece.shape.type = 2;
  workpiece.shape.fingerprint = 1;
  workpiece.file = std::string_view((bench.folder.path() / "box.stl").string());
  bench.options.workpieces->observe(output);
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0], HasSubstr("E9205"));
  EXPECT_THAT(complaints[0], HasSubstr("load the program again"));
  ++workpiece.announcements;
  ++workpiece.shapes;
  workpiece.file = std::string_view("/nowhere/box.stl");
  bench.options.workpieces->observe(output);
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_THAT(complaints[1], HasSubstr("cannot read /nowhere/box.stl"));
}

TEST(BlankFile, ComesBackFromItsText) {
  const lang::BlankFile file{.fingerprint = 18446744073709551557ULL,
                             .low = {-0.1, 1.0 / 3.0, -1e-7},
                             .high = {40.0, 1e6, 2.5}};
  const auto back = lang::read_blank_file(lang::text_of(file));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->fingerprint, file.fingerprint);
  EXPECT_EQ(back->low, file.low);
  EXPECT_EQ(back->high, file.high);
  EXPECT_FALSE(lang::read_blank_file("solid box\n"));
  EXPECT_FALSE(lang::read_blank_file("blank-of-stl-file 1 2 3"));
  EXPECT_TRUE(lang::names_stl_file("blanks/Box.STL"));
  EXPECT_FALSE(lang::names_stl_file(".stl"));
  EXPECT_FALSE(lang::names_stl_file("box.nc"));
}

}  // namespace
}  // namespace stanok::runtime
