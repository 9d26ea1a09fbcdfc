// What an operator (or a test, or a replay) asks of the machine, as plain data: the input layer of
// the cycle.
#pragma once

#include <cstdint>
#include <limits>

#include "base/fixed_text.h"

namespace stanok::channels {

// Logs hold the numbers: a new action goes to the end.
enum class OperatorAction : std::uint8_t {
  machine_on,  // drives of the axes that take part are enabled
  machine_off,
  machine_estop,  // all channels stop along their path, then drives off
  program_load,   // text = program
  program_run,    // load and start
  program_start,  // start the loaded program, resume when held
  program_hold,
  program_resume,
  program_stop,       // hold, then abort: the program is over, no alarm
  program_reset,      // abort and clear alarms
  override_feed,      // value = 0..2
  override_rapid,     // value = 0..1
  override_spindle,   // value = 0.5..1.5
  kinematics_select,  // number = scheme
  alarm_acknowledge,
  optional_stop,   // M1 stops: number = 1 yes, 0 no
  block_skip,      // number = level 1..9 whose blocks are skipped from the next sync point on
  block_skip_off,  // number = level
  single_block,    // the program stops after each block: number = 1 yes, 0 no
  mdi,             // text = one line, compiled and run
  // Of the feed: value = L_A, value_2 = L_B, both in mm; L_A = 0 ends it.
  process_interrupt,
  process_automatic,  // a feed law of the cycle: text = "modulated" or "linear", number = 1 on, 0
                      // off
  jog,                // text = axis, value = velocity, value_2 = increment (0: while it is renewed)
  home,               // text = axis; empty: all of the channel
  tool_set,           // number = tool, text = value of it, value, value_2 = edge (0: 1)
  offset_set,         // text = work offset and axis of the machine, "G54 X"; value
  process_adaptive,   // number = ForceAction, text = quantity ("" or "force", "level", "mass",
                      // "frequency"), value
  program_search,     // where the loaded program begins when it is started: text = target of
                      // lang::search_target, number = 1 without calculation, value = pass
  channel_control,    // number = session that has the channel to itself; 0: nobody
};

// What an operator does with the force control of a channel.
enum class ForceAction : std::uint8_t { off, on, set };

struct OperatorEvent {
  std::uint64_t id = 0;  // of the reply; 0: nobody waits for one
  OperatorAction action = OperatorAction::program_hold;
  std::int32_t channel = 0;  // 0: the machine
  // Stops that had been taken when this was asked for (daemon/cycle/event_queue.h).
  std::uint64_t stops_before = std::numeric_limits<std::uint64_t>::max();
  std::int32_t number = 0;
  double value = 0.0;
  double value_2 = 0.0;
  FixedText<256> text;
};

// In the id of an event whose asker hears of its reply apart from all others: a stop.
inline constexpr std::uint64_t stop_id_mark = std::uint64_t{1} << 63;

// Accepted or refused, once for every event with an id; refused with a code of the catalogue.
struct OperatorReply {
  std::uint64_t id = 0;
  bool ok = true;
  FixedText<8> code;
  FixedText<240> text;
};

}  // namespace stanok::channels
