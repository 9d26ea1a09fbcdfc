// Values computed from the text of a line are those that the compiled block computes: the same
// blocks, plain and with a `/* */` behind them, which only the compiler reads.
#include <cmath>
#include <initializer_list>
#include <random>

#include "lang/program/program.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

constexpr unsigned seed = 20261;

// Random text of the RS274 kind; some of it has no value.
class Writer {
 public:
  std::string value(int depth) {
    switch (below(depth > 0 ? 8 : 3)) {
      case 0:
        return number();
      case 1:
        return "#" + std::to_string(1 + below(4));
      case 2:
        return below(2) == 0 ? "#<depth>" : number();
      case 3:
        return joined({pick({"-", "+", "- "}), value(depth - 1)});
      case 4:
        return joined(
            {pick({"SIN", "cos", "TAN", "SQRT", "ABS", "round", "FIX", "FUP", "LN", "EXP"}),
             bracket(depth)});
      case 5:
        return joined({"ATAN", bracket(depth), pick({"/", " / "}), bracket(depth)});
      case 6:
        return "#" + bracket(depth);
      default:
        return bracket(depth);
    }
  }
  std::string bracket(int depth) {
    std::string text = "[" + value(depth - 1);
    for (int more = below(3); more > 0; --more) {
      text += pick({"+", " - ", "*", " / ", " ** ", " MOD ", " EQ ", " ne ", " LT ", " and ",
                    " OR ", " XOR ", "-", "GE"});
      text += value(depth - 1);
    }
    return text + "]";
  }
  // The parts of a list are made from left to right, those of a sum in the order of the compiler.
  static std::string joined(std::initializer_list<std::string> parts) {
    std::string text;
    for (const std::string& part : parts) text += part;
    return text;
  }
  std::string number() { return pick({"1", "2.5", ".5", "0", "3.", "12", "0.001", "7", "100"}); }
  // `text` with one character left out, doubled or exchanged.
  std::string damaged(std::string text) {
    if (text.empty()) return text;
    const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size())));
    const std::string other = pick({"", "]", "[", "#", "-", ".", "=", " ", "<", "A", "/", "*"});
    return text.replace(at, 1, other);
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  std::string pick(std::initializer_list<const char*> choices) {
    return *(choices.begin() + below(static_cast<int>(choices.size())));
  }

  std::mt19937 random_{seed};
};

class TextValue : public ProgramTest {
 protected:
  struct Outcome {
    std::string code;
    int line = 0;
    int column = 0;
    std::vector<double> ends;
  };

  Outcome outcome(const std::string& block, const std::string& behind) {
    const std::string text = "G21 G90 F100 #1=3 #2=-0.25 #3=4 #4=1 #<depth>=2.5\n" + block +
                             behind + "\nG0 X#1 Y#2 Z#<depth> B#3\nM30\n";
    Outcome result;
    commands.clear();
    result.code = error_code(text);
    if (!result.code.empty()) {
      result.line = error.place.line;
      result.column = error.place.column;
    }
    for (const Move& move : all<Move>()) {
      for (std::size_t axis = 0; axis < 4; ++axis) result.ends.push_back(move.end[axis]);
    }
    return result;
  }
};

TEST_F(TextValue, IsThatOfTheCompiledBlock) {
  Writer writer;
  int computed = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    // Settings behind the words: of two faults both report the first.
    std::string block = Writer::joined({"G1 X", writer.value(3), " Y", writer.value(2),
                                        " #2=", writer.value(3), " #<depth> = ", writer.value(1)});
    if (turn % 3 == 0) block = writer.damaged(block);
    const Outcome plain = outcome(block, "");
    const Outcome compiled = outcome(block, " /* */");
    ASSERT_EQ(plain.code, compiled.code) << block << "\nseed " << seed;
    ASSERT_EQ(plain.ends, compiled.ends) << block << "\nseed " << seed;
    ASSERT_EQ(plain.line, compiled.line) << block << "\nseed " << seed;
    computed += plain.code.empty() ? 1 : 0;
    // Faults of the text are found by the compiler in both.
    if (!plain.code.starts_with("E30")) continue;
    // The compiler counts the brackets around a value to it, and the sign of a parameter.
    ASSERT_GE(plain.column, compiled.column) << block << "\nseed " << seed;
    for (int column = compiled.column; column < plain.column; ++column) {
      const char between = block[static_cast<std::size_t>(column) - 1];
      ASSERT_TRUE(between == '[' || between == ' ' || between == '#') << block;
    }
  }
  EXPECT_GT(computed, 500) << "too few blocks had values";
}

// A zero with a sign points the other way for ATAN: there is none.
TEST_F(TextValue, HasOneZero) {
  const std::string block = "G1 X[ATAN[-0]/[-7]] Y[ATAN[- SQRT[0]]/[-7]] #2=-0";
  const Outcome plain = outcome(block, "");
  ASSERT_EQ(plain.code, "");
  ASSERT_EQ(plain.ends.size(), 8u);
  EXPECT_EQ(plain.ends[0], 180.0);
  EXPECT_EQ(plain.ends[1], 180.0);
  EXPECT_FALSE(std::signbit(plain.ends[5]));
  EXPECT_EQ(plain.ends, outcome(block, " /* */").ends);
}

TEST_F(TextValue, NeedsNoMemoryPerBlock) {
  std::string text = "#1=0.5\nF100\n";
  for (int line = 0; line < 1000; ++line) text += "G1 X[#1 * " + std::to_string(line) + "]\n";
  files.texts["main.nc"] = text + "M30\n";
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program.has_value());
  const CompiledFile& file = *(*program)->files.front();
  EXPECT_EQ(file.plain_lines.size(), 1u) << "one piece of text";
  EXPECT_LE(file.code.size(), 4u);
}

TEST_F(TextValue, KnowsTheLineItStandsIn) {
  const auto at = moves("G0 X1\n\n(comment)\nX[#<_line> + #5420]\nX#<_line>\nM30\n");
  ASSERT_EQ(at.size(), 3u);
  EXPECT_EQ(at[1].end[0], 5.0);
  EXPECT_EQ(at[2].end[0], 5.0);
}

}  // namespace
}  // namespace stanok::lang::testing
