// Parameters that only controls of Fanuc give a meaning. What they are there: operator's manual
// B-64304EN, 16.2 (system variables); that LinuxCNC has none of them: its list of numbered
// parameters.
#include "lang/program/foreign_parameter.h"

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

struct ForeignCase {
  const char* name;
  const char* text;
  std::vector<int> lines;  // of warnings
};

class ForeignParameterTest : public ProgramTest,
                             public ::testing::WithParamInterface<ForeignCase> {};

TEST_P(ForeignParameterTest, IsWarnedOfWhereItIsOnlyReadOrOnlySet) {
  files.texts["O0200.nc"] = "#5041=7\nM99\n";
  ASSERT_TRUE(load_errors(GetParam().text).empty());
  std::vector<int> lines;
  for (const Diagnostic& warning : warnings) {
    EXPECT_EQ(warning.code, "W414") << to_text(warning);
    lines.push_back(static_cast<int>(warning.place.line));
  }
  EXPECT_EQ(lines, GetParam().lines);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, ForeignParameterTest,
    ::testing::Values(
        ForeignCase{"in_a_block", "G0 X1\nG0 X#5021\nM2\n", {2}},
        ForeignCase{"in_linuxcnc", "(dialect linuxcnc)\n#1=[#5041+1]\nG0 X#1\nM2\n", {2}},
        ForeignCase{"once", "G0 X#5021\nG0 X#5021\nM2\n", {1}},
        ForeignCase{"alarm", "#3000=1 (NO TOOL)\nM2\n", {1}},
        ForeignCase{"modal_code", "O1 if [#4003 EQ 91]\nG90\nO1 endif\nM2\n", {1}},
        ForeignCase{"input", "WHILE [#1000 EQ 0] DO1\nEND1\nM2\n", {1}},
        ForeignCase{"length", "G0 Z[#5083]\nM2\n", {1}},
        ForeignCase{"own_variable", "#5021=5\nG0 X#5021\n#2001=1 #1100=#2001\nG0 X#1100\nM2\n", {}},
        ForeignCase{"of_a_file", "M98 P200\nG0 X#5041\nM2\n", {}},
        ForeignCase{"of_linuxcnc", "G0 X#5061 Y#5221\nG0 X#5420\n#1=#5400\n#2=#5399\nM2\n", {}},
        ForeignCase{"of_fanuc", "(dialect fanuc)\n#1=#5021\n#3000=1 (NO TOOL)\nM2\n", {}}),
    [](const auto& one) { return one.param.name; });

// A line by hand sets what another line reads.
TEST_F(ProgramTest, ALineByHandIsNotWarnedOfForeignParameters) {
  Diagnostics said;
  const auto line = compile_line("G0 X#5021", nullptr, files, &channel, said);
  EXPECT_TRUE(line.has_value());
  EXPECT_TRUE(said.empty());
}

}  // namespace
}  // namespace stanok::lang::testing
