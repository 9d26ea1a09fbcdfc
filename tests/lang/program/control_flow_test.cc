// Control flow, functions, scopes, subprograms in files.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class ControlFlow : public ProgramTest {};

TEST_F(ControlFlow, ChoosesByIfAndElse) {
  const std::string text =
      "if (depth > 10) { msg (\"deep\"); } else if (depth == 0) { msg (\"none\"); }"
      " else { msg (\"flat\"); }\nM30\n";
  EXPECT_EQ(messages("num depth = 11;\n" + text), Texts{"deep"});
  EXPECT_EQ(messages("num depth;\n" + text), Texts{"none"});
  EXPECT_EQ(messages("num depth = 3;\n" + text), Texts{"flat"});
}

TEST_F(ControlFlow, LoopsWithBlocksInItsBody) {
  const auto list = moves(
      "num depth = 3;\nF100\nwhile (depth > 0) { G91 G1 Z=-1\nG90\ndepth -= 1; }\n"
      "do { depth += 1; if (depth == 2) { continue; } G1 X=depth } while (depth < 4);\n"
      "for (num idx = 0; idx < 8; idx++) { if (idx == 3) { break; } G0 Y=idx }\nM30\n");
  std::vector<double> z;
  std::vector<double> x;
  std::vector<double> y;
  for (const Move& move : list) {
    if (move.words == 4) z.push_back(move.end[2]);
    if (move.words == 1) x.push_back(move.end[0]);
    if (move.words == 2) y.push_back(move.end[1]);
  }
  EXPECT_EQ(z, (std::vector<double>{-1, -2, -3}));
  EXPECT_EQ(x, (std::vector<double>{1, 3, 4}));
  EXPECT_EQ(y, (std::vector<double>{0, 1, 2}));
}

TEST_F(ControlFlow, SwitchesWithoutFallingThrough) {
  const std::string text =
      "switch (part) {\n  case 1, 2: { msg (\"small\"); }\n  case 3: { G0 X1\n  msg (\"large\"); "
      "}\n"
      "  default: { msg (\"other\"); }\n}\nswitch (str (part)) { case \"3\": { msg (\"three\"); } "
      "}\n"
      "M30\n";
  EXPECT_EQ(messages("num part = 2;\n" + text), Texts{"small"});
  EXPECT_EQ(messages("num part = 3;\n" + text), (Texts{"large", "three"}));
  EXPECT_EQ(messages("num part = 9;\n" + text), Texts{"other"});
  EXPECT_EQ(messages("num ii_; {\n  if (true) {\n  }\n  }\n"
                     "\nwhile (true) { switch (ii_) { case 2: { break; } } ii_++; }\n"
                     "msg (str (ii_));\nM30\n"),
            Texts{"2"});
}

TEST_F(ControlFlow, WorksInBoundedSteps) {
  files.texts["main.nc"] = "num count;\nwhile (count < 100000) { count += 1; }\nM30\n";
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  Interpreter one(channel, tables, files);
  one.start(*program, {});
  Command command;
  int working = 0;
  for (Step step = one.next(command); step != Step::ended; step = one.next(command)) {
    if (step == Step::working) ++working;
    ASSERT_LT(working, 10000);
  }
  EXPECT_GT(working, 3);
}

TEST_F(ControlFlow, PassesArgumentsByValueReferenceAndArray) {
  const auto list = moves(
      "num ramp (num from, num to, num part = 0.5) { return from + (to - from)*part; }\n"
      "void hole (num xpos, num &count, num table[]) {\n  G0 X=xpos F=table[0]\n  count += 1;\n"
      "  table[1] = 7;\n  xpos = 0;\n}\n"
      "num made = 0, feeds[2] = {150, 90};\nhole (10, made, feeds);\nhole (ramp (20, 40), made, "
      "feeds);\n"
      "hole (1, feeds[0], feeds);\nG0 Y=made Z=feeds[1]\nY=feeds[0]\nM30\n");
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[0].end[0], 10.0);
  EXPECT_EQ(list[1].end[0], 30.0);
  EXPECT_EQ(list[3].end[1], 2.0);
  EXPECT_EQ(list[3].end[2], 7.0);
  EXPECT_EQ(list[4].end[1], 151.0);
}

