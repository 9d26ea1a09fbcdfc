// What is remembered of measurements: the newest of each channel, with their numbers.
#include "daemon/report/measurement_notes.h"

#include <gtest/gtest.h>

#include <string_view>

namespace stanok::daemon {
namespace {

using nlohmann::json;

channels::Event logged(int channel, std::string_view text) {
  channels::Event event;
  event.cycle = 7;
  event.channel = channel;
  event.text = text;
  return event;
}

TEST(MeasurementNotes, KeepMeasurementsAndNothingElse) {
  MeasurementNotes notes;
  notes.take(logged(1, "measured bore size=14.05 error_size=0.05"));
  notes.take(logged(1, "nothing was measured"));
  notes.take(logged(2, "measured face z=-1.5"));
  const json all = notes.history(0);
  ASSERT_EQ(all["measurements"].size(), 2U);
  EXPECT_FALSE(all.contains("forgotten"));
  EXPECT_EQ(all["measurements"][0], json({{"channel", 1},
                                          {"number", 1},
                                          {"cycle", 7},
                                          {"feature", "bore"},
                                          {"values", {{"size", 14.05}, {"error_size", 0.05}}},
                                          {"text", "measured bore size=14.05 error_size=0.05"}}));
  EXPECT_EQ(notes.history(2)["measurements"].size(), 1U);
  EXPECT_TRUE(notes.history(3)["measurements"].empty());
}

TEST(MeasurementNotes, SayHowManyOlderOnesWent) {
  MeasurementNotes notes;
  for (int k = 0; k < 503; ++k) notes.take(logged(1, "measured bore size=14"));
  const json of_one = notes.history(1);
  ASSERT_EQ(of_one["measurements"].size(), 500U);
  EXPECT_EQ(of_one["measurements"][0]["number"], 4);
  EXPECT_EQ(of_one["measurements"][499]["number"], 503);
  EXPECT_EQ(of_one["forgotten"], 3);
}

}  // namespace
}  // namespace stanok::daemon
