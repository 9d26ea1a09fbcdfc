// DriveGuard: what the drives of a channel's axes tell, and what of it is a fault.
//
// A drive that held its axis and is silent, reports a fault, strays or has switched itself off, and
// an axis that comes onto a limit switch, stop the channel. Without feedback the drives are ideal:
// they hold what they are told. Thread: the real-time cycle. Owner: the channel. Invariant:
// `enabled` and `referenced` of the feedback hold only while it is valid, and its numbers are
// finite then.
#pragma once

#include <optional>
#include <span>

#include "base/fixed_text.h"
#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/axes/axis_group.h"
#include "channels/contract/output.h"

namespace stanok::channels {

// What stops a channel: a code of the catalogue, and the sentence that says what it is about.
struct Fault {
  FixedText<8> code;
  FixedText<128> text;
};

// Homing looks for the switches at the ends of its axes itself.
enum class LimitSwitches : std::uint8_t { stop_the_axis, are_looked_for };

class DriveGuard {
 public:
  // `axes` outlives the guard.
  DriveGuard(const ChannelConstants& constants, const AxisGroup& axes);

  // In the order of the machine's axes; empty: ideal drives. The first fault that there is.
  [[nodiscard]] std::optional<Fault> advance(NumberedSpan<const AxisFeedback> machine,
                                             LimitSwitches limit_switches) RT_SAFE;
  // Another drive has the axis now; it is waited for anew.
  void forget(int axis) RT_SAFE { was_ready_[axis] = was_homed_[axis] = false; }

  [[nodiscard]] bool is_ideal() const RT_SAFE { return is_ideal_; }
  [[nodiscard]] const AxisFeedback& feedback(int axis) const RT_SAFE { return feedback_[axis]; }
  [[nodiscard]] std::span<const AxisFeedback> feedback() const RT_SAFE { return feedback_; }
  [[nodiscard]] bool all_answer() const RT_SAFE { return all_answer_; }
  // Every drive that is commanded on holds its axis.
  [[nodiscard]] bool all_ready() const RT_SAFE { return all_ready_; }
  // The position of the axis belongs to the machine, as its drive says.
  [[nodiscard]] bool is_homed(int axis) const RT_SAFE { return feedback(axis).referenced; }
  // The first axis that stands on a limit switch; -1: none.
  [[nodiscard]] int axis_on_limit_switch() const RT_SAFE;

  void show(ChannelOutput& output) const RT_SAFE;

 private:
  void take(int axis, const AxisFeedback& told) RT_SAFE;
  [[nodiscard]] std::optional<Fault> fault_of_drives() RT_SAFE;
  [[nodiscard]] std::optional<Fault> fault_of_references(LimitSwitches switches) RT_SAFE;
  [[nodiscard]] std::optional<Fault> fault_of_limit_switches(LimitSwitches switches) RT_SAFE;

  const AxisGroup& axes_;
  AxisArray<AxisFeedback> feedback_{};
  AxisArray<bool> was_ready_{};  // since its drive was commanded on
  AxisArray<bool> was_homed_{};  // since then, while no homing changed it
  lang::AxisSet on_limit_switch_ = 0;
  bool is_ideal_ = true;
  bool all_answer_ = true;
  bool all_ready_ = true;
};

}  // namespace stanok::channels
