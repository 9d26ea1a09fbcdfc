// Variables of the Fanuc dialect that outlive a run: what is kept, counted, and forgotten.
#include <gtest/gtest.h>

#include "lang/run/block_search.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class MacroVariables : public ProgramTest {};

TEST_F(MacroVariables, KeptOnesAreThereInTheNextRun) {
  run("(dialect fanuc)\n#500=6.5\n#501=#0\nM30\n");
  EXPECT_EQ(tables.common_variables.at(500), 6.5);
  EXPECT_TRUE(std::isnan(tables.common_variables.at(501)));
  run("(dialect fanuc)\nX#500 Y#501\nM30\n");
  ASSERT_FALSE(commands.empty());
  const Move& move = std::get<Move>(commands.front().payload);
  EXPECT_EQ(move.end[0], 6.5);
  EXPECT_EQ(move.words, axis_bit(0));
}

TEST_F(MacroVariables, PartsAreCountedByTheEndOfTheProgram) {
  run("(dialect fanuc)\nM30\n");
  run("(dialect fanuc)\nM2\n");
  run("(dialect fanuc)\nX1\n");  // no M30: no part
  run("M30\n");                  // not of the dialect
  EXPECT_EQ(tables.common_variables.at(3901), 2.0);
}

TEST_F(MacroVariables, OtherDialectsHaveNoneThatIsKept) {
  run("#500=6\nX#500\nM30\n");
  EXPECT_TRUE(tables.common_variables.empty());
}

TEST_F(MacroVariables, ASearchReadsWhatItWroteAndForgetsIt) {
  tables.common_variables[500] = 1.0;
  files.texts["main.nc"] = "(dialect fanuc)\n#500=#500+1\nX#500\nY1\nM30\n";
  auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  Interpreter searched(channel, tables, files);
  StopPlace place;
  place.line = 4;
  searched.start_search(*program, start_B, place);
  Command command;
  Step step = Step::working;
  double x = 0.0;
  while (step != Step::stopped && step != Step::ended) {
    step = searched.next(command);
    if (step != Step::command) continue;
    if (const auto* const move = std::get_if<Move>(&command.payload)) x = move->end[0];
  }
  EXPECT_EQ(step, Step::stopped);
  EXPECT_EQ(x, 2.0);
  EXPECT_EQ(tables.common_variables.at(500), 1.0);
}

}  // namespace
}  // namespace stanok::lang::testing
