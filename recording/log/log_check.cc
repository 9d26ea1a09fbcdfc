#include "recording/log/log_check.h"

#include <zlib.h>

#include <stanok_messages/log_check_t.hpp>

#include "recording/format/channel_names.h"
#include "recording/format/decode.h"

namespace stanok::recording {
namespace {

// Returns where the next number goes.
std::uint8_t* put_big_endian(std::uint64_t value, std::size_t count, std::uint8_t* place) {
  for (std::size_t k = count; k > 0; --k)
    *place++ = static_cast<std::uint8_t>(value >> (8 * (k - 1)));
  return place;
}

// Adds without overflow, also the numbers of a forged log.
std::int64_t sum_of_any(std::int64_t one, std::int64_t other) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(one) +
                                   static_cast<std::uint64_t>(other));
}

}  // namespace

std::uint32_t check_sum(std::uint32_t of_parts_before, std::span<const std::uint8_t> part) {
  return static_cast<std::uint32_t>(::crc32_z(of_parts_before, part.data(), part.size()));
}

std::array<std::uint8_t, event_header_bytes> event_header(std::int64_t number, std::int64_t utime,
                                                          std::size_t channel_bytes,
                                                          std::size_t data_bytes) {
  std::array<std::uint8_t, event_header_bytes> bytes{};
  std::uint8_t* place = put_big_endian(event_sync_word, sizeof event_sync_word, bytes.data());
  place = put_big_endian(static_cast<std::uint64_t>(number), sizeof number, place);
  place = put_big_endian(static_cast<std::uint64_t>(utime), sizeof utime, place);
  place = put_big_endian(channel_bytes, sizeof(std::int32_t), place);
  put_big_endian(data_bytes, sizeof(std::int32_t), place);
  return bytes;
}

void CheckReading::take(const LogEvent& event) {
  const bool is_check = topic_of(event.channel) == name_of(Topic::log_check);
  if (is_check && event.whole.size() > check_sum_bytes) {
    sum_ = check_sum(sum_, event.whole.first(event.whole.size() - check_sum_bytes));
    compare(event);
  } else {
    sum_ = check_sum(sum_, event.whole);
    coverage_.end = LogEnd::goes_on;
  }
}

void CheckReading::compare(const LogEvent& event) {
  const auto check = decode<log_check_t>(event.bytes);
  const std::int64_t end = event.offset + static_cast<std::int64_t>(event.whole.size());
  const std::int64_t size = end - begin_ - static_cast<std::int64_t>(check_sum_bytes);
  const bool follows =
      check && (!next_ || (check->begin == next_->begin && check->seq == next_->seq));
  const bool is_as_written =
      follows && check->size == size && static_cast<std::uint32_t>(check->crc) == sum_;
  coverage_.has_checks = true;
  coverage_.end = is_as_written ? static_cast<LogEnd>(check->end) : LogEnd::goes_on;
  if (!is_as_written) coverage_.faults.push_back({DamageKind::altered, begin_, end - begin_});
  if (coverage_.faults.empty()) coverage_.sound_bytes = end;
  next_.reset();
  if (is_as_written) next_ = {sum_of_any(check->begin, end - begin_), sum_of_any(check->seq, 1)};
  begin_ = end;
  sum_ = 0;
}

LogCoverage CheckReading::coverage(std::int64_t bytes_of_file) const {
  LogCoverage coverage = coverage_;
  coverage.bytes_behind = bytes_of_file - begin_;
  if (coverage.bytes_behind > 0) coverage.end = LogEnd::goes_on;
  return coverage;
}

}  // namespace stanok::recording
