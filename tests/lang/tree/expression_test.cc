// Expressions of high-level text and of brackets: values, precedence, types.
#include <cmath>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

struct ValueCase {
  const char* expression;
  double value;
};

class NumberExpression : public ProgramTest, public ::testing::WithParamInterface<ValueCase> {};

TEST_P(NumberExpression, HasItsValueFoldedAndComputed) {
  const std::string expression = GetParam().expression;
  const auto list = moves(
      "num one = 1, two = 2;\nbool yes = true;\nnum list[3] = {10, 20, 30};\n"
      "num made = " +
      expression + ";\nG0 X=made\nM30\n");
  ASSERT_EQ(list.size(), 1u) << expression;
  EXPECT_NEAR(list[0].end[0], GetParam().value, 1e-12 * std::abs(GetParam().value)) << expression;
}

INSTANTIATE_TEST_SUITE_P(
    Values, NumberExpression,
    ::testing::Values(
        ValueCase{"1 + 2 * 3", 7}, ValueCase{"(1 + 2) * 3", 9}, ValueCase{"10 - 4 - 3", 3},
        ValueCase{"2 ** 3 ** 2", 512}, ValueCase{"-2 ** 2", -4}, ValueCase{"2 ** -1", 0.5},
        ValueCase{"7 % 3", 1}, ValueCase{"-7 % 3", 2}, ValueCase{"7 % -3", -2},
        ValueCase{"24 / 4 / 2", 3}, ValueCase{"1.5e-3 * 2", 0.003}, ValueCase{".5 + 1.", 1.5},
        ValueCase{"- -two", 2}, ValueCase{"+two", 2}, ValueCase{"one + two * two", 5},
        ValueCase{"two ** two ** one", 4}, ValueCase{"-two ** two", -4},
        ValueCase{"list[0] + list[two]", 40}, ValueCase{"list[one + one] / two", 15},
        ValueCase{"yes ? one : two", 1}, ValueCase{"!yes ? one : two", 2},
        ValueCase{"one < two && two <= 2 ? 5 : 6", 5}, ValueCase{"one > two || yes ? 5 : 6", 5},
        ValueCase{"one == 1 ? 5 : 6", 5}, ValueCase{"yes == (one != 1) ? 5 : 6", 6},
        ValueCase{"one < two ? two < 2 ? 1 : 2 : 3", 2}, ValueCase{"sin (30)", 0.5},
        ValueCase{"cos (90)", 0}, ValueCase{"sin (180)", 0}, ValueCase{"cos (-60 * one)", 0.5},
        ValueCase{"tan (45)", 1}, ValueCase{"sin (45 * one)", 0.70710678118654752},
        ValueCase{"asin (1)", 90}, ValueCase{"acos (0)", 90}, ValueCase{"atan (1)", 45},
        ValueCase{"atan2 (1, -1)", 135}, ValueCase{"sqrt (two * 8)", 4}, ValueCase{"abs (-two)", 2},
        ValueCase{"sign (-7)", -1}, ValueCase{"min (3, two, 4)", 2},
        ValueCase{"max (3, two, 4, 9)", 9}, ValueCase{"floor (-1.5)", -2},
        ValueCase{"ceil (-1.5)", -1}, ValueCase{"round (2.5)", 3}, ValueCase{"trunc (-1.5)", -1},
        ValueCase{"exp (0)", 1}, ValueCase{"ln (exp (two))", 2}, ValueCase{"log10 (1000)", 3},
        ValueCase{"pow (two, 10)", 1024}, ValueCase{"hypot (3, 4)", 5}, ValueCase{"mod (-1, 4)", 3},
        ValueCase{"clamp (7, 0, 5)", 5}, ValueCase{"wrap360 (-90)", 270},
        ValueCase{"1 + wrap360 (-1e-18)", 1}, ValueCase{"bit_and (12, 10)", 8},
        ValueCase{"bit_or (12, 10)", 14}, ValueCase{"bit_xor (12, 10)", 6},
        ValueCase{"len (\"abc\" + str (12))", 5}, ValueCase{"find (\"abcd\", \"cd\")", 2},
        ValueCase{"len (\"\u0444\u0440\u20AC\U0001F527\")", 4},
        ValueCase{"find (\"\u0444\u0440 cd\", \"cd\")", 3},
        ValueCase{"find (\"\u0444\u0440\", \"\u0440\")", 1},
        ValueCase{"len (substr (\"\u0444\u0440\u20AC cd\", 1, 2))", 2},
        ValueCase{"substr (\"\u0444\u0440\u20AC cd\", 1, 2) == \"\u0440\u20AC\" ? 1 : 0", 1},
        ValueCase{"substr (\"\u0444\u0440\", 2) == \"\" ? 1 : 0", 1},
        ValueCase{"to_num (\" 2.50 \")", 2.5}, ValueCase{"PI", 3.14159265358979323846},
        ValueCase{"CH_ALARM + GV_ALL", 67}, ValueCase{"near (1, 1 + 1e-9) ? 1 : 0", 1},
        ValueCase{"near (1, 1.1, 0.2) ? 1 : 0", 1}));

