// Stepper: single block. One block, or one statement with an effect outside the interpreter, may
// begin at a time.
//
// A step is what has one block number and one line. The path is closed before the block behind the
// current step, so the axes come to rest along the path; what is no motion is asked for by its tag.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "motion/path/path.h"
#include "motion/profile/feed_control.h"

namespace stanok::channels {

class Stepper {
 public:
  // `at_hand`: the block that is being executed; it is finished first.
  void switch_on(const motion::BlockTag& at_hand) RT_SAFE {
    if (on_) return;
    on_ = true;
    step_ = at_hand;
    awaits_next_ = false;
  }
  void switch_off() RT_SAFE { on_ = false; }

  // A run begins: its first step may be taken.
  void begin(std::uint32_t run) RT_SAFE {
    step_ = {run, 0, 0, 0};
    awaits_next_ = true;
  }
  // The operator asks for the next step.
  void next() RT_SAFE { awaits_next_ = true; }

  // Whether what has this tag may begin; when a step is awaited, this is the one.
  [[nodiscard]] bool admits(const motion::BlockTag& tag) RT_SAFE {
    if (!on_ || is_step(tag)) return true;
    if (!awaits_next_) return false;
    step_ = tag;
    awaits_next_ = false;
    return true;
  }

  // Whether what is no step by itself and has this tag may take effect: it goes before its step.
  [[nodiscard]] bool lets_through(const motion::BlockTag& tag) const RT_SAFE {
    return !on_ || awaits_next_ || tag.run != step_.run || tag.block <= step_.block;
  }

  // The path went into a block before it could stop.
  void pass(const motion::BlockTag& tag) RT_SAFE { step_ = tag; }

  [[nodiscard]] bool awaits_next() const RT_SAFE { return on_ && awaits_next_; }
  [[nodiscard]] std::uint64_t closed_from_block() const RT_SAFE {
    return on_ ? step_.block + 1 : motion::FeedControl::no_gate;
  }

 private:
  [[nodiscard]] bool is_step(const motion::BlockTag& tag) const RT_SAFE {
    return tag.run == step_.run && tag.block == step_.block && tag.line == step_.line &&
           tag.file == step_.file;
  }

  bool on_ = false;
  bool awaits_next_ = false;
  motion::BlockTag step_;
};

}  // namespace stanok::channels
