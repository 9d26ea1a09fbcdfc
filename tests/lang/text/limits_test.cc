// The limits of the language, each at the limit and one beyond it.
#include <array>
#include <new>

#include "lang/tree/value.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

// Codes that exclude each other in nothing.
constexpr auto one_of_each_group = std::to_array<std::string_view>(
    {"G0 ", "G17 ", "G90 ", "G91.1 ", "G94 ", "G21 ", "G40 ", "G49 ", "G13.1 ", "G98 ", "G50 ",
     "G54 ", "G64 ", "G97 ", "G8 ", "G69 ", "G4 P0 "});

struct LimitCase {
  const char* name;
  std::size_t limit;
  std::string (*text)(std::size_t count);  // a program that uses `count` of it
  const char* code;                        // of the fault beyond the limit
};

class Limit : public ProgramTest, public ::testing::WithParamInterface<LimitCase> {};

TEST_P(Limit, IsReachedButNotExceeded) {
  const LimitCase& one = GetParam();
  EXPECT_EQ(error_code(one.text(one.limit) + "M30\n"), "") << to_text(error);
  EXPECT_EQ(error_code(one.text(one.limit + 1) + "M30\n"), one.code);
}

INSTANTIATE_TEST_SUITE_P(
    Limits, Limit,
    ::testing::Values(
        LimitCase{"BytesOfABlock", 4096,
                  [](std::size_t count) { return "#1=1" + repeated(" ", count - 4) + "\n"; },
                  "E1007"},
        LimitCase{
            "BytesOfAStatement", 65536,
            [](std::size_t count) { return "num aa = 1" + repeated(" ", count - 11) + ";\n"; },
            "E1007"},
        LimitCase{"BytesOfTheHeadOfALoop", 65536,
                  [](std::size_t count) {
                    return "num aa;\nwhile (" + repeated(" ", count - 9) + "aa > 1) { M5 }\n";
                  },
                  "E1007"},
        LimitCase{"BytesOfAJoinedString", 4096,
                  [](std::size_t count) {
                    return "string aa = \"" + repeated("x", count - 1) + "\";\naa += \"y\";\n";
                  },
                  "E3009"},
        LimitCase{"Braces", 64,
                  [](std::size_t count) {
                    return repeated("{", count) + " M5\n" + repeated("}", count) + "\n";
                  },
                  "E2030"},
        LimitCase{"Parentheses", 64,
                  [](std::size_t count) {
                    return "num aa = " + repeated("(", count) + "1" + repeated(")", count) + ";\n";
                  },
                  "E2030"},
        LimitCase{"Brackets", 64,
                  [](std::size_t count) {
                    return "#1=" + repeated("[", count) + "1" + repeated("]", count) + "\n";
                  },
                  "E2030"},
        LimitCase{"ElseIfs", 1000,
                  [](std::size_t count) {
                    return "num aa;\nif (aa > 0) { }" + repeated(" else if (aa > 1) { }", count) +
                           "\n";
                  },
                  "E2031"},
        LimitCase{"CallsOfFunctions", 64,
                  [](std::size_t count) {
                    return "void down (num left) { if (left > 1) { down (left - 1); } }\ndown (" +
                           std::to_string(count) + ");\n";
                  },
                  "E8001"},
        LimitCase{"CallsOfOLines", 64,
                  [](std::size_t count) {
                    return "O1 sub\nO2 if [#1 GT 1]\nO1 call [#1 - 1]\nO2 endif\nO1 endsub\n"
                           "O1 call [" +
                           std::to_string(count) + "]\n";
                  },
                  "E8001"},
        LimitCase{"CallsOfNumberedPrograms", 64,
                  [](std::size_t count) {
                    return "#1=" + std::to_string(count) +
                           "\nM98 P100\nM30\nO100\nO2 if [#1 GT 1]\n#1=[#1 - 1]\nM98 P100\n"
                           "O2 endif\nM99\n";
                  },
                  "E8001"},
        LimitCase{"ArgumentsOfACall", 30,
                  [](std::size_t count) {
                    return "O1 sub\nO1 endsub\nO1 call" + repeated(" [1]", count) + "\n";
                  },
                  "E3005"},
        LimitCase{"ElementsOfAnArray", 1000000,
                  [](std::size_t count) { return "num aa[" + std::to_string(count) + "];\n"; },
                  "E3017"},
        LimitCase{"Operators", 1000,
                  [](std::size_t count) { return "num aa = 1" + repeated("+1", count) + ";\n"; },
                  "E2031"},
        LimitCase{"LettersOfAName", 64,
                  [](std::size_t count) { return "num " + repeated("a", count) + ";\n"; }, "E3003"},
        LimitCase{"CodesOfABlock", 16,
                  [](std::size_t count) {
                    std::string block;
                    for (std::size_t i = 0; i < count; ++i) block += one_of_each_group[i];
                    return block + "\n";
                  },
                  "E4005"}),
    [](const auto& one) { return std::string(one.param.name); });

class ManyFiles : public ProgramTest {};

