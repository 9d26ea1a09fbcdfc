// ForceEvents: what force control announces in a cycle: one event, the first of the cycle, and a
// state that lasts only when it begins.
//
// Part of the force control of a channel, in the cycle; allocates nothing.
#pragma once

#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"

namespace stanok::process {

class ForceEvents {
 public:
  void begin_cycle() RT_SAFE { event_ = motion::ForceEvent::none; }
  void note(motion::ForceEvent event) RT_SAFE {
    if (event_ == motion::ForceEvent::none) event_ = event;
  }
  // Once a cycle each: the sensor of vibration gives no number; the force is too large at S_min.
  void set_vibration_lost(bool lost) RT_SAFE {
    if (lost && !vibration_is_lost_) note(motion::ForceEvent::vibration_lost);
    vibration_is_lost_ = lost;
  }
  void set_overloaded(bool overloaded) RT_SAFE {
    if (overloaded && !is_overloaded_) note(motion::ForceEvent::overload_at_feed_min);
    is_overloaded_ = overloaded;
  }
  // What lasts is announced anew.
  void tell_again() RT_SAFE { vibration_is_lost_ = is_overloaded_ = false; }

  [[nodiscard]] motion::ForceEvent event() const RT_SAFE { return event_; }

 private:
  motion::ForceEvent event_ = motion::ForceEvent::none;
  bool vibration_is_lost_ = false;
  bool is_overloaded_ = false;
};

}  // namespace stanok::process
