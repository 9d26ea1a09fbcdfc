// A command of an operator on its way into the cycle, and the reply to it; plain data.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "base/fixed_text.h"
#include "channels/contract/operator_command.h"

namespace stanok::channels {

struct OperatorEvent {
  std::uint64_t id = 0;  // of the reply; 0: nobody waits for one
  // Stops that had been taken when this was asked for (daemon/cycle/event_queue.h).
  std::uint64_t stops_before = std::numeric_limits<std::uint64_t>::max();
  OperatorCommand command = commands::ProgramHold{};
  std::int32_t channel = 0;     // 0: the machine
  std::uint32_t situation = 0;  // of the channel, in which alone it holds; 0: in any
  // The newest cycle that its asker had seen, or in which it came in: what begins motion is refused
  // when that is long ago (channels/coordinator/request_gate.h). -1: it has no age.
  std::int64_t seen_cycle = -1;
  std::int32_t session = 0;  // that asks; 0: none

  [[nodiscard]] OperatorAction action() const RT_SAFE { return action_of(command); }
};
static_assert(std::is_trivially_copyable_v<OperatorEvent>);

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
