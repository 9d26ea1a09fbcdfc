#include "recording/log/rest_filter.h"

#include <algorithm>
#include <ranges>
#include <stanok_messages/log_meta_t.hpp>
#include <stanok_messages/log_rest_t.hpp>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"

namespace stanok::recording {
namespace {

constexpr std::int64_t record_period_us = 5'000'000;
constexpr std::size_t held_bytes_max = 1UL << 20;  // texts of programs may come in one cycle

}  // namespace

void RestFilter::send(const std::string& channel, std::int64_t utime,
                      std::span<const std::uint8_t> bytes) {
  if (held_count_ > 0 && cycle_of(bytes) != cycle_of(held_.front().bytes)) end_cycle();
  if (topic_of(channel) == name_of(Topic::log_meta)) {
    if (const auto meta = decode<log_meta_t>(bytes)) cycle_us_ = meta->cycle_us;
    record_channel_ = channel.substr(0, channel.size() - name_of(Topic::log_meta).size()) +
                      std::string(name_of(Topic::log_rest));
  }
  if (held_count_ == held_.size()) held_.emplace_back();
  Held& held = held_[held_count_++];
  held.channel = channel;
  held.utime = utime;
  held.bytes.assign(bytes.begin(), bytes.end());
  held_bytes_ += bytes.size();
  if (held_bytes_ > held_bytes_max) write_held();
}

void RestFilter::finish() {
  end_cycle();
  end_stretch();
}

void RestFilter::end_cycle() {
  if (held_count_ == 0) return;
  if (pieces_ != log_.status().pieces) {  // each stands alone
    end_stretch();
    pattern_.clear();
    latest_.clear();
    stretch_.continues = false;
    pieces_ = log_.status().pieces;
  }
  if (is_next_cycle() && find_repeats()) {
    extend();
  } else {
    write_held();
  }
  held_count_ = 0;
  held_bytes_ = 0;
}

// The time of a stretch is that of its cycles.
bool RestFilter::is_next_cycle() const {
  if (cycle_us_ <= 0 || record_channel_.empty()) return false;
  const std::int64_t cycle = cycle_of(held_.front().bytes);
  const std::int64_t next = stretch_.first.cycle + stretch_.cycles;
  const bool has_begun = stretch_.cycles > 0 || stretch_.continues;
  return !has_begun || (cycle == next &&
                        held_.front().utime == stretch_.first.utime + stretch_.cycles * cycle_us_);
}

bool RestFilter::is_repeat(const Held& message, const LatestMessage& latest) const {
  if (message.bytes.size() != latest.bytes.size()) return false;
  const MessageStamp now = stamp_of(message.bytes);
  const MessageStamp before = stamp_of(latest.bytes);
  const std::int64_t cycles = now.cycle - before.cycle;
  const auto body = static_cast<std::ptrdiff_t>(stamp_end);
  return cycles > 0 && now.seq > before.seq && now.utime == before.utime + cycles * cycle_us_ &&
         now.utime == held_.front().utime && now.utime == message.utime &&
         std::equal(message.bytes.begin(), message.bytes.begin() + 8, latest.bytes.begin()) &&
         std::equal(message.bytes.begin() + body, message.bytes.end(), latest.bytes.begin() + body);
}

// Whether the cycle has all messages that are due, in their order, and otherwise only such as join
// the pattern.
bool RestFilter::find_repeats() {
  joining_.clear();
  const std::int64_t cycle = cycle_of(held_.front().bytes);
  const std::vector<std::size_t>& due = pattern_.due(cycle);
  std::size_t next = 0;
  for (const Held& message : held()) {
    if (message.bytes.size() < stamp_end) return false;
    const std::int32_t part = part_of(message.channel, message.bytes);
    LatestMessage* const latest = latest_.find(message.channel, part);
    if (latest == nullptr || !is_repeat(message, *latest)) return false;
    const MessageStamp now = stamp_of(message.bytes);
    if (next < due.size() && pattern_.streams()[due[next]].latest == latest) {
      if (pattern_.streams()[due[next]].seq != now.seq) return false;
      ++next;
      continue;
    }
    if (latest->is_in_pattern) return false;
    const MessageStamp before = stamp_of(latest->bytes);
    const std::size_t place = next < due.size() ? due[next] : pattern_.streams().size();
    joining_.push_back({place, RestStream{.channel = message.channel,
                                          .part = part,
                                          .latest = latest,
                                          .due = cycle,
                                          .step = cycle - before.cycle,
                                          .seq = now.seq,
                                          .seq_step = now.seq - before.seq}});
  }
  return next == due.size();
}

void RestFilter::extend() {
  const std::int64_t cycle = cycle_of(held_.front().bytes);
  if (stretch_.cycles == 0) {
    stretch_.first = {.utime = held_.front().utime, .cycle = cycle, .seq = 0};
    stretch_.streams = pattern_.streams();
  }
  for (const Joining& joining : std::views::reverse(joining_)) {
    joining.stream.latest->is_in_pattern = true;
    stretch_.streams.insert(stretch_.streams.begin() + static_cast<std::ptrdiff_t>(joining.place),
                            joining.stream);
    pattern_.insert(joining.place, joining.stream);
    stretch_.continues = false;
  }
  for (const std::size_t place : std::vector<std::size_t>(pattern_.due(cycle))) {
    const RestStream& stream = pattern_.streams()[place];
    put_stamp({.utime = held_.front().utime, .cycle = cycle, .seq = stream.seq},
              stream.latest->bytes);
    pattern_.pass(place);
  }
  ++stretch_.cycles;
  if (stretch_.cycles * cycle_us_ < record_period_us) return;
  end_stretch();
  stretch_.continues = log_.status().pieces == pieces_;
}

void RestFilter::end_stretch() {
  if (stretch_.cycles == 0) return;
  write_record();
  stretch_.first.cycle += stretch_.cycles;
  stretch_.first.utime += stretch_.cycles * cycle_us_;
  stretch_.cycles = 0;
  stretch_.continues = false;
}

void RestFilter::write_record() {
  const std::int64_t last = stretch_.first.cycle + stretch_.cycles - 1;
  log_rest_t record{};
  record.utime = stretch_.first.utime + (stretch_.cycles - 1) * cycle_us_;
  record.cycle = last;
  record.seq = records_++;
  record.first_cycle = stretch_.first.cycle;
  record.first_utime = stretch_.first.utime;
  record.cycle_us = cycle_us_;
  record.continues = stretch_.continues ? 1 : 0;
  if (!stretch_.continues) {
    for (const RestStream& stream : stretch_.streams) {
      record.stream_name.push_back(stream.channel);
      record.stream_part.push_back(stream.part);
      record.stream_cycle.push_back(stream.due);
      record.stream_step.push_back(stream.step);
      record.stream_seq.push_back(stream.seq);
      record.stream_seq_step.push_back(stream.seq_step);
      record.stream_sum.push_back(sum_of(stream.latest->bytes));
    }
  }
  record.stream_count = static_cast<std::int32_t>(record.stream_name.size());
  std::vector<std::uint8_t> bytes(checked_size(record.getEncodedSize()));
  record.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  log_.send(record_channel_, record.utime, bytes);
}

void RestFilter::write_held() {
  end_stretch();
  pattern_.clear();
  latest_.leave_pattern();
  stretch_.continues = false;
  for (const Held& message : held()) {
    log_.send(message.channel, message.utime, message.bytes);
    if (message.bytes.size() >= stamp_end) latest_.keep(message.channel, message.bytes);
  }
  held_count_ = 0;
  held_bytes_ = 0;
}

}  // namespace stanok::recording
