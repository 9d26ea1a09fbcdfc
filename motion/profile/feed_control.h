// What operator and program ask of a channel's feed in a cycle.
#pragma once

#include <cstdint>
#include <limits>

#include "base/rt_safe.h"

namespace stanok::motion {

struct FeedControl {
  static constexpr std::uint64_t no_gate = std::numeric_limits<std::uint64_t>::max();

  double feed_override = 1.0;   // 0..2, of programmed feed
  double rapid_override = 1.0;  // 0..1
  double law_part = 1.0;  // 0..1, of programmed feed: what laws formed in the cycle leave of it
  // Force control (motion/segments/feed_modifier.h): the feed that it asks for in place of the
  // programmed one, mm/s, 0: it does not; what that may become at most; on segments whose way
  // counts one of these axes, bit k: channel axis k.
  double controlled_per_s = 0.0;
  double controlled_max_per_s = 0.0;
  unsigned controlled_axes = 0;
  bool hold = false;           // feed hold: come to rest on the path
  bool leaves_thread = false;  // within a thread, too, which a hold lets run to its end
  // A gate: the path comes to rest before the first segment of this block or a later one.
  std::uint64_t closed_from_block = no_gate;
  double spindle_rev_per_min = 0.0;  // that a feed per revolution follows

  // What the spindle makes of the feed of a block; `block_rev_per_min`: the speed it is planned
  // for, 0 for a feed per time.
  [[nodiscard]] double spindle_part(double block_rev_per_min) const RT_SAFE {
    if (block_rev_per_min <= 0.0 || spindle_rev_per_min == block_rev_per_min) return 1.0;
    return spindle_rev_per_min / block_rev_per_min;
  }
  // The same under the override and the laws of the cycle.
  [[nodiscard]] double feed_part(double block_rev_per_min) const RT_SAFE {
    return feed_override * law_part * spindle_part(block_rev_per_min);
  }

  [[nodiscard]] bool is_nominal() const {
    return feed_override == 1.0 && rapid_override == 1.0 && law_part == 1.0 &&
           controlled_per_s <= 0.0 && !hold;
  }
  friend bool operator==(const FeedControl&, const FeedControl&) = default;
};

}  // namespace stanok::motion
