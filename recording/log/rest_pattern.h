// RestPattern: which messages come again and again while nothing happens, when, and in what order.
//
// A machine at rest says the same every cycle, some of it every 50 ms, every second, every minute.
// RestFilter leaves such messages out of a log, RestExpansion makes them again; both keep this
// pattern. A stream is what is said on one LCM channel; on that of a path each part is a stream.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::recording {

// The fields that every message of ours begins with, behind its fingerprint.
struct MessageStamp {
  std::int64_t utime = 0;
  std::int64_t cycle = 0;
  std::int64_t seq = 0;
};

inline constexpr std::size_t stamp_end = 32;  // bytes of fingerprint and stamp

// Of a message of at least `stamp_end` bytes.
[[nodiscard]] MessageStamp stamp_of(std::span<const std::uint8_t> bytes);
void put_stamp(const MessageStamp& stamp, std::span<std::uint8_t> bytes);
// What all messages of a stretch have in common: of fingerprint and what follows the stamp.
[[nodiscard]] std::int64_t sum_of(std::span<const std::uint8_t> bytes);
// Of a path the place of its first point, else 0.
[[nodiscard]] std::int32_t part_of(std::string_view channel, std::span<const std::uint8_t> bytes);

// The latest message of a stream.
struct LatestMessage {
  std::vector<std::uint8_t> bytes;
  bool is_in_pattern = false;
};

// By LCM channel and part.
class LatestMessages {
 public:
  // Nothing has been said: nullptr.
  [[nodiscard]] LatestMessage* find(std::string_view channel, std::int32_t part);
  LatestMessage& keep(std::string_view channel, std::span<const std::uint8_t> bytes);
  void clear() { latest_.clear(); }
  void leave_pattern();

 private:
  std::map<std::string, std::map<std::int32_t, LatestMessage>, std::less<>> latest_;
};

struct RestStream {
  std::string channel;
  std::int32_t part = 0;
  LatestMessage* latest = nullptr;  // not owned
  std::int64_t due = 0;             // cycle of its next message
  std::int64_t step = 1;            // cycles between two
  std::int64_t seq = 0;             // number of the next one
  std::int64_t seq_step = 1;
};

class RestPattern {
 public:
  // At that place in the order; the end is a place.
  void insert(std::size_t place, RestStream stream);
  void clear();

  [[nodiscard]] const std::vector<RestStream>& streams() const { return streams_; }
  // Places of those whose message comes in this cycle, in their order. Valid until the next call.
  [[nodiscard]] const std::vector<std::size_t>& due(std::int64_t cycle);
  // The message of that stream has come.
  void pass(std::size_t place);

 private:
  void sort_out();

  std::vector<RestStream> streams_;
  std::vector<std::size_t> frequent_;  // places of those of every cycle
  std::int64_t rare_due_ = 0;          // the next cycle in which one of the others comes
  bool is_sorted_out_ = false;
  std::vector<std::size_t> due_;
};

}  // namespace stanok::recording
