// Transitions of the state automaton, numbered as in CiA 402.
#include "plant/drive/power_state.h"

#include "drives/cia402.h"

namespace stanok::plant {
namespace {

using drives::DriveState;
namespace control = drives::control;

enum class Command : std::uint8_t {
  disable_voltage,
  quick_stop,
  shutdown,
  switch_on,
  enable_operation,
};

// Object 6040h: bits 0..3 decide, the fault reset is an edge and stands apart.
Command command_of(std::uint16_t word) RT_SAFE {
  if ((word & control::enable_voltage) == 0) {
    return Command::disable_voltage;
  }
  if ((word & control::no_quick_stop) == 0) {
    return Command::quick_stop;
  }
  if ((word & control::switch_on) == 0) {
    return Command::shutdown;
  }
  return (word & control::enable_operation) == 0 ? Command::switch_on : Command::enable_operation;
}

DriveState after_shutdown(DriveState state) RT_SAFE {
  switch (state) {
    case DriveState::switch_on_disabled:  // 2
    case DriveState::switched_on:         // 6
    case DriveState::operation_enabled:   // 8
      return DriveState::ready_to_switch_on;
    default:
      return state;
  }
}

// Transitions 3, 5 with `switched_on`, 4 with `operation_enabled`.
DriveState after_switch_on(DriveState state, DriveState wanted) RT_SAFE {
  switch (state) {
    case DriveState::ready_to_switch_on:
    case DriveState::switched_on:
    case DriveState::operation_enabled:
      return wanted;
    default:
      return state;
  }
}

DriveState after(DriveState state, Command command) RT_SAFE {
  switch (command) {
    case Command::disable_voltage:  // 7, 9, 10, 12
      return DriveState::switch_on_disabled;
    case Command::quick_stop:  // 11; 7, 10
      return state == DriveState::operation_enabled || state == DriveState::quick_stop_active
                 ? DriveState::quick_stop_active
                 : DriveState::switch_on_disabled;
    case Command::shutdown:
      return after_shutdown(state);
    case Command::switch_on:
      return after_switch_on(state, DriveState::switched_on);
    case Command::enable_operation:
      return after_switch_on(state, DriveState::operation_enabled);
  }
  return state;
}

}  // namespace

bool PowerState::is_powered() const RT_SAFE {
  return state_ == DriveState::operation_enabled || state_ == DriveState::quick_stop_active ||
         state_ == DriveState::fault_reaction_active;
}

void PowerState::take_control_word(std::uint16_t word) RT_SAFE {
  const bool reset = (word & control::fault_reset & ~last_word_) != 0;
  last_word_ = word;
  switch (state_) {
    case DriveState::fault:
      if (reset) {  // 15
        restart();
      }
      return;
    case DriveState::fault_reaction_active:
    case DriveState::not_ready_to_switch_on:
      return;
    default:
      state_ = after(state_, command_of(word));
  }
}

void PowerState::trip(std::uint16_t fault_code) RT_SAFE {
  if (state_ != DriveState::fault && state_ != DriveState::fault_reaction_active) {  // 13
    state_ = DriveState::fault_reaction_active;
    fault_code_ = fault_code;
  }
}

void PowerState::notice_standstill() RT_SAFE {
  if (state_ == DriveState::quick_stop_active) {  // 12
    state_ = DriveState::switch_on_disabled;
  } else if (state_ == DriveState::fault_reaction_active) {  // 14
    state_ = DriveState::fault;
  }
}

void PowerState::restart() RT_SAFE {
  state_ = DriveState::switch_on_disabled;
  fault_code_ = 0;
}

}  // namespace stanok::plant
