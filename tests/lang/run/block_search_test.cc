// Block search: where a target stands, what is collected on the way, what ends a search.
#include "lang/run/block_search.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/lang/program_support.h"

namespace stanok::lang {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BlockSearchTest : public testing::ProgramTest {
 protected:
  std::shared_ptr<const Program> load(const std::string& text) {
    files.texts["main.nc"] = text;
    auto loaded = compile("main.nc", files, &channel, warnings);
    EXPECT_TRUE(loaded) << (loaded ? "" : to_text(loaded.error().front()));
    return loaded ? *loaded : nullptr;
  }
  static SearchTarget line(std::uint32_t number) {
    SearchTarget target;
    target.line = number;
    return target;
  }
  // Interprets up to the target; `ended` says what came instead, empty when it was reached.
  SearchState search(const std::string& text, const SearchTarget& target) {
    auto program = load(text);
    const auto place = find_place(*program, target);
    EXPECT_TRUE(place) << (place ? "" : place.error().message);
    interpreter = std::make_unique<Interpreter>(channel, tables, files);
    if (!place) return {};
    interpreter->start_search(program, start_B, *place);
    SearchCollector collector;
    Command command;
    ended = "nothing";
    for (int n = 0; n < 100000; ++n) {
      const Step step = interpreter->next(command);
      if (step == Step::stopped) {
        ended.clear();
        break;
      }
      if (step == Step::ended) {
        ended = "end of program";
        break;
      }
      if (step == Step::failed) {
        ended = interpreter->error().code;
        break;
      }
      if (step != Step::command) continue;
      collector.take(command);
      const auto* request = std::get_if<ProgramRequest>(&command.payload);
      if (request == nullptr) continue;
      const auto answer = collector.answer(*request);
      if (!answer) {
        ended = "unknown in line " + std::to_string(command.origin.line);
        break;
      }
      interpreter->answer(*answer);
    }
    return collector.state();
  }
  // X ends of the moves behind the target.
  std::vector<double> rest() {
    commands.clear();
    drain();
    std::vector<double> ends;
    for (const Move& move : all<Move>()) ends.push_back(move.end[0]);
    return ends;
  }
  // ... of a run that begins at the target.
  std::vector<double> run_at(const std::string& text, const SearchTarget& target) {
    auto program = load(text);
    const auto place = find_place(*program, target);
    EXPECT_TRUE(place);
    interpreter = std::make_unique<Interpreter>(channel, tables, files);
    fault = interpreter->start_at(program, start_B, *place);
    return fault ? std::vector<double>{} : rest();
  }

  std::string ended;
  std::optional<Diagnostic> fault;
};

TEST_F(BlockSearchTest, StopsBeforeTheTargetWithAllThatIsInForce) {
  tables.tools[3] = {.number = 3, .length_mm = {}, .radius_mm = 0.0};
  const SearchState state =
      search("T3 M6\nS800 M3\nM8\nG0 X10 Y2\nG91 G1 X1 F100\nX2\nX4\nM30\n", line(7));
  EXPECT_EQ(ended, "");
  EXPECT_EQ(state.position_W[0], 13.0);
  EXPECT_EQ(state.position_W[1], 2.0);
  EXPECT_EQ(state.tool, 3);
  EXPECT_EQ(state.spindles.at(0).action, SpindleAction::clockwise);
  EXPECT_EQ(state.speeds.at(0), 800.0);
  EXPECT_TRUE(state.coolant.flood);
  EXPECT_THAT(rest(), ElementsAre(17.0));
}

TEST_F(BlockSearchTest, VariablesHaveTheirValues) {
  const std::string text =
      "num count = 0;\nfor (num turn = 0; turn < 5; turn += 1) {\n  count += 2;\n}\nG0 "
      "X=count\nM30\n";
  search(text, line(5));
  EXPECT_EQ(ended, "");
  EXPECT_THAT(rest(), ElementsAre(10.0));
}

TEST_F(BlockSearchTest, APassCountChoosesTheTurnOfALoop) {
  const std::string text =
      "for (num turn = 0; turn < 5; turn += 1) {\n  G0 X=turn\n  Y=turn\n}\nM30\n";
  SearchTarget target = line(2);
  target.passes = 4;
  search(text, target);
  EXPECT_EQ(ended, "");
  EXPECT_THAT(rest(), ElementsAre(3.0, 3.0, 4.0, 4.0));
}

TEST_F(BlockSearchTest, ACallPathChoosesTheCall) {
  const std::string text =
      "void hole (num place) {\n  G0 X=place\n  Y1\n}\nhole (1);\nhole (2);\nM30\n";
  SearchTarget target = line(3);
  target.calls = {6};
  search(text, target);
  EXPECT_EQ(ended, "");
  EXPECT_THAT(rest(), ElementsAre(2.0));
  target.calls = {5};
  search(text, target);
  EXPECT_THAT(rest(), ElementsAre(1.0, 2.0, 2.0));
}

TEST_F(BlockSearchTest, BlockNumbersAndOffsetsNameLines) {
  auto program = load("N10 G0 X1\nN20 X2\n/N30 X3\nN20 X4\n(N50)\nM30\n");
  SearchTarget target;
  target.block_number = 10;
  EXPECT_EQ(find_place(*program, target)->line, 1u);
  target.block_number = 20;
  const auto twice = find_place(*program, target);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, "E6040");
  EXPECT_EQ(twice.error().notes.size(), 2u);
  target.block_number = 50;
  EXPECT_THAT(find_place(*program, target).error().message, HasSubstr("no block N50"));
  SearchTarget offset;
  offset.offset = 12;
  EXPECT_EQ(find_place(*program, offset)->line, 2u);
  offset.offset = 1000;
  EXPECT_FALSE(find_place(*program, offset));
  EXPECT_FALSE(find_place(*program, line(100)));
}

