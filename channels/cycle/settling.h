// Settling: while nothing runs, the preparation is asked in which frame and with which tool the
// channel stands, whenever something has changed that this depends on: a row of a table, the
// scheme, the start of the machine.
//
// Several changes are asked about at once. Thread: the real-time cycle. Owner: the ItemWorker.
// Invariant: is_done() is false from a change until the answer to a question that was asked behind
// it; until then nothing may begin.
#pragma once

#include "base/rt_safe.h"
#include "channels/messages/channel_link.h"

namespace stanok::channels {

class Settling {
 public:
  // The link outlives it.
  explicit Settling(ChannelLink& link) : link_(link) {}

  void want(const lang::ChangedRows& rows) RT_SAFE;
  // The channel is at rest, and stands so.
  void ask(const Stand& stand) RT_SAFE;
  // Before the first cycle, whatever was asked before.
  void ask_at_start(const Stand& stand);
  // The preparation has answered; a reset answers whatever was asked before.
  void finish() RT_SAFE { is_asked_ = false; }

  [[nodiscard]] bool is_wanted() const RT_SAFE { return is_wanted_; }
  [[nodiscard]] bool is_done() const RT_SAFE { return !is_wanted_ && !is_asked_; }

 private:
  ChannelLink& link_;
  lang::ChangedRows rows_{.all = true};  // at the start of the machine
  bool is_wanted_ = true;
  bool is_asked_ = false;
};

}  // namespace stanok::channels
