// Power out of a log that has changes only.
#include "jobs/cutting/power_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/encode_input_record.h"

namespace stanok::jobs {
namespace {

void take(PowerReadings& readings, std::int64_t cycle, double power_w) {
  const channels::SpindleInput input{
      .spindle = 0, .quantity = channels::SpindleQuantity::power_w, .value = power_w};
  const input_t message = recording::to_input({.cycle = cycle, .channel = 0, .content = input},
                                              {.utime = 0, .cycle = cycle, .seq = 0});
  std::vector<std::uint8_t> bytes(checked_size(message.getEncodedSize()));
  message.encode(bytes.data(), 0, message.getEncodedSize());
  const std::string channel = recording::ChannelNames("mill").name(0, recording::Topic::input);
  readings.take({.channel = channel, .bytes = bytes});
}

std::string shown(const std::vector<double>& power_w) {
  std::string text;
  for (const double power : power_w)
    text += std::isnan(power) ? "- " : std::to_string(std::lround(power)) + " ";
  return text;
}

PowerReadings readings_of(const std::vector<std::pair<std::int64_t, double>>& changes) {
  PowerReadings readings(0);
  for (const auto& [cycle, power_w] : changes) take(readings, cycle, power_w);
  return readings;
}

TEST(PowerReadings, AreHeldFromPollToPoll) {
  const PowerReadings readings = readings_of({{10, 1}, {12, 2}, {14, 3}, {20, 4}});
  EXPECT_EQ(shown(readings.given(9, 13)), "- 1 - 2 - 3 - 3 - 3 - 4 - ");
}

TEST(PowerReadings, AreThoseOfThePollsBeforeTheCyclesThatAreAskedFor) {
  const PowerReadings readings = readings_of({{10, 1}, {12, 2}, {14, 3}, {30, 4}});
  EXPECT_EQ(shown(readings.given(21, 5)), "- 3 - 3 - ");
  EXPECT_EQ(shown(readings.given(31, 2)), "- - ");
}

TEST(PowerReadings, AreOnlyThemselvesWhereNoPollIsKnown) {
  EXPECT_EQ(shown(readings_of({{10, 1}, {14, 2}}).given(10, 6)), "1 - - - 2 - ");
}

// Whatever numbers stand in it: memory and time are those of the cycles that are asked for.
TEST(PowerReadings, OfADamagedLogCostNoMoreThanWhatIsAskedFor) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const std::int64_t last = std::int64_t{1} << 53;
  const PowerReadings readings = readings_of({{10, 1},
                                              {11, 2},
                                              {12, 3},
                                              {last, 4},
                                              {13, 5},
                                              {largest, 6},
                                              {-largest, 7},
                                              {14, 8},
                                              {15, 9}});
  EXPECT_EQ(shown(readings.given(10, 8)), "1 2 3 5 8 9 3 3 ");
  EXPECT_EQ(shown(readings.given(largest, 2)), "- - ");
  EXPECT_EQ(shown(readings.given(-1, 2)), "- - ");
  EXPECT_EQ(shown(readings.given(last, 2)), "4 - ");
  EXPECT_EQ(shown(readings.by_row(largest, {900.0, 900.0}, 1e-3)), "- - ");
}

}  // namespace
}  // namespace stanok::jobs
