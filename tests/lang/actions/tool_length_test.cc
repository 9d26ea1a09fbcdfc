// Tool length compensation: it stays as it was put in force, as one value, whatever is written into
// the tool table meanwhile.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class ToolLengthTest : public ProgramTest {
 protected:
  ToolLengthTest() {
    tables.tools[3] = {3, {0.0, 0.0, 30.0}, 0.0};
    tables.tools[4] = {4, {0.0, 0.0, 7.0}, 0.0};
    // Tool 3 is measured while the program waits.
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

// language.md: a length that a program writes counts from the next G43.
TEST_F(ToolLengthTest, AValueOfTheTableCountsFromTheNextG43) {
  EXPECT_EQ(lengths("T3 M6 G43\nsync ();\nG0 Z0\nG43\nM30\n"), (std::vector<double>{30.0, 35.0}));
}

TEST_F(ToolLengthTest, ASyncPointChangesNoLength) {
  EXPECT_EQ(lengths("G44 H3\nsync ();\nM30\n"), (std::vector<double>{-30.0}));
  EXPECT_EQ(lengths("G43 H4\nG43.2 H3\nsync ();\nM30\n"), (std::vector<double>{7.0, 42.0}));
  EXPECT_EQ(lengths("T3 M6 G43.1 Z12\nsync ();\nM30\n"), (std::vector<double>{12.0}));
}

// H0 is no length, where tool 3 has one.
TEST_F(ToolLengthTest, NoLengthStaysNoLengthAtASyncPoint) {
  const auto list = moves("T3 M6\nG43 H0\nsync ();\nM1\nG0 Z50\nM30\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].end[2], 50.0);
  for (const ToolLength& length : all<ToolLength>()) EXPECT_EQ(length.offset_mm[2], 0.0);
}

// Saved while 30 mm are in force, restored while 7 are.
TEST_F(ToolLengthTest, IsRestoredWhole) {
  run("G43 H4\nG43.2 H3\nM70\nG49\nM72\nsync ();\nM30\n");
  EXPECT_EQ(error.code, "") << to_text(error);
  const auto all_lengths = all<ToolLength>();
  ASSERT_EQ(all_lengths.size(), 4u);
  EXPECT_EQ(all_lengths[3], all_lengths[1]);
  EXPECT_EQ(all_lengths[3].base_mm[2], 7.0);
  EXPECT_EQ(all_lengths[3].tool, 3);
}

TEST_F(ToolLengthTest, MovesTheProgrammedPointByTheNewLength) {
  const auto list = moves("G0 Z100\nT3 M6 G43\nsync ();\nG91 G0 Z1\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].end[2], 71.0);
}

TEST_F(ToolLengthTest, NeedsTheToolThatG432Adds) {
  EXPECT_EQ(error_code("G43.2\nM30\n"), "E4007");
}

}  // namespace
}  // namespace stanok::lang::testing
