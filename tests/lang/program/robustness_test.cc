// Properties over random programs: both ways of a block agree, and no text does any harm.
#include <bit>
#include <cstdlib>
#include <random>

#include "lang/text/number.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

// One number for everything in a command that a double or a flag can tell.
std::vector<double> fingerprint(const Command& command) {
  std::vector<double> all{static_cast<double>(command.payload.index()),
                          static_cast<double>(command.origin.line),
                          static_cast<double>(command.block)};
  if (const auto* move = std::get_if<Move>(&command.payload)) {
    all.insert(all.end(), move->end.begin(), move->end.end());
    all.insert(all.end(), move->centre.begin(), move->centre.end());
    all.insert(all.end(),
               {static_cast<double>(move->kind), static_cast<double>(move->words), move->feed,
                static_cast<double>(move->feed_mode), static_cast<double>(move->path.mode),
                move->path.tolerance_mm, static_cast<double>(move->plane),
                move->counter_clockwise ? 1.0 : 0.0, static_cast<double>(move->turns),
                move->stop_at_end ? 1.0 : 0.0, move->machine_coordinates ? 1.0 : 0.0});
  }
  if (const auto* frame = std::get_if<FrameChange>(&command.payload)) {
    all.insert(all.end(), frame->offset.begin(), frame->offset.end());
  }
  if (const auto* dwell = std::get_if<Dwell>(&command.payload)) all.push_back(dwell->seconds);
  return all;
}

class Robustness : public ProgramTest {
 protected:
  std::mt19937 random{20260};

  int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random); }

  std::string number() {
    const int whole = below(2000) - 1000;
    char text[48];
    switch (below(5)) {
      case 0:
        std::snprintf(text, sizeof text, "%d", whole);
        break;
      case 1:
        std::snprintf(text, sizeof text, "%d.", whole);
        break;
      case 2:
        std::snprintf(text, sizeof text, "+%d.%03d", std::abs(whole), below(1000));
        break;
      case 3:
        std::snprintf(text, sizeof text, "%s.%05d", whole < 0 ? "-" : "", below(100000));
        break;
      default:
        std::snprintf(text, sizeof text, "%.17f", whole / 7.0);
    }
    return text;
  }

  std::string random_block() {
    static const char* const codes[] = {"G0",  "g1", "G90", "G91", "G17", "G55 ", "G54", "G20",
                                        "G21", "G9", "G61", "G64", "G94", "G53",  "G80", "G4P0.2"};
    std::string line;
    if (below(4) == 0) line += "N" + std::to_string(below(9999)) + " ";
    if (below(2) == 0) line += codes[below(16)];
    for (const char* axis : {"X", "y", "Z ", "B", "C"}) {
      if (below(2) == 0) line += axis + number() + (below(2) == 0 ? " " : "");
    }
    if (below(6) == 0) line += "F" + std::to_string(below(900));
    if (below(6) == 0) line += "(note)";
    return line;
  }
};

TEST_F(Robustness, BothWaysOfABlockMakeTheSameCommands) {
  tables.offsets[2] = {1.5, -2.5, 3.5, 10.0, 20.0};
  for (int n = 0; n < 300; ++n) {
    std::string plain = "G1 F100\n";
    std::string compiled = plain;
    for (int i = 0; i < 12; ++i) {
      const std::string line = random_block();
      plain += line + "\n";
      compiled += line + "/* not plain */\n";
    }
    run(plain);
    const auto plain_commands = commands;
    const std::string plain_error = error.code;
    const Place plain_place = error.place;
    run(compiled);
    EXPECT_EQ(error.code, plain_error) << plain;
    EXPECT_EQ(error.place.line, plain_place.line) << plain;
    EXPECT_EQ(error.place.column, plain_place.column) << plain;
    ASSERT_EQ(commands.size(), plain_commands.size()) << plain;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      EXPECT_EQ(fingerprint(commands[i]), fingerprint(plain_commands[i]))
          << plain << " command " << i;
    }
  }
}

TEST_F(Robustness, NumbersAreCorrectlyRounded) {
  for (int n = 0; n < 20000; ++n) {
    std::string text = below(2) == 0 ? "-" : "";
    const int digits = 1 + below(24);
    const int point = below(digits + 1);
    for (int i = 0; i < digits; ++i) {
      if (i == point) text += '.';
      text += static_cast<char>('0' + below(10));
    }
    const char* at = text.data();
    double value = 0.0;
    bool whole = false;
    ASSERT_TRUE(read_number(at, text.data() + text.size(), value, whole)) << text;
    EXPECT_EQ(at, text.data() + text.size());
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value),
              std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr) + 0.0))
        << text;
  }
}

