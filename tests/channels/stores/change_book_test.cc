// What drives and preparations told is written down where it changes, and its loss is an input of
// its own: nothing behind it can be repeated.
#include "channels/stores/change_book.h"

#include <gtest/gtest.h>

#include <memory>

namespace stanok::channels {
namespace {

struct Books {
  explicit Books(std::size_t capacity) : changes(capacity, inputs) {}

  std::vector<InputChange> taken() {
    std::vector<InputChange> all;
    for (InputChange change; changes.changes().pop(change);) all.push_back(change);
    return all;
  }
  std::vector<std::int64_t> losses() {
    std::vector<std::int64_t> cycles;
    for (InputRecord record; inputs.records().pop(record);) {
      const auto* lost = std::get_if<LostInputs>(&record.content);
      if (lost != nullptr && lost->count == 0) cycles.push_back(record.cycle);
    }
    return cycles;
  }

  EventBook events{8};
  InputBook inputs{16, events};
  ChangeBook changes;
};

std::unique_ptr<CycleOutput> output_of(std::int64_t cycle, double position) {
  auto output = std::make_unique<CycleOutput>();
  output->cycle = cycle;
  output->channel_count = 1;
  ChannelOutput& channel = output->channels[0];
  channel.id = 3;
  channel.axis_count = 2;
  channel.has_feedback = true;
  channel.feedback[1].position = position;
  channel.arrivals.chunks = static_cast<std::uint64_t>(cycle / 10);
  return output;
}

TEST(ChangeBook, WritesDownEachAxisAtFirstAndThenWhatChanges) {
  Books books(64);
  books.changes.note(*output_of(1, 0.0));
  EXPECT_EQ(books.taken().size(), 2U) << "both axes are told, although they stand at 0";
  books.changes.note(*output_of(2, 0.0));
  EXPECT_TRUE(books.taken().empty());
  books.changes.note(*output_of(10, 2.5));
  const auto told = books.taken();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(std::get<Arrivals>(told[0].content).chunks, 1U);
  EXPECT_EQ(told[1].cycle, 10);
  EXPECT_EQ(told[1].channel, 3);
  EXPECT_EQ(std::get<FeedbackInput>(told[1].content).axis, 1);
  EXPECT_EQ(std::get<FeedbackInput>(told[1].content).value.position, 2.5);
}

TEST(ChangeBook, TellsALossOnceUntilHalfOfTheRingIsFree) {
  Books books(16);
  for (int cycle = 1; cycle <= 40; ++cycle) books.changes.note(*output_of(cycle, cycle));
  EXPECT_EQ(books.losses(), std::vector<std::int64_t>{15});
  EXPECT_EQ(books.taken().size(), 16U);
  books.changes.note(*output_of(41, 41.0));
  EXPECT_EQ(books.taken().size(), 1U);
  EXPECT_TRUE(books.losses().empty());
  EXPECT_EQ(books.inputs.lost(), 1U);
}

TEST(ChangeBook, KeepsNothingWithoutARecorder) {
  Books books(0);
  for (int cycle = 1; cycle <= 40; ++cycle) books.changes.note(*output_of(cycle, cycle));
  EXPECT_TRUE(books.taken().empty());
  EXPECT_TRUE(books.losses().empty());
}

}  // namespace
}  // namespace stanok::channels
