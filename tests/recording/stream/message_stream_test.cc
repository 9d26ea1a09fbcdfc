// Messages: there and back, the same bytes twice, names that LCM takes, a disk that is full, a bus.
#include "recording/stream/message_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <span>
#include <string>

#include "recording/format/decode.h"
#include "recording/format/encode_tool_row.h"
#include "recording/read/log_export.h"
#include "recording/stream/lcm_publisher.h"
#include "tests/recording/recorded_log.h"
#include "tests/support/project_folders.h"

namespace stanok::recording {
namespace {

TEST(Encode, GivesASetpointBackToTheBit) {
  channels::ChannelOutput output = output_of(7).channels[0];
  output.axes[0].position = 0.1 + 0.2;
  output.axes[0].jerk = -1e-300;
  output.axes[0].position_code = -9007199254740993;  // no double holds it
  output.tag = {.run = 1, .block = 5'000'000'000, .line = 12, .file = 3};
  output.state = channels::ChannelState::held;
  output.drives[1] = {.enabled = true, .brake_closed = false};
  const setpoint_t message = to_setpoint(output, {.utime = 7000, .cycle = 7, .seq = 7});
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  const auto decoded = decode<setpoint_t>(bytes);
  ASSERT_TRUE(decoded);
  const channels::ChannelOutput back = from_setpoint(*decoded);
  EXPECT_EQ(back.axes[0].position, output.axes[0].position);
  EXPECT_EQ(back.axes[0].jerk, output.axes[0].jerk);
  EXPECT_EQ(back.axes[0].position_code, output.axes[0].position_code);
  EXPECT_EQ(back.point_W[0].value, output.point_W[0].value);
  EXPECT_EQ(back.tag.block, output.tag.block);
  EXPECT_EQ(back.tag.line, output.tag.line);
  EXPECT_EQ(back.state, output.state);
  EXPECT_TRUE(back.running);
  EXPECT_TRUE(back.drives[1].enabled);
  EXPECT_FALSE(back.drives[1].brake_closed);
  EXPECT_TRUE(back.drives[0].brake_closed);
}

TEST(Encode, NamesTheProgramInTheStateOfItsChannel) {
  channels::ChannelOutput output = output_of(7).channels[0];
  EXPECT_STREQ(reinterpret_cast<const char*>(to_state(output, {}).program), "");
  output.program = FixedText<96>("part.nc");
  EXPECT_STREQ(reinterpret_cast<const char*>(to_state(output, {}).program), "part.nc");
}

TEST(Decode, RefusesBytesThatAreNotExactlyOneMessage) {
  const setpoint_t message = to_setpoint(output_of(0).channels[0], {});
  const auto size = static_cast<std::size_t>(message.getEncodedSize());
  Bytes bytes(size + 1);
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  const std::span<const std::uint8_t> all(bytes);
  EXPECT_TRUE(decode<setpoint_t>(all.first(size)));
  EXPECT_FALSE(decode<setpoint_t>(all));
  EXPECT_FALSE(decode<setpoint_t>(all.first(size - 1)));
  EXPECT_FALSE(decode<setpoint_t>({}));
}

TEST(MessageStream, WritesTheSameBytesTwice) {
  const auto first = test_file("1.lcm");
  const auto second = test_file("2.lcm");
  record(first, 300);
  record(second, 300);
  EXPECT_FALSE(bytes_of(first).empty());
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(ChannelNames, KeepWithinTheLimitOfLcm) {
  const ChannelNames names(std::string(200, 'm'));
  for (int channel = 0; channel <= channels::channels_max; ++channel) {
    for (const Topic topic : enum_values<Topic>()) {
      EXPECT_LE(names.name(channel, topic).size(), 63U);
    }
  }
  EXPECT_EQ(ChannelNames("e-7 x").name(2, Topic::setpoint), "STANOK_E_7_X_CH2_SETPOINT");
}

TEST(LogWriterOnAFullDisk, TellsOfAFullDiskAndGoesOnWithoutIt) {
  auto writer = LogWriter::open("/dev/full");
  ASSERT_TRUE(writer);
  MessageStream stream(small_machine(), {writer->get()});
  for (int cycle = 0; cycle < 5000; ++cycle) stream.cycle(output_of(cycle));
  EXPECT_FALSE((*writer)->flush());
  ASSERT_TRUE((*writer)->status().error);
  EXPECT_EQ((*writer)->status().error->system_error, ENOSPC);
}

std::int64_t messages_on(const std::filesystem::path& file, const std::string& channel) {
  const auto contents = read_contents(file);
  if (!contents || !contents->channels.contains(channel)) return 0;
  return contents->channels.at(channel).messages;
}

TEST(MessageStream, SendsAWorkpieceWhenItIsAnnouncedAndEveryMinuteFromThenOn) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    LogDescription slow_machine = small_machine();
    slow_machine.cycle_us = 20'000;
    MessageStream stream(slow_machine, {writer->get()});
    const int minute = 60 * 50;
    for (int cycle = 0; cycle <= 10 + 2 * minute; ++cycle) {
      channels::CycleOutput output = output_of(cycle);
      output.channels[0].workpiece.announcements = cycle < 5 ? 0U : cycle < 10 ? 1U : 3U;
      stream.cycle(output);
    }
    ASSERT_TRUE((*writer)->flush());
  }
  EXPECT_EQ(messages_on(file, "STANOK_MILL_CH1_WORKPIECE"), 4);
}

channels::ToolRow end_mill(double radius) {
  channels::ToolRow row;
  row.number = 3;
  row.kind = FixedText<16>("flat");
  row.length = 80.0;
  row.radius = radius;
  row.wear_radius = -0.02;
  row.orientation = 0;
  row.holder_length = 45.0;
  row.point_angle = 118.0;
  return row;
}

// When it comes, when a value changes, when it comes again, and each minute.
TEST(MessageStream, SendsTheRowOfTheToolWhenItChangesAndEveryMinuteFromThenOn) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    LogDescription slow_machine = small_machine();
    slow_machine.cycle_us = 20'000;
    MessageStream stream(slow_machine, {writer->get()});
    const int minute = 60 * 50;
    for (int cycle = 0; cycle <= 20 + minute; ++cycle) {
      channels::CycleOutput output = output_of(cycle);
      const bool is_there = cycle >= 5 && (cycle < 15 || cycle >= 20);
      if (is_there) output.channels[0].tool_row = end_mill(cycle < 10 ? 3.0 : 2.5);
      stream.cycle(output);
    }
    ASSERT_TRUE((*writer)->flush());
  }
  EXPECT_EQ(messages_on(file, "STANOK_MILL_CH1_TOOL_ROW"), 4);
}

