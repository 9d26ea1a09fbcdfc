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
