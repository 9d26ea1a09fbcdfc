// Programs as they are loaded, used and left, without a preparation.
#include "channels/preparation/program_shelf.h"

#include <gtest/gtest.h>

#include "tests/channels/preparation/preparation_bench.h"

namespace stanok::channels {
namespace {

class ProgramShelfTest : public ::testing::Test {
 protected:
  PreparationBench bench_;
  PreparationParts parts_{bench_.machine, bench_.channel, bench_.schemes, bench_.files,
                          bench_.books};
  bool unwanted_ = false;
  ProgramShelf shelf_{bench_.channel, parts_.description, bench_.files,
                      bench_.shared,  bench_.reports,     [this] { return unwanted_; }};
};

TEST_F(ProgramShelfTest, ALoadHoldsFromItsUseOn) {
  bench_.files.texts["part.nc"] = "G0 X1\nM30\n";
  const LoadDone done = shelf_.load("part.nc", 4);
  EXPECT_TRUE(done.succeeded);
  EXPECT_EQ(done.number, 4);
  EXPECT_EQ(done.text.view(), "part.nc");
  EXPECT_EQ(shelf_.program(), nullptr);
  shelf_.use(3);
  EXPECT_EQ(shelf_.program(), nullptr);  // the cycle has not heard of it
  shelf_.use(4);
  EXPECT_NE(shelf_.program(), nullptr);
  EXPECT_EQ(shelf_.name(), "part.nc");
}

TEST_F(ProgramShelfTest, ALoadThatFailsLeavesTheProgramAndSaysWhy) {
  bench_.files.texts["part.nc"] = "G0 X1\nM30\n";
  ASSERT_TRUE(shelf_.load("part.nc", 1).succeeded);
  shelf_.use(1);
  const auto before = shelf_.program();
  bench_.files.texts["wrong.nc"] = "G0 X\n";
  const LoadDone done = shelf_.load("wrong.nc", 2);
  EXPECT_FALSE(done.succeeded);
  EXPECT_NE(done.text.view().find("wrong.nc:1:"), std::string_view::npos) << done.text.view();
  shelf_.use(2);
  EXPECT_EQ(shelf_.program(), before);
  EXPECT_FALSE(bench_.reports.load_diagnostics().empty());
}

TEST_F(ProgramShelfTest, WhatIsUnwantedIsNotCompiled) {
  bench_.files.texts["part.nc"] = "G0 X1\nM30\n";
  unwanted_ = true;
  EXPECT_FALSE(shelf_.load("part.nc", 1).succeeded);
}

TEST_F(ProgramShelfTest, ALineStandsBesideTheProgram) {
  EXPECT_TRUE(shelf_.load_line("G0 X5").succeeded);
  EXPECT_NE(shelf_.line(), nullptr);
  EXPECT_EQ(shelf_.program(), nullptr);
}

}  // namespace
}  // namespace stanok::channels