TEST_F(ManyFiles, CallEachOtherInAllWaysSixtyFourTimesTogether) {
  const std::string deeper = "O1 if [#100 GT 0]\n#100=[#100 - 1]\n";
  files.texts["functions.nc"] =
      "void deeper () {\nif (#100 > 0) {\n#100=[#100 - 1]\ncall (\"called.nc\");\n}\n}\n";
  files.texts["called.nc"] = deeper + "M98 P200\nO1 endif\nM99\n";
  files.texts["200.nc"] = "O200\n" + deeper + "O<lower> call\nO1 endif\nM99\n";
  files.texts["lower.nc"] = "O<lower> sub\n" + deeper + "G65 P400\nO1 endif\nO<lower> endsub\n";
  files.texts["400.nc"] =
      "#include \"functions.nc\"\nO400\n" + deeper + "deeper ();\nO1 endif\nM99\n";
  for (const int calls : {64, 65}) {
    const std::string code = error_code(
        "#include \"functions.nc\"\n#100=" + std::to_string(calls - 1) + "\ndeeper ();\nM30\n");
    EXPECT_EQ(code, calls == 64 ? "" : "E8001") << to_text(error);
  }
  ASSERT_EQ(error.stack.size(), 64u);
  for (const std::size_t level : {std::size_t{0}, std::size_t{63}}) {
    EXPECT_NE(error.stack[level].find("called at"), std::string::npos) << error.stack[level];
  }
  EXPECT_NE(error.stack[63].find("in deeper(), called at main.nc:3:1"), std::string::npos)
      << error.stack[63];
}

TEST_F(ManyFiles, AreAtMostTwoHundredAndFiftySix) {
  for (const int included : {255, 256}) {
    std::string text;
    for (int i = 0; i < included; ++i) {
      const std::string name = "part" + std::to_string(i) + ".nc";
      files.texts[name] = "const num PART = 1;\n";
      text += "#include \"" + name + "\"\n";
    }
    EXPECT_EQ(error_code(text + "M30\n"), included == 255 ? "" : "E8003");
  }
}

class Memory : public ProgramTest {
 protected:
  static constexpr std::size_t most = std::size_t{64} << 20;
};

TEST_F(Memory, IsBoundForAllArraysTogether) {
  const std::size_t elements = most / sizeof(Value);
  const auto arrays = [&](std::size_t rest) {
    return "num aa[1000000];\nnum bb[1000000];\nnum cc[" + std::to_string(rest) + "];\nM30\n";
  };
  EXPECT_EQ(error_code(arrays(elements - 2000000)), "");
  EXPECT_EQ(error_code(arrays(elements - 2000000 + 1)), "E8002");
}

TEST_F(Memory, OfArraysThatAreGoneIsFree) {
  EXPECT_EQ(error_code("num turn;\nwhile (turn < 20) { num many[1000000]; turn += 1; }\nM30\n"),
            "");
}

TEST_F(Memory, HoldsTheStringsOfArraysToo) {
  const std::size_t string_bytes = 4096;
  const std::size_t count = most / (string_bytes + sizeof(Value));
  const auto strings = [&](std::size_t filled) {
    return "string one = \"" + repeated("x", string_bytes) + "\";\nstring many[" +
           std::to_string(count + 1) + "];\nnum idx;\nwhile (idx < " + std::to_string(filled) +
           ") {\nmany[idx] = one;\nidx += 1;\n}\n" +
           // What is written over counts no more.
           "many[0] = \"\";\nmany[0] = one;\nM30\n";
  };
  EXPECT_EQ(error_code(strings(count)), "") << to_text(error);
  EXPECT_EQ(error_code(strings(count + 1)), "E8002");
}

class Loop : public ProgramTest {};

TEST_F(Loop, HasNoLimitOfPasses) {
  EXPECT_EQ(messages("num idx;\nwhile (idx < 300000) { idx += 1; }\nmsg (str (idx));\nM30\n"),
            std::vector<std::string>{"300000"});
  EXPECT_EQ(messages("#1=0\nO1 repeat [200000]\n#1=[#1 + 1]\nO1 endrepeat\n(DEBUG,%d#1)\nM30\n"),
            std::vector<std::string>{"200000"});
}

TEST_F(Loop, WithoutABlockCanBeStopped) {
  for (const char* const text : {"while (true) { }\n", "O1 while [1]\nO1 endwhile\n",
                                 "O1 while [1]\n#1=[#1 + 1]\nO1 endwhile\n"}) {
    files.texts["main.nc"] = std::string(text) + "M30\n";
    const auto program = compile("main.nc", files, &channel, warnings);
    ASSERT_TRUE(program.has_value()) << text;
    interpreter = std::make_unique<Interpreter>(channel, tables, files);
    interpreter->start(*program, start_B);
    Command command;
    while (interpreter->next(command) == Step::command) {
    }
    for (int turn = 0; turn < 3; ++turn) EXPECT_EQ(interpreter->next(command), Step::working);
    EXPECT_LE(interpreter->origin().line, 3u) << text;
  }
}

TEST_F(ProgramTest, SaysAtMostAHundredErrorsOfAFile) {
  EXPECT_EQ(load_errors(repeated("G777\n", 100) + "M30\n").size(), 100u);
  EXPECT_EQ(load_errors(repeated("G777\n", 101) + "M30\n").size(), 100u);
}

// Files of a machine that has no memory left.
class NoMemory : public Files {
 public:
  [[nodiscard]] Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    throw std::bad_alloc();
  }
};

TEST_F(Memory, ThatDoesNotSufficeIsAnErrorOfTheProgram) {
  const auto program = compile("part.nc", NoMemory(), nullptr, warnings);
  ASSERT_FALSE(program);
  ASSERT_EQ(program.error().size(), 1U);
  EXPECT_EQ(program.error()[0].code, "E8002");
  EXPECT_EQ(program.error()[0].place.file, "part.nc");
  const auto line = compile_line("#include \"other.nc\"", nullptr, NoMemory(), nullptr, warnings);
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error()[0].code, "E8002");
}

}  // namespace
}  // namespace stanok::lang::testing