// Whoever is asked is told which output is meant.
TEST(MessageStream, SendsTheSituationWhenItChangesAndEverySecond) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    LogDescription slow_machine = small_machine();
    slow_machine.cycle_us = 20'000;
    MessageStream stream(slow_machine, {writer->get()});
    stream.cycle(output_of(0));  // nobody to ask: none
    stream.ask_for_situations([](const channels::ChannelOutput& output) {
      return channels::SituationReport{.number = output.tag.situation, .meaning = {}};
    });
    const int second = 50;
    for (int cycle = 1; cycle <= 10 + 2 * second; ++cycle) {
      channels::CycleOutput output = output_of(cycle);
      output.channels[0].tag.situation = cycle < 5 ? 7U : cycle < 10 ? 8U : 9U;
      stream.cycle(output);
    }
    ASSERT_TRUE((*writer)->flush());
  }
  EXPECT_EQ(messages_on(file, "STANOK_MILL_CH1_SITUATION"), 5);
}

TEST(Encode, GivesTheRowOfAToolBackToTheBit) {
  const tool_row_t message =
      to_tool_row(2, end_mill(0.1 + 0.2), {.utime = 5, .cycle = 4, .seq = 3});
  EXPECT_EQ(message.channel, 2);
  EXPECT_EQ(message.cycle, 4);
  EXPECT_EQ(from_tool_row(message), end_mill(0.1 + 0.2));
}

