// What a cycle sees of signals and sensors, and what of it is written down.
#include "channels/machine/input_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stanok::channels {
namespace {

struct WatchedInputs {
  EventBook events{4};
  InputBook book{64, events};
  ChangeBook change_book{64, book};
  Signals outputs;
  InputWatch watch{2, nullptr, {book, change_book}};
  InputWatch looped{0, &outputs, {book, change_book}};

  std::vector<InputRecord> records() {
    std::vector<InputRecord> records;
    for (InputRecord record; book.records().pop(record);) records.push_back(record);
    return records;
  }
  std::vector<InputChange> changes() {
    std::vector<InputChange> changes;
    for (InputChange change; change_book.changes().pop(change);) changes.push_back(change);
    return changes;
  }
};

TEST(InputWatch, WritesDownTheSignalsThatChange) {
  WatchedInputs inputs;
  Signals given;
  given.set(3, true);
  given.analog[1] = 2.5;
  inputs.watch.take(7, &given, {});
  inputs.watch.take(8, &given, {});
  EXPECT_EQ(inputs.watch.signals(), given);
  const auto records = inputs.records();
  const auto changes = inputs.changes();
  ASSERT_EQ(records.size(), 1U) << "nothing changes in the second cycle";
  ASSERT_EQ(changes.size(), 1U) << "nothing changes in the second cycle";
  EXPECT_EQ(records[0].cycle, 7);
  EXPECT_EQ(std::get<DigitalInput>(records[0].content).number, 3);
  EXPECT_TRUE(std::get<DigitalInput>(records[0].content).is_on);
  EXPECT_EQ(changes[0].cycle, 7);
  EXPECT_EQ(std::get<AnalogInput>(changes[0].content).number, 1);
  EXPECT_EQ(std::get<AnalogInput>(changes[0].content).value, 2.5);

  inputs.watch.take(9, nullptr, {});
  EXPECT_EQ(inputs.watch.signals(), Signals{}) << "none are given";
  EXPECT_EQ(inputs.records().size(), 1U);
  EXPECT_EQ(inputs.changes().size(), 1U);
}

TEST(InputWatch, SeesOutputsWhereTheyAreLoopedAndNoInputsGiven) {
  WatchedInputs inputs;
  inputs.outputs.set(5, true);
  inputs.looped.take(1, nullptr, {});
  EXPECT_TRUE(inputs.looped.signals().is_on(5));
  const Signals given;
  inputs.looped.take(2, &given, {});
  EXPECT_FALSE(inputs.looped.signals().is_on(5));
}

TEST(InputWatch, WritesDownTheSensorsThatChangeAndThatTheyTellNothingOnce) {
  WatchedInputs inputs;
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<SpindleSensors> given(2);
  given[0] = given[1] = {.power_w = nothing, .vibration_um = nothing, .vibration_hz = nothing};
  inputs.watch.take(1, nullptr, given);
  static_cast<void>(inputs.changes());
  given[1].power_w = 900.0;
  inputs.watch.take(2, nullptr, given);
  inputs.watch.take(3, nullptr, given);
  const auto changes = inputs.changes();
  ASSERT_EQ(changes.size(), 1U);
  const auto& record = std::get<SpindleInput>(changes[0].content);
  EXPECT_EQ(record.spindle, 1);
  EXPECT_EQ(record.quantity, SpindleQuantity::power_w);
  EXPECT_EQ(record.value, 900.0);
  EXPECT_EQ(inputs.watch.sensors()[1].power_w, 900.0);

  given[1].power_w = nothing;
  inputs.watch.take(4, nullptr, given);
  const auto end = inputs.changes();
  ASSERT_EQ(end.size(), 1U);
  EXPECT_TRUE(std::isnan(std::get<SpindleInput>(end[0].content).value));
  inputs.watch.take(5, nullptr, {});
  EXPECT_TRUE(inputs.changes().empty()) << "the values stay";
}

}  // namespace
}  // namespace stanok::channels
