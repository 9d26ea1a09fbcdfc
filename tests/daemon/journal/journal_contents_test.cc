// JournalContents: what records come to is the same after they were made short.
#include "daemon/journal/journal_contents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace stanok::daemon {
namespace {

using channels::AlarmReport;
using channels::RunOutcome;
using channels::RunReport;
using nlohmann::json;
using ::testing::IsEmpty;
using ::testing::SizeIs;

RunReport run(int channel, std::uint64_t number) {
  RunReport report;
  report.channel = channel;
  report.number = number;
  report.program = "part" + std::to_string(number) + ".nc";
  report.begun_at = 1000.0 * static_cast<double>(number);
  report.ended_at = report.begun_at + 5.0;
  report.ended = true;
  report.end = RunOutcome::done;
  report.blocks = 17;
  report.lost = {.total = 9, .longest = 4};
  return report;
}

AlarmReport alarm(int channel, std::uint64_t number, std::int64_t cycle) {
  AlarmReport report;
  report.channel = channel;
  report.number = number;
  report.cycle = cycle;
  report.at = 3.5;
  return report;
}

json place(int channel, std::uint64_t number, int line, double at) {
  return {{"kind", "place"},  {"channel", channel}, {"number", number},
          {"file", "sub.nc"}, {"line", line},       {"at", at}};
}

TEST(JournalContents, ARunThatNobodyHasEndedWasCutOffWhereItWasLast) {
  JournalContents contents;
  contents.take(run_begun_record(run(1, 1)));
  contents.take(run_ended_record(run(1, 1)));
  contents.take(run_begun_record(run(1, 2)));
  contents.take(place(1, 2, 10, 2001.0));
  contents.take(place(1, 2, 12, 2002.5));
  const auto cut = contents.cut_off();
  ASSERT_THAT(cut, SizeIs(1));
  EXPECT_EQ(cut[0].run.number, 2U);
  EXPECT_EQ(cut[0].run.end, RunOutcome::cut_off);
  EXPECT_EQ(cut[0].run.ended_at, 2002.5);
  EXPECT_EQ(cut[0].file, "sub.nc");
  EXPECT_EQ(cut[0].line, 12);
  const auto past = contents.past();
  ASSERT_THAT(past.runs, SizeIs(2));
  EXPECT_EQ(past.runs[0].end, RunOutcome::done);
  EXPECT_TRUE(past.runs[0].ok);
  EXPECT_EQ(past.runs[0].blocks, 17U);
  EXPECT_EQ(past.runs[0].lost.total, 9);
  EXPECT_EQ(past.runs[0].lost.longest, 4);
  EXPECT_TRUE(past.runs[1].ended);
  EXPECT_FALSE(past.runs[1].ok);
  contents.take(run_ended_record(cut[0].run));
  EXPECT_THAT(contents.cut_off(), IsEmpty());
}

// The cycle begins a run before the preparation names it: the begin is told twice.
TEST(JournalContents, ARunMayBeNamedAfterItHasBegun) {
  JournalContents contents;
  RunReport unnamed = run(1, 7);
  unnamed.program.clear();
  contents.take(run_begun_record(unnamed));
  contents.take(place(1, 7, 4, 7003.0));
  contents.take(run_begun_record(run(1, 7)));
  const auto cut = contents.cut_off();
  ASSERT_THAT(cut, SizeIs(1));
  EXPECT_EQ(cut[0].run.program, "part7.nc");
  EXPECT_EQ(cut[0].line, 4);
}

AlarmReport cut_off_notice(int channel, std::uint64_t number) {
  AlarmReport notice = alarm(channel, number, 0);
  notice.diagnostic.code = "W941";
  return notice;
}

// An alarm that no cycle raised stands until somebody has seen it, over any number of starts.
TEST(JournalContents, ANoticeStandsUntilItIsSeenOnItsChannel) {
  JournalContents contents;
  contents.take(alarm_record(cut_off_notice(1, 3)));
  contents.take(alarm_record(alarm(1, 4, 77)));
  ASSERT_THAT(contents.past().alarms, SizeIs(2));
  EXPECT_FALSE(contents.past().alarms[0].is_over);
  EXPECT_TRUE(contents.past().alarms[1].is_over);
  contents.take(seen_record(1, 2));
  EXPECT_FALSE(contents.past().alarms[0].is_over) << "one before it";
  contents.take(seen_record(2, 9));
  EXPECT_FALSE(contents.past().alarms[0].is_over) << "of another channel";
  contents.take(seen_record(1, 3));
  EXPECT_TRUE(contents.past().alarms[0].is_over);
  contents.take(alarm_record(cut_off_notice(1, 5)));
  EXPECT_FALSE(contents.past().alarms[2].is_over) << "it came behind what was seen";
}

// The journal looks at alarms now and then, and is told at once of what an operator does.
TEST(JournalContents, WhatWasSeenMayBeToldBeforeTheAlarm) {
  JournalContents contents;
  contents.take(seen_record(1, 3));
  contents.take(alarm_record(cut_off_notice(1, 3)));
  EXPECT_TRUE(contents.past().alarms[0].is_over);
}

// Or the alarm is lost with the daemon that was killed: its number is not given to another one.
TEST(JournalContents, TheNumberOfALostAlarmIsNotGivenAgain) {
  JournalContents contents;
  contents.take(seen_record(2, 6));
  const std::map<int, std::uint64_t> given{{2, 6}};
  EXPECT_EQ(contents.past().alarm_numbers, given);
}

json shown(const JournalContents& contents) {
  json all = {{"id", contents.id()}, {"actions", contents.actions()}};
  for (const RunReport& report : contents.past().runs)
    all["runs"].push_back({report.channel, report.number, report.program, report.begun_at,
                           report.ended_at, run_outcome_name(report.end).value_or("")});
  for (const AlarmReport& report : contents.past().alarms)
    all["alarms"].push_back({report.channel, report.number, report.at, report.is_over,
                             report.diagnostic.code, report.diagnostic.place.line});
  for (const auto& cut : contents.cut_off())
    all["cut"].push_back({cut.run.channel, cut.run.number, cut.file, cut.line});
  return all;
}

json random_record(std::mt19937& chance, std::map<int, std::uint64_t>& runs,
                   std::map<int, std::uint64_t>& alarms) {
  const int channel = 1 + static_cast<int>(chance() % 3);
  switch (chance() % 6) {
    case 0:
      return run_begun_record(run(channel, ++runs[channel]));
    case 1:
      return run_ended_record(run(channel, runs[channel]));
    case 2:
      return place(channel, runs[channel], static_cast<int>(chance() % 100),
                   1.0 * static_cast<double>(chance() % 1000));
    case 3: {
      AlarmReport report =
          alarm(channel, ++alarms[channel], static_cast<std::int64_t>(chance() % 2));
      report.diagnostic.place.line = static_cast<int>(chance() % 50);
      return alarm_record(report);
    }
    case 4:
      return seen_record(channel, alarms[channel] + chance() % 2);
    default:
      return {{"kind", chance() % 2 == 0 ? "start" : "end"},
              {"at", 1.0 * static_cast<double>(chance() % 1000)}};
  }
}

// Made short at any moment, it goes on as if it had not been.
TEST(JournalContents, SaysTheSameFromItsOwnRecords) {
  std::mt19937 chance(53);
  std::map<int, std::uint64_t> runs;
  std::map<int, std::uint64_t> alarms;
  JournalContents long_one;
  JournalContents short_one;
  for (JournalContents* contents : {&long_one, &short_one})
    contents->take({{"kind", "journal"}, {"id", "abc"}});
  for (int k = 0; k < 6000; ++k) {
    const json record = random_record(chance, runs, alarms);
    long_one.take(record);
    short_one.take(record);
    if (chance() % 300 == 0) {
      JournalContents again;
      for (const json& told : short_one.records()) again.take(told);
      short_one = again;
    }
  }
  EXPECT_EQ(shown(short_one), shown(long_one));
  EXPECT_LE(short_one.records().size(),
            1 + JournalContents::actions_max + std::size_t{3} * 4 * JournalContents::kept_max);
}

}  // namespace
}  // namespace stanok::daemon
