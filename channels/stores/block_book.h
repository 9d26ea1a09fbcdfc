// BlockBook: what the preparation of a channel knows of its blocks, kept until the cycle executes
// them: the active codes and where each block ends. For displays; no effect on motion.
//
// The preparation is ahead of the motion by as many blocks as the path queue holds; a display asks
// for the current block. Any thread.
#pragma once

#include <deque>
#include <mutex>

#include "channels/contract/reports.h"
#include "lang/contract/active_codes.h"
#include "motion/path/path.h"

namespace stanok::channels {

class BlockBook {
 public:
  explicit BlockBook(const lang::ActiveCodes& at_start) : changes_{{0, at_start}} {}

  // Preparation side.
  void begin_run(std::uint32_t run);
  void tell_codes(const lang::CodeChange& change);
  void tell_end(const motion::BlockTag& tag, const motion::Point& end_W);

  // Of a block of the run that goes on; of another run: what the newest one left behind.
  [[nodiscard]] BlockReport at(const motion::BlockTag& tag);
  // What the newest run left behind.
  [[nodiscard]] BlockReport newest();

 private:
  // More than the path queue and the look-ahead hold.
  static constexpr std::size_t blocks_max = 32768;
  struct End {
    std::uint64_t block = 0;
    motion::Point end_W{};
  };

  [[nodiscard]] BlockReport newest_locked() const { return {changes_.back().codes, std::nullopt}; }

  std::mutex mutex_;
  std::uint32_t run_ = 0;
  std::deque<lang::CodeChange> changes_;  // by block; never empty
  std::deque<End> ends_;                  // by block
};

}  // namespace stanok::channels