TEST_F(ControlFlow, RecursesWithItsOwnVariables) {
  EXPECT_EQ(messages("num factorial (num nn_) { if (nn_ <= 1) { return 1; } num below = nn_ - 1;\n"
                     "return nn_ * factorial (below); }\nmsg (str (factorial (10)));\nM30\n"),
            Texts{"3628800"});
  EXPECT_EQ(
      messages("void swap (num &aa, num &bb) { num cc = aa; aa = bb; bb = cc; }\n"
               "void twice (num &xx_, num &yy_) { swap (xx_, yy_); }\n"
               "num one = 1, two = 2;\ntwice (one, two);\nmsg (str (one) + str (two));\nM30\n"),
      Texts{"21"});
}

TEST_F(ControlFlow, CallsWithinExpressionsAfterRequests) {
  answering = [](const ProgramRequest&) {
    Answer answer;
    answer.number = 3.0;
    return answer;
  };
  EXPECT_EQ(messages("num asked (num base) { G0 X=base\nreturn base + channel_state (2); }\n"
                     "msg (str (10 * asked (1) + asked (2)));\nM30\n"),
            Texts{"45"});
}

TEST_F(ControlFlow, StopsRunawayRecursion) {
  EXPECT_EQ(error_code("void deep () { deep (); }\ndeep ();\nM30\n"), "E8001");
  EXPECT_GT(error.stack.size(), 60u);
  EXPECT_EQ(error.stack.back(), "in deep(), called at main.nc:2:1");
}

TEST_F(ControlFlow, UsesFunctionsAndConstantsOfIncludedFiles) {
  files.texts["tools.nc"] =
      "const num SAFE_Z = 25 * 2;\nnum counter = 5;\nnum lift (num by) { counter += by;\n"
      "G0 Z=SAFE_Z + by\nreturn counter; }\nmsg (\"not executed\");\nG0 X99\n";
  EXPECT_EQ(
      messages("#include \"tools.nc\"\n#include \"tools.nc\"\nmsg (str (lift (1) + SAFE_Z));\n"
               "msg (str (lift (2)));\nM30\n"),
      (Texts{"51", "3"}));
  EXPECT_EQ(all<Move>().size(), 2u);
  EXPECT_EQ(all<Move>().at(0).end[2], 51.0);
  EXPECT_EQ(commands[0].origin.file, 1);
}

TEST_F(ControlFlow, CallsFilesAsSubprograms) {
  files.texts["sub.nc"] = "num passes;\npasses += 1;\nG91 G0 X=passes\nM99\nG0 X50\n";
  const auto list =
      moves("#include \"sub.nc\"\ncall (\"sub.nc\");\ncall (\"sub.nc\");\nX10\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].end[0], 1.0);
  EXPECT_EQ(list[1].end[0], 2.0);
  EXPECT_EQ(list[2].end[0], 12.0);
  EXPECT_EQ(error_code("call (\"missing.nc\");\nM30\n"), "E7005");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "W710");
}

// Moves of a program with the block skip switches `levels` on: bit 1 is that of `/`.
class SkippedBlocks : public ControlFlow {
 protected:
  std::size_t moves_with(const std::string& text, int levels) {
    files.texts["main.nc"] = text;
    const auto program = compile("main.nc", files, &channel, warnings);
    EXPECT_TRUE(program);
    if (!program) return 0;
    interpreter = std::make_unique<Interpreter>(channel, tables, files);
    interpreter->set_block_skip(static_cast<std::uint16_t>(levels));
    interpreter->start(*program, {});
    commands.clear();
    drain();
    return all<Move>().size();
  }
};

TEST_F(SkippedBlocks, AreLeftOutWhenToldSo) {
  const std::string text = "/G0 X1\n/2 G0 X2\n/ N5 X3\nX4\nM30\n";
  EXPECT_EQ(moves_with(text, 0), 4u);
  EXPECT_EQ(moves_with(text, 2), 2u);
  EXPECT_EQ(moves_with(text, 4), 3u);
}

