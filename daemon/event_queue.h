// EventQueue: operator events on their way into the real-time cycle, in their order.
//
// One producer (the operator server's thread), one consumer (the cycle). The last places are kept
// for events that stop motion, so that nobody who floods the machine with requests can keep a stop
// out; a stop never overtakes what was asked before it, so nothing starts behind it.
#pragma once

#include <array>
#include <span>

#include "base/ring.h"
#include "channels/operator_action.h"
#include "channels/operator_event.h"

namespace stanok::daemon {

class EventQueue {
 public:
  static constexpr std::size_t capacity = 128;
  static constexpr std::size_t kept_for_stops = 64;

  // False: no room; the event is not taken.
  [[nodiscard]] bool put(const channels::OperatorEvent& event) {
    if (!channels::is_stop(event.action) && ring_.space() <= kept_for_stops) return false;
    return ring_.push(event);
  }

  // All events that wait. The span is valid until the next call.
  [[nodiscard]] std::span<const channels::OperatorEvent> take() RT_SAFE {
    const std::size_t count = ring_.size();
    for (std::size_t k = 0; k < count; ++k) taken_[k] = ring_[k];
    ring_.pop_front(count);
    return {taken_.data(), count};
  }

 private:
  Ring<channels::OperatorEvent> ring_{capacity};
  std::array<channels::OperatorEvent, capacity> taken_{};
};

}  // namespace stanok::daemon
