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
    answering = [this](const ProgramRequest&) {
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

struct WayCase {
  const char* name;
  const char* text;
  double z_M;
};

// In machine coordinates the end of a block is its W and the length: B is W here.
class LengthInIncrementTest : public ToolLengthTest,
                              public ::testing::WithParamInterface<WayCase> {};

TEST_P(LengthInIncrementTest, EndsWhereTheControlOfTheDialectEnds) {
  tables.tools[1] = {1, {0.0, 0.0, -4.0}, 0.0};
  const auto list = moves(GetParam().text);
  const auto lengths = all<ToolLength>();
  ASSERT_FALSE(list.empty());
  const double length = lengths.empty() ? 0.0 : lengths.back().offset_mm[2];
  EXPECT_NEAR(list.back().end[2] + length, GetParam().z_M, 1e-9);
}

// The first is an example of Fanuc's operator's manual (B-64304EN, tool length offset: boring);
// the others by its rule, that the end of a block is the programmed one and the offset.
INSTANTIATE_TEST_SUITE_P(
    Blocks, LengthInIncrementTest,
    ::testing::Values(
        WayCase{"boring",
                "(dialect fanuc)\nN1 G91 G00 X120.0 Y80.0\nN2 G43 Z-32.0 H1\n"
                "N3 G01 Z-21.0 F1000\nM2\n",
                -57.0},
        WayCase{"g43", "(dialect fanuc)\nG91 G43 G0 Z-10 H3\nM2\n", 20.0},
        WayCase{"g44", "(dialect fanuc)\nG91 G44 G0 Z-10 H3\nM2\n", -40.0},
        WayCase{"g49", "(dialect fanuc)\nG43 H3\nG91 G49 G0 Z-10\nM2\n", -40.0},
        WayCase{"h_alone", "(dialect fanuc)\nG43 H3\nG91 G0 Z-10 H4\nM2\n", -33.0},
        WayCase{"no_way", "(dialect fanuc)\nG91 G43 G0 Z0 H3\nM2\n", 30.0},
        WayCase{"back_to_g90", "(dialect fanuc)\nG0 Z5\nG91\nG90 G43 G0 Z1 H3\nM2\n", 31.0},
        WayCase{"length_before", "(dialect fanuc)\nG43 H3\nG91 G0 Z-10\nM2\n", -10.0},
        WayCase{"cycle", "(dialect fanuc)\nG91 G99 G43 G81 Z-10 R-5 H3 F100\nM2\n", 25.0},
        WayCase{"cycle_to_initial_level", "(dialect fanuc)\nG91 G98 G43 G81 Z-10 R-5 H3 F100\nM2\n",
                30.0},
        WayCase{"haas", "(dialect haas)\nG91 G43 G0 Z-10 H3\nM2\n", 20.0},
        WayCase{"linuxcnc", "(dialect linuxcnc)\nG91 G43 G0 Z-10 H3\nM2\n", -10.0},
        WayCase{"stanok", "G91 G43 G0 Z-10 H3\nM2\n", -10.0}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace stanok::lang::testing
