// A preparation alone, notices in, items out; and its parts without it.
#include "channels/preparation/preparation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/channels/preparation/preparation_bench.h"

namespace stanok::channels {
namespace {

class PreparationTest : public ::testing::Test {
 protected:
  std::vector<ItemKind> kinds_after(const Notice& notice) {
    EXPECT_TRUE(bench_.link.notices.push(notice));
    std::vector<ItemKind> kinds;
    for (int n = 0; n < 100; ++n) {
      static_cast<void>(preparation_.step());
      for (const Item& item : bench_.items()) kinds.push_back(item.kind);
    }
    return kinds;
  }

  PreparationBench bench_;
  Preparation preparation_{bench_.machine, bench_.channel, bench_.schemes,
                           bench_.files,   bench_.books,   {}};
};

TEST_F(PreparationTest, AProgramBecomesItemsAndPathInItsOrder) {
  bench_.files.texts["part.nc"] = "G94\nM8\nG1 X1 F600\nG4 P0.5\nM30\n";
  EXPECT_EQ(kinds_after(PreparationBench::load_of("part.nc")), std::vector{ItemKind::load_done});
  const std::vector<ItemKind> kinds = kinds_after(ProgramStart{PreparationBench::start()});
  ASSERT_GE(kinds.size(), 4U);
  EXPECT_EQ(kinds.front(), ItemKind::transform);
  EXPECT_EQ(kinds.back(), ItemKind::run_end);
  EXPECT_GT(bench_.link.path.chunks.pushed(), 0U);
}

TEST_F(PreparationTest, AFaultOfABlockEndsTheRun) {
  bench_.files.texts["part.nc"] = "G94\nG1 X501 F600\nM30\n";
  kinds_after(PreparationBench::load_of("part.nc"));
  EXPECT_EQ(kinds_after(ProgramStart{PreparationBench::start()}).back(), ItemKind::run_failed);
}

TEST_F(PreparationTest, AResetIsAnswered) {
  EXPECT_EQ(kinds_after(PathReset{}), std::vector{ItemKind::reset_done});
}

TEST(PreparationPartsTest, BeginsAfreshInAScheme) {
  PreparationBench bench;
  PreparationParts parts(bench.machine, bench.channel, bench.schemes, bench.files, bench.books);
  EXPECT_EQ(parts.scheme, nullptr);
  motion::Point axes_M{};
  axes_M[1] = 12.5;
  parts.restart(2, axes_M);
  EXPECT_EQ(parts.scheme, bench.schemes.at(2).get());
  EXPECT_EQ(parts.feed.blocks().axes_M()[1], 12.5);
  parts.restart(99, {});
  EXPECT_EQ(parts.scheme, nullptr);
}

TEST(PreparationPartsTest, ASchemeOfAnUnknownTypeIsNotMade) {
  MachineConfig machine = stanok::testing::two_channel_machine();
  machine.channels[0].schemes[0].type = "no such type";
  EXPECT_THROW(static_cast<void>(make_schemes(machine.channels[0])), std::invalid_argument);
}

}  // namespace
}  // namespace stanok::channels
