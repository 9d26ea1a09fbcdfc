// ReportBook: what is told of runs stays right whichever side speaks first.
#include "channels/report_book.h"

#include <gtest/gtest.h>

namespace stanok::channels {
namespace {

TEST(ReportBook, NamesARunThatWasAskedForBeforeItsPreparationNamedIt) {
  ReportBook reports;
  RunRecord begun;
  begun.channel = 1;
  begun.run = 2;
  ASSERT_TRUE(reports.run_records().push(begun));
  ASSERT_EQ(reports.runs().size(), 1U);
  reports.name_run(1, 2, "part.nc");
  EXPECT_EQ(reports.runs().front().program, "part.nc");
}

}  // namespace
}  // namespace stanok::channels
