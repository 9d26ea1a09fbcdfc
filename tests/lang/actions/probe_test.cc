// Probing: what the program learns from the channel's answer.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class Probing : public ProgramTest {
 protected:
  // The probe changes at (107, 3) of the base, and the axes stand there.
  void find_at_a_point() {
    answering = [](const ProgramRequest& request) {
      Answer answer;
      if (request.kind != RequestKind::probe_result) return answer;
      answer.probe_B = {107.0, 3.0, 0.0};
      answer.position_B = answer.probe_B;
      answer.position_valid = true;
      return answer;
    };
  }
  void find_nothing() {
    answering = [](const ProgramRequest& request) {
      Answer answer;
      answer.ok = request.kind != RequestKind::probe_result;
      return answer;
    };
  }
};

TEST_F(Probing, TellsThePointInTheSystemAndTheUnitsOfTheProgram) {
  tables.offsets[2] = {100.0, 0.0, 0.0};
  find_at_a_point();
  EXPECT_EQ(messages("G55\nG51 X0 Y0 P2\nG38.2 X20 F50\n"
                     "msg (str ($probe[X]) + \" \" + str (#5062) + \" \" + str (#5070));\n"
                     "G7\nmsg (str ($probe[X]) + \" \" + str ($prog_pos[X]));\nM30\n"),
            (std::vector<std::string>{"3.5 1.5 1", "7 7"}));
}

TEST_F(Probing, GoesOnFromWhereTheProbeChanged) {
  find_at_a_point();
  const auto list = moves("G38.4 X200 F50\nG91 G1 X1\nM30\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].end[0], 108.0);
}

TEST_F(Probing, WithoutContactIsAnErrorOnlyWhereItIsAsked) {
  find_nothing();
  for (const char* const code : {"G38.2", "G38.4"}) {
    EXPECT_EQ(error_code(std::string(code) + " X5 F50\nM30\n"), "E4320") << code;
    EXPECT_EQ(error.place.line, 1);
  }
  for (const char* const code : {"G38.3", "G38.5", "G31"}) {
    EXPECT_EQ(messages(std::string(code) + " X5 F50\n" +
                       "if (!$probe_ok) { msg (str (#5061) + \" \" + str (#5070)); }\nM30\n"),
              std::vector<std::string>{"5 0"})
        << code;
  }
}

// A plain line is no instruction: the fault is told of it, not of the instruction before.
TEST_F(Probing, WithoutContactFailsInItsOwnLine) {
  find_nothing();
  EXPECT_EQ(error_code("#1=5\nG0 X0\nG38.2 X#1 F50\nM30\n"), "E4320");
  EXPECT_EQ(error.place.line, 3);
  EXPECT_EQ(error_code("G0 X0\nG1 X1 F100\nG38.2 X5 F50\nM30\n"), "E4320");
  EXPECT_EQ(error.place.line, 3);
  EXPECT_EQ(error.place.column, 1);
}

// Haas mill operator's manual, M78 and M79: in the block of the skip or in any later one.
TEST_F(Probing, TellsOfHaasWhetherItsResultIsAnAlarm) {
  find_nothing();
  EXPECT_EQ(error_code("(dialect haas)\nM79 G31 X5 F50\nM30\n"), "E4320");
  EXPECT_EQ(error_code("(dialect haas)\nG31 X5 F50\nG0 X0\nM79\nM30\n"), "E4320");
  EXPECT_EQ(error.place.line, 4);
  EXPECT_EQ(error_code("(dialect haas)\nM78 G31 X5 F50\nM78\nM30\n"), "");
  find_at_a_point();
  EXPECT_EQ(error_code("(dialect haas)\nM78 G31 X5 F50\nM30\n"), "E4324");
  EXPECT_EQ(error_code("(dialect haas)\nG31 X5 F50\nG0 X0\nM78\nM30\n"), "E4324");
  EXPECT_EQ(error_code("(dialect haas)\nM79 G31 X5 F50\nM79\nM30\n"), "");
  EXPECT_EQ(error_code("(dialect fanuc)\nM79 G31 X5 F50\nM30\n"), "E4004");
}

// G31 is of its block alone: the motion before goes on.
TEST_F(Probing, OfOneBlockLeavesTheMotionAsItWas) {
  find_at_a_point();
  const auto list = moves("G1 X1 F50\nG31 X200\nX#5061\nX150\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].end[0], 107.0);
  EXPECT_EQ(list[2].end[0], 150.0);
  EXPECT_EQ(list[2].kind, MoveKind::line);
  const auto probes = all<ProbeMove>();
  ASSERT_EQ(probes.size(), 1u);
  EXPECT_TRUE(probes[0].until_contact);
  EXPECT_FALSE(probes[0].alarm_when_missed);
  EXPECT_EQ(probes[0].input, 1);
  EXPECT_EQ(error_code("G31 X200 P5 F50\nM30\n"), "E4008");
}

TEST_F(Probing, MayWatchAnotherInput) {
  find_at_a_point();
  moves("G31 X200 P3 F50\nM30\n");
  const auto probes = all<ProbeMove>();
  ASSERT_EQ(probes.size(), 1u);
  EXPECT_EQ(probes[0].input, 3);
}

}  // namespace
}  // namespace stanok::lang::testing
