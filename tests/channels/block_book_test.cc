// What is told of the current block: active codes and its end, while the preparation is far ahead.
#include "channels/stores/block_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::MachineBench;
using ::testing::Not;

BlockReport at_hand(MachineBench& bench) {
  const ChannelOutput& output = bench.channel(1);
  return bench.machine().block(output);
}

TEST(BlockBook, KnowsTheEndAndTheCodesOfEveryBlockThatMoves) {
  MachineBench bench;
  bench.program("p.nc", "G17 G90\nG1 X10 F6000\nG91 Y5\nG90 G0 X0 Y0\nG4 P0.1\nM30\n");
  bench.run(1, "p.nc");
  std::map<std::uint32_t, motion::Point> ends;
  std::map<std::uint32_t, std::vector<std::string>> codes;
  bench.run_to_end([&](const CycleOutput&) {
    const ChannelOutput& output = bench.channel(1);
    if (!output.running || output.tag.line == 0) return;
    const BlockReport report = at_hand(bench);
    codes[output.tag.line] = lang::names_of(report.codes, 'G');
    if (report.end_W) ends[output.tag.line] = *report.end_W;
  });
  EXPECT_EQ(ends[2][0], 10.0);
  EXPECT_EQ(ends[3][0], 10.0);
  EXPECT_EQ(ends[3][1], 5.0);
  EXPECT_EQ(ends[4][1], 0.0);
  EXPECT_EQ(ends[5][0], 0.0) << "a dwell stands at the end of the block before";
  EXPECT_THAT(codes[2], Contains("G1"));
  EXPECT_THAT(codes[2], Contains("G90"));
  EXPECT_THAT(codes[3], Contains("G91"));
  EXPECT_THAT(codes[4], Contains("G0"));
  EXPECT_FALSE(at_hand(bench).end_W);
}

TEST(BlockBook, HasTheDefaultCodesBehindAResetAndThoseOfALineBehindALine) {
  MachineBench bench;
  bench.ask(OperatorAction::mdi, 1, "G91 G1 F100");
  bench.run_to_end();
  EXPECT_THAT(lang::names_of(at_hand(bench).codes, 'G'), Contains("G91"));
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_THAT(lang::names_of(at_hand(bench).codes, 'G'), Not(Contains("G91")));
}

TEST(BlockBook, ForgetsTheOldestBlocksOnly) {
  BlockBook book(lang::default_codes(lang::ChannelKind::mill));
  book.begin_run(3);
  constexpr std::uint64_t blocks = 100000;
  for (std::uint64_t block = 1; block <= blocks; ++block)
    book.tell_end({.run = 3, .block = block}, {static_cast<double>(block)});
  EXPECT_FALSE(book.at({.run = 3, .block = 1}).end_W);
  EXPECT_EQ((*book.at({.run = 3, .block = blocks - 20000}).end_W)[0], blocks - 20000.0);
  EXPECT_FALSE(book.at({.run = 2, .block = blocks}).end_W) << "of another run";
}

}  // namespace
}  // namespace stanok::channels
