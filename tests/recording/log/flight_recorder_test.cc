// The last seconds in memory, and the log that is begun late.
#include "recording/log/flight_recorder.h"

#include <gtest/gtest.h>

#include "recording/format/decode.h"
#include "recording/log/log_switch.h"
#include "recording/read/log_contents.h"
#include "tests/recording/recorded_log.h"

namespace stanok::recording {
namespace {

TEST(FlightRecorder, KeepsItsSpanAndAtMostASecondMore) {
  FlightRecorder flight(5'000'000);
  MessageStream stream(small_machine(), {&flight});
  for (int cycle = 0; cycle < 12'345; ++cycle) stream.cycle(output_of(cycle));
  const auto file = test_file("lcm");
  const auto written = flight.recording().write(file);
  ASSERT_TRUE(written);
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound());
  ASSERT_TRUE(contents->description);
  EXPECT_EQ(contents->description->machine, "mill");
  const auto& kept = contents->channels.at(setpoint_channel);
  EXPECT_EQ(kept.missing, 0);
  EXPECT_GE(kept.messages, 5000);
  EXPECT_LE(kept.messages, 6000);
  EXPECT_EQ(kept.cycle_last, 12'344);
}

TEST(FlightRecorder, NeedsNoMoreMemoryLater) {
  FlightRecorder flight(2'000'000);
  MessageStream stream(small_machine(), {&flight});
  for (int cycle = 0; cycle < 4000; ++cycle) stream.cycle(output_of(cycle));
  const std::size_t early = flight.bytes();
  for (int cycle = 4000; cycle < 60'000; ++cycle) stream.cycle(output_of(cycle));
  EXPECT_LT(flight.bytes(), 2 * early);
}

// One second in seven has much to tell: not every second keeps the memory for that.
TEST(FlightRecorder, HoldsWhatItKeepsHoweverUnlikeSecondsAre) {
  FlightRecorder flight(5'000'000);
  MessageStream stream(small_machine(), {&flight});
  std::size_t kept_max = 0;
  channels::Event event;
  for (int cycle = 0; cycle < 100'000; ++cycle) {
    stream.cycle(output_of(cycle));
    event.cycle = cycle;
    for (int n = 0; cycle / 1000 % 7 == 0 && n < 5; ++n) stream.event(event);
    kept_max = std::max(kept_max, flight.bytes());
  }
  EXPECT_LT(flight.bytes_held(), kept_max + kept_max / 2);
}

// Messages of the setpoints of a file: first and last cycle, and that none is missing between.
void expect_cycles(const std::filesystem::path& file, std::int64_t first, std::int64_t last) {
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->coverage.is_complete());
  const auto& kept = contents->channels.at(setpoint_channel);
  EXPECT_EQ(kept.cycle_first, first);
  EXPECT_EQ(kept.cycle_last, last);
  EXPECT_EQ(kept.messages, last - first + 1);
}

// A recording is of its moment, however late it is written; the recorder loses nothing meanwhile.
TEST(FlightRecorder, GoesOnWhileARecordingIsBeingWritten) {
  FlightRecorder flight(2'000'000);
  MessageStream stream(small_machine(), {&flight});
  for (int cycle = 0; cycle < 1500; ++cycle) stream.cycle(output_of(cycle));
  const FlightRecording early = flight.recording();
  for (int cycle = 1500; cycle < 5000; ++cycle) stream.cycle(output_of(cycle));
  const FlightRecording late = flight.recording();
  for (int cycle = 5000; cycle < 9000; ++cycle) stream.cycle(output_of(cycle));
  const auto file = test_file("lcm");
  ASSERT_TRUE(early.write(file));
  expect_cycles(file, 0, 1499);
  ASSERT_TRUE(late.write(file));
  expect_cycles(file, 2500, 4999);
}

TEST(FlightRecorder, SaysWhyItsFileCannotBeMade) {
  FlightRecorder flight(1'000'000);
  const auto written = flight.recording().write("/nowhere/flight.lcm");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().text.find("/nowhere/flight.lcm"), std::string::npos);
}

// Begun in the middle, ended before the end: whole between, and readable alone.
TEST(LogSwitch, BeginsAndEndsALogWhileTheStreamGoesOn) {
  const auto file = test_file("lcm");
  LogSwitch log;
  MessageStream stream(small_machine(), {&log});
  stream.text({.cycle = 0, .name = "part.nc", .text = "M30\n"});
  for (int cycle = 0; cycle < 900; ++cycle) {
    if (cycle == 300) log.turn_to(std::move(*LogWriter::open(file)), 300'000);
    if (cycle == 700) log.turn_to(nullptr, 700'000);
    stream.cycle(output_of(cycle));
  }
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound());
  EXPECT_TRUE(contents->description);
  EXPECT_EQ(contents->channels.at(setpoint_channel).messages, 400);
  EXPECT_EQ(contents->channels.at(setpoint_channel).missing, 0);
  EXPECT_EQ(contents->channels.at(setpoint_channel).cycle_last, 699);
  EXPECT_EQ(contents->channels.count("STANOK_MILL_PROGRAM"), 1u);
}

}  // namespace
}  // namespace stanok::recording
