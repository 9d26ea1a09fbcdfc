// Which run it is, what it did and how it ended.
#include "channels/cycle/run_book.h"

#include <gtest/gtest.h>

#include "channels/cycle/channel_log.h"

namespace stanok::channels {
namespace {

motion::InterpolatorOutput path_at(std::uint32_t run, std::uint64_t block, double advanced) {
  motion::InterpolatorOutput path;
  path.tag.run = run;
  path.tag.block = block;
  path.path_advanced = advanced;
  path.axes[0] = 7.0;
  path.point[1] = 8.0;
  return path;
}

class RunBookTest : public ::testing::Test {
 protected:
  RunReport record() {
    const std::vector<RunReport> runs = reports_.runs();
    return runs.empty() ? RunReport{} : runs.back();
  }

  ReportBook reports_;
  RunBook runs_{4, 2, reports_};
};

TEST_F(RunBookTest, TellsTheBeginAndTheEndOfARun) {
  runs_.begin_cycle(100);
  runs_.begin(path_at(0, 0, 0.0));
  const RunReport begun = record();
  EXPECT_EQ(begun.channel, 4);
  EXPECT_EQ(begun.run, 1U);
  EXPECT_FALSE(begun.ended);
  EXPECT_EQ(begun.start_cycle, 100);
  runs_.begin_cycle(150);
  runs_.advance(path_at(1, 9, 0.5), 40);
  runs_.advance(path_at(1, 9, 0.25), 10);
  runs_.end(RunResult::succeeded, 12, path_at(1, 9, 0.0));
  const RunReport ended = record();
  EXPECT_TRUE(ended.ended);
  EXPECT_TRUE(ended.ok);
  EXPECT_EQ(ended.blocks, 12U);
  EXPECT_EQ(ended.start_cycle, 100);
  EXPECT_EQ(ended.end_cycle, 150);
  EXPECT_EQ(ended.path_mm, 0.75);
  EXPECT_EQ(ended.lookahead_max_blocks, 40U);
  EXPECT_EQ(ended.end_M[0], 7.0);
  EXPECT_EQ(ended.end_W[1], 8.0);
}

TEST_F(RunBookTest, CountsThePeriodsThatItLost) {
  runs_.note_lost_periods(9);  // before the run
  runs_.begin({});
  runs_.note_lost_periods(2);
  runs_.note_lost_periods(5);
  runs_.note_lost_periods(1);
  runs_.end(RunResult::succeeded, 0, {});
  runs_.note_lost_periods(7);  // after it
  EXPECT_EQ(record().lost.total, 8);
  EXPECT_EQ(record().lost.longest, 5);
  runs_.begin({});
  runs_.end(RunResult::succeeded, 0, {});
  EXPECT_EQ(record().lost.total, 0);
  EXPECT_EQ(record().lost.longest, 0);
}

TEST_F(RunBookTest, KnowsHowThisRunAndTheOneBeforeEnded) {
  runs_.begin({});
  EXPECT_FALSE(runs_.ended_well(1));  // it has not ended yet
  runs_.end(RunResult::succeeded, 0, {});
  runs_.begin({});
  runs_.end(RunResult::failed, 0, {});
  EXPECT_TRUE(runs_.ended_well(1));
  EXPECT_FALSE(runs_.ended_well(2));
  runs_.begin({});
  EXPECT_FALSE(runs_.ended_well(1));  // too long ago
}

TEST_F(RunBookTest, AnAlarmBehindTheEndSpoilsTheRun) {
  runs_.begin({});
  runs_.end(RunResult::succeeded, 0, {});
  runs_.spoil();
  EXPECT_FALSE(runs_.ended_well(1));
}

TEST_F(RunBookTest, CountsBlocksOfItsOwnRunOnly) {
  runs_.begin({});
  runs_.advance(path_at(1, 5, 0.0), 0);
  runs_.advance(path_at(7, 900, 0.0), 0);
  EXPECT_EQ(runs_.blocks(), 5U);
  runs_.note_reset();
  EXPECT_TRUE(runs_.was_reset());
  runs_.begin({});
  EXPECT_FALSE(runs_.was_reset());
  EXPECT_EQ(runs_.blocks(), 0U);
}

TEST_F(RunBookTest, AlarmsAreLoggedWithTheirPlaceAndEventsWithTheFirstLine) {
  ChannelLink link;
  link.file_names[2] = FileName("part.nc");
  EventBook events(8);
  ChannelLog log(4, runs_, link, events, reports_);
  runs_.begin_cycle(3);
  runs_.begin({});
  log.alarm("A4001", "first line\nsecond line", {.run = 1, .block = 6, .line = 17, .file = 2});
  const std::vector<AlarmReport> alarms = reports_.alarms();
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].diagnostic.place.file, "part.nc");
  EXPECT_EQ(alarms[0].diagnostic.message, "first line");
  EXPECT_EQ(alarms[0].diagnostic.notes.at(0).text, "second line");
  EXPECT_EQ(alarms[0].cycle, 3);
  Event event;
  ASSERT_TRUE(events.events().pop(event));
  EXPECT_EQ(event.text.view(), "first line");
  EXPECT_EQ(event.channel, 4);
  EXPECT_EQ(log.last_alarm().line, 17U);
  EXPECT_EQ(log.file_name({.run = 9, .file = 2}).view(), "");  // of another run
}

}  // namespace
}  // namespace stanok::channels
