#include "channels/cycle/run_control.h"

namespace stanok::channels {

void RunControl::begin_run() RT_SAFE {
  runs_.begin(motion_.path());
  state_.apply(Change::run_begins);
  stepper_.begin(runs_.run());
  holds_path_ = false;
  motion_.cut_history();
  motion_.lengths().forget();
}

void RunControl::end_run(RunResult result, std::uint64_t blocks) RT_SAFE {
  state_.apply(Change::run_ends);
  hold_waits_ = false;
  holds_path_ = false;
  runs_.end(result, blocks, motion_.path());
  motion_.cut_history();
}

void RunControl::hold(HoldCause cause) RT_SAFE {
  stop_by_hand();
  if (!state_.is_running() || state_.is_ending()) return;
  // Who presses hold where another hold lasts does not end its step.
  if (!holds_path_ || cause != HoldCause::operator_hold) hold_cause_ = cause;
  holds_path_ = true;
  state_.apply(Change::held);
}

void RunControl::stop_by_hand() RT_SAFE {
  ++hand_stops_;
  motion_.stop_by_hand();
  if (!motion_.moves_by_hand()) state_.apply(Change::hand_ends);
}

void RunControl::hold_by_operator(FeedStop feed_stop) RT_SAFE {
  if (!state_.is_running() && !state_.is_ending()) {
    ++generation_;
    if (state_.situation() == Situation::switching) return begin_stop();
  }
  hold_waits_ = state_.is_running() && feed_stop == FeedStop::waits;
  if (!hold_waits_) hold(HoldCause::operator_hold);
}

void RunControl::resume() RT_SAFE {
  hold_waits_ = false;
  if (state_.situation() != Situation::held) return;
  // Other holds are in the middle of a step.
  if (hold_cause_ == HoldCause::single_block || hold_cause_ == HoldCause::program_stop)
    stepper_.next();
  holds_path_ = false;
  state_.apply(Change::resumed);
}

HoldCause RunControl::hold_cause() const RT_SAFE {
  return state_.shown() == ChannelState::held ? hold_cause_ : HoldCause::none;
}

void RunControl::raise_alarm(std::string_view code, std::string_view text,
                             const motion::BlockTag& tag) RT_SAFE {
  state_.apply(Change::alarm);
  runs_.spoil();
  log_.alarm(code, text, tag);
}

void RunControl::fail(std::string_view code, std::string_view text, const motion::BlockTag& tag)
    RT_SAFE {
  if (alarm_stays_) return;
  raise_alarm(code, text, tag);
  begin_reset();
  alarm_stays_ = true;
}

void RunControl::fault(const Fault& fault) RT_SAFE {
  if (alarm_stays_) return;
  fail(fault.code.view(), fault.text.view(), motion_.path().tag);
  power_off_wanted_ = true;
}

void RunControl::stop_in_emergency() RT_SAFE {
  const Fault stop{{"A1001"}, {"stopped by an operator (STOP ALL)"}};
  if (!alarm_stays_) return fault(stop);
  ++generation_;
  log_.alarm(stop.code.view(), stop.text.view(), motion_.path().tag);
  power_off_wanted_ = true;
}

void RunControl::begin_reset() RT_SAFE {
  ++generation_;
  alarm_stays_ = false;
  stop_by_hand();
  if (state_.is_ending()) return;
  state_.apply(Change::ending_begins);
  ends_since_ = runs_.cycle();
  reset_is_told_ = false;
  resets_wanted_.fetch_add(1, std::memory_order_relaxed);
  holds_path_ = true;
}

void RunControl::begin_stop() RT_SAFE {
  const bool alarm_stood = alarm_stays_ || state_.shown() == ChannelState::alarm;
  begin_reset();
  alarm_stays_ = alarm_stood;
}

void RunControl::break_off() RT_SAFE {
  raise_alarm("A1002", "the axes did not come to rest in time: power is off", motion_.path().tag);
  alarm_stays_ = true;
}

void RunControl::finish_reset() RT_SAFE {
  state_.apply(alarm_stays_ ? Change::ending_ends_in_alarm : Change::ending_ends);
  alarm_stays_ = false;
  holds_path_ = false;
  runs_.note_reset();
}

bool RunControl::takes_power_off() RT_SAFE {
  if (!power_off_wanted_ || state_.is_ending() || !motion_.is_standing()) return false;
  power_off_wanted_ = false;
  return true;
}

void RunControl::show(ChannelOutput& output) const RT_SAFE {
  output.state = state_.shown();
  output.running = state_.is_running();
  output.run = runs_.run();
  output.hold_cause = hold_cause();
  output.program = runs_.program();
}

}  // namespace stanok::channels