TEST(Decode, TakesNoRowThatNoTableCanHave) {
  const tool_row_t sound = to_tool_row(1, end_mill(3.0), {});
  const auto is_taken = [&](const auto& change) {
    tool_row_t message = sound;
    change(message);
    return from_tool_row(message).has_value();
  };
  EXPECT_TRUE(is_taken([](tool_row_t& /*message*/) {}));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.number = 0; }));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.edge = -1; }));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.orientation = 10; }));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.radius = -1.0; }));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.flute_length = 1e300; }));
  EXPECT_FALSE(is_taken([](tool_row_t& message) { message.length = std::nan(""); }));
}

// LOG_META keeps the types that it was released with; its successor beside it has them all.
TEST(LogTypes, HasEveryTypeThatThereIs) {
  const log_types_t message = to_log_types({.utime = 5, .cycle = 4, .seq = 3});
  std::vector<std::string> names;
  for (int k = 0; k < message.type_count; ++k) {
    names.emplace_back(text_of(message.type_name[k]));
    EXPECT_NE(message.type_fingerprint[k], 0) << names.back();
  }
  std::vector<std::string> defined;
  for (const auto& entry :
       std::filesystem::directory_iterator(stanok::testing::source_folder() + "/messages"))
    if (entry.path().extension() == ".lcm") defined.push_back(entry.path().stem());
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(defined));

  const log_meta_t meta = to_log_meta(small_machine(), {});
  EXPECT_EQ(meta.type_count, 16);
  EXPECT_EQ(text_of(meta.type_name[0]), "setpoint_t");
  EXPECT_EQ(text_of(meta.type_name[15]), "log_check_t");
}

TEST(LogTypes, ComeWithLogMeta) {
  const auto file = test_file("lcm");
  record(file, 10);
  auto reader = LogReader::open(file);
  ASSERT_TRUE(reader);
  std::vector<std::string> channels;
  while (const auto event = reader->next()) {
    if (topic_of(event->channel) != name_of(Topic::log_check))
      channels.emplace_back(event->channel);
  }
  ASSERT_GE(channels.size(), 2U);
  EXPECT_EQ(channels[0], "STANOK_MILL_LOG_META");
  EXPECT_EQ(channels[1], "STANOK_MILL_LOG_TYPES");
}

TEST(Encode, TellsWhatTheDrivesReported) {
  channels::ChannelOutput output = output_of(1).channels[0];
  output.drives[1].follows_velocity = true;
  output.feedback[0] = {.position = 12.0,
                        .setpoint = 12.5,
                        .velocity = -3.0,
                        .valid = true,
                        .fault = false,
                        .enabled = false,
                        .referenced = true,
                        .brake_closed = true};
  output.feedback[1] = {.position = 0.0,
                        .setpoint = 0.0,
                        .velocity = 0.0,
                        .valid = true,
                        .fault = true,
                        .enabled = true,
                        .referenced = false,
                        .brake_closed = false};
  const drive_status_t message = to_drive_status(output, {.utime = 1000, .cycle = 1, .seq = 0});
  EXPECT_EQ(message.channel, output.id);
  EXPECT_EQ(message.position[0], 12.0);
  EXPECT_EQ(message.velocity[0], -3.0);
  EXPECT_EQ(message.following_error[0], 0.5);
  EXPECT_EQ(message.valid & 3, 3);
  EXPECT_EQ(message.fault & 3, 2);
  EXPECT_EQ(message.enabled & 3, 2);
  EXPECT_EQ(message.referenced & 3, 1);
  EXPECT_EQ(message.brake_closed & 3, 1);
  EXPECT_EQ(message.follows_velocity & 3, 2);
}

TEST(MessageStream, SendsDrivesTwentyTimesASecondWhereThereAreSome) {
  const auto file = test_file("lcm");
  {
    auto writer = LogWriter::open(file);
    ASSERT_TRUE(writer);
    LogDescription machine = small_machine();
    machine.cycle_us = 1000;
    MessageStream stream(machine, {writer->get()});
    for (int cycle = 1; cycle <= 200; ++cycle) {
      channels::CycleOutput output = output_of(cycle);
      output.channels[0].has_feedback = cycle > 100;
      stream.cycle(output);
    }
    ASSERT_TRUE((*writer)->flush());
  }
  EXPECT_EQ(messages_on(file, "STANOK_MILL_CH1_DRIVE"), 2);  // in cycles 150 and 200
}

