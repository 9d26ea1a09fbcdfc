// RadiusCounter, OverhangKey and CutRadius, blocks 10 and 11: the radius at which the tool cuts,
// counted in increments of the transverse axis.
//
// The counter is preset where the axes stand in a frame that is new: at the reference point, behind
// work offsets and tools. Between, it follows the pulses of the transverse axis and nothing else.
// An overhang command sends the difference of the overhangs to the counter while the key keeps it
// from the drive: the counter moves, the slide stands. Part of the force control of a channel, in
// the cycle.
#pragma once

#include <cstdint>

#include "base/numeric.h"
#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"

namespace stanok::process {

// Block 11: lets pulses through to the transverse drive, but for those of an overhang command.
class OverhangKey {
 public:
  void set_blocked(bool blocked) RT_SAFE { is_blocked_ = blocked; }
  [[nodiscard]] std::int64_t pass(std::int64_t pulses) const RT_SAFE {
    return is_blocked_ ? 0 : pulses;
  }

 private:
  bool is_blocked_ = false;
};

// Block 10.
class RadiusCounter {
 public:
  struct Slide {
    double position_mm = 0.0;
    std::int64_t code = 0;  // position in increments
    double increment_mm = 0.001;
  };
  // The tool stands at this radius while the slide stands there: what lies between them is rounded
  // once, so that the counter stays within an increment of the radius.
  void preset(double radius_mm, const Slide& slide) RT_SAFE {
    increment_mm_ = slide.increment_mm;
    code_ = slide.code + nearest_integer((radius_mm - slide.position_mm) / slide.increment_mm);
  }
  void count(std::int64_t pulses) RT_SAFE { code_ += pulses; }

  [[nodiscard]] std::int64_t code() const RT_SAFE { return code_; }  // K_R
  [[nodiscard]] double radius_mm() const RT_SAFE {
    return increment_mm_ * static_cast<double>(code_ < 0 ? -code_ : code_);
  }

 private:
  std::int64_t code_ = 0;
  double increment_mm_ = 0.001;
};

// Both as they are wired: a new frame moves the counter while the key holds the slide.
class CutRadius {
 public:
  // Once a cycle.
  void count(const motion::CutState& cut) RT_SAFE {
    const RadiusCounter::Slide slide{.position_mm = cut.transverse_mm,
                                     .code = cut.transverse_code,
                                     .increment_mm = cut.increment_mm};
    key_.set_blocked(cut.frame_is_new);
    counter_.count(key_.pass(slide.code - transverse_code_));
    if (cut.frame_is_new) counter_.preset(cut.radius_mm, slide);
    transverse_code_ = slide.code;
  }
  [[nodiscard]] const RadiusCounter& counter() const RT_SAFE { return counter_; }

 private:
  RadiusCounter counter_;
  OverhangKey key_;
  std::int64_t transverse_code_ = 0;
};

}  // namespace stanok::process
