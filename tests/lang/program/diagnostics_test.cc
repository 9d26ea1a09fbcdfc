// Every code of the language is raised by some program, at the right place.
#include <gmock/gmock.h>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

struct PlacedFaultCase {
  std::string text;
  const char* code;
  int line;
  int column;
};

class Fault : public ProgramTest, public ::testing::WithParamInterface<PlacedFaultCase> {};

TEST_P(Fault, IsReportedAtItsPlace) {
  tables.tools[1] = {1, {0.0, 0.0, 10.0}, 0.0};
  channel.axes.resize(4);  // X Y Z B
  EXPECT_EQ(error_code(GetParam().text + "\nM30\n"), GetParam().code) << to_text(error);
  EXPECT_EQ(error.place.line, GetParam().line) << to_text(error);
  EXPECT_EQ(error.place.column, GetParam().column) << to_text(error);
  EXPECT_FALSE(error.message.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Text, Fault,
    ::testing::Values(
        PlacedFaultCase{"G0 X1 \xD0\xA4", "E1001", 1, 7}, PlacedFaultCase{"?", "E2001", 1, 1},
        PlacedFaultCase{"G0 X1\n\x01", "E1001", 2, 1},
        PlacedFaultCase{"G0 X1 (open", "E1006", 1, 7}, PlacedFaultCase{"/* open", "E1006", 1, 1},
        PlacedFaultCase{"G0 X1 (a (b))", "E1008", 1, 10},
        PlacedFaultCase{"G0 X1" + repeated(" ", 5000) + "Y1", "E1007", 1, 1},
        PlacedFaultCase{"G0 X1 N5", "E2006", 1, 7}, PlacedFaultCase{"G0 XY5", "E2007", 1, 4},
        PlacedFaultCase{"M2=3", "E2011", 1, 1},
        PlacedFaultCase{"G0 X-" + repeated("9", 400), "E1002", 1, 6},
        PlacedFaultCase{"num aa = 1e400;", "E1002", 1, 10},
        PlacedFaultCase{"{\n#include \"a.nc\"\n}", "E2012", 2, 10},
        PlacedFaultCase{"{\nO100\n}", "E2012", 2, 1}, PlacedFaultCase{"G0 X1,B5", "E2001", 1, 6},
        PlacedFaultCase{"num sum_ = 1" + repeated("+1", 1001) + ";", "E2031", 1, 2013},
        PlacedFaultCase{"G0 X" + repeated("-", 70) + "1", "E2030", 1, 70},
        PlacedFaultCase{repeated("{", 65) + repeated("}", 65), "E2030", 1, 65}));

INSTANTIATE_TEST_SUITE_P(
    Blocks, Fault,
    ::testing::Values(
        PlacedFaultCase{"G0G9G90G91.1G94G21G17G40G49G50G54G64G69G80G97G98G15 X1", "E4005", 1, 49},
        PlacedFaultCase{"G80\nX1", "E4012", 2, 1}, PlacedFaultCase{"G1 X1 F-5", "E4022", 1, 7},
        PlacedFaultCase{"S-1", "E4022", 1, 1}, PlacedFaultCase{"G93\nG1 X1", "E4023", 2, 1},
        PlacedFaultCase{"G1 X1", "E4020", 1, 1},
        PlacedFaultCase{"G95 F1\nG94 G1 X1", "E4020", 2, 1},
        PlacedFaultCase{"F100\nG53 G2 X1 I1", "E4041", 2, 1},
        PlacedFaultCase{"G91\nG53 G0 X1", "E4042", 2, 1}, PlacedFaultCase{"M6", "E4051", 1, 1},
        PlacedFaultCase{"G4 S5", "E4052", 1, 4}, PlacedFaultCase{"G4", "E4007", 1, 1},
        PlacedFaultCase{"G54.1 P301", "E4008", 1, 7}, PlacedFaultCase{"G54.1", "E4007", 1, 1},
        PlacedFaultCase{"T7", "E5021", 1, 1}, PlacedFaultCase{"G43 H7", "E5021", 1, 5},
        PlacedFaultCase{"G43 H1.5", "E4008", 1, 5}, PlacedFaultCase{"G10 L2 X1", "E4007", 1, 1},
        PlacedFaultCase{"G10 L3 P1 X1", "E4008", 1, 5}, PlacedFaultCase{"G0 C1", "E4010", 1, 4},
        PlacedFaultCase{"G64 P-1", "E4008", 1, 5}, PlacedFaultCase{"M98", "E4007", 1, 1},
        PlacedFaultCase{"M98 P5", "E7005", 1, 1}, PlacedFaultCase{"G34 X1", "E2090", 1, 1},
        PlacedFaultCase{"G34 X1 K1", "E2090", 1, 1}, PlacedFaultCase{"G=17.33", "E4004", 1, 1},
        PlacedFaultCase{"num gg = 106;\nG=gg", "E4004", 2, 1}));

INSTANTIATE_TEST_SUITE_P(
    Runs, Fault,
    ::testing::Values(PlacedFaultCase{"G43.4 H1\n#kinematics (1, 1)", "E5011", 2, 1},
                      PlacedFaultCase{"num aa = 0;\nnum bb = 1/aa;", "E3008", 2, 10},
                      PlacedFaultCase{"num aa[900000], bb[900000], cc[900000], dd[900000];",
                                      "E8002", 1, 41}));

class DiagnosticsTest : public ProgramTest {
 protected:
  void refuse_all() {
    answering = [](const ProgramRequest&) {
      Answer answer;
      answer.ok = false;
      answer.text = "E6006 the machine is off";
      return answer;
    };
  }
};

TEST_F(DiagnosticsTest, OfRefusedStatementsNameTheFunctionAndTheReason) {
  refuse_all();
  const std::pair<const char*, const char*> cases[] = {
      {"channel_wait (2);", "E6010"},  {"channel_load (2, \"a\");", "E6011"},
      {"channel_start (2);", "E6012"}, {"channel_run (2, \"a\");", "E6013"},
      {"channel_stop (2);", "E6014"},  {"channel_reset (2);", "E6015"}};
  for (const auto& [text, code] : cases) {
    EXPECT_EQ(error_code(std::string(text) + "\nM30\n"), code);
    EXPECT_NE(error.message.find("the machine is off"), std::string::npos);
  }
}

TEST_F(DiagnosticsTest, OfOtherRefusalsCarryTheCodeOfTheReason) {
  refuse_all();
  EXPECT_EQ(error_code("#kinematics (2, 1)\nM30\n"), "E6006");
  EXPECT_EQ(error.message, "the machine is off");
  EXPECT_EQ(error_code("num aa = channel_state (2);\nM30\n"), "E6006");
  answering = [](const ProgramRequest&) {
    Answer answer;
    answer.ok = false;
    return answer;
  };
  EXPECT_EQ(error_code("#kinematics (2, 1)\nM30\n"), "E5010");
  EXPECT_EQ(error_code("num aa = channel_state (2);\nM30\n"), "E6032");
}

TEST_F(DiagnosticsTest, NameAMissingWorkOffset) {
  class FewOffsets : public MemoryTables {
   public:
    [[nodiscard]] std::optional<AxisValues> work_offset(int number) const override {
      return number <= 6 ? std::optional(AxisValues{}) : std::nullopt;
    }
  };
  FewOffsets few;
  files.texts["main.nc"] = "G0 X1\nG59.1\nM30\n";
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  Interpreter one(channel, few, files);
  one.start(*program, {});
  Command command;
  while (one.next(command) == Step::command) {
  }
  EXPECT_EQ(one.error().code, "E5001");
  EXPECT_EQ(one.error().place.line, 2);
}

TEST_F(DiagnosticsTest, NameAPlaneWithoutAxes) {
  channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
  EXPECT_EQ(error_code("F1 G2 X5 I2.5\nM30\n"), "E4036");
  EXPECT_EQ(error.notes.at(0).text, "G17 is active by default");
}

TEST_F(DiagnosticsTest, CountCharactersNotBytes) {
  EXPECT_EQ(error_code("(\xD0\xA4\xD0\xA4) G0 X1 X2\nM30\n"), "E4001");
  EXPECT_EQ(error.place.column, 12);
  EXPECT_EQ(error.place.end_column, 14);
}

TEST_F(DiagnosticsTest, WarnOfEncodingAndFrames) {
  run("(\xFF)\n; \xFF\nG0 X1\nM30\n");
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].code, "W110");
  EXPECT_EQ(warnings[1].place.line, 2);
  run("%\nG0 X1\nM30\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "W210");
  run("G0 X1\nM30\n%\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].place.line, 3);
}

TEST_F(DiagnosticsTest, ShowTheCallStack) {
  EXPECT_EQ(error_code("void inner (num dd) { G1 X=1/dd }\nvoid outer () {\n  inner (0); }\n"
                       "outer ();\nM30\n"),
            "E3008");
  EXPECT_EQ(error.stack, (std::vector<std::string>{"in inner(), called at main.nc:3:3",
                                                   "in outer(), called at main.nc:4:1"}));
}

TEST_F(DiagnosticsTest, LimitTheNumberOfFiles) {
  std::string text;
  for (int i = 0; i < 256; ++i) {
    const std::string name = "file" + std::to_string(i) + ".nc";
    files.texts[name] = "M99\n";
    text += "#include \"" + name + "\"\n";
  }
  EXPECT_EQ(error_code(text + "M30\n"), "E8003");
  EXPECT_EQ(error.place.line, 256);
}

TEST_F(DiagnosticsTest, CountTheErrorsThatAreNotShown) {
  const auto errors = load_errors(repeated("?\n", 130) + "M30\n");
  EXPECT_EQ(errors.size(), 100U);
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.back().code, "W213");
  EXPECT_EQ(warnings.back().message, "30 more errors are not shown");
}

