// A request whose answer comes before the preparation has said that it waits: each place of the
// request in the steps of its preparation.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/recorded_by_chance.h"

namespace stanok::runtime {
namespace {

class AnswersBetweenSteps : public ::testing::TestWithParam<int> {};

// With one step in a cycle the cycle answers as soon as it can.
TEST_P(AnswersBetweenSteps, NoneIsLost) {
  std::string text;
  for (int k = 0; k < GetParam(); ++k)
    text += k % 2 == 0 ? "G55\n" : "G54\n";  // a command, and nothing to wait for
  text += "settable_tool (1, 1, \"wear_length\", 0.01);\nM30\n";
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 1);
  run.prepare_every(1);
  run.program("p.nc", text);
  run.ask(OperatorAction::program_run, 1, "p.nc");
  run.run(3000);
  const auto runs = run.runs();
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].ended && runs[0].ok);
  run.close();
}

INSTANTIATE_TEST_SUITE_P(Places, AnswersBetweenSteps, ::testing::Range(50, 70));

}  // namespace
}  // namespace stanok::runtime
