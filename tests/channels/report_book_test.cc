// ReportBook: what is told of runs stays right whichever side speaks first.
#include "channels/stores/report_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stanok::channels