TEST_F(DiagnosticsTest, NameWhatTheMachineFileCanMakeOfAnUnknownCode) {
  const auto errors = load_errors("M87\nG87.5\nM30\n");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].code, "E4004");
  EXPECT_THAT(errors[0].help,
              ElementsAre(AllOf(HasSubstr("M87 = \"cycles/name.nc\""), HasSubstr("\"output 4 on\""),
                                HasSubstr("\"before\""))));
  EXPECT_EQ(errors[1].code, "E4004");
  EXPECT_THAT(errors[1].help, ElementsAre(Not(HasSubstr("output"))));
}

TEST_F(DiagnosticsTest, SayWhatASlipMayHaveMeant) {
  const auto help_of = [&](const std::string& text) {
    error_code(text + "\nM30\n");
    return error.help.empty() ? std::string() : error.help.front();
  };
  EXPECT_THAT(help_of("GOO Z1"), HasSubstr("`G00`"));
  EXPECT_EQ(help_of("GOT Z1"), "");
  EXPECT_THAT(help_of("#1==2"), HasSubstr("[#1 EQ 2]"));
  EXPECT_THAT(help_of("M98 (SUB.NC)"), HasSubstr("is a comment"));
  EXPECT_THAT(help_of("(dialect fanuc)\n:O1001"), HasSubstr("`:1001`"));
  EXPECT_THAT(help_of("(dialect fanuc)\nSETVN 101[WIDTH]"), HasSubstr("numbers"));
  EXPECT_THAT(help_of("(dialect fanuc)\nWHILE [#1 EQ 0] DO1 #1=1\nEND1"),
              HasSubstr("line of its own"));
}

