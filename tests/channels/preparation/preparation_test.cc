// A preparation alone, notices in, items out; and its parts without it.
#include "channels/preparation/preparation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/channels/preparation/preparation_bench.h"

namespace stanok::channels {
namespace {

class PreparationTest : public ::testing::Test {
 protected:
  std::vector<ItemContent> items_after(const Notice& notice) {
    EXPECT_TRUE(bench_.link.notices.push(notice));
    std::vector<ItemContent> contents;
    for (int n = 0; n < 100; ++n) {
      static_cast<void>(preparation_.step());
      for (const Item& item : bench_.items()) contents.push_back(item.content);
    }
    return contents;
  }

  PreparationBench bench_;
  Preparation preparation_{bench_.machine, bench_.channel, bench_.schemes,
                           bench_.files,   bench_.books,   {}};
};

TEST_F(PreparationTest, AProgramBecomesItemsAndPathInItsOrder) {
  bench_.files.texts["part.nc"] = "G94\nM8\nG1 X1 F600\nG4 P0.5\nM30\n";
  const auto load = items_after(PreparationBench::load_of("part.nc"));
  ASSERT_EQ(load.size(), 1U);
  EXPECT_TRUE(std::get<LoadDone>(load[0]).succeeded);
  const auto run = items_after(ProgramStart{PreparationBench::start()});
  ASSERT_GE(run.size(), 4U);
  EXPECT_TRUE(std::holds_alternative<TransformSet>(run.front()));
  EXPECT_TRUE(std::holds_alternative<RunEnd>(run.back()));
  EXPECT_GT(bench_.link.path.chunks.pushed(), 0U);
}

TEST_F(PreparationTest, AFaultOfABlockEndsTheRun) {
  bench_.files.texts["part.nc"] = "G94\nG1 X501 F600\nM30\n";
  items_after(PreparationBench::load_of("part.nc"));
  const auto run = items_after(ProgramStart{PreparationBench::start()});
  EXPECT_TRUE(std::holds_alternative<RunFailed>(run.back()));
}

TEST_F(PreparationTest, AResetIsAnswered) {
  const auto items = items_after(PathReset{});
  ASSERT_EQ(items.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<ResetDone>(items[0]));
}

TEST(PreparationPartsTest, BeginsAfreshInAScheme) {
  PreparationBench bench;
  PreparationParts parts(bench.machine, bench.channel, bench.schemes, bench.files, bench.books);
  EXPECT_EQ(parts.scheme, nullptr);
  motion::Point axes_M{};
  axes_M[1] = 12.5;
  parts.restart({.scheme = 2, .axes_M = axes_M});
  EXPECT_EQ(parts.scheme, bench.schemes.at(2).get());
  EXPECT_EQ(parts.feed.blocks().axes_M()[1], 12.5);
  parts.restart({.scheme = 99});
  EXPECT_EQ(parts.scheme, nullptr);
}

TEST(PreparationPartsTest, ASchemeOfAnUnknownTypeIsNotMade) {
  MachineConfig machine = stanok::testing::two_channel_machine();
  machine.channels[0].schemes[0].type = "no such type";
  EXPECT_THROW(static_cast<void>(make_schemes(machine.channels[0])), std::invalid_argument);
}

}  // namespace
}  // namespace stanok::channels