class ExpressionTest : public ProgramTest {};

TEST_F(ExpressionTest, JoinsAndComparesStrings) {
  EXPECT_EQ(
      messages("string name = \"part\";\nname += \" 7\";\nmsg (upper (name) + str (1.5, 2));\n"
               "if (name == \"part 7\" && name != \"x\") { msg (substr (name, 5)); }\nM30\n"),
      (std::vector<std::string>{"PART 71.50", "7"}));
  EXPECT_EQ(
      messages("msg (str (0.1) + \" \" + str (1e21) + \" \" + lower (\"A\\\"\\\\\\tB\"));\nM30"),
      (std::vector<std::string>{"0.1 1e+21 a\"\\\tb"}));
}

TEST_F(ExpressionTest, WritesNumbersSoThatTheyReadBack) {
  EXPECT_EQ(messages("msg (str (999.9999999999999));\nmsg (str (0));\nmsg (str (-33.3));\n"
                     "msg (str (123456789012345));\nmsg (str (0.00001));\nmsg (str (1e-7));\n"
                     "msg (str (2/3));\nM30\n"),
            (std::vector<std::string>{"999.9999999999999", "0", "-33.3", "123456789012345",
                                      "0.00001", "1e-07", "0.6666666666666666"}));
}

TEST_F(ExpressionTest, ComputesOnlyWhatDecides) {
  EXPECT_EQ(messages("num zero;\nif (zero != 0 && 1 / zero > 1) { msg (\"no\"); }\n"
                     "if (zero == 0 || 1 / zero > 1) { msg (\"yes\"); }\nM30\n"),
            (std::vector<std::string>{"yes"}));
}

TEST_F(ExpressionTest, OfAWordEndsWhereTheNextWordBegins) {
  const auto list = moves(
      "num len1 = 10, len2 = -4, aa = 7, bb = 3;\n"
      "G1 X=len1+2 Y=(len1+len2)/2 (this is a comment) Z=abs (len2) F=200//end\n"
      "X=aa -bb Y=aa (comment)\nG91 X=1 Y=2;old style\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].end[0], 12.0);
  EXPECT_EQ(list[0].end[1], 3.0);
  EXPECT_EQ(list[0].end[2], 4.0);
  EXPECT_EQ(list[0].feed, 200.0);
  EXPECT_EQ(list[1].end[0], 4.0);
  EXPECT_EQ(list[1].end[1], 7.0);
  EXPECT_EQ(list[2].end[0], 5.0);
}

TEST_F(ExpressionTest, InBracketsFollowsTheRulesOfBrackets) {
  const auto list = moves(
      "#1=4 #<dd>=0.5\nG0 X[#1*2] Y-#1 Z-#<dd>\n"
      "X[2 + 3 * 4 ** 2] Y[[2 + 3] * 4 MOD 3] Z[ATAN[1]/[1]]\n"
      "X[1 EQ 1.0000001] Y[1 LT 2 AND 2 GE 3] Z[FIX[-1.5] + FUP[1.2] + ROUND[2.5]]\n"
      "Xsin[30] Y[EXISTS[#<dd>] + EXISTS[#<other>]] Z##1\n#4=9 X#4\nX#4 Y[#[2*2]]\nM30\n");
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[0].end[0], 8.0);
  EXPECT_EQ(list[0].end[1], -4.0);
  EXPECT_EQ(list[0].end[2], -0.5);
  EXPECT_EQ(list[1].end[0], 50.0);
  EXPECT_EQ(list[1].end[1], 2.0);
  EXPECT_EQ(list[1].end[2], 45.0);
  EXPECT_EQ(list[2].end[0], 1.0);
  EXPECT_EQ(list[2].end[1], 0.0);
  EXPECT_EQ(list[2].end[2], 3.0);
  EXPECT_EQ(list[3].end[0], 0.5);
  EXPECT_EQ(list[3].end[1], 1.0);
  EXPECT_EQ(list[3].end[2], 0.0);
  EXPECT_EQ(list[4].end[0], 0.0);  // a setting takes effect after its block
  EXPECT_EQ(list[5].end[0], 9.0);
  EXPECT_EQ(list[5].end[1], 9.0);
}

