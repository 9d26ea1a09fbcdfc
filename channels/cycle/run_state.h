// RunState: what a channel is doing, as one stored situation that changes by one table.
//
// Commands are admitted by the situation (channels/contract/command_rules.h). Whoever makes
// something of a channel begin or end names the change; what the situation becomes stands in the
// table alone, which docs/developer/channels.md prints. A change that the table has no row for
// leaves the situation as it is. Thread: the real-time cycle. Owner: RunControl. Invariant: a
// situation of rest (off, idle, ready) agrees with is_powered() and has_program().
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/contract/command_rules.h"
#include "channels/contract/output.h"

namespace stanok::channels {

enum class Change : std::uint8_t {
  power_on,
  power_off,
  loaded,  // a program
  run_begins,
  held,
  resumed,
  path_left,  // axes are moved away from it by hand
  path_joined,
  run_ends,
  alarm,  // of a program or a fault; it stays until a reset
  ending_begins,
  ending_ends,
  ending_ends_in_alarm,
  hand_begins,  // axes are jogged or homed
  hand_ends,
  switch_begins,  // of kinematics
  switch_ends,
};

// Where a change leads. rest and alarm are two or three situations, by power and program.
enum class Aim : std::uint8_t { rest, running, held, aside, alarm, ending, by_hand, switching };

using SituationSet = std::uint16_t;  // bit k: the situation with the number k

struct Transition {
  Change change;
  SituationSet from;
  Aim to;
};

[[nodiscard]] std::span<const Transition> transitions() RT_SAFE;
// "run_begins", "rest"
[[nodiscard]] std::string_view name_of(Change change);
[[nodiscard]] std::string_view name_of(Aim aim);

class RunState {
 public:
  void apply(Change change) RT_SAFE;

  [[nodiscard]] Situation situation() const RT_SAFE { return situation_; }
  // As it is shown: while the channel comes to rest, what it did before.
  [[nodiscard]] ChannelState shown() const RT_SAFE { return shown_; }
  [[nodiscard]] bool is_powered() const RT_SAFE { return is_powered_; }
  [[nodiscard]] bool has_program() const RT_SAFE { return has_program_; }
  // Of a run: it is held, whether its axes are on the path or not.
  [[nodiscard]] bool is_held() const RT_SAFE {
    return situation_ == Situation::held || situation_ == Situation::aside;
  }
  // A run is under way: running, held, or coming to its end.
  [[nodiscard]] bool is_running() const RT_SAFE { return is_running_; }
  [[nodiscard]] bool is_ending() const RT_SAFE { return situation_ == Situation::ending; }

 private:
  // Of the situation, unless the channel comes to rest.
  [[nodiscard]] ChannelState state() const RT_SAFE;
  [[nodiscard]] Situation reached(Aim aim) const RT_SAFE;
  void note(Change change) RT_SAFE;

  Situation situation_ = Situation::off;
  ChannelState shown_ = ChannelState::idle;
  bool is_powered_ = false;
  bool has_program_ = false;
  bool is_running_ = false;
};

}  // namespace stanok::channels
