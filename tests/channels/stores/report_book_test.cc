// ReportBook: what is told of runs stays right whichever side speaks first.
#include "channels/stores/report_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace stanok::channels {
namespace {

using ::testing::ElementsAre;

TEST(ReportBook, NamesARunThatWasAskedForBeforeItsPreparationNamedIt) {
  ReportBook reports;
  RunRecord begun;
  begun.channel = 1;
  begun.run = 2;
  reports.put(begun);
  ASSERT_EQ(reports.runs().size(), 1U);
  reports.name_run(1, 2, "part.nc", {"part.nc", "called.nc"});
  EXPECT_EQ(reports.runs().front().program, "part.nc");
  EXPECT_THAT(reports.runs().front().files, ElementsAre("part.nc", "called.nc"));
}

RunRecord run_of(int channel, std::uint32_t run) {
  RunRecord record;
  record.channel = channel;
  record.run = run;
  return record;
}

AlarmRecord alarm_of(int channel, std::uint32_t run) {
  AlarmRecord record;
  record.channel = channel;
  record.tag.run = run;
  record.code = FixedText<8>("A3001");
  return record;
}

// A life of the daemon: what is kept of it does not grow, and what went is known.
TEST(ReportBook, KeepsTheNewestOfEachChannelAndKnowsHowManyWent) {
  constexpr std::size_t kept = 5;
  constexpr std::uint32_t runs = 40;
  ReportBook reports(kept);
  reports.name_run(2, 1, "other.nc", {});
  reports.put(run_of(2, 1));
  reports.put(alarm_of(2, 1));
  for (std::uint32_t run = 1; run <= runs; ++run) {
    reports.name_run(1, run, "part" + std::to_string(run) + ".nc", {});
    reports.put(run_of(1, run));
    reports.put(alarm_of(1, run));
  }
  const std::vector<RunReport> of_runs = reports.runs();
  ASSERT_EQ(of_runs.size(), kept + 1);
  EXPECT_EQ(of_runs.front().program, "other.nc") << "one channel takes nothing from another";
  EXPECT_EQ(of_runs[1].program, "part36.nc");
  EXPECT_EQ(of_runs.back().number, runs);
  EXPECT_EQ(forgotten(of_runs, 1), runs - kept);
  EXPECT_EQ(forgotten(of_runs, 2), 0U);
  EXPECT_EQ(forgotten(of_runs, 0), runs - kept);
  const std::vector<AlarmReport> alarms = reports.alarms();
  EXPECT_EQ(alarms.size(), kept + 1);
  EXPECT_EQ(alarms.back().diagnostic.place.file, "part40.nc");
  EXPECT_EQ(newest_number(alarms, 1), runs);
  EXPECT_EQ(newest_number(alarms, 3), 0U);
  EXPECT_EQ(forgotten(alarms, 1), runs - kept);
}

RunRecord ended_run(int channel, std::uint32_t run, std::int64_t start, std::int64_t end) {
  RunRecord record = run_of(channel, run);
  record.ended = true;
  record.start_cycle = start;
  record.end_cycle = end;
  return record;
}

AlarmRecord alarm_at(std::int64_t cycle, const char* code) {
  AlarmRecord record = alarm_of(1, 1);
  record.cycle = cycle;
  record.code = FixedText<8>(code);
  return record;
}

// What ended a run, whichever of the two is told first.
TEST(ReportBook, SaysHowARunEnded) {
  ReportBook reports;
  reports.put(alarm_at(5, "A3001"));
  reports.put(ended_run(1, 1, 10, 20));
  reports.put(alarm_at(25, "E5001"));
  reports.put(ended_run(1, 2, 20, 30));
  reports.put(ended_run(1, 3, 40, 50));
  EXPECT_EQ(reports.runs().back().end, RunOutcome::stopped);
  reports.put(alarm_at(50, "A1001"));
  static_cast<void>(reports.alarms());
  RunRecord well = ended_run(1, 4, 60, 70);
  well.ok = true;
  reports.put(well);
  std::vector<RunOutcome> ends;
  for (const RunReport& run : reports.runs()) ends.push_back(run.end);
  EXPECT_THAT(ends, ElementsAre(RunOutcome::stopped, RunOutcome::alarm, RunOutcome::estop,
                                RunOutcome::done));
}

// Numbers go on behind those of the start before, and no run of now is taken for one of then.
TEST(ReportBook, GoesOnBehindWhatThereWasBefore) {
  ReportBook reports(3);
  Past past;
  RunReport before;
  before.channel = 1;
  before.number = 7;
  before.run = 1;
  before.program = "before.nc";
  past.runs = {before};
  AlarmReport alarm;
  alarm.channel = 1;
  alarm.number = 4;
  past.alarms = {alarm};
  past.alarm_numbers = {{1, 5}};
  reports.recall(past, [](std::int64_t cycle) { return 1e9 + static_cast<double>(cycle); });
  reports.name_run(1, 1, "now.nc", {});
  reports.put(ended_run(1, 1, 10, 20));
  const std::vector<RunReport> runs = reports.runs();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs.front().program, "before.nc");
  EXPECT_EQ(runs.back().program, "now.nc");
  EXPECT_EQ(runs.back().number, 8U);
  EXPECT_EQ(runs.back().begun_at, 1e9 + 10);
  EXPECT_EQ(runs.back().ended_at, 1e9 + 20);
  EXPECT_EQ(reports.note(alarm), 6U) << "5 was given and is lost";
  reports.put(alarm_at(30, "A3001"));
  EXPECT_EQ(reports.alarms().back().number, 7U);
  EXPECT_EQ(reports.alarms().back().at, 1e9 + 30);
}

TEST(ReportBook, ARunThatIsKeptIsNamedAndEndedWhereItStands) {
  ReportBook reports(2);
  reports.put(run_of(1, 1));
  reports.put(run_of(1, 2));
  RunRecord ended = run_of(1, 1);
  ended.ended = true;
  reports.put(ended);
  const std::vector<RunReport> runs = reports.runs();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_TRUE(runs[0].ended);
  EXPECT_FALSE(runs[1].ended);
}

Diagnostics errors_of(const char* code, std::size_t count) {
  Diagnostic error;
  error.code = code;
  return Diagnostics(count, error);
}

// The first error is the one that an operator is told.
TEST(ReportBook, TheLatestLoadIsKeptWhole) {
  ReportBook reports(3);
  reports.add_diagnostics(1, errors_of("E1001", 2));
  reports.add_diagnostics(1, errors_of("E1002", 7));
  EXPECT_EQ(reports.load_diagnostics().size(), 7U);
  EXPECT_EQ(reports.load_diagnostics().front().diagnostic.code, "E1002");
  EXPECT_EQ(forgotten(reports.load_diagnostics(), 1), 2U);
  reports.add_diagnostics(1, errors_of("E1003", 1));
  EXPECT_EQ(reports.load_diagnostics().size(), 3U);
}

// Nobody looks at a machine that simulates alone for long.
TEST(ReportBook, AsManyAsThereAreMayBeKept) {
  ReportBook reports(std::numeric_limits<std::size_t>::max());
  for (std::uint32_t run = 1; run <= 200; ++run) reports.put(run_of(1, run));
  EXPECT_EQ(reports.runs().size(), 200U);
}

}  // namespace
}  // namespace stanok::channels
