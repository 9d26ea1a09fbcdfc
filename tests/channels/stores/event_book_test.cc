// Events and reports that find no place are counted, and people are told.
#include "channels/stores/event_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/stores/report_book.h"
#include "tests/support/machine/coordinator_bench.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

Event message(std::int64_t cycle) {
  Event event;
  event.cycle = cycle;
  return event;
}

TEST(EventBook, SaysHowManyMessagesAreMissingWhereTheyAre) {
  EventBook book(4);
  for (std::int64_t cycle = 1; cycle <= 10; ++cycle)
    EXPECT_EQ(book.put(message(cycle)), cycle <= 4);
  EXPECT_EQ(book.lost(), 6U);
  Event event;
  while (book.events().pop(event)) {
  }
  EXPECT_EQ(event.cycle, 4);
  EXPECT_TRUE(book.put(message(11)));
  ASSERT_TRUE(book.events().pop(event));
  EXPECT_EQ(event.code.view(), "W721");
  EXPECT_EQ(event.text.view(),
            "6 messages before this one are missing: they were not read in time");
  ASSERT_TRUE(book.events().pop(event));
  EXPECT_EQ(event.cycle, 11);
  EXPECT_FALSE(book.events().pop(event));
}

TEST(EventBook, OnePlaceThatIsFreeIsNotEnoughToSayItAndGoOn) {
  EventBook book(2);
  for (std::int64_t cycle = 1; cycle <= 3; ++cycle) book.put(message(cycle));
  book.events().pop_front();
  EXPECT_FALSE(book.put(message(4)));
  book.events().pop_front();
  EXPECT_TRUE(book.put(message(5)));
  EXPECT_EQ(book.lost(), 2U);
}

TEST(EventBook, ReportsThatFindNoPlaceAreCounted) {
  ReportBook reports;
  for (int k = 0; k < 300; ++k) reports.put(AlarmRecord{});
  EXPECT_GT(reports.lost(), 0U);
  EXPECT_EQ(reports.alarms().size() + reports.lost(), 300U);
  reports.put(AlarmRecord{});
  reports.name_run(1, 1, "part.nc", {});
  EXPECT_EQ(reports.alarms().size() + reports.lost(), 301U);
}

// Every emergency stop is an alarm of both channels; nobody looks at the history meanwhile.
TEST(EventBook, AHistoryThatIsNotWholeIsTold) {
  stanok::testing::MachineBench bench;
  for (int stop = 0; stop < 200; ++stop) {
    bench.ask(OperatorAction::machine_estop, 0);
    bench.cycle();
  }
  EXPECT_THAT(bench.event_codes(), ::testing::Contains("W722"));
}

// The preparation of a channel does not take what it is told: the channel stops by a fault.
TEST(EventBook, ANoticeThatFindsNoPlaceStopsItsChannel) {
  stanok::testing::CoordinatorBench bench;
  ChannelLink& link = bench.link(0);
  for (std::size_t k = 0; k <= link.notices.capacity(); ++k) link.tell({});
  bench.cycle();
  EXPECT_EQ(bench.table[0].log.last_alarm().code.view(), "A9001");
  EXPECT_EQ(bench.table[0].state().situation(), Situation::ending);
  EXPECT_EQ(bench.table[1].state().situation(), Situation::ready);
}

}  // namespace
}  // namespace stanok::channels
