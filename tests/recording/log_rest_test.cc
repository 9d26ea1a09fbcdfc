// What a machine at rest says again and again is left out of a log, and reads as if it stood there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <stanok_messages/log_rest_t.hpp>

#include "recording/format/decode.h"
#include "recording/log/log_switch.h"
#include "recording/read/log_contents.h"
#include "tests/recording/recorded_log.h"

namespace stanok::recording {
namespace {

struct Written {
  std::int64_t utime = 0;
  std::string channel;
  Bytes bytes;

  friend bool operator==(const Written&, const Written&) = default;
};

// Without what belongs to the file alone.
std::vector<Written> messages_of(const std::filesystem::path& file) {
  std::vector<Written> messages;
  auto reader = LogReader::open(file);
  EXPECT_TRUE(reader);
  while (const auto event = reader->next()) {
    const std::string_view topic = topic_of(event->channel);
    if (topic == name_of(Topic::log_check) || topic == name_of(Topic::log_rest)) continue;
    messages.push_back({event->utime, std::string(event->channel),
                        Bytes(event->bytes.begin(), event->bytes.end())});
  }
  EXPECT_TRUE(reader->damage().empty());
  return messages;
}

// Of each that is not the same, where the first one is.
std::string difference(const std::vector<Written>& one, const std::vector<Written>& other) {
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
    if (one[k] == other[k]) continue;
    return std::to_string(k) + ": " + one[k].channel + " of cycle " +
           std::to_string(cycle_of(one[k].bytes)) + ", " + other[k].channel + " of cycle " +
           std::to_string(cycle_of(other[k].bytes));
  }
  return one.size() == other.size()
             ? ""
             : "their number: " + std::to_string(one.size()) + ", " + std::to_string(other.size());
}

// Two channels that rest, move, raise events, are told things, and lose cycles, by chance; the same
// stream into a log that has all of it and into one that leaves out what repeats.
class LogRest : public ::testing::Test {
 protected:
  LogRest() {
    description.channels.push_back({2, {{"X2", "X", false}}});
    output = output_of(0);
    output.channel_count = 2;
    output.channels[1].id = 2;
    output.channels[1].axis_count = 1;
    output.channels[1].has_feedback = true;
  }

  enum class Beside { full_log, nothing };
  void begin(std::int64_t size_max_bytes = 0, Beside beside = Beside::full_log) {
    std::vector<MessageSink*> sinks{&log};
    if (beside == Beside::full_log) {
      auto full = LogWriter::open(full_file);
      ASSERT_TRUE(full);
      whole = std::move(*full);
      sinks.push_back(whole.get());
    }
    auto short_one = LogWriter::open(file, size_max_bytes);
    ASSERT_TRUE(short_one);
    writer = short_one->get();
    log.turn_to(std::move(*short_one), 0);
    stream = std::make_unique<MessageStream>(description, sinks);
    stream->ask_for_situations(
        [](const channels::ChannelOutput&) { return channels::SituationReport{}; });
  }
  void rest(std::int64_t cycles) {
    for (std::int64_t n = 0; n < cycles; ++n) {
      ++output.cycle;
      stream->cycle(output);
    }
  }
  void end() {
    pieces = writer->status().pieces;
    log.turn_to(nullptr, 0);
    if (whole) {
      ASSERT_TRUE(whole->finish());
    }
  }
  [[nodiscard]] static std::int64_t size_of(const std::filesystem::path& of) {
    return static_cast<std::int64_t>(std::filesystem::file_size(of));
  }