TEST(Encode, TellsTheCuttingProcess) {
  channels::ChannelOutput output = output_of(1).channels[0];
  output.process = {.law = motion::LawKind::interrupted,
                    .increments = 7,
                    .stands = true,
                    .feed_mm_per_min = 120.0,
                    .feed_mm_per_rev = 0.2,
                    .spindle_rev_per_min = -600.0,
                    .cutting_speed_m_per_min = 94.2,
                    .force = {}};
  const process_status_t message = to_process_status(output, {.utime = 1000, .cycle = 1, .seq = 0});
  EXPECT_EQ(message.channel, output.id);
  EXPECT_EQ(message.law, 3);
  EXPECT_EQ(message.stands, 1);
  EXPECT_EQ(message.increments, 7);
  EXPECT_EQ(message.feed, 120.0);
  EXPECT_EQ(message.feed_per_rev, 0.2);
  EXPECT_EQ(message.spindle_speed, -600.0);
  EXPECT_EQ(message.cutting_speed, 94.2);
}

TEST(Encode, WritesTheWorkpieceAsItIsKnown) {
  channels::ChannelOutput output = output_of(7).channels[0];
  output.workpiece.has_position = true;
  output.workpiece.position = {{1.0, 2.0, 3.0}, {10.0, 20.0, 30.0}};
  EXPECT_EQ(to_workpiece(output, {}).known, 2);
  EXPECT_EQ(to_workpiece(output, {}).position[2], 3.0);
  EXPECT_EQ(to_workpiece(output, {}).angles[0], 10.0);
  output.workpiece.has_shape = true;
  output.workpiece.shape = {1, 1, 0.5, {80.0, 20.0, 60.0}, {0.0, 0.0, 30.0}};
  const workpiece_t message = to_workpiece(output, {});
  EXPECT_EQ(message.known, 3);
  EXPECT_EQ(message.shape, 1);
  EXPECT_EQ(message.machining, 1);
  EXPECT_EQ(message.size[1], 20.0);
  EXPECT_EQ(message.zero[2], 30.0);
  EXPECT_EQ(message.screen_resolution, 0.5);
}

void keep_position(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/,
                   const setpoint_t* setpoint, std::vector<double>* positions) {
  positions->push_back(setpoint->position[0]);
}

TEST(LcmPublisher, ReachesASubscriberOnTheBus) {
  LcmPublisher publisher("memq://");
  ASSERT_TRUE(publisher.good());
  std::vector<double> positions;
  publisher.bus()->subscribeFunction(setpoint_channel, &keep_position, &positions);
  MessageStream stream(small_machine(), {&publisher});
  for (int cycle = 0; cycle < 3; ++cycle) stream.cycle(output_of(cycle));
  while (publisher.bus()->handleTimeout(0) > 0) {
  }
  EXPECT_EQ(positions, (std::vector<double>{0.0, 0.01 * 1.0, 0.01 * 2.0}));
}

TEST(LogExport, WritesOneRowForEveryCycle) {
  const auto file = test_file("lcm");
  record(file, 120);
  const auto contents = read_contents(file);
  ASSERT_TRUE(contents);
  const auto csv = test_file("csv");
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(csv.c_str(), "w"),
                                                         &std::fclose);
  ASSERT_NE(stream, nullptr);
  const auto rows = export_setpoints(file, *contents, 1, stream.get());
  stream.reset();
  ASSERT_TRUE(rows);
  EXPECT_EQ(*rows, 120);
  std::ifstream lines(csv);
  std::string heading;
  std::string first;
  std::getline(lines, heading);
  std::getline(lines, first);
  EXPECT_NE(heading.find("X1_mm,X1_velocity_mm_per_s"), std::string::npos);
  EXPECT_NE(heading.find("tip_C_deg"), std::string::npos);
  EXPECT_NE(first.find(",33.3,"), std::string::npos);
  EXPECT_EQ(std::count(heading.begin(), heading.end(), ','),
            std::count(first.begin(), first.end(), ','));
}

}  // namespace
}  // namespace stanok::recording
