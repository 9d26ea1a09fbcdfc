// InputRecord: an input of the cycle that changed the outcome, with the cycle at which it took
// effect, as logs keep it for a replay (docs/developer/architecture.md#time-and-determinism). One
// struct for each kind of input; plain data.
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "channels/contract/operator_command.h"

namespace stanok::channels {

// Inputs of programs.
struct DigitalInput {
  std::int32_t number = 0;
  bool is_on = false;
};
struct AnalogInput {
  std::int32_t number = 0;
  double value = 0.0;
};

enum class SpindleQuantity : std::uint8_t { power_w, vibration_um, vibration_hz };

// A sensor of a spindle; the value is NaN when it tells nothing any more.
struct SpindleInput {
  std::int32_t spindle = 0;  // index in the machine
  SpindleQuantity quantity = SpindleQuantity::power_w;
  double value = 0.0;
};

// Where the preparation of the channel took over what others had written into the tables
// (channels/stores/table_view.h).
struct TableTaking {
  std::uint32_t run = 0;      // of the channel
  std::uint64_t command = 0;  // before which, counted in the run
  std::uint64_t version = 0;  // up to this write

  friend bool operator==(const TableTaking&, const TableTaking&) = default;
};

// Periods passed without a cycle before this one (channels/contract/clock_gap.h).
struct Overrun {
  std::int64_t periods = 0;
};

// Input records are missing (channels/stores/input_book.h).
struct LostInputs {
  std::uint64_t count = 0;  // up to this cycle; 0 where the loss begins
};

// Read from a log that has what this version does not know.
struct UnknownInput {};

using InputContent = std::variant<OperatorCommand, DigitalInput, AnalogInput, SpindleInput, Overrun,
                                  LostInputs, TableTaking, UnknownInput>;

struct InputRecord {
  std::int64_t cycle = 0;
  std::int32_t channel = 0;  // 0: the machine
  InputContent content{};
};
static_assert(std::is_trivially_copyable_v<InputRecord>);

}  // namespace stanok::channels
