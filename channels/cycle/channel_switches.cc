// The operator's switches of one channel: overrides, hold, optional stop, block skip, single block.
#include <algorithm>

#include "channels/cycle/channel.h"

namespace stanok::channels {

void Channel::take_overrides(const lang::OverrideControl& overrides) RT_SAFE {
  overrides_ = overrides;
  apply_spindle_override();
  if (overrides_.feed_stop_enabled && hold_wanted_) hold_by_operator();
}

void Channel::apply_spindle_override() RT_SAFE {
  const double factor = overrides_.spindle_enabled ? spindle_override_ : 1.0;
  for (Spindle& spindle : spindles_) spindle.set_override(factor);
}

void Channel::set_spindle_override(double factor) RT_SAFE {
  spindle_override_ = factor;
  apply_spindle_override();
}

void Channel::hold_by_operator() RT_SAFE {
  if (!running_ && !resetting_) {
    ++generation_;
    if (is_switching()) return begin_stop();
  }
  hold_wanted_ = running_ && !overrides_.feed_stop_enabled;
  if (!hold_wanted_) hold(HoldCause::operator_hold);
}

void Channel::set_block_skip(int level, bool on) RT_SAFE {
  const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(level));
  block_skip_ = static_cast<std::uint16_t>(on ? block_skip_ | bit : block_skip_ & ~bit);
}

void Channel::set_single_block(bool on) RT_SAFE {
  if (on) {
    stepper_.switch_on(tag_at_hand());
  } else {
    stepper_.switch_off();
  }
}

// A step that is awaited and begins on the path: the first block that is closed.
void Channel::take_step() RT_SAFE {
  const auto& pieces = link_.path.pieces;
  for (std::size_t k = 0; k < std::min<std::size_t>(pieces.size(), 2); ++k) {
    if (!stepper_.awaits_next()) return;
    const motion::BlockTag& tag = pieces[k].tag;
    if (tag.block >= stepper_.closed_from_block()) static_cast<void>(stepper_.admits(tag));
  }
}

// A path that came too fast to a gate runs on to the end of the block behind it.
void Channel::stop_at_step() RT_SAFE {
  if (path_.tag.run == run_ && path_.tag.block >= stepper_.closed_from_block()) {
    stepper_.pass(path_.tag);
  }
  const bool at_step = path_.at_gate && closed_from_block() == stepper_.closed_from_block();
  if (at_step && state_ == ChannelState::running && !resetting_) hold(HoldCause::single_block);
}

std::optional<double> Channel::spindle_speed(int id) const RT_SAFE {
  for (int k = 0; k < figures_.spindle_count; ++k) {
    const Spindle& spindle = spindles_[static_cast<std::size_t>(k)];
    if (spindle.id() == id || (id == 0 && k == 0)) return spindle.speed();
  }
  return std::nullopt;
}

}  // namespace stanok::channels