TEST_F(ExpressionTest, KnowsRParametersAndSystemVariables) {
  tables.tools[4] = {4, {0, 0, 77.0}, 2.5};
  const auto list = moves(
      "R5=12.5 R6=R5\nG0 X=R5*2 Y=R6\nT4 M6\nF120 S900 G55\n"
      "X=$tool Y=$prog_pos[X] Z=$tool_length\nX=$feed Y=$speed Z=$g[12]\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].end[0], 25.0);
  EXPECT_EQ(list[0].end[1], 0.0);
  EXPECT_EQ(list[1].end[0], 4.0);
  EXPECT_EQ(list[1].end[1], 25.0);
  EXPECT_EQ(list[1].end[2], 77.0);
  EXPECT_EQ(list[2].end[0], 120.0);
  EXPECT_EQ(list[2].end[1], 900.0);
  EXPECT_EQ(list[2].end[2], 55.0);
}

TEST_F(ExpressionTest, StopsInItsMiddleForTheAnswerOfTheChannel) {
  answering = [](const ProgramRequest& request) {
    Answer answer;
    answer.number = request.kind == RequestKind::channel_state ? 2.0 : 10.0 + request.index;
    return answer;
  };
  const auto list = moves(
      "num sum = 1 + channel_state (2) * 10 + $pos[Y] + clock ();\nG0 X=sum\n"
      "if (channel_state (2) == CH_RUNNING) { G0 Y1 }\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], 1.0 + 20.0 + 11.0 + 10.0);
  EXPECT_EQ(all<ProgramRequest>().at(1).text, "pos");
  EXPECT_EQ(all<ProgramRequest>().at(2).text, "clock");
}

TEST_F(ExpressionTest, TellsWhyAChannelFunctionReturnedFalse) {
  answering = [](const ProgramRequest&) {
    Answer answer;
    answer.ok = false;
    answer.text = "E7001 file not found: a.nc";
    return answer;
  };
  EXPECT_EQ(messages("if (!channel_load (2, \"a.nc\")) { msg (channel_error ()); }\nM30\n"),
            (std::vector<std::string>{"E7001 file not found: a.nc"}));
}

class ExpressionFault : public ProgramTest, public ::testing::WithParamInterface<FaultCase> {};

TEST_P(ExpressionFault, IsReported) {
  EXPECT_EQ(error_code(std::string("num aa = 1, zero;\nbool ok;\nnum list[2];\n") +
                       GetParam().text + "\nM30\n"),
            GetParam().code)
      << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, ExpressionFault,
    ::testing::Values(FaultCase{"aa = 1 / zero;", "E3008"}, FaultCase{"aa = 1 / 0;", "E3008"},
                      FaultCase{"aa = sqrt (-1);", "E3009"}, FaultCase{"aa = 10 ** 400;", "E3009"},
                      FaultCase{"aa = ln (zero);", "E3009"}, FaultCase{"aa = \"text\";", "E3004"},
                      FaultCase{"aa = ok;", "E3004"}, FaultCase{"ok = aa;", "E3004"},
                      FaultCase{"ok = aa < 2 < 3;", "E2008"}, FaultCase{"aa = bb;", "E3001"},
                      FaultCase{"aa = list[2];", "E3011"}, FaultCase{"aa = list[0.5];", "E3011"},
                      FaultCase{"aa = list[0][0];", "E3004"}, FaultCase{"aa = aa[0];", "E3004"},
                      FaultCase{"aa = list;", "E3004"}, FaultCase{"aa = sin ();", "E3005"},
                      FaultCase{"aa = sin (1, 2);", "E3005"}, FaultCase{"aa = (1 + 2;", "E2001"},
                      FaultCase{"aa = 1 +;", "E2001"}, FaultCase{"aa = 1", "E2001"},
                      FaultCase{"msg (aa);", "E3004"}, FaultCase{"msg (\"aa);", "E1004"},
                      FaultCase{"msg (\"\\q\");", "E1005"}, FaultCase{"aa = 1x;", "E1002"},
                      FaultCase{"G0 X#<unset>", "E3014"}, FaultCase{"G0 X#0", "E3015"},
                      FaultCase{"G0 X#1.5", "E3010"}, FaultCase{"R1000=1", "E3015"},
                      FaultCase{"aa = Q;", "E4010"}, FaultCase{"aa = X;", "E3004"},
                      FaultCase{"aa = $nothing;", "E3001"}, FaultCase{"G0 X=ok", "E3004"},
                      FaultCase{"aa = clamp (1, 3, 2);", "E3009"}));

}  // namespace
}  // namespace stanok::lang::testing
