// The drive's side of the CiA 402 state automaton: control words in, state out.
//
// Source: CiA 402 part 2, transitions 2..15. Quick stop follows option code 2: after standstill the
// drive disables itself. Motion is reported to it; it holds no motion of its own.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "drives/drive.h"

namespace stanok::plant {

class PowerState {
 public:
  [[nodiscard]] drives::DriveState state() const RT_SAFE { return state_; }
  [[nodiscard]] std::uint16_t fault_code() const RT_SAFE { return fault_code_; }

  // The motor is under power: it follows, or stops on its ramp.
  [[nodiscard]] bool is_powered() const RT_SAFE;

  void take_control_word(std::uint16_t word) RT_SAFE;

  // A fault: the reaction begins, unless there is one already.
  void trip(std::uint16_t fault_code) RT_SAFE;

  // Once per step: ends quick stop and fault reaction when the motor stands.
  void notice_standstill() RT_SAFE;

  // Power was lost and has come back.
  void restart() RT_SAFE;

 private:
  drives::DriveState state_ = drives::DriveState::switch_on_disabled;
  std::uint16_t fault_code_ = 0;
  std::uint16_t last_word_ = 0;
};

}  // namespace stanok::plant
