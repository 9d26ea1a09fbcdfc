// EventQueue: operator events on their way into the real-time cycle.
//
// Two producers, each with a ring of its own: the operator server's thread for everything, the
// reception's thread for stops, which wait for nothing that the other one does. One consumer, the
// cycle. An event carries how many stops had been put when its request came in: it is handed on
// behind these, and when it begins motion and a stop of its channel has been put since then, it is
// overtaken and not handed on at all. So nothing starts behind a stop that was asked for later.
// What somebody has given up waiting for is withdrawn: it takes no effect when the cycle comes at
// last.
#pragma once

#include <array>
#include <atomic>
#include <span>

#include "base/ring.h"
#include "channels/contract/operator_action.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"

namespace stanok::daemon {

class EventQueue {
 public:
  static constexpr std::size_t capacity = 80;
  static constexpr std::size_t kept_for_stops = 16;  // of the operator server
  static constexpr std::size_t stops_max = 48;
  static constexpr std::size_t kept_for_emergency = 8;  // of the stops

  // Operator server's thread. False: no room; the event is not taken.
  [[nodiscard]] bool put(const channels::OperatorEvent& event) {
    if (!channels::is_stop(event.action()) && events_.space() <= kept_for_stops) return false;
    return events_.push(event);
  }
  // Operator server's thread, whose events have ascending ids. What is no stop and has an id up to
  // this one is not handed on any more, but for what the cycle has begun to take: the newest id of
  // these. It is answered by the cycle; who asked for anything newer may be told that it is void.
  [[nodiscard]] std::uint64_t withdraw(std::uint64_t up_to_id) {
    withdrawn_.store(up_to_id, std::memory_order_seq_cst);
    return taking_.load(std::memory_order_seq_cst);
  }
  // Reception's thread. False: no room; the stop is not taken.
  [[nodiscard]] bool put_stop(const channels::OperatorEvent& stop) {
    const bool is_emergency = stop.action() == channels::OperatorAction::machine_estop ||
                              stop.action() == channels::OperatorAction::machine_off;
    if (!is_emergency && stops_.space() <= kept_for_emergency) return false;
    return stops_.push(stop);
  }
  // Stops put since construction; reception's thread.
  [[nodiscard]] std::uint64_t stops_put() const { return stops_.pushed(); }

  struct Taken {
    std::span<const channels::OperatorEvent> events;     // in their order
    std::span<const channels::OperatorEvent> overtaken;  // or withdrawn: to be refused
  };
  // All that waits. The spans are valid until the next call.
  [[nodiscard]] Taken take() RT_SAFE;

 private:
  // Which stop of a channel was the last one; they count from 1.
  struct LastStop {
    std::int32_t channel = 0;
    std::uint64_t number = 0;
  };
  void note_stops(std::size_t count) RT_SAFE;
  [[nodiscard]] bool is_void(const channels::OperatorEvent& event, std::uint64_t withdrawn) const
      RT_SAFE;
  [[nodiscard]] bool is_overtaken(const channels::OperatorEvent& event) const RT_SAFE;

  Ring<channels::OperatorEvent> events_{capacity};
  Ring<channels::OperatorEvent> stops_{stops_max};
  // Written before withdrawn_ is read, and read after that is written: of an event that is
  // withdrawn while it is taken at least one of both sides knows.
  std::atomic<std::uint64_t> taking_{0};     // id of the newest event that take() has seen
  std::atomic<std::uint64_t> withdrawn_{0};  // up to this id
  std::uint64_t stops_taken_ = 0;
  std::uint64_t last_of_any_ = 0;
  std::uint64_t last_of_all_ = 0;
  std::array<LastStop, channels::channels_max> last_{};
  std::array<channels::OperatorEvent, capacity + stops_max> taken_{};
  std::array<channels::OperatorEvent, capacity> overtaken_{};
};

}  // namespace stanok::daemon
