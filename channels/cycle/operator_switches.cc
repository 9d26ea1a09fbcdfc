#include "channels/cycle/operator_switches.h"

namespace stanok::channels {

void OperatorSwitches::admit(const lang::OverrideControl& overrides) RT_SAFE {
  admitted_ = overrides;
  apply_spindle_override();
  if (admitted_.feed_stop_enabled && run_.hold_waits()) hold();
}

void OperatorSwitches::set_spindle_override(double factor) RT_SAFE {
  spindle_override_ = factor;
  apply_spindle_override();
}

void OperatorSwitches::apply_spindle_override() RT_SAFE {
  spindles_.set_override(admitted_.spindle_enabled ? spindle_override_ : 1.0);
}

void OperatorSwitches::set_spindles(Switch to) RT_SAFE {
  if (to == Switch::off) {
    spindles_.rest();
    spindle_rest_ = Rest::lasts;
  } else if (spindle_rest_ == Rest::lasts) {
    spindles_.turn_again();
    spindle_rest_ = Rest::ends;
  }
}

void OperatorSwitches::end_interlude() RT_SAFE {
  spindles_.turn_again();
  spindle_rest_ = Rest::none;
  coolant_ = Switch::on;
  resume_.waits = false;
}

void OperatorSwitches::resume() RT_SAFE {
  coolant_ = Switch::on;
  if (!resume_.waits && spindles_turn_as_commanded()) return run_.resume();
  set_spindles(Switch::on);
  resume_ = {.waits = true, .hand_stops = run_.hand_stops()};
}

void OperatorSwitches::advance() RT_SAFE {
  if (spindle_rest_ == Rest::ends && spindles_.are_settled()) spindle_rest_ = Rest::none;
  if (!resume_.waits) return;
  const bool is_called_off = resume_.hand_stops != run_.hand_stops() ||
                             run_.state().situation() != Situation::held ||
                             spindle_rest_ == Rest::lasts;
  if (!is_called_off && !spindles_turn_as_commanded()) return;
  resume_.waits = false;
  if (!is_called_off) run_.resume();
}

void OperatorSwitches::set_block_skip(int level, bool on) RT_SAFE {
  const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(level));
  block_skip_ = static_cast<std::uint16_t>(on ? block_skip_ | bit : block_skip_ & ~bit);
}

}  // namespace stanok::channels