// Pieces of real syntax in random order: nothing may crash, hang or end without an answer.
TEST_F(Robustness, AnyTextIsAnsweredByAProgramOrByErrors) {
  static const char* const pieces[] = {"G1",
                                       "X",
                                       "10",
                                       ".5",
                                       "=",
                                       "==",
                                       "(",
                                       ")",
                                       "[",
                                       "]",
                                       "{",
                                       "}",
                                       "\n",
                                       "\n",
                                       ";",
                                       " ",
                                       "#",
                                       "#5",
                                       "#<ab>",
                                       "if",
                                       "while",
                                       "for",
                                       "switch",
                                       "case 1:",
                                       "default:",
                                       "else",
                                       "num",
                                       "bool",
                                       "string",
                                       "aa",
                                       "bb",
                                       "sin",
                                       "(1)",
                                       "true",
                                       "return",
                                       "break;",
                                       "/",
                                       "//",
                                       "/*",
                                       "*/",
                                       "\"",
                                       "\"s\"",
                                       "%",
                                       "N10",
                                       "O100",
                                       "M98 P100",
                                       "M99",
                                       "M30",
                                       "+",
                                       "-",
                                       "**",
                                       "&&",
                                       "||",
                                       "!",
                                       "?",
                                       ":",
                                       ",",
                                       "&",
                                       "$",
                                       "$pos",
                                       "@",
                                       "#include \"a.nc\"",
                                       "#kinematics (1,1)",
                                       "channel_wait",
                                       "msg",
                                       "call",
                                       "void",
                                       "const",
                                       "++",
                                       "+=",
                                       "1e5",
                                       "\xD0\xA4",
                                       "\xFF",
                                       "\t",
                                       "\r",
                                       "S",
                                       "T1",
                                       "H1=",
                                       "R5=",
                                       "S_n=",
                                       "void ff (",
                                       "(MSG,",
                                       "do",
                                       "do1",
                                       "IF [",
                                       "Xsin[",
                                       "atan[1]/[2]"};
  constexpr int count = static_cast<int>(std::size(pieces));
  files.texts["a.nc"] = "num inner (num xx_) { return xx_; }\n";
  for (int n = 0; n < 4000; ++n) {
    std::string text;
    const int length = 1 + below(40);
    for (int i = 0; i < length; ++i) {
      text += pieces[below(count)];
      if (below(3) == 0) text += ' ';
    }
    files.texts["main.nc"] = text;
    warnings.clear();
    const auto program = compile("main.nc", files, &channel, warnings);
    if (!program) {
      ASSERT_FALSE(program.error().empty()) << text;
      for (const Diagnostic& one : program.error()) EXPECT_FALSE(to_text(one).empty());
      continue;
    }
    Interpreter one(channel, tables, files);
    one.start(*program, {});
    Command command;
    for (int i = 0; i < 50; ++i) {
      const Step step = one.next(command);
      if (step == Step::ended || step == Step::failed) break;
      if (step == Step::waiting) one.answer({});
    }
  }
}

TEST_F(Robustness, RandomBytesAreAnswered) {
  for (int n = 0; n < 1000; ++n) {
    std::string text;
    const int length = below(200);
    for (int i = 0; i < length; ++i) text += static_cast<char>(below(256));
    files.texts["main.nc"] = text;
    const auto program = compile("main.nc", files, nullptr, warnings);
    if (!program) {
      EXPECT_FALSE(program.error().empty());
    }
  }
}

TEST_F(Robustness, DeepNestingIsAnErrorNotACrash) {
  const std::string deep[] = {"num aa = " + repeated("(", 5000) + "1;\n",
                              "num aa = " + repeated("-", 5000) + "1;\n",
                              "num aa = " + repeated("sin(", 5000) + "1;\n",
                              "num aa = 1" + repeated("+1", 5000) + ";\n",
                              "G1 X[1" + repeated("+1", 1500) + "]\n",
                              "num aa = " + repeated("true?1:", 5000) + "1;\n",
                              "num aa = " + repeated("2**", 5000) + "1;\n",
                              repeated("{", 5000),
                              repeated("if (true) {", 5000),
                              "if (true) { }" + repeated(" else if (true) { }", 5000),
                              "G1 X" + repeated("[", 3000) + "1\n",
                              "G1 X" + repeated("-", 3000) + "1\n",
                              "G1 X" + repeated("#", 3000) + "1\n",
                              "G1 X" + repeated("sin[", 900) + "1\n"};
  for (const std::string& text : deep) {
    const auto errors = load_errors(text + "M30\n");
    EXPECT_FALSE(errors.empty()) << text.substr(0, 40);
  }
}

TEST_F(Robustness, LongSumsAreNoNesting) {
  std::string sum = "num aa = 1";
  for (int i = 0; i < 900; ++i) sum += " + 1";
  const auto list = moves(sum + ";\nG0 X=aa\nM30\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].end[0], 901.0);
}

}  // namespace
}  // namespace stanok::lang::testing