  const std::filesystem::path full_file = test_file("full.lcm");
  const std::filesystem::path file = test_file("lcm");
  LogDescription description = small_machine();
  channels::CycleOutput output;
  std::unique_ptr<LogWriter> whole;
  LogWriter* writer = nullptr;
  LogSwitch log;
  std::unique_ptr<MessageStream> stream;
  int pieces = 0;
};

TEST_F(LogRest, IsLeftOutAndReadsAsIfItStoodThere) {
  begin();
  rest(130'000);
  end();
  EXPECT_EQ(difference(messages_of(full_file), messages_of(file)), "");
  EXPECT_LT(size_of(file), 30'000);
  EXPECT_GT(size_of(full_file), 100'000'000);
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound() && !contents->is_cut());
  const ChannelContents& setpoints = contents->channels.at(setpoint_channel);
  EXPECT_EQ(setpoints.messages, 130'000);
  EXPECT_EQ(setpoints.missing, 0);
  EXPECT_EQ(setpoints.cycle_last, 130'000);
  EXPECT_LT(setpoints.bytes, 5'000) << "in the file";
}

TEST_F(LogRest, ByChanceNothingIsOtherwise) {
  std::mt19937 chance(53);
  const auto any = [&](int count) {
    return static_cast<int>(chance() % static_cast<unsigned>(count));
  };
  begin();
  channels::Event happened;
  channels::InputRecord input{.cycle = 0, .channel = 1, .content = channels::OperatorCommand{}};
  for (int n = 0; n < 400; ++n) {
    channels::ChannelOutput& channel = output.channels[static_cast<std::size_t>(any(2))];
    switch (any(9)) {
      case 0:
        rest(any(3000));
        break;
      case 1:
        for (int k = any(30); k > 0; --k) {
          channel.axes[0].position += 0.01;
          rest(1);
        }
        break;
      case 2:
        happened.cycle = output.cycle;
        happened.channel = channel.id;
        stream->event(happened);
        break;
      case 3:
        input.cycle = output.cycle + any(20);
        stream->input(input);
        break;
      case 4:
        output.cycle += any(5);  // outputs that were lost
        break;
      case 5:
        channel.tool.number = any(3);
        channel.tool_row.number = channel.tool.number;
        break;
      case 6:
        channel.has_feedback = any(2) == 0;
        break;
      case 7:
        stream->path({channel.id, "part.nc",
                      std::vector<PreviewPoint>(static_cast<std::size_t>(any(300) + 1))});
        break;
      default:
        rest(any(40));
    }
  }
  rest(70'000);
  end();
  EXPECT_EQ(difference(messages_of(full_file), messages_of(file)), "");
  EXPECT_LT(size_of(file), size_of(full_file) / 10);
}

// A day is 50 GB otherwise; of a day by ./test --all (STANOK_REST_HOURS=24), else of some minutes.
TEST_F(LogRest, OfADayTakesLittle) {
  const char* const hours = std::getenv("STANOK_REST_HOURS");
  const int minutes = hours == nullptr ? 10 : 60 * std::stoi(hours);
  begin(0, Beside::nothing);
  for (int minute = 0; minute < minutes; ++minute) {
    rest(60'000);
    if (minute % 60 == 0) {
      ASSERT_TRUE(writer->flush());
    }
  }
  end();
  constexpr std::int64_t of_the_beginning = 50'000;
  EXPECT_LT(size_of(file), of_the_beginning + 20'000'000LL * minutes / (24LL * 60));
  RecordProperty("bytes", std::to_string(size_of(file)));
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound() && !contents->is_cut());
  EXPECT_EQ(contents->channels.at(setpoint_channel).messages, 60'000LL * minutes);
  EXPECT_EQ(contents->channels.at(setpoint_channel).missing, 0);
}

// A path is sent again every minute, in some hundred parts.
TEST_F(LogRest, PathsOfDisplaysAreLeftOutToo) {
  begin();
  rest(10);
  stream->path({1, "part.nc", {}});
  recording::PathPreview path{1, "part.nc", {}};
  for (int k = 0; k < 10'000; ++k)
    path.points.push_back({.point = {0.1 * k, 0.0, 0.0}, .begins = k == 0, .rapid = false});
  stream->path(path);
  rest(130'000);
  const std::int64_t before = writer->status().bytes;
  rest(130'000);
  end();
  EXPECT_LT(size_of(file) - before, 35'000);
  EXPECT_EQ(difference(messages_of(full_file), messages_of(file)), "");
}

TEST_F(LogRest, EachPieceStandsAlone) {
  begin(20'000);
  for (int n = 0; n < 100; ++n) {
    rest(700);
    output.channels[0].axes[0].position += 1.0;
  }
  end();
  ASSERT_GT(pieces, 3);
  std::int64_t messages = 0;
  for (int piece = 1; piece <= pieces; ++piece) {
    const auto contents = read_contents(piece_name(file, piece));
    ASSERT_TRUE(contents);
    EXPECT_TRUE(contents->is_sound()) << piece;
    const auto setpoints = contents->channels.find(setpoint_channel);
    if (setpoints == contents->channels.end()) continue;
    messages += setpoints->second.messages;
    EXPECT_EQ(setpoints->second.missing, 0) << piece;
  }
  EXPECT_EQ(messages, 70'000);
}

// The machine is known to have rested until 5 s before the cut.
TEST_F(LogRest, ACutLogTellsUntilWhenTheMachineRested) {
  begin();
  rest(42'000);
  ASSERT_TRUE(writer->flush());
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_cut());
  EXPECT_TRUE(contents->is_sound());
  EXPECT_GT(contents->channels.at(setpoint_channel).cycle_last, 37'000);
  EXPECT_EQ(contents->channels.at(setpoint_channel).missing, 0);
}

// Whatever bytes are missing: what is read was written, and what is not read is said to be missing.
TEST_F(LogRest, OfADamagedLogNothingIsInvented) {
  begin();
  for (int n = 0; n < 20; ++n) {
    rest(200);
    output.channels[0].axes[0].position += 1.0;
    output.channels[1].axes[0].position += 1.0;
  }
  end();
  std::vector<Written> written = messages_of(full_file);
  std::ranges::sort(written, {}, [](const Written& m) { return std::pair(m.channel, m.bytes); });
  const Bytes bytes = bytes_of(file);
  std::mt19937 chance(53);
  for (int n = 0; n < 200; ++n) {
    Bytes damaged = bytes;
    const auto at = static_cast<std::ptrdiff_t>(chance() % damaged.size());
    const auto end = std::min<std::ptrdiff_t>(at + static_cast<std::ptrdiff_t>(chance() % 3000),
                                              std::ssize(damaged));
    damaged.erase(damaged.begin() + at, damaged.begin() + end);
    const auto broken = test_file("broken.lcm");
    write_bytes(broken, damaged);
    auto reader = LogReader::open(broken);
    ASSERT_TRUE(reader);
    while (const auto event = reader->next()) {
      const std::string_view topic = topic_of(event->channel);
      if (topic != name_of(Topic::setpoint) || event->is_in_file()) continue;
      const Written read{event->utime, std::string(event->channel),
                         Bytes(event->bytes.begin(), event->bytes.end())};
      const auto found =
          std::ranges::lower_bound(written, std::pair(read.channel, read.bytes), {},
                                   [](const Written& m) { return std::pair(m.channel, m.bytes); });
      ASSERT_TRUE(found != written.end() && *found == read)
          << read.channel << " of cycle " << cycle_of(read.bytes) << ", damaged from " << at
          << " to " << end;
    }
  }
}

// Records of another length than any that is written: no reader is kept busy for ever.
TEST_F(LogRest, AnAbsurdRecordGivesNothing) {
  begin();
  rest(10);
  log_rest_t record{};
  record.cycle = std::numeric_limits<std::int64_t>::max();
  record.first_cycle = 11;
  record.cycle_us = 1000;
  record.stream_count = 1;
  record.stream_name = {setpoint_channel};
  record.stream_part = {0};
  record.stream_cycle = {11};
  record.stream_step = {1};
  record.stream_seq = {10};
  record.stream_seq_step = {1};
  record.stream_sum = {0};
  Bytes bytes(static_cast<std::size_t>(record.getEncodedSize()));
  record.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  writer->send("STANOK_MILL_LOG_REST", 0, bytes);
  end();
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  EXPECT_EQ(contents->channels.at(setpoint_channel).messages, 10);
}

}  // namespace
}  // namespace stanok::recording