TEST_F(DiagnosticsTest, SayWhichWordAMacroWasCalledWithout) {
  for (const char* const block : {"G1 X1 F#9", "G1 X1 F[#9] (compiled)"}) {
    const std::string macro = "O9001\n" + std::string(block) + "\nM99\n";
    ASSERT_EQ(error_code("(dialect fanuc)\nG65 P9001\nM30\n" + macro), "E4020");
    EXPECT_THAT(error.notes, ::testing::Contains(::testing::Field(
                                 &Note::text, HasSubstr("the word F is left out"))));
  }
  ASSERT_EQ(error_code("(dialect fanuc)\nG1 X1\nM30\n"), "E4020");
  for (const Note& note : error.notes) EXPECT_THAT(note.text, Not(HasSubstr("left out")));
}

TEST_F(DiagnosticsTest, NameWhatATextIsFor) {
  const auto made_for = [&](const std::string& text) {
    return error_code(text + "\nM30\n") == "E2042" ? error.message : std::string();
  };
  EXPECT_THAT(made_for("G1 X=AC(10) F100"), HasSubstr("Siemens"));
  EXPECT_THAT(made_for("DIAM90"), HasSubstr("Siemens"));
  EXPECT_THAT(made_for("LABEL1: G1 X10"), HasSubstr("Siemens"));
  EXPECT_THAT(made_for("switch (1) {\ndefault: { G0 X }\n}"), Not(HasSubstr("Siemens")));
  EXPECT_THAT(made_for("FEDRAT/100"), HasSubstr("CL data"));
  EXPECT_THAT(made_for("$IF V.G.WZ_AKT.P1 > 3"), HasSubstr("ISG"));
  EXPECT_THAT(made_for("MSG \"ready\""), HasSubstr("Eding"));
  EXPECT_THAT(made_for("M109 S210"), HasSubstr("3-D printer"));
  EXPECT_EQ(made_for("M109 P500"), "");
}

TEST_F(DiagnosticsTest, SayWhatDoesWhatAnotherControlHas) {
  ASSERT_EQ(error_code("(dialect fanuc)\nM98 <SUB>\nM30\n"), "E2001");
  EXPECT_THAT(error.help, ElementsAre(HasSubstr("by their number")));
  ASSERT_EQ(error_code("(dialect fanuc)\nG0 <SUB>\nM30\n"), "E2001");
  EXPECT_TRUE(error.help.empty());
}

TEST_F(DiagnosticsTest, KeepTheMotionBeforeTheFaultyBlock) {
  run("G0 X1\nX2\nT9 X3\nX4\nM30\n");
  EXPECT_EQ(error.code, "E5021");
  EXPECT_THAT(error.help, ElementsAre(HasSubstr("stanok tool set 9 length")));
  EXPECT_EQ(all<Move>().size(), 2u);
  EXPECT_EQ(all<ToolPrepare>().size(), 0u);
  EXPECT_EQ(interpreter->next(commands.front()), Step::failed);
}

TEST_F(DiagnosticsTest, FreeTheMemoryOfArraysThatAreGone) {
  EXPECT_EQ(error_code("void use () { num big[500000]; big[0] = 1; }\n"
                       "for (num nn_ = 0; nn_ < 20; nn_++) { use (); }\nM30\n"),
            "");
}

}  // namespace
}  // namespace stanok::lang::testing
