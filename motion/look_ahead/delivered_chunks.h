// DeliveredChunks: the chunks that a look-ahead has put into a queue: their numbers, and how long
// those take that the consumer has not done with. Owner: the look-ahead, in the thread of the
// preparation.
#pragma once

#include <cstdint>
#include <deque>

#include "motion/path/path_queue.h"

namespace stanok::motion {

class DeliveredChunks {
 public:
  // Of the next one; they count from 0.
  [[nodiscard]] std::uint64_t next_number() const { return count_; }
  // The chunk has been pushed.
  void note(const Chunk& chunk, const PathQueue& queue) {
    ++count_;
    in_queue_.push_back({queue.chunks.pushed(), chunk.time_s});
    seconds_ += chunk.time_s;
  }

  // By whole chunks.
  [[nodiscard]] double seconds_in(const PathQueue& queue) {
    const std::size_t done = queue.chunks.popped();
    while (!in_queue_.empty() && in_queue_.front().pushed <= done) {
      seconds_ -= in_queue_.front().time_s;
      in_queue_.pop_front();
    }
    if (in_queue_.empty()) seconds_ = 0.0;  // rounding
    return seconds_;
  }
  // Of those that the consumer may enter: it waits before the last one until the next is known.
  [[nodiscard]] double seconds_free_in(const PathQueue& queue) {
    const double all = seconds_in(queue);
    return in_queue_.empty() ? 0.0 : all - in_queue_.back().time_s;
  }

 private:
  struct InQueue {
    std::size_t pushed = 0;  // chunks with this one, since the queue was made
    double time_s = 0.0;
  };
  std::uint64_t count_ = 0;
  std::deque<InQueue> in_queue_;
  double seconds_ = 0.0;
};

}  // namespace stanok::motion
