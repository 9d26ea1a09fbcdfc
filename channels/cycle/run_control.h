// RunControl: begins, holds and ends what a channel does, and is the only one to do so.
//
// Holds and ends bring the axes to rest along their path. An end (stop, reset, fault) makes the
// preparation forget its path; until that is done the channel is in Situation::ending. Thread: the
// real-time cycle. Owner: the channel. Invariant: an alarm that is raised stays until a reset that
// was begun after it is over.
#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/axes/axis_motion.h"
#include "channels/cycle/channel_log.h"
#include "channels/cycle/run_book.h"
#include "channels/cycle/run_state.h"
#include "channels/cycle/stepper.h"

namespace stanok::channels {

// Whether a program lets the feed hold of an operator act (M53).
enum class FeedStop : std::uint8_t { acts, waits };

class RunControl {
 public:
  // All outlive the control.
  RunControl(RunBook& runs, ChannelLog& log, AxisMotion& motion,
             std::atomic<std::uint32_t>& resets_wanted)
      : runs_(runs), log_(log), motion_(motion), resets_wanted_(resets_wanted) {}

  [[nodiscard]] const RunState& state() const RT_SAFE { return state_; }
  // Changes that are no run and no end: power, load, moves by hand, switch of kinematics.
  void apply(Change change) RT_SAFE { state_.apply(change); }
  [[nodiscard]] Stepper& stepper() RT_SAFE { return stepper_; }
  [[nodiscard]] const Stepper& stepper() const RT_SAFE { return stepper_; }

  void begin_run() RT_SAFE;
  void end_run(RunResult result, std::uint64_t blocks) RT_SAFE;

  void hold(HoldCause cause) RT_SAFE;
  // What moves outside of programs is over with it.
  void hold_by_operator(FeedStop feed_stop) RT_SAFE;
  void resume() RT_SAFE;
  // What moves outside of programs comes to rest.
  void stop_by_hand() RT_SAFE;
  // A jog begins in a hold: a return or a resume that still waits is over.
  void call_off_by_hand() RT_SAFE { ++hand_stops_; }
  // An operator has asked for a hold that the program does not let act yet.
  [[nodiscard]] bool hold_waits() const RT_SAFE { return hold_waits_; }
  [[nodiscard]] HoldCause hold_cause() const RT_SAFE;

  // Stops along the path and forgets the run; the alarm stays until reset.
  void fail(std::string_view code, std::string_view text, const motion::BlockTag& tag) RT_SAFE;
  // The same, drives off.
  void fault(const Fault& fault) RT_SAFE;
  // The same by an operator; told also when a fault is being reacted to.
  void stop_in_emergency() RT_SAFE;
  // What is over already has failed.
  void raise_alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
      RT_SAFE;
  void begin_reset() RT_SAFE;  // stops along the path, then forgets the run and its alarms
  void begin_stop() RT_SAFE;   // the same; alarms stay
  // The axes have not come to rest in time and have no power any more (A1002).
  void break_off() RT_SAFE;
  void power_off_at_rest() RT_SAFE { power_off_wanted_ = true; }

  // Of an end that is under way: since which cycle; whether the preparation has been told; it is
  // over.
  [[nodiscard]] std::int64_t ends_since() const RT_SAFE { return ends_since_; }
  [[nodiscard]] bool reset_is_told() const RT_SAFE { return reset_is_told_; }
  void note_reset_told() RT_SAFE { reset_is_told_ = true; }
  void finish_reset() RT_SAFE;
  // True once, when the time for it has come.
  [[nodiscard]] bool takes_power_off() RT_SAFE;

  // Counts what calls off moves by hand, and what was asked for in a hold and still waits.
  [[nodiscard]] std::uint32_t hand_stops() const RT_SAFE { return hand_stops_; }
  // Counts what ends all that was asked for before: stops, resets, faults.
  [[nodiscard]] std::uint32_t generation() const RT_SAFE { return generation_; }
  // For the path: it comes to rest; within a thread, too.
  [[nodiscard]] bool holds_path() const RT_SAFE { return holds_path_; }
  [[nodiscard]] bool leaves_thread() const RT_SAFE { return state_.is_ending(); }

  void show(ChannelOutput& output) const RT_SAFE;

 private:
  RunBook& runs_;
  ChannelLog& log_;
  AxisMotion& motion_;
  std::atomic<std::uint32_t>& resets_wanted_;
  RunState state_;
  Stepper stepper_;
  HoldCause hold_cause_ = HoldCause::none;
  std::int64_t ends_since_ = 0;
  bool holds_path_ = false;
  bool hold_waits_ = false;
  bool reset_is_told_ = false;
  bool alarm_stays_ = false;  // after the end under way
  bool power_off_wanted_ = false;
  std::uint32_t generation_ = 0;
  std::uint32_t hand_stops_ = 0;
};

}  // namespace stanok::channels
