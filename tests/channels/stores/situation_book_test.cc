// What gives the words of the current block their meaning, and its end, while the preparation is
// far ahead.
#include "channels/stores/situation_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::MachineBench;
using ::testing::Not;

SituationReport at_hand(MachineBench& bench) {
  const ChannelOutput& output = bench.channel(1);
  return bench.machine().situation(output);
}

TEST(SituationBookTest, KnowsTheEndAndTheCodesOfEveryBlockThatMoves) {
  MachineBench bench;
  bench.program("p.nc", "G17 G90\nG1 X10 F6000\nG91 Y5\nG90 G0 X0 Y0\nG4 P0.1\nM30\n");
  bench.run(1, "p.nc");
  std::map<std::uint32_t, motion::Point> ends;
  std::map<std::uint32_t, std::vector<std::string>> codes;
  bench.run_to_end([&](const CycleOutput&) {
    const ChannelOutput& output = bench.channel(1);
    if (!output.running || output.tag.line == 0) return;
    const SituationReport report = at_hand(bench);
    codes[output.tag.line] = lang::names_of(report.meaning.codes, 'G');
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

TEST(SituationBookTest, HasTheDefaultCodesBehindAResetAndThoseOfALineBehindALine) {
  MachineBench bench;
  bench.ask(OperatorAction::mdi, 1, "G91 G1 F100");
  bench.run_to_end();
  EXPECT_THAT(lang::names_of(at_hand(bench).meaning.codes, 'G'), Contains("G91"));
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_THAT(lang::names_of(at_hand(bench).meaning.codes, 'G'), Not(Contains("G91")));
}

TEST(SituationBookTest, ForgetsTheOldestBlocksOnly) {
  SituationBook book;
  book.begin_run(3);
  constexpr std::uint64_t blocks = 100000;
  for (std::uint64_t block = 1; block <= blocks; ++block)
    book.tell_end({.run = 3, .block = block}, {static_cast<double>(block)});
  EXPECT_FALSE(book.at({.run = 3, .block = 1}).end_W);
  EXPECT_EQ((*book.at({.run = 3, .block = blocks - 20000}).end_W)[0], blocks - 20000.0);
  EXPECT_FALSE(book.at({.run = 2, .block = blocks}).end_W) << "of another run";
}

// A run of days, displayed: what lies behind is forgotten, what is ahead is not.
TEST(SituationBookTest, KeepsWhatIsAheadAndLittleThatIsBehind) {
  SituationBook book;
  book.begin_run(1);
  constexpr std::uint64_t ahead = 5000;
  for (std::uint64_t block = 1; block <= 200'000; ++block) {
    const std::uint32_t situation = book.enter({});
    book.tell_end({.run = 1, .block = block}, {static_cast<double>(block)});
    if (block % 100 != 0 || block <= ahead) continue;
    const motion::BlockTag shown{.run = 1,
                                 .block = block - ahead,
                                 .situation = situation - static_cast<std::uint32_t>(ahead)};
    EXPECT_EQ((*book.at(shown).end_W)[0], static_cast<double>(block - ahead));
    EXPECT_LT(book.size(), 2 * (ahead + 8192 + 300));
  }
}

TEST(SituationBookTest, ANumberKeepsItsMeaning) {
  SituationBook book;
  lang::Meaning inch;
  inch.codes[lang::Group::units] = lang::g(20);
  const std::uint32_t first = book.enter(inch);
  inch.codes[lang::Group::units] = lang::g(21);
  const std::uint32_t second = book.enter(inch);
  EXPECT_EQ(second, first + 1);
  EXPECT_TRUE(book.at({.situation = first}).meaning.inches());
  EXPECT_FALSE(book.at({.situation = second}).meaning.inches());
  EXPECT_EQ(book.at({.situation = first}).number, first);
}

// The offset of the table is in the first output already.
TEST(SituationBookTest, TheFirstCycleShowsHowTheChannelStands) {
  MachineConfig config = testing::two_channel_machine();
  config.tables.offsets["G54"]["X"] = 11.0;
  MachineBench bench(config);
  const ChannelOutput& output = bench.cycle().channels[0];
  EXPECT_EQ(output.point_W[0].value, output.axes[0].position - 11.0);
  EXPECT_NE(output.tag.situation, 0U);
}

// What stands beside a stop is of the stop, and no older than the move before it: line, codes,
// coolant, frame.
TEST(SituationBookTest, AStopShowsItsOwnLineCodesAndCoolant) {
  MachineBench bench(testing::two_channel_machine(), {.on_at_start = true, .stops_go_on = false});
  bench.ask(OperatorAction::offset_set, 1, "G55 X", 30.0);
  bench.program("p.nc", "G21\nM8\nG0 X1\nM9\nG55\nM0\nM2\n");
  bench.run(1, "p.nc");
  bench.cycle();
  for (int n = 0; n < 20000 && bench.channel(1).hold_cause != HoldCause::program_stop; ++n)
    bench.cycle();
  const ChannelOutput& output = bench.channel(1);
  EXPECT_EQ(output.tag.line, 6U);
  EXPECT_FALSE(output.coolant.flood);
  EXPECT_THAT(lang::names_of(at_hand(bench).meaning.codes, 'G'), Contains("G55"));
  EXPECT_NEAR(output.point_W[0].value, -29.0, 1e-9);
}

}  // namespace
}  // namespace stanok::channels
