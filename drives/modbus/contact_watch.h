// ContactWatch: whether one drive is in contact, from its good and bad exchanges. No sockets, no
// clock.
//
// Contact is lost after `timeout` without a good answer, or when a leaky counter (up with every bad
// exchange, down with every good one) passes its limit, and is back when the polls of one and a
// half time-outs were answered. Invariant: a drive that is lost stays so until enough exchanges
// were good. Owned by the exchange of one axis, on the bus thread.
#pragma once

#include <chrono>
#include <cstdint>

#include "base/rt_safe.h"
#include "drives/bus.h"

namespace stanok::drives {

// Time is given by the caller, as the time since the start of the bus.
using BusTime = std::chrono::nanoseconds;

class ContactWatch {
 public:
  ContactWatch(BusTime poll, BusTime timeout);

  // A good answer, with values that are not older than `asked`.
  void note_answer(BusTime asked) RT_SAFE;
  void note_failure(ExchangeError error) RT_SAFE;
  // Contact is to be given up now.
  [[nodiscard]] bool is_exhausted(BusTime now) const RT_SAFE;
  void lose() RT_SAFE;

  [[nodiscard]] bool is_lost() const RT_SAFE { return lost_; }
  [[nodiscard]] bool is_answering() const RT_SAFE { return answering_; }  // the last time asked
  [[nodiscard]] BusTime answered_at() const RT_SAFE { return answered_at_; }
  [[nodiscard]] BusTime timeout() const RT_SAFE { return timeout_; }
  [[nodiscard]] const ErrorCounts& errors() const RT_SAFE { return errors_; }
  [[nodiscard]] std::uint64_t error_count() const RT_SAFE;  // of all kinds

 private:
  BusTime timeout_;
  int leak_regained_;
  int leak_ = 0;
  BusTime answered_at_{0};
  ErrorCounts errors_{};
  bool answering_ = true;
  bool lost_ = false;
};

}  // namespace stanok::drives
