// A block search alone: where it comes to and what the entry of the run is.
#include "channels/preparation/search_runner.h"

#include <gtest/gtest.h>

#include "channels/preparation/search_sink.h"
#include "tests/channels/preparation/preparation_bench.h"

namespace stanok::channels {
namespace {

using Result = SearchRunner::Result;

class SearchRunnerTest : public ::testing::Test {
 protected:
  Result look(const std::string& target, bool calculates) {
    bench_.files.texts["part.nc"] = "G94\nS500 M3\nG0 X10 Y5 Z5\nG1 X20 F100\nG1 X30\nM30\n";
    Diagnostics warnings;
    const auto program = lang::compile("part.nc", bench_.files, &parts_.description, warnings);
    EXPECT_TRUE(program);
    const BlockSearch search{.start = PreparationBench::start(),
                             .way = calculates ? SearchWay::calculated : SearchWay::not_calculated,
                             .target = ShortText(target)};
    return finished(search_.look(search, *program));
  }
  Result finished(Result result) {
    while (result == Result::working || result == Result::computing) result = search_.advance(64);
    return result;
  }

  PreparationBench bench_;
  PreparationParts parts_{bench_.machine, bench_.channel, bench_.schemes, bench_.files,
                          bench_.books};
  SearchRunner search_{parts_};
};

TEST_F(SearchRunnerTest, FindsTheBlockAndTellsWhereItIs) {
  ASSERT_EQ(look("5", true), Result::found);
  EXPECT_TRUE(search_.is_set());
  EXPECT_FALSE(search_.is_under_way());
  const auto report = bench_.reports.search(1);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->line, 5U);
  ASSERT_EQ(report->position.size(), 5U);
  EXPECT_EQ(report->position[0], 20.0);
  EXPECT_EQ(report->position[1], 5.0);
  EXPECT_TRUE(bench_.items().empty());  // nothing of it is executed
}

TEST_F(SearchRunnerTest, TheRunIsEnteredWithItsStateAndAnApproach) {
  ASSERT_EQ(look("5", true), Result::found);
  parts_.restart({.scheme = 1});
  ASSERT_EQ(finished(search_.begin_run()), Result::entered);
  EXPECT_FALSE(search_.is_set());
  lang::Command command;
  bool spindle = false;
  motion::Point end{};
  while (search_.next_entry(command)) {
    if (const auto* move = std::get_if<lang::Move>(&command.payload))
      std::copy(move->end.begin(), move->end.end(), end.begin());
    spindle = spindle || std::holds_alternative<lang::SpindleCommand>(command.payload);
  }
  EXPECT_TRUE(spindle);
  EXPECT_EQ(end[0], 20.0);
  EXPECT_EQ(end[2], 5.0);
}

TEST_F(SearchRunnerTest, WithoutCalculationTheRunIsEnteredAtOnce) {
  ASSERT_EQ(look("5", false), Result::found);
  parts_.restart({.scheme = 1});
  EXPECT_EQ(search_.begin_run(), Result::entered);
  lang::Command command;
  EXPECT_FALSE(search_.next_entry(command));
}

TEST_F(SearchRunnerTest, WhatIsNoBlockFailsAndLeavesNothing) {
  EXPECT_EQ(look("N77", true), Result::failed);
  EXPECT_FALSE(search_.is_set());
  EXPECT_FALSE(search_.fault().code.empty());
}

TEST(SearchSinkTest, KeepsTheStateOfTheMachine) {
  lang::SearchCollector collector;
  SearchSink sink(collector);
  EXPECT_EQ(sink.depth(), FeedDepth::positions);
  lang::Command command;
  command.payload = lang::ToolChange{.tool = 7};
  sink.begin_command(command);
  EXPECT_EQ(collector.state().tool, 7);
}

}  // namespace
}  // namespace stanok::channels
