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

void OperatorSwitches::set_block_skip(int level, bool on) RT_SAFE {
  const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(level));
  block_skip_ = static_cast<std::uint16_t>(on ? block_skip_ | bit : block_skip_ & ~bit);
}

}  // namespace stanok::channels
