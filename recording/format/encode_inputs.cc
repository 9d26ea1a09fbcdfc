#include "recording/format/encode_inputs.h"

#include <cstring>

#include "recording/format/log_description.h"

namespace stanok::recording {
namespace {

enum Bit : unsigned {
  valid = 1,
  fault = 2,
  enabled = 4,
  referenced = 8,
  brake_closed = 16,
  home_switch = 32,
  limit_negative = 64,
  limit_positive = 128,
  strays = 256
};

template <class Message>
Message stamped(const Stamp& stamp) {
  Message message;
  std::memset(&message, 0, sizeof message);
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
  return message;
}

}  // namespace

arrival_t to_arrival(int channel, const channels::Arrivals& arrivals, const Stamp& stamp) {
  auto message = stamped<arrival_t>(stamp);
  message.channel = channel;
  message.resets = static_cast<std::int64_t>(arrivals.resets);
  message.chunks = static_cast<std::int64_t>(arrivals.chunks);
  message.items = static_cast<std::int64_t>(arrivals.items);
  message.riders = static_cast<std::int64_t>(arrivals.riders);
  message.remarks = static_cast<std::int64_t>(arrivals.remarks);
  return message;
}

feedback_t to_feedback(int channel, int axis, const channels::AxisFeedback& feedback,
                       const Stamp& stamp) {
  auto message = stamped<feedback_t>(stamp);
  const auto bit = [](bool on, Bit one) { return on ? static_cast<unsigned>(one) : 0U; };
  message.channel = channel;
  message.axis = axis;
  message.flags = static_cast<std::int32_t>(
      bit(feedback.valid, valid) | bit(feedback.fault, fault) | bit(feedback.enabled, enabled) |
      bit(feedback.referenced, referenced) | bit(feedback.brake_closed, brake_closed) |
      bit(feedback.home_switch, home_switch) | bit(feedback.limit_negative, limit_negative) |
      bit(feedback.limit_positive, limit_positive) | bit(feedback.strays, strays));
  message.index_count = feedback.index_count;
  message.position = feedback.position;
  message.setpoint = feedback.setpoint;
  message.velocity = feedback.velocity;
  message.position_offset = feedback.position_offset;
  message.index_position = feedback.index_position;
  return message;
}

program_read_t to_program_read(const ProgramRead& read, const Stamp& stamp) {
  auto message = stamped<program_read_t>(stamp);
  message.hash = static_cast<std::int64_t>(text_hash(read.text));
  message.found = read.found ? 1 : 0;
  put_text(read.name, message.name);
  put_text(read.from, message.from);
  put_text(read.path, message.path);
  return message;
}

channels::Arrivals from_arrival(const arrival_t& message) {
  return {.resets = static_cast<std::uint64_t>(message.resets),
          .chunks = static_cast<std::uint64_t>(message.chunks),
          .items = static_cast<std::uint64_t>(message.items),
          .riders = static_cast<std::uint64_t>(message.riders),
          .remarks = static_cast<std::uint64_t>(message.remarks)};
}

channels::AxisFeedback from_feedback(const feedback_t& message) {
  const auto has = [&](Bit bit) {
    return (static_cast<std::uint32_t>(message.flags) & static_cast<unsigned>(bit)) != 0;
  };
  return {.position = message.position,
          .setpoint = message.setpoint,
          .velocity = message.velocity,
          .valid = has(valid),
          .fault = has(fault),
          .enabled = has(enabled),
          .referenced = has(referenced),
          .brake_closed = has(brake_closed),
          .home_switch = has(home_switch),
          .limit_negative = has(limit_negative),
          .limit_positive = has(limit_positive),
          .strays = has(strays),
          .position_offset = message.position_offset,
          .index_position = message.index_position,
          .index_count = static_cast<std::uint32_t>(message.index_count)};
}

}  // namespace stanok::recording
