// PathHistory: the segments that the cycle has passed, for a way back along them.
//
// The newest ones are kept, as many as the memory holds; what cannot be undone cuts them off.
// Records are packed and stand one behind the other in a ring of bytes, with their size at both
// ends, so that they are read in both directions. Thread: the real-time cycle; memory is taken in
// the constructor. Owner: the axes' motion of a channel. Invariant: from oldest() to newest() there
// are whole records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

// Whether the axes come to rest at the end of a segment, or the path goes on.
enum class ChainPlace : std::uint8_t { within, last };

struct PassedSegment {
  Segment segment;  // without what the process made of it: it has a feed, and no law
  ChainPlace place = ChainPlace::within;
  bool begins_chain = false;  // the axes rested before it
};

class PathHistory {
 public:
  // A place between two records: bytes written before it since construction.
  using Place = std::uint64_t;

  // 0 bytes: keeps nothing.
  explicit PathHistory(std::size_t bytes);

  void note(const Segment& segment, ChainPlace place) RT_SAFE;
  // What was passed cannot be undone.
  void cut() RT_SAFE { oldest_ = newest_; }

  // The axes rest behind the newest record, or there is none.
  [[nodiscard]] bool rests() const RT_SAFE { return is_empty() || last_place_ == ChainPlace::last; }
  [[nodiscard]] bool is_empty() const RT_SAFE { return oldest_ == newest_; }
  [[nodiscard]] bool is_of_newest_block(const BlockTag& tag) const RT_SAFE {
    return tag.run == last_.run && tag.block == last_.block;
  }
  [[nodiscard]] Place oldest() const RT_SAFE { return oldest_; }
  [[nodiscard]] Place newest() const RT_SAFE { return newest_; }
  // Where the record begins that ends at `place`, which is not the oldest one.
  [[nodiscard]] Place before(Place place) const RT_SAFE;
  // Where the record ends that begins at `place`, which is not the newest one.
  [[nodiscard]] Place behind(Place place) const RT_SAFE;
  // The record that begins there.
  void read(Place place, PassedSegment& record) const RT_SAFE;
  // Of the record that begins there.
  [[nodiscard]] std::uint32_t line_at(Place place) const RT_SAFE;
  // Blocks between two places, those that are kept in part included.
  [[nodiscard]] std::uint64_t blocks_between(Place first, Place last) const RT_SAFE;

 private:
  using Size = std::uint32_t;  // of a record, with its two sizes

  void write(Place place, const void* from, std::size_t size) RT_SAFE;
  void copy(Place place, void* to, std::size_t size) const RT_SAFE;
  [[nodiscard]] std::uint64_t block_at(Place place) const RT_SAFE;

  std::size_t capacity_;
  std::unique_ptr<std::byte[]> bytes_;
  Place oldest_ = 0;
  Place newest_ = 0;
  std::uint64_t blocks_ = 0;
  BlockTag last_;
  ChainPlace last_place_ = ChainPlace::last;
};

}  // namespace stanok::motion
