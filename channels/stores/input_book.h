// InputBook: the inputs of the cycle on their way to the recorder, and that some of them are
// missing.
//
// A recorder that falls behind leaves the ring full. What finds no place is lost, and from there on
// the recording cannot be repeated; that itself is an input record, for which one place is kept: a
// LostInputs of the first cycle with a loss, and another one with the number of the lost when
// there is room again. Operators get an event (W720) at the begin of each such gap. One gap ends
// when half of the ring is free, so that a recorder at its limit makes one gap, not thousands.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/ring.h"
#include "channels/contract/input_record.h"
#include "channels/stores/event_book.h"

namespace stanok::channels {

class InputBook {
 public:
  // `events` outlives the book; its producer is the thread that notes.
  InputBook(std::size_t capacity, EventBook& events) : records_(capacity), events_(events) {}

  // The cycle's thread.
  void note(const InputRecord& record) RT_SAFE;
  // An input that goes to the recorder by another way found no place there.
  void note_loss(std::int64_t cycle) RT_SAFE;

  // The consumer's side.
  [[nodiscard]] Ring<InputRecord>& records() { return records_; }
  // Since construction; any thread.
  [[nodiscard]] std::uint64_t lost() const RT_SAFE { return lost_; }

 private:
  void begin_gap(std::int64_t cycle) RT_SAFE;
  void end_gap(std::int64_t cycle) RT_SAFE;
  void tell(std::int64_t cycle) RT_SAFE;

  Ring<InputRecord> records_;
  EventBook& events_;
  std::int64_t lost_in_gap_ = 0;   // 0: there is no gap
  std::int64_t untold_cycle_ = 0;  // of a gap whose event found no place; 0: none
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace stanok::channels
