// Tool length compensation follows the tool table.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class ToolLengthTest : public ProgramTest {
 protected:
  ToolLengthTest() {
    tables.tools[3] = {3, {0.0, 0.0, 30.0}, 0.0};
    tables.tools[4] = {4, {0.0, 0.0, 7.0}, 0.0};
    // The operator measures tool 3 while the program waits.
    answering = [this](const Request&) {
      tables.tools[3].length_mm = {0.0, 0.0, 35.0};
      return Answer{};
    };
  }

  std::vector<double> lengths(const std::string& text) {
    run(text);
    EXPECT_EQ(error.code, "") << to_text(error);
    std::vector<double> list;
    for (const ToolLength& length : all<ToolLength>()) list.push_back(length.offset_mm[2]);
    return list;
  }
};

TEST_F(ToolLengthTest, TakesANewValueOfTheTableFromTheNextBlock) {
  EXPECT_EQ(lengths("T3 M6 G43\nsync ();\nG0 Z0\nM30\n"), (std::vector<double>{30.0, 35.0}));
}

TEST_F(ToolLengthTest, KeepsTheSignOfG44) {
  EXPECT_EQ(lengths("G44 H3\nsync ();\nM30\n"), (std::vector<double>{-30.0, -35.0}));
}

TEST_F(ToolLengthTest, KeepsWhatG432AddedTo) {
  EXPECT_EQ(lengths("G43 H4\nG43.2 H3\nsync ();\nM30\n"), (std::vector<double>{7.0, 37.0, 42.0}));
}

TEST_F(ToolLengthTest, LeavesLengthsGivenByAxisWordsAlone) {
  EXPECT_EQ(lengths("T3 M6 G43.1 Z12\nsync ();\nM30\n"), (std::vector<double>{12.0}));
}

TEST_F(ToolLengthTest, MovesTheProgrammedPointWithTheNewValue) {
  const auto list = moves("G0 Z100\nT3 M6 G43\nsync ();\nG91 G0 Z1\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].end[2], 66.0);
}

TEST_F(ToolLengthTest, NeedsTheToolThatG432Adds) {
  EXPECT_EQ(error_code("G43.2\nM30\n"), "E4007");
}

}  // namespace
}  // namespace stanok::lang::testing
