// InputRecord: an input of the cycle, as logs keep it for a replay. Plain data.
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/fixed_text.h"

namespace stanok::channels {

// One input that changed the outcome, with the cycle at which it took effect
// (docs/developer/architecture.md#time-and-determinism).
enum class InputKind : std::uint8_t {
  operator_event,
  arrival,
  feedback,
  sensor,
  overrun,
  spindle_sensor,
  lost  // input records are missing: channels/stores/input_book.h
};

struct InputRecord {
  std::int64_t cycle = 0;
  InputKind kind = InputKind::operator_event;
  std::int32_t channel = 0;  // 0: the machine
  // operator_event: channels::OperatorAction; arrival: sequence number of the item; sensor: number
  // of the input, analog ones counted on behind the digital ones; spindle_sensor: index of the
  // spindle in the machine, and `number` is 0 power, 1 vibration, 2 its frequency. lost: `value` is
  // how many were lost up to this cycle, 0 where the loss begins.
  std::int32_t method = 0;
  std::int32_t number = 0;  // of an operator event as well, as value_2
  double value = 0.0;
  double value_2 = 0.0;
  FixedText<256> text;
};
static_assert(std::is_trivially_copyable_v<InputRecord>);

}  // namespace stanok::channels
