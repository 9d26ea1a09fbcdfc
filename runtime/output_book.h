// OutputBook: every cycle's output on its way to the publisher; a full ring drops the newest,
// counted. Operators get an event (W720) at the begin of each gap; one gap ends when half of the
// ring is free. Inputs go by another way, so that a replay computes again what is missing.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/ring.h"
#include "channels/contract/output.h"

namespace stanok::runtime {

class OutputBook {
 public:
  // `events` outlives the book; its producer is the cycle's thread.
  OutputBook(std::size_t capacity, Ring<channels::Event>& events)
      : outputs_(capacity), events_(events) {}

  // The cycle's thread.
  void note(const channels::CycleOutput& output) RT_SAFE {
    if (outputs_.space() > outputs_.capacity() / 2) has_told_gap_ = false;
    if (outputs_.push(output)) return;
    lost_.fetch_add(1, std::memory_order_relaxed);
    if (!has_told_gap_) tell(output.cycle);
  }

  // The consumer's side.
  [[nodiscard]] Ring<channels::CycleOutput>& outputs() { return outputs_; }
  // Since construction; any thread.
  [[nodiscard]] std::uint64_t lost() const RT_SAFE { return lost_; }

 private:
  void tell(std::int64_t cycle) RT_SAFE {
    channels::Event event;
    event.cycle = cycle;
    event.code = FixedText<8>("W720");
    event.text = FixedText<240>("setpoints of cycle ");
    event.text.append(static_cast<long>(cycle))
        .append(
            " and of some after it are missing from the recording: the recorder was too slow; "
            "a replay computes them again");
    has_told_gap_ = events_.push(event);
  }

  Ring<channels::CycleOutput> outputs_;
  Ring<channels::Event>& events_;
  bool has_told_gap_ = false;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace stanok::runtime