TEST_F(SkippedBlocks, MayBeWholeLoopsAndBranchesOfOLines) {
  const std::string text =
      "/ o1 repeat [3]\n/ G91 G0 X1\n/ o1 endrepeat\n"
      "/2 o2 if [1]\n/2 G0 Y1\n/2 o2 else\n/2 G0 Y2\n/2 G0 Y3\n/2 o2 endif\nG0 Z1\nM30\n";
  EXPECT_EQ(moves_with(text, 0), 5u);
  EXPECT_EQ(moves_with(text, 2), 2u);
  EXPECT_EQ(moves_with(text, 4), 4u);
  EXPECT_EQ(moves_with(text, 6), 1u);
}

TEST_F(ControlFlow, EndsTheMainProgramByM99WhereTheChannelDoesNotBeginItAgain) {
  run("G0 X1\nM99\n");
  EXPECT_EQ(all<Move>().size(), 1u);
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::restart);
}

TEST_F(ControlFlow, BeginsAgainFromWithinAFunction) {
  int passes = 0;
  answering = [&](const ProgramRequest&) {
    Answer answer;
    answer.ok = ++passes < 4;
    return answer;
  };
  run("void again () {\n  G0 X1\n  M99\n}\n#100=[#100+1]\nmsg (str (#100));\nagain ();\nM30\n");
  EXPECT_EQ(all<Move>().size(), 4u);
  EXPECT_EQ(all<Message>().back().text, "4");
}

TEST_F(ControlFlow, ReportsTextBehindTheEndOnlyWhenItIsReached) {
  EXPECT_EQ(error_code("G0 X1\nM30\nO7\nG0 X1 X2\nM99\n"), "");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "E4001");
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(error_code("M98 P7\nM30\nO7\nG0 X1 X2\nM99\n"), "E4001");
  EXPECT_EQ(error.place.line, 4);
  EXPECT_EQ(error_code("M98 P7\nM30\nO7\nG0 X1 G99.9\nM99\n"), "E4004");
}

TEST_F(ControlFlow, DropsTheJumpsOfFaultyTextBehindTheEnd) {
  EXPECT_EQ(error_code(
                "M30\nwhile (true) { if (true) { break; } if (false) { continue; unknown = 1; } }\n"
                "do { if (true) { break; bad = 1; } } while (false);\n"),
            "");
  EXPECT_EQ(warnings.size(), 2u);
}

TEST_F(ControlFlow, NeverHidesAnErrorBehindWarnings) {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "G4 P500\n";
  EXPECT_EQ(error_code(text + "G0 X1 X2\nM30\n"), "E4001");
}

class FlowFault : public ProgramTest, public ::testing::WithParamInterface<FaultCase> {};

