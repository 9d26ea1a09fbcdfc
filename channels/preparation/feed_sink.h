// FeedSink: where the results of a PathFeed go. There is one for each use of a program: a run
// (QueueSink), a dry run, a block search (SearchSink).
//
// A sink decides nothing about commands; what it does not need it ignores. Thread: that of its
// PathFeed. Invariant: results come in the order of the program.
#pragma once

#include <cstdint>
#include <span>

#include "channels/messages/item.h"
#include "lang/contract/command.h"
#include "motion/segments/path_builder.h"
#include "motion/threads/thread_builder.h"

namespace stanok::channels {

// How far a PathFeed follows the motion of a program.
enum class FeedDepth : std::uint8_t {
  positions,  // the ends of blocks; no axis limits are checked
  path,       // segments of path and threads, within the limits of all axes
};

class FeedSink {
 public:
  virtual ~FeedSink() = default;

  [[nodiscard]] virtual FeedDepth depth() const = 0;

  // Called first for every command.
  virtual void begin_command(const lang::Command& /*command*/) {}
  // The blocks of a command of motion, before their poses are checked; never empty.
  virtual void take_motion(const lang::Command& /*command*/,
                           std::span<const motion::PathBlock> /*blocks*/) {}
  virtual void take_segment(const motion::PathBuilder::Built& /*built*/) {}
  virtual void take_thread(motion::ThreadChain&& /*chain*/) {}
  virtual void take_item(const Item& /*item*/) {}
  virtual void take_request(const motion::BlockTag& /*tag*/,
                            const lang::ProgramRequest& /*request*/) {}
  virtual void take_rider(const Rider& /*rider*/) {}
  virtual void take_remark(const Remark& /*remark*/) {}
};

}  // namespace stanok::channels
