// The master program of the project's first demonstration: it switches kinematic schemes of channel
// 1 and runs two programs there.
#include <fstream>
#include <sstream>

#include "tests/lang/program_support.h"
#include "tests/support/project_folders.h"

namespace stanok::lang::testing {
namespace {

// The program as people find it.
std::string read_master() {
  std::ifstream stream(stanok::testing::source_folder() + "/programs/examples/master.nc");
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}
const std::string master_text = read_master();

class MasterProgram : public ProgramTest {
 protected:
  MasterProgram() {
    channel = master_channel();
    files.texts["0003_MB_3D.nc"] = "%\nG90 G54 X10 F100\nG1 Z-1 B5 S100 T1\nM30\n%\n";
    files.texts["Impeller_surface.nc"] = "G43.4 H1\nG1 X1 Y2 Z3 B4 C5 F2000\nM30\n";
  }

  std::vector<std::string> requests() const {
    std::vector<std::string> list;
    for (const ProgramRequest& request : all<ProgramRequest>()) {
      list.push_back(std::to_string(static_cast<int>(request.kind)) + " ch" +
                     std::to_string(request.channel) + " n" + std::to_string(request.number) + " " +
                     request.text + (request.statement ? " statement" : ""));
    }
    return list;
  }
};

std::string kind(RequestKind kind) {
  return std::to_string(static_cast<int>(kind));
}

TEST_F(MasterProgram, RunsBothProgramsInOrder) {
  run(master_text);
  EXPECT_EQ(error.code, "") << to_text(error);
  const std::vector<std::string> expected{
      kind(RequestKind::kinematics) + " ch1 n1 ",
      kind(RequestKind::channel_run) + " ch1 n0 0003_MB_3D.nc",
      kind(RequestKind::channel_wait) + " ch1 n0  statement",
      kind(RequestKind::kinematics) + " ch1 n2 ",
      kind(RequestKind::channel_run) + " ch1 n0 Impeller_surface.nc",
      kind(RequestKind::channel_wait) + " ch1 n0  statement"};
  EXPECT_EQ(requests(), expected);
  EXPECT_EQ(all<ProgramEnd>().size(), 1u);
  EXPECT_TRUE(warnings.empty());
}

TEST_F(MasterProgram, TerminatesWithTheCodeOfTheProgramWhenARunIsRefused) {
  answering = [](const ProgramRequest& request) {
    Answer answer;
    answer.ok = request.kind != RequestKind::channel_run || request.text != "Impeller_surface.nc";
    answer.text = answer.ok ? "" : "E7001 file not found: Impeller_surface.nc";
    return answer;
  };
  run(master_text);
  EXPECT_EQ(last_step, Step::failed);
  EXPECT_EQ(error.code, "U1006");
  EXPECT_EQ(error.message, "Impeller_surface.nc");
  EXPECT_EQ(error.place.line, 12);
  EXPECT_EQ(all<ProgramRequest>().back().kind, RequestKind::terminate);
  EXPECT_EQ(all<ProgramRequest>().back().number, 1006);
}

TEST_F(MasterProgram, FailsWhenTheAwaitedProgramEndedByAlarm) {
  answering = [](const ProgramRequest& request) {
    Answer answer;
    answer.ok = request.kind != RequestKind::channel_wait;
    answer.text = "E4020 motion at feed without F";
    return answer;
  };
  run(master_text);
  EXPECT_EQ(error.code, "E6010");
  EXPECT_EQ(error.place.line, 8);
  EXPECT_EQ(error.place.column, 1);
  EXPECT_NE(error.message.find("E4020"), std::string::npos);
}

TEST_F(MasterProgram, TellsWhichProgramsAndSchemesItDispatches) {
  files.texts["main.nc"] = master_text;
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  const auto& dispatches = constant_dispatches(**program);
  ASSERT_EQ(dispatches.size(), 4u);
  EXPECT_EQ(dispatches[0].scheme, 1);
  EXPECT_EQ(dispatches[1].program, "0003_MB_3D.nc");
  EXPECT_EQ(dispatches[2].scheme, 2);
  EXPECT_EQ(dispatches[3].program, "Impeller_surface.nc");
  EXPECT_EQ(dispatches[3].place.line, 11);
}

TEST_F(MasterProgram, DoesNotLoadWithoutItsIncludes) {
  files.texts.erase("Impeller_surface.nc");
  const auto errors = load_errors(master_text);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, "E7001");
  EXPECT_EQ(errors[0].place.line, 3);
  EXPECT_EQ(errors[0].place.column, 10);
}

TEST_F(MasterProgram, ReportsErrorsOfIncludedFilesAtTheirOwnPlace) {
  files.texts["0003_MB_3D.nc"] = "G1 X1\nG1 X1 X2\nM30\n";
  const auto errors = load_errors(master_text);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, "E4001");
  EXPECT_EQ(errors[0].place.file, "0003_MB_3D.nc");
  EXPECT_EQ(errors[0].place.line, 2);
  ASSERT_EQ(errors[0].notes.size(), 1u);
  EXPECT_EQ(errors[0].notes[0].place.line, 2);
  EXPECT_EQ(errors[0].notes[0].place.file, "main.nc");
}

TEST_F(MasterProgram, RefusesConstantsThatCannotBeRight) {
  EXPECT_EQ(error_code("channel_wait (3);\nM30"), "E6001");
  EXPECT_EQ(error_code("channel_wait (2);\nM30"), "E6031");
  EXPECT_EQ(error_code("#kinematics (7, 1)\nM30"), "E5201");
  EXPECT_EQ(error_code("#kinematics (1, 9)\nM30"), "E6001");
}

TEST_F(MasterProgram, HasNoAxesSpindleOrTool) {
  EXPECT_EQ(error_code("G0 X1\nM30"), "E4010");
  EXPECT_EQ(error_code("S100\nM30"), "E4009");
  EXPECT_EQ(error_code("T1\nM30"), "E4009");
  EXPECT_EQ(error_code("M3\nM30"), "E4009");
}

}  // namespace
}  // namespace stanok::lang::testing
