#include "recording/log/rest_expansion.h"

#include <algorithm>
#include <stanok_messages/log_rest_t.hpp>
#include <utility>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"

namespace stanok::recording {
namespace {

// Records are written every 5 s; logs may come from anywhere.
constexpr std::int64_t cycles_max = 1'000'000;

// Nothing: the log has another message before it.
std::optional<RestStream> stream_of(const log_rest_t& record, std::size_t k,
                                    LatestMessages& latest) {
  RestStream stream{.channel = record.stream_name[k],
                    .part = record.stream_part[k],
                    .latest = nullptr,
                    .due = record.stream_cycle[k],
                    .step = record.stream_step[k],
                    .seq = record.stream_seq[k],
                    .seq_step = record.stream_seq_step[k]};
  stream.latest = latest.find(stream.channel, stream.part);
  if (stream.latest == nullptr || stream.latest->bytes.size() < stamp_end) return std::nullopt;
  const bool follows = stamp_of(stream.latest->bytes).seq == stream.seq - stream.seq_step &&
                       sum_of(stream.latest->bytes) == record.stream_sum[k];
  const bool is_possible = stream.step > 0 && stream.step < cycles_max * cycles_max &&
                           stream.seq_step > 0 && stream.due >= record.first_cycle;
  return follows && is_possible ? std::optional(std::move(stream)) : std::nullopt;
}

}  // namespace

void RestExpansion::take(std::string_view channel, std::span<const std::uint8_t> bytes) {
  const std::string_view topic = topic_of(channel);
  if (topic == name_of(Topic::log_check)) return;
  if (topic == name_of(Topic::log_rest)) return begin(bytes);
  may_continue_ = false;
  if (bytes.size() >= stamp_end) latest_.keep(channel, bytes);
}

void RestExpansion::begin(std::span<const std::uint8_t> bytes) {
  const auto record = decode<log_rest_t>(bytes);
  const bool was_whole = std::exchange(may_continue_, false);
  if (!record || record->first_cycle < 0 || record->cycle < record->first_cycle ||
      record->cycle - record->first_cycle >= cycles_max || record->cycle_us <= 0)
    return;
  if (record->continues != 0) {
    if (!was_whole || record->first_cycle != last_cycle_ + 1) return;
  } else {
    pattern_.clear();
    for (std::size_t k = 0; k < record->stream_name.size(); ++k) {
      auto stream = stream_of(*record, k, latest_);
      if (stream) pattern_.insert(pattern_.streams().size(), *std::move(stream));
    }
  }
  cycle_ = record->first_cycle;
  last_cycle_ = record->cycle;
  utime_ = record->first_utime;
  cycle_us_ = record->cycle_us;
  due_ = pattern_.due(cycle_);
  next_due_ = 0;
  may_continue_ = true;
}

std::optional<RestExpansion::Repeated> RestExpansion::next() {
  while (cycle_ <= last_cycle_) {
    if (next_due_ < due_.size()) {
      const std::size_t place = due_[next_due_++];
      const RestStream& stream = pattern_.streams()[place];
      put_stamp({.utime = utime_, .cycle = cycle_, .seq = stream.seq}, stream.latest->bytes);
      pattern_.pass(place);
      return Repeated{utime_, stream.channel, stream.latest->bytes};
    }
    ++cycle_;
    utime_ += cycle_us_;
    due_ = pattern_.due(cycle_);
    next_due_ = 0;
  }
  return std::nullopt;
}

}  // namespace stanok::recording
