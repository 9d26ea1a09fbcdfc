#include "recording/log/rest_pattern.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/place.h"
#include "recording/format/channel_names.h"
#include "recording/log/big_endian.h"

namespace stanok::recording {
namespace {

constexpr std::size_t utime_at = 8;
constexpr std::size_t cycle_at = 16;
constexpr std::size_t seq_at = 24;
constexpr std::size_t path_first_at = stamp_end + 12;  // behind channel, preview and total

std::int64_t number_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::int64_t>(big_endian(bytes.subspan(offset, 8)));
}

void put_number(std::int64_t value, std::size_t offset, std::span<std::uint8_t> bytes) {
  auto rest = static_cast<std::uint64_t>(value);
  for (std::size_t k = 8; k-- > 0; rest >>= 8U)
    bytes[offset + k] = static_cast<std::uint8_t>(rest & 0xFFU);
}

}  // namespace

MessageStamp stamp_of(std::span<const std::uint8_t> bytes) {
  return {.utime = number_at(bytes, utime_at),
          .cycle = number_at(bytes, cycle_at),
          .seq = number_at(bytes, seq_at)};
}

void put_stamp(const MessageStamp& stamp, std::span<std::uint8_t> bytes) {
  put_number(stamp.utime, utime_at, bytes);
  put_number(stamp.cycle, cycle_at, bytes);
  put_number(stamp.seq, seq_at, bytes);
}

std::int64_t sum_of(std::span<const std::uint8_t> bytes) {
  constexpr std::uint64_t basis = 14695981039346656037ULL;
  constexpr std::uint64_t prime = 1099511628211ULL;
  std::uint64_t sum = basis;
  const auto add = [&](std::span<const std::uint8_t> part) {
    for (const std::uint8_t byte : part) sum = (sum ^ byte) * prime;
  };
  add(bytes.first(utime_at));
  add(bytes.subspan(stamp_end));
  return static_cast<std::int64_t>(sum);
}

std::int32_t part_of(std::string_view channel, std::span<const std::uint8_t> bytes) {
  if (bytes.size() < path_first_at + 4 || topic_of(channel) != name_of(Topic::path)) return 0;
  return static_cast<std::int32_t>(big_endian(bytes.subspan(path_first_at, 4)));
}

LatestMessage* LatestMessages::find(std::string_view channel, std::int32_t part) {
  const auto parts = latest_.find(channel);
  if (parts == latest_.end()) return nullptr;
  const auto latest = parts->second.find(part);
  return latest == parts->second.end() ? nullptr : &latest->second;
}

LatestMessage& LatestMessages::keep(std::string_view channel, std::span<const std::uint8_t> bytes) {
  auto parts = latest_.find(channel);
  if (parts == latest_.end()) parts = latest_.try_emplace(std::string(channel)).first;
  LatestMessage& latest = parts->second[part_of(channel, bytes)];
  latest.bytes.assign(bytes.begin(), bytes.end());
  return latest;
}

void LatestMessages::leave_pattern() {
  for (auto& [channel, parts] : latest_) {
    for (auto& [part, latest] : parts) latest.is_in_pattern = false;
  }
}

void RestPattern::insert(std::size_t place, RestStream stream) {
  streams_.insert(streams_.begin() + static_cast<std::ptrdiff_t>(place), std::move(stream));
  is_sorted_out_ = false;
}

void RestPattern::clear() {
  streams_.clear();
  is_sorted_out_ = false;
}

void RestPattern::sort_out() {
  frequent_.clear();
  rare_due_ = std::numeric_limits<std::int64_t>::max();
  for (std::size_t k = 0; k < streams_.size(); ++k) {
    if (streams_[k].step == 1) frequent_.push_back(k);
    if (streams_[k].step != 1) rare_due_ = std::min(rare_due_, streams_[k].due);
  }
  is_sorted_out_ = true;
}

const std::vector<std::size_t>& RestPattern::due(std::int64_t cycle) {
  if (!is_sorted_out_) sort_out();
  due_.clear();
  if (cycle < rare_due_) {
    for (const std::size_t k : frequent_) {
      if (streams_[k].due == cycle) due_.push_back(k);
    }
    return due_;
  }
  for (std::size_t k = 0; k < streams_.size(); ++k) {
    if (streams_[k].due == cycle) due_.push_back(k);
  }
  return due_;
}

void RestPattern::pass(std::size_t place) {
  RestStream& stream = streams_[place];
  if (stream.step != 1) is_sorted_out_ = false;
  stream.due += stream.step;
  stream.seq += stream.seq_step;
}

}  // namespace stanok::recording
