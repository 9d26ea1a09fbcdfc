// A small log for tests: one machine with one channel of two axes, a known motion, and its bytes.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "recording/log/log_writer.h"
#include "recording/stream/message_stream.h"

namespace stanok::recording {

using Bytes = std::vector<std::uint8_t>;

inline std::filesystem::path test_file(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(::testing::TempDir()) /
         (std::string(test->test_suite_name()) + "." + test->name() + "." + name);
}

// The LCM channel of the setpoints of small_machine().
inline constexpr const char* setpoint_channel = "STANOK_MILL_CH1_SETPOINT";

inline LogDescription small_machine() {
  LogDescription description;
  description.machine = "mill";
  description.version = "1.2.3";
  description.build = "a compiler";
  description.libm = this_libm();
  description.cycle_us = 1000;
  description.channels.push_back({1, {{"X1", "X", false}, {"C1", "C", true}}});
  return description;
}

// X moves at 10 mm/s from 0 along a line; C stands at 33.3.
inline channels::CycleOutput output_of(std::int64_t cycle) {
  channels::CycleOutput output;
  output.cycle = cycle;
  output.channel_count = 1;
  channels::ChannelOutput& channel = output.channels[0];
  channel.id = 1;
  channel.axis_count = 2;
  channel.running = true;
  channel.run = 1;
  channel.scheme = 1;
  channel.feed_commanded = 10.0;
  channel.path_speed = 10.0;
  channel.point_W[0] = {0.01 * static_cast<double>(cycle), 10.0, 0.0, 0.0};
  channel.axes[0].position = 0.01 * static_cast<double>(cycle);
  channel.axes[0].velocity = 10.0;
  channel.axes[1].position = 33.3;
  return output;
}

inline void record(const std::filesystem::path& file, int cycles) {
  auto writer = LogWriter::open(file);
  ASSERT_TRUE(writer);
  MessageStream stream(small_machine(), {writer->get()});
  for (int cycle = 0; cycle < cycles; ++cycle) stream.cycle(output_of(cycle));
  ASSERT_TRUE((*writer)->flush());
}

inline Bytes bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(stream), {});
}

inline void write_bytes(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

}  // namespace stanok::recording