TEST_P(FlowFault, IsReported) {
  EXPECT_EQ(error_code(std::string(GetParam().text) + "\nM30\n"), GetParam().code)
      << GetParam().text << "\n"
      << to_text(error);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, FlowFault,
    ::testing::Values(
        FaultCase{"for (num i = 0; i < 8; i++) { G0 X=i }", "E3003"},
        FaultCase{"num depth;\nif (depth > 0) G0 Z50", "E2020"},
        FaultCase{"num count;\nif (count) { }", "E3006"},
        FaultCase{"num count;\nif (count = 1) { }", "E2001"},
        FaultCase{"if (true) { G0 Z50; G0 X0; }", "E2004"}, FaultCase{"while (true) {", "E2003"},
        FaultCase{"}", "E2003"}, FaultCase{"break;", "E3016"}, FaultCase{"continue;", "E3016"},
        FaultCase{"return;", "E3016"}, FaultCase{"num if;", "E3003"},
        FaultCase{"num goto;", "E3003"}, FaultCase{"num x1pos;", "E3003"},
        FaultCase{"num sin;", "E3003"}, FaultCase{"num do5;", "E3003"},
        FaultCase{"num end5;", "E3003"}, FaultCase{"void DO12 () {}", "E3003"},
        FaultCase{"num xsin;", "E3003"}, FaultCase{"num aa;\nnum AA;", "E3002"},
        FaultCase{"num aa;\nif (true) { num aa; }", "E3002"},
        FaultCase{"num ff () { return 1; }\nnum ff;", "E3002"},
        FaultCase{"num ff () { if (true) { return 1; } }", "E3012"},
        FaultCase{"void ff (num xx_ = 1, num yy_) { }", "E3007"},
        FaultCase{"num vv;\nvoid ff (num xx_ = vv) { }", "E3007"},
        FaultCase{"void ff (num xx_ = \"a\") { }", "E3007"},
        FaultCase{"void ff () { return 1; }", "E3004"}, FaultCase{"num ff () { return; }", "E3004"},
        FaultCase{"void ff () { }\nnum aa = ff ();", "E3004"},
        FaultCase{"void ff (num &xx_) { }\nff (1);", "E3004"},
        FaultCase{"void ff (num xx_) { }\nff ();", "E3005"}, FaultCase{"const num CC;", "E3007"},
        FaultCase{"const num CC = 1;\nCC = 2;", "E3013"}, FaultCase{"PI = 3;", "E3013"},
        FaultCase{"num aa[0];", "E3017"}, FaultCase{"num aa[2] = {1, 2, 3};", "E3017"},
        FaultCase{"num aa[2000000];", "E3017"},
        FaultCase{"switch (1) { case 1: { } case 1: { } }", "E3018"},
        FaultCase{"num vv;\nswitch (1) { case vv: { } }", "E3007"},
        FaultCase{"unknown_function (1);", "E3001"}, FaultCase{"/if (true) { }", "E2005"},
        FaultCase{"#includ \"a.nc\"", "E2010"}, FaultCase{"#workpiece (0)", "E3005"},
        FaultCase{"#kinematics (1)", "E3005"}, FaultCase{"IF [1 EQ 1] GOTO 5", "E3024"},
        FaultCase{"O<name> sub", "E2013"}, FaultCase{"G1 X1 F1 SPOS=2", "E2090"},
        FaultCase{"M3 $7", "E4053"}, FaultCase{"G0 X1 $1", "E4003"}, FaultCase{"H1=3", "E4003"},
        FaultCase{"shared num aa = 1;", "E3020"}, FaultCase{"terminate (5, \"low\");", "E3009"},
        FaultCase{"channel_wait (1);", "E6031"},
        FaultCase{"num cc = 9;\nchannel_wait (cc);", "E6001"},
        FaultCase{"num cc = 1.5;\nchannel_wait (cc);", "E3010"}));

TEST_F(ControlFlow, KeepsErrorsOfAllStatements) {
  const auto errors = load_errors(
      "G0 X1 X2\nnum aa = ;\nG99.9\nif (aa) { G1 Q5\n bb = 1; }\nG0 Y1 0\nmsg (\"x)\nM30\n");
  std::vector<std::string> codes;
  for (const Diagnostic& one : errors) codes.push_back(one.code);
  for (const char* code : {"E4001", "E2001", "E4004", "E3001", "E4003", "E1003", "E1004"}) {
    EXPECT_NE(std::find(codes.begin(), codes.end(), code), codes.end()) << code;
  }
}

TEST_F(ControlFlow, SuggestsTheNearestName) {
  EXPECT_EQ(error_code("num depth;\ndepht = 1;\nM30\n"), "E3001");
  EXPECT_EQ(error.help.at(0), "did you mean `depth`?");
  EXPECT_EQ(error_code("#kinematic (1, 1)\nM30\n"), "E2010");
  EXPECT_EQ(error.help.at(0), "did you mean `#kinematics`?");
}

TEST_F(ControlFlow, ReportsAtMostAHundredErrors) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "G0 X1 X2\n";
  EXPECT_EQ(load_errors(text).size(), 100u);
}

}  // namespace
}  // namespace stanok::lang::testing
