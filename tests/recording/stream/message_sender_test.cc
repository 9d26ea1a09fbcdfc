// MessageSender: numbers and stamps of messages, and that every sink gets each of them.
#include "recording/stream/message_sender.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/format/decode.h"
#include "recording/format/encode.h"

namespace stanok::recording {
namespace {

struct KeptMessages final : MessageSink {
  void send(const std::string& channel, std::int64_t utime,
            std::span<const std::uint8_t> bytes) override {
    channels.push_back(channel);
    utimes.push_back(utime);
    all.emplace_back(bytes.begin(), bytes.end());
  }
  std::vector<std::string> channels;
  std::vector<std::int64_t> utimes;
  std::vector<std::vector<std::uint8_t>> all;
};

LogDescription of_mill() {
  LogDescription description;
  description.machine = "mill";
  description.cycle_us = 250;
  description.utime_start = 1000;
  return description;
}

TEST(MessageSender, EachChannelAndTopicCountsByItself) {
  MessageSender sender(of_mill(), {}, 64);
  EXPECT_EQ(sender.next_stamp(4, 1, Topic::setpoint).utime, 1000 + 4 * 250);
  EXPECT_EQ(sender.next_stamp(5, 1, Topic::setpoint).seq, 1);
  EXPECT_EQ(sender.next_stamp(5, 2, Topic::setpoint).seq, 0);
  EXPECT_EQ(sender.next_stamp(5, 1, Topic::state).seq, 0);
  EXPECT_EQ(sender.next_stamp(6, 1, Topic::setpoint).seq, 2);
}

TEST(MessageSender, EverySinkGetsTheSameBytes) {
  KeptMessages first;
  KeptMessages second;
  const log_types_t types = to_log_types({.utime = 7, .cycle = 2, .seq = 0});
  MessageSender sender(of_mill(), {&first, &second}, types.getEncodedSize());
  sender.send(types, 0, Topic::log_types);
  ASSERT_EQ(first.all.size(), 1U);
  EXPECT_EQ(first.all, second.all);
  EXPECT_EQ(first.utimes.front(), 7);
  EXPECT_EQ(first.channels.front(), ChannelNames("mill").name(0, Topic::log_types));
  const auto decoded = decode<log_types_t>(first.all.front());
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->cycle, 2);
}

}  // namespace
}  // namespace stanok::recording
