// Inputs that find no place are not lost in silence.
#include "channels/stores/input_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::machine_of_one_axis_channels;
using testing::MachineBench;
using ::testing::Not;

InputRecord input_of(std::int64_t cycle) {
  InputRecord record;
  record.cycle = cycle;
  return record;
}

std::vector<InputRecord> taken(Ring<InputRecord>& ring, std::size_t count) {
  std::vector<InputRecord> records;
  for (InputRecord record; records.size() < count && ring.pop(record);) records.push_back(record);
  return records;
}

struct SmallBook {
  static constexpr std::size_t capacity = 16;
  EventBook events{4};
  InputBook book{capacity, events};
};

TEST(InputBook, SaysAtItsPlaceThatInputsAreMissingAndThenHowMany) {
  SmallBook small;
  for (std::int64_t cycle = 1; cycle <= 100; ++cycle) small.book.note(input_of(cycle));
  EXPECT_EQ(small.book.lost(), 100U - (SmallBook::capacity - 1));
  const auto kept = taken(small.book.records(), SmallBook::capacity);
  ASSERT_EQ(kept.size(), SmallBook::capacity);
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    EXPECT_TRUE(std::holds_alternative<OperatorCommand>(kept[k].content));
    EXPECT_EQ(kept[k].cycle, static_cast<std::int64_t>(k) + 1);
  }
  EXPECT_EQ(std::get<LostInputs>(kept.back().content).count, 0U);
  EXPECT_EQ(kept.back().cycle, static_cast<std::int64_t>(SmallBook::capacity));

  small.book.note(input_of(101));
  const auto behind = taken(small.book.records(), SmallBook::capacity);
  ASSERT_EQ(behind.size(), 2U);
  EXPECT_EQ(std::get<LostInputs>(behind[0].content).count, 85U) << "of 100";
  EXPECT_TRUE(std::holds_alternative<OperatorCommand>(behind[1].content));
  EXPECT_EQ(behind[1].cycle, 101);
}

// A recorder at its limit takes one record in each cycle where two come: a gap lasts until half of
// the ring is free, and each is told once.
TEST(InputBook, TellsOperatorsOnceForEachGap) {
  constexpr int cycles = 1000;
  EventBook events{cycles};
  InputBook book{SmallBook::capacity, events};
  std::vector<std::int64_t> gaps;
  for (std::int64_t cycle = 1; cycle <= cycles; ++cycle) {
    for (int n = 0; n < 2; ++n) book.note(input_of(cycle));
    const InputRecord record = taken(book.records(), 1).at(0);
    const auto* lost = std::get_if<LostInputs>(&record.content);
    if (lost != nullptr && lost->count == 0) gaps.push_back(record.cycle);
  }
  EXPECT_GT(gaps.size(), 1U);
  EXPECT_LE(gaps.size(), cycles / (SmallBook::capacity / 2));
  for (const std::int64_t cycle : gaps) {
    Event event;
    ASSERT_TRUE(events.events().pop(event));
    EXPECT_EQ(event.code.view(), "W720");
    EXPECT_EQ(event.channel, 0);
    EXPECT_EQ(event.cycle, cycle);
    EXPECT_THAT(std::string(event.text.view()),
                ::testing::HasSubstr("from cycle " + std::to_string(cycle)));
  }
}

// The ring of the events was full as well.
TEST(InputBook, TellsOperatorsLaterWhenItCannotNow) {
  SmallBook small;
  while (small.events.events().push({})) {
  }
  for (std::int64_t cycle = 1; cycle <= 100; ++cycle) small.book.note(input_of(cycle));
  small.events.events().pop_front(4);
  small.book.note(input_of(101));
  Event event;
  ASSERT_TRUE(small.events.events().pop(event));
  EXPECT_EQ(event.cycle, static_cast<std::int64_t>(SmallBook::capacity)) << "where it began";
}

TEST(MachineInputs, ThatAreTooManyForTheRecordRaiseAWarning) {
  constexpr int kept = 4096 - 1;
  MachineBench bench(machine_of_one_axis_channels(1));
  const auto ask = [&](int count) {
    for (int n = 0; n < count; ++n)
      bench.ask(OperatorAction::override_feed, 1, "", 0.5 + 0.0001 * n);
    bench.cycle();
  };
  ask(kept);
  EXPECT_EQ(bench.machine().inputs_lost(), 0U);
  EXPECT_THAT(bench.event_codes(), Not(Contains("W720")));
  ask(kept + 7);
  EXPECT_EQ(bench.machine().inputs_lost(), 7U);
  EXPECT_THAT(bench.event_codes(), Contains("W720"));
}

}  // namespace
}  // namespace stanok::channels
