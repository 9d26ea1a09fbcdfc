// Compilations that come to an end: large, deep and faulty texts in one pass, texts that are too
// large, compilations that are interrupted; and runs that compute without end.
#include <algorithm>

#include "lang/text/limits.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class CompileEndTest : public ProgramTest {
 protected:
  std::string code_with(const std::string& text, const Interruption& interrupted = {}) {
    files.texts["main.nc"] = text;
    const auto program = compile("main.nc", files, &channel, warnings, interrupted);
    return program ? "" : program.error().front().code;
  }
};

// Each of these took minutes when the work grew with the square of the length.
TEST_F(CompileEndTest, TextsOfVeryManyFaultsAreReadInOnePass) {
  constexpr int many = 100'000;
  EXPECT_EQ(code_with(repeated("{", many) + "\n" + repeated("}", many) + "\nM30\n"), "E2030");
  EXPECT_EQ(code_with(repeated("}", many) + "\nM30\n"), "E2003");
  EXPECT_EQ(code_with("M30\n" + repeated("?;", many) + "\n"), "") << "nothing reaches it";
  EXPECT_EQ(code_with("num aa;\n" + repeated("aa = bb;", many) + "\nM30\n"), "E3001");
  EXPECT_EQ(code_with(repeated("(\xcf\xf0\xe8)\n", many) + "M30\n"), "");
}

TEST_F(CompileEndTest, WhatVeryManyCallsMeanIsLookedUpAndNotSearchedFor) {
  const std::string calls = repeated("O7 call\nM98 P55\n", 200'000);
  EXPECT_EQ(code_with(calls + "M30\nO7 sub\nO7 endsub\nO55\nM99\n"), "");
}

TEST_F(CompileEndTest, AllCasesOfALargeSwitchAreCompared) {
  std::string cases;
  for (int k = 0; k < 100'000; ++k) cases += "case " + std::to_string(k) + ": {}";
  EXPECT_EQ(code_with("switch (1) {" + cases + "}\nM30\n"), "");
  EXPECT_EQ(code_with("switch (1) {" + cases + "case 7: {}}\nM30\n"), "E3018");
}

TEST_F(CompileEndTest, AFaultBehindTheEndOfTheProgramIsRaisedWhereItIsReached) {
  run("O100 call\nM30\nO100 sub\n  G1 X1 F100\n  ?\nO100 endsub\n");
  EXPECT_EQ(error.code, "E2001");
  EXPECT_EQ(error.place.line, 5);
  EXPECT_EQ(error.place.column, 3);
  EXPECT_EQ(error.source_line, "  ?");
}

TEST_F(CompileEndTest, TheLineOfABadCharacterInALongCommentIsRight) {
  static_cast<void>(code_with("M5\r\n/* one\r\ntwo\rthree \xff\n*/\nM30\n"));
  const auto found = std::find_if(warnings.begin(), warnings.end(),
                                  [](const Diagnostic& one) { return one.code == "W110"; });
  ASSERT_NE(found, warnings.end());
  EXPECT_EQ(found->place.line, 4);
  EXPECT_EQ(found->place.column, 7);
}

TEST_F(CompileEndTest, AListOfValuesIsNotReadBeyondTheLengthOfAStatement) {
  EXPECT_EQ(code_with("num aa[] = {1" + repeated(",1", 40'000) + "};\nM30\n"), "E1007");
  EXPECT_EQ(code_with("num aa" + repeated(", bb = 1", 10'000) + ";\nM30\n"), "E1007");
  EXPECT_EQ(code_with("G1 X1" + repeated(" R1=1", 1000) + "\nM30\n"), "E1007");
}

TEST_F(CompileEndTest, AllFilesTogetherAreBounded) {
  channel.bounds.bytes = 1000;
  files.texts["sub.nc"] = repeated("M5\n", 200);
  EXPECT_EQ(code_with("#include \"sub.nc\"\nM30\n"), "");
  EXPECT_EQ(code_with("#include \"sub.nc\"\n" + repeated("M5\n", 130) + "M30\n"), "E8004");
  EXPECT_EQ(code_with(repeated("M5\n", 400)), "E8004");
}

TEST_F(CompileEndTest, StatementsOfAProgramAreBoundedFullSize) {
  const std::string statement = "aa=1;\n";
  const auto text = [&](std::size_t count) {
    return "num aa;\n" + repeated(statement, count - 1) + "G1 X1 F1\n";
  };
  EXPECT_EQ(code_with(text(limits::statements)), "");
  EXPECT_EQ(code_with(text(limits::statements + 1)), "E8002");
}

TEST_F(CompileEndTest, AnInterruptedCompilationIsAnErrorOfTheProgram) {
  int asked = 0;
  const auto after = [&asked](int times) { return [&asked, times] { return ++asked > times; }; };
  EXPECT_EQ(code_with(repeated("G1 X1 F100\n", 1000) + "M30\n", after(500)), "E6072");
  EXPECT_LT(asked, 510);
  asked = 0;
  EXPECT_EQ(code_with(repeated("{ M5 }\n", 1000) + "M30\n", after(4500)), "E6072") << "compiler";
}

// A million steps and what one call of next() does.
TEST_F(CompileEndTest, ARunThatOnlyComputesIsEnded) {
  channel.bounds.steps = 1'000'000;
  for (const char* text :
       {"while (true) { }\nM30\n", "num aa;\nwhile (true) { aa += 1; }\nM30\n",
        "while (true) { G1 X0 F100\n}\nM30\n", "M98 P100 L99999999\nM30\nO100\nM99\n"}) {
    run(text);
    EXPECT_EQ(error.code, "E8005") << text;
    EXPECT_LT(interpreter->steps(), 4'000'000U) << text;
  }
}

TEST_F(CompileEndTest, StepsThatAreRenewedDoNotEndARun) {
  channel.bounds.steps = 1'000'000;
  files.texts["main.nc"] = "#1=0\nwhile (#1 < 100000) {\n#1=[#1+1]\nG1 X[#1] F100\n}\nM30\n";
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  interpreter = std::make_unique<Interpreter>(channel, tables, files);
  interpreter->start(*program, start_B);
  Command command;
  Step step = Step::working;
  while (step == Step::working || step == Step::command) {
    step = interpreter->next(command);
    if (step == Step::command) interpreter->renew_steps();
  }
  EXPECT_EQ(step, Step::ended);
  EXPECT_GT(interpreter->steps(), 10'000'000U) << "a block counts hundred";
}

}  // namespace
}  // namespace stanok::lang::testing
