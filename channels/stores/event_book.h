// EventBook: events on their way out of the cycle, and that some of them are missing.
//
// Who does not take them leaves the ring full. What finds no place then is lost; when there is room
// again an event of its own (W721) says how many. One producer, the cycle's thread, and one
// consumer.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/ring.h"
#include "base/rt_safe.h"
#include "channels/contract/output.h"

namespace stanok::channels {

class EventBook {
 public:
  explicit EventBook(std::size_t capacity) : events_(capacity) {}

  // The cycle's thread. False: it found no place.
  bool put(const Event& event) RT_SAFE;

  // The consumer's side.
  [[nodiscard]] Ring<Event>& events() { return events_; }
  // Since construction; any thread.
  [[nodiscard]] std::uint64_t lost() const RT_SAFE { return lost_; }

 private:
  void tell_loss(std::int64_t cycle) RT_SAFE;

  Ring<Event> events_;
  std::int64_t untold_ = 0;  // lost since it was told last
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace stanok::channels
