// WayAside: where the axes of a held channel are while an operator has moved them away from the
// path, and the way that they went there, which is the way back.
//
// The way is a row of straight parts from where the path is held; each was moved by hand, so that
// each was free. Moves along one axis that follow each other are one part. Thread: the real-time
// cycle. Owner: the axes' motion of a channel. Invariant: while it is on, the first place is where
// the path is held, and the last one where the axes came to rest last.
#pragma once

#include <array>
#include <cstddef>

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::channels {

class WayAside {
 public:
  void begin(const motion::Point& axes_M) RT_SAFE;
  // The path is held there from now on, and the axes stay: the tool has another length. The way of
  // its point stays the same, so that each part moves along, as far as axes travel. Not when it is
  // full.
  void shift(const motion::Point& path_M, const motion::MotionConfig& config) RT_SAFE;
  // Where the path is held, to the bit.
  void note_path(const motion::JetPoint& axes_M) RT_SAFE;
  [[nodiscard]] const motion::Point& path() const RT_SAFE { return places_[0]; }
  void end() RT_SAFE { count_ = 0; }

  [[nodiscard]] bool is_on() const RT_SAFE { return count_ > 0; }
  [[nodiscard]] bool is_full() const RT_SAFE { return count_ == places_.size(); }
  [[nodiscard]] bool is_at_path() const RT_SAFE { return count_ == 1; }

  // The axes are there in this cycle, and, once they rest, a part of the way ends there.
  void follow(const motion::JetPoint& axes_M) RT_SAFE;
  void come_to_rest() RT_SAFE;
  void place(motion::JetPoint& axes_M) const RT_SAFE;

  // Where the last part begins: the next rest is on it. Not at the path.
  [[nodiscard]] const motion::Point& turn_back() RT_SAFE;

 private:
  [[nodiscard]] const motion::Point& last() const RT_SAFE { return places_[count_ - 1]; }
  [[nodiscard]] bool goes_on_along_axis() const RT_SAFE;

  std::array<motion::Point, 64> places_{};
  std::size_t count_ = 0;
  motion::Point now_{};
  bool goes_back_ = false;
};

}  // namespace stanok::channels
