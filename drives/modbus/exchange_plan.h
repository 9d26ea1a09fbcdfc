// The requests of one exchange with a drive: as few as its register map and the functions it knows
// allow.
//
// Registers that follow each other are one run. A written run has no gap, since a gap would be
// written too; a read run may bridge gaps of at most `gap_max` registers. With function 23 a
// written and a read run go in one request, so a map of two blocks takes one trip. All writes come
// before the read of the echo, so that the echo is of this exchange. Where the control word is not
// next to the targets, it comes behind them when it lets the drive move, so that no drive is
// enabled with an old target, and before them when it stops the drive, so that a refused target
// delays no stop. Source: MODBUS Application Protocol V1.1b3, clauses 6.3, 6.6, 6.12, 6.17.
#pragma once

#include <cstdint>
#include <vector>

#include "drives/bus_config.h"
#include "drives/register_map.h"

namespace stanok::drives {

struct RegisterRun {
  int first = 0;
  int count = 0;

  [[nodiscard]] int end() const { return first + count; }
  bool operator==(const RegisterRun&) const = default;
};

enum class Function : std::uint8_t {
  read_registers = 3,
  write_register = 6,
  write_registers = 16,
  write_and_read_registers = 23,
};

struct ModbusRequest {
  Function function = Function::read_registers;
  RegisterRun written{};  // count 0: nothing
  RegisterRun read{};     // count 0: nothing

  bool operator==(const ModbusRequest&) const = default;
};

enum class WriteOrder : std::uint8_t { target_first, control_word_first };

[[nodiscard]] std::vector<ModbusRequest> exchange_plan(const AxisDriveConfig& drive,
                                                       WriteOrder order = WriteOrder::target_first);

// Only reads: how a drive is asked that has never answered.
[[nodiscard]] std::vector<ModbusRequest> look_plan(const AxisDriveConfig& drive);

}  // namespace stanok::drives
