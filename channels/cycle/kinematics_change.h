// KinematicsChange: the switch of a channel to another kinematic scheme: brakes and drives of the
// axes that leave and join, and what remains of it when one of them does not obey.
//
// The preparation makes the steps, as items; here they are carried out. A change that fails leaves
// the scheme as it was, and what it has moved where it is, braked. Thread: the real-time cycle.
// Owner: the channel. Invariant: outcome() is pending from begin() until SwitchDone, SwitchFailed
// or an end.
#pragma once

#include "base/rt_safe.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/run_control.h"
#include "channels/messages/channel_link.h"

namespace stanok::channels {

class KinematicsChange {
 public:
  // All outlive the change.
  KinematicsChange(AxisGroup& axes, const DriveGuard& drives, const AxisMotion& motion,
                   RunControl& run, ChannelLink& link)
      : axes_(axes), drives_(drives), motion_(motion), run_(run), link_(link) {}

  void begin(int scheme) RT_SAFE;
  [[nodiscard]] bool is_pending() const RT_SAFE { return outcome_ == Outcome::pending; }
  [[nodiscard]] Outcome outcome() const RT_SAFE { return outcome_; }
  // Why it failed.
  [[nodiscard]] const FixedText<8>& code() const RT_SAFE { return code_; }
  [[nodiscard]] const ShortText& text() const RT_SAFE { return text_; }

  // The time that brakes and drives take, in s.
  [[nodiscard]] double begin_step(const AxesStep& step) RT_SAFE;
  // An axis of the step whose brake is not closed or whose drive does not hold it, or -1.
  [[nodiscard]] int disobedient_axis(const AxesStep& step) const RT_SAFE;
  void finish_step(const AxesStep& step) RT_SAFE;
  // The axis does not obey.
  void fail(const AxesStep& step, int axis) RT_SAFE;

  // As the preparation says.
  void succeed() RT_SAFE;
  void refuse(std::string_view code, std::string_view text) RT_SAFE;
  // A stop in its middle.
  void end() RT_SAFE;

 private:
  void close(Outcome outcome) RT_SAFE;

  AxisGroup& axes_;
  const DriveGuard& drives_;
  const AxisMotion& motion_;
  RunControl& run_;
  ChannelLink& link_;
  Outcome outcome_ = Outcome::succeeded;
  FixedText<8> code_;
  ShortText text_;
  lang::AxisSet changed_ = 0;  // axes that it braked or released so far
};

}  // namespace stanok::channels