TEST_F(BlockSearchTest, ALineWithoutCodeMeansTheNextOneWithCode) {
  auto program = load("G0 X1\n\n// nothing\nif (true) {\n}\nG0 X2\nM30\n");
  EXPECT_EQ(find_place(*program, line(4))->line, 4u);
  search("if (true) { sync (); }\n// nothing\nif (true) { sync (); }\nM30\n", line(2));
  EXPECT_EQ(ended, "");
}

TEST_F(BlockSearchTest, WhatIsNotExecutedIsCounted) {
  const SearchState state = search(
      "msg (\"a\");\nmsg (\"b\");\nM64 P1\nchannel_run (2, \"w.nc\");\nG0 X1\nX2\nM30\n", line(6));
  EXPECT_EQ(ended, "");
  std::vector<std::pair<std::string, int>> omissions;
  for (const auto& omission : state.omissions)
    omissions.emplace_back(omission.what, omission.count);
  EXPECT_THAT(omissions, ElementsAre(std::pair("messages", 2), std::pair("outputs", 1),
                                     std::pair("channel functions", 1)));
}

TEST_F(BlockSearchTest, AValueOfTheMachineEndsTheSearchAtItsLine) {
  search("G0 X1\nif ($in[3]) { G0 X2\n }\nG0 X3\nM30\n", line(4));
  EXPECT_EQ(ended, "unknown in line 2");
  search("if (channel_run (2, \"w.nc\")) { G0 X2\n }\nG0 X3\nM30\n", line(3));
  EXPECT_EQ(ended, "unknown in line 1");
  search("G38.2 X1 F10\nG0 X3\nM30\n", line(2));
  EXPECT_EQ(ended, "unknown in line 1");
}

TEST_F(BlockSearchTest, ATargetThatIsNeverMetIsTheEndOfTheProgram) {
  search("if (false) {\n  G0 X1\n}\nM30\nG0 X5\n", line(2));
  EXPECT_EQ(ended, "end of program");
}

TEST_F(BlockSearchTest, InsideRadiusCompensationNoProgramIsEntered) {
  tables.tools[1] = {.number = 1, .length_mm = {}, .radius_mm = 2.0};
  search("T1 M6\nG41 D1 G1 X10 Y0 F100\nX20\nY20\nG40 Y30\nM30\n", line(4));
  EXPECT_EQ(ended, "E6042");
}

// The axes would go to the end of the move before it first.
TEST_F(BlockSearchTest, BehindTheMoveOfACornerNoProgramIsEntered) {
  const std::string text = "G1 X10 F100\nY20 ,R2\nX0\nY0\nM30\n";
  search(text, line(3));
  EXPECT_EQ(ended, "E6042");
  search(text, line(4));
  EXPECT_NE(ended, "E6042");
  search(text, line(2));
  EXPECT_NE(ended, "E6042");
}

TEST_F(BlockSearchTest, WithoutCalculationTheDefaultStateIsInForce) {
  EXPECT_THAT(run_at("G91 G0 X5\nX6\nX7\nM30\n", line(2)), ElementsAre(6.0, 7.0));
}

TEST_F(BlockSearchTest, WithoutCalculationAStatementIsEnteredAtItsBeginning) {
  const std::string text =
      "G0 X1\nfor (num turn = 5; turn < 7; turn += 1) {\n  X=turn G0\n}\nX9\nM30\n";
  EXPECT_THAT(run_at(text, line(2)), ElementsAre(5.0, 6.0, 9.0));
  EXPECT_THAT(run_at(text, line(5)), ElementsAre(9.0));
  EXPECT_THAT(run_at(text, line(3)), IsEmpty());
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code, "E6042");
}

TEST_F(BlockSearchTest, WithoutCalculationNoSubprogramIsEntered) {
  const std::string text = "O100 sub\n  G0 X1\nO100 endsub\nG0 X2\nM30\n";
  EXPECT_THAT(run_at(text, line(2)), IsEmpty());
  EXPECT_TRUE(fault);
  EXPECT_THAT(run_at(text, line(4)), ElementsAre(2.0));
}

// Seeded random programs: the rest behind any target is the end of the whole run.
TEST_F(BlockSearchTest, TheRestOfARunIsTheSameFromEveryTarget) {
  std::mt19937 random(2026);
  std::uniform_int_distribution<int> distance(-9, 9);
  std::string text;
  for (int n = 0; n < 30; ++n) {
    text += n % 5 == 4 ? "R1 = R1 + 1\n" : n % 7 == 3 ? "G91\n" : n % 7 == 5 ? "G90\n" : "";
    text += "G1 F100 X" + std::to_string(distance(random)) + (n % 4 == 1 ? "" : " Z=R1") + "\n";
  }
  const auto lines = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
  run(text + "M30\n");
  std::vector<double> whole;
  for (const Move& move : all<Move>()) whole.push_back(move.end[0]);
  for (std::uint32_t target = 1; target <= lines; ++target) {
    search(text + "M30\n", line(target));
    ASSERT_EQ(ended, "");
    const auto found = rest();
    ASSERT_LE(found.size(), whole.size());
    EXPECT_TRUE(std::equal(found.rbegin(), found.rend(), whole.rbegin())) << "line " << target;
  }
}

}  // namespace
}  // namespace stanok::lang
