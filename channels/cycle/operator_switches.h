// OperatorSwitches: what an operator has set for a channel: overrides, optional stop, block skip;
// and which of them the program lets act (M48 to M53).
//
// Thread: the real-time cycle. Owner: the channel.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/rt_safe.h"
#include "channels/axes/spindle_group.h"
#include "channels/contract/operator_command.h"
#include "channels/cycle/run_control.h"

namespace stanok::channels {

class OperatorSwitches {
 public:
  // Both outlive the switches.
  OperatorSwitches(SpindleGroup& spindles, RunControl& run) : spindles_(spindles), run_(run) {}

  // By a program; {}: all act.
  void admit(const lang::OverrideControl& overrides) RT_SAFE;

  void set_feed_override(double factor) RT_SAFE { feed_override_ = factor; }
  void set_rapid_override(double factor) RT_SAFE { rapid_override_ = factor; }
  void set_spindle_override(double factor) RT_SAFE;
  // Of the first part of a program rapid traverse is a quarter at most.
  void set_first_part(Switch to) RT_SAFE { first_part_ = to; }
  void set_optional_stop(bool on) RT_SAFE { optional_stop_ = on; }
  void set_block_skip(int level, bool on) RT_SAFE;
  // Of a held program; both are on before it goes on, and when it ends.
  void set_spindles(Switch to) RT_SAFE;
  void set_coolant(Switch to) RT_SAFE { coolant_ = to; }
  void end_interlude() RT_SAFE;
  [[nodiscard]] bool spindles_are_off() const RT_SAFE { return spindle_rest_ == Rest::lasts; }
  [[nodiscard]] bool spindles_turn_as_commanded() const RT_SAFE {
    return spindle_rest_ == Rest::none;
  }
  [[nodiscard]] Switch coolant() const RT_SAFE { return coolant_; }
  // The held program goes on, as soon as spindles that were off have their speed again.
  void resume() RT_SAFE;
  // Once a cycle.
  void advance() RT_SAFE;
  void hold() RT_SAFE { run_.hold_by_operator(feed_stop()); }

  [[nodiscard]] double feed_override() const RT_SAFE { return feed_override_; }  // as it is set
  [[nodiscard]] double feed_override_in_force() const RT_SAFE {
    return admitted_.feed_enabled ? feed_override_ : 1.0;
  }
  [[nodiscard]] double rapid_override() const RT_SAFE { return rapid_override_; }  // as it is set
  [[nodiscard]] double rapid_override_in_force() const RT_SAFE {
    constexpr double first_part_max = 0.25;
    return first_part_ == Switch::on ? std::min(rapid_override_, first_part_max) : rapid_override_;
  }
  [[nodiscard]] Switch first_part() const RT_SAFE { return first_part_; }
  [[nodiscard]] bool optional_stop() const RT_SAFE { return optional_stop_; }
  [[nodiscard]] std::uint16_t block_skip() const RT_SAFE { return block_skip_; }  // bit n: level n

 private:
  enum class Rest : std::uint8_t { none, lasts, ends };
  struct AskedResume {
    bool waits = false;            // for spindles
    std::uint32_t hand_stops = 0;  // as it was asked: a later stop calls it off
  };

  [[nodiscard]] FeedStop feed_stop() const RT_SAFE {
    return admitted_.feed_stop_enabled ? FeedStop::acts : FeedStop::waits;
  }
  void apply_spindle_override() RT_SAFE;

  SpindleGroup& spindles_;
  RunControl& run_;
  lang::OverrideControl admitted_;
  double feed_override_ = 1.0;
  double rapid_override_ = 1.0;
  Switch first_part_ = Switch::off;
  double spindle_override_ = 1.0;
  Rest spindle_rest_ = Rest::none;
  AskedResume resume_;
  Switch coolant_ = Switch::on;
  bool optional_stop_ = false;
  std::uint16_t block_skip_ = 0;
};

}  // namespace stanok::channels
