// TapInHole: remembers a tap from when it leaves its rest until it is back there, so that one that
// a stop, a fault or a loss of power has left in its hole can be taken out.
//
// The tap does not have to stand where it was stopped: what is known of it is its thread, and where
// that begins. Thread: the real-time cycle. Owner: the channel. Invariant: is_in() from the cycle
// in which a tap has left its rest to that in which it is back, or another one is about to begin.
#pragma once

#include "base/fixed_text.h"
#include "base/rt_safe.h"
#include "channels/contract/held_tap.h"
#include "channels/contract/texts.h"
#include "motion/interpolation/interpolator.h"

namespace stanok::channels {

class TapInHole {
 public:
  // Once a cycle, behind the path; `rev_per_min`: what the spindle of the path's tap is commanded.
  // True: the path was given up while a tap is in, in this cycle.
  bool follow(const motion::InterpolatorOutput& path, double rev_per_min) RT_SAFE;

  [[nodiscard]] bool is_in() const RT_SAFE { return is_in_; }
  // Its own path does not have it any more, and the axes stand where it can be: one that was freed
  // by hand is not shown when they have gone elsewhere.
  [[nodiscard]] bool is_left() const RT_SAFE {
    return is_in_ && is_near_ && (!is_on_path_ || is_on_way_out_);
  }
  [[nodiscard]] const HeldTap& tap() const RT_SAFE { return tap_; }

  // It is to be taken out: until the preparation says that it is, or why it cannot be.
  void begin_way_out() RT_SAFE;
  void end_way_out(const FixedText<8>& code, const ShortText& text) RT_SAFE;
  [[nodiscard]] bool is_on_way_out() const RT_SAFE { return is_on_way_out_; }
  // Empty: it came out.
  [[nodiscard]] const FixedText<8>& code() const RT_SAFE { return code_; }
  [[nodiscard]] const ShortText& text() const RT_SAFE { return text_; }

 private:
  void stand_before(const motion::InterpolatorOutput& path, double rev_per_min) RT_SAFE;
  void go_deeper(const motion::InterpolatorOutput& path) RT_SAFE;
  [[nodiscard]] bool is_near(const motion::InterpolatorOutput& path) const RT_SAFE;

  HeldTap tap_;
  double depth_ = 0.0;  // of the deepest point, by all axes
  bool is_in_ = false;
  bool is_on_path_ = false;
  bool is_on_way_out_ = false;
  bool is_near_ = false;
  FixedText<8> code_;
  ShortText text_;
};

}  // namespace stanok::channels
