// MessageSender: messages of one machine on their way to all sinks: stamped, numbered by channel
// and topic, encoded once.
//
// Time stamps are cycle x cycle time, so that equal runs give equal bytes. Owned by the stream of
// messages, on its thread; never for the real-time cycle. Invariant: the numbers of a channel and
// topic are 0, 1, 2, ... in the order in which stamps were asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "recording/format/channel_names.h"
#include "recording/format/encode_inputs.h"
#include "recording/format/log_description.h"
#include "recording/stream/message_sink.h"

namespace stanok::recording {

class MessageSender {
 public:
  // `bytes_max`: of the largest message. The sinks outlive it.
  MessageSender(const LogDescription& description, std::vector<MessageSink*> sinks, int bytes_max);

  // Of the next message of this channel and topic.
  [[nodiscard]] Stamp next_stamp(std::int64_t cycle, int channel, Topic topic);

  template <class Message>
  void send(const Message& message, int channel, Topic topic) {
    const int size = message.encode(buffer_.data(), 0, static_cast<int>(buffer_.size()));
    STANOK_ASSERT(size > 0);
    const std::span<const std::uint8_t> bytes(buffer_.begin(), buffer_.begin() + size);
    for (MessageSink* sink : sinks_) sink->send(names_.name(channel, topic), message.utime, bytes);
  }

 private:
  std::int64_t utime_start_;
  int cycle_us_;
  ChannelNames names_;
  std::vector<MessageSink*> sinks_;
  std::vector<std::uint8_t> buffer_;
  PerChannel<EnumArray<Topic, std::int64_t>> next_seq_{};
};

}  // namespace stanok::recording
