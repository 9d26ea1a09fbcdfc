// The outbox: numbers without gaps, consumers that wait for each other, a bound that is told.
#include "gateway/outbox/outbox.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "gateway/outbox/wall_clock.h"
#include "tests/support/temporary_directory.h"

namespace stanok::testing {
namespace {

using gateway::Event;
using gateway::Outbox;
using nlohmann::json;

class TheOutbox : public ::testing::Test {
 protected:
  void append(int count) {
    for (int i = 0; i < count; ++i)
      outbox_.append({{"mill", "alarm", 12.5, {{"i", i}}}}, "mill", i);
  }
  std::vector<std::int64_t> numbers() {
    std::vector<std::int64_t> numbers;
    for (const auto& stored : outbox_.behind(0, 1000)) numbers.push_back(stored.number);
    return numbers;
  }

  TemporaryDirectory folder_;
  std::filesystem::path file_ = folder_.path() / "outbox.sqlite";
  Outbox outbox_{file_, 100};
};

// Eclipse Sparkplug 3.0.0, tck-id-topics-nbirth-bdseq-increment.
TEST_F(TheOutbox, CountsSessionsOfSparkplugOverAStart) {
  for (std::uint64_t wanted = 0; wanted < 256; ++wanted) {
    Outbox next(file_);
    ASSERT_EQ(next.sparkplug_session(), wanted);
    ASSERT_EQ(next.sparkplug_session(), wanted) << "no connection came about";
    next.note_sparkplug_session();
  }
  EXPECT_EQ(outbox_.sparkplug_session(), 0U);
}

TEST_F(TheOutbox, KeepsEventsAndMarkForWhoOpensItNext) {
  append(2);
  Outbox again(file_);
  EXPECT_EQ(again.source(), outbox_.source());
  EXPECT_EQ(again.mark("mill"), json(1));
  EXPECT_TRUE(again.mark("lathe").is_null());
  const auto events = again.behind(0, 10);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].number, 2);
  EXPECT_EQ(events[1].event.machine, "mill");
  EXPECT_EQ(events[1].event.time_s, 12.5);
  EXPECT_EQ(events[1].event.content, json({{"i", 1}}));
}

TEST_F(TheOutbox, KeepsWhatTheSlowestConsumerLacks) {
  outbox_.set_consumers({"broker", "history"});
  append(5);
  outbox_.set_position("broker", 4);
  EXPECT_EQ(numbers(), (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  outbox_.set_position("history", 2);
  EXPECT_EQ(numbers(), (std::vector<std::int64_t>{3, 4, 5}));
  // Numbers are never given again, even when none of them is left.
  outbox_.set_position("history", 5);
  outbox_.set_position("broker", 5);
  append(1);
  EXPECT_EQ(numbers(), (std::vector<std::int64_t>{6}));
}

TEST_F(TheOutbox, WaitsForNobodyWhoIsNotNamedAnyMore) {
  outbox_.set_consumers({"broker", "history"});
  append(3);
  outbox_.set_position("broker", 3);
  outbox_.set_consumers({"broker"});
  outbox_.set_position("broker", 3);
  EXPECT_TRUE(numbers().empty());
}

TEST_F(TheOutbox, TellsWhatItHasGivenUp) {
  append(101);
  // One too many, and a hundredth of the bound.
  const auto events = outbox_.behind(0, 1000);
  ASSERT_EQ(events.size(), 100U);
  EXPECT_EQ(events.front().number, 3);
  EXPECT_EQ(events.back().number, 102);
  EXPECT_EQ(events.back().event.kind, "lost");
  EXPECT_EQ(events.back().event.content, json({{"first", 1}, {"last", 2}}));
}

TEST_F(TheOutbox, SaysThatTheDiskTakesNothing) {
  EXPECT_THROW(Outbox(folder_.path() / "none" / "outbox.sqlite"), gateway::DatabaseError);
}

TEST(WallClock, SaysTimesAsIso8601) {
  // 2026-03-01 is day 20513 since 1970.
  EXPECT_EQ(gateway::utc_text(20513 * 86400.0 + 7.5 * 3600 + 0.125), "2026-03-01T07:30:00.125Z");
  EXPECT_EQ(gateway::utc_text(86400.0 - 0.0001), "1970-01-02T00:00:00.000Z");
}

}  // namespace
}  // namespace stanok::testing
