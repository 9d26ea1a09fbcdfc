// Signals of programs on the bus: inputs and outputs of I/O modules and drives, digital and analog.
//
// M62 to M68 write outputs, $in[n], $ain[n] and M66 read inputs; a [[signal]] of the machine file
// says where one of them is on the bus (docs/integrator/drives.md#signals).
#pragma once

#include <cstdint>
#include <string>

#include "base/signals.h"
#include "drives/register_map.h"

namespace stanok::drives {

enum class SignalKind : std::uint8_t { digital_input, digital_output, analog_input, analog_output };

// The four tables of Modbus. Outputs are coils or holding registers.
enum class SignalTable : std::uint8_t { coil, discrete_input, holding_register, input_register };

struct SignalConfig {
  SignalKind kind = SignalKind::digital_input;
  int number = 0;  // of the program
  int unit = 1;
  SignalTable table = SignalTable::coil;
  int bit = 0;               // digital, in a register
  bool is_inverted = false;  // digital: on is 0 on the wire
  RegisterField field{};     // address; analog: width, sign, order, scale, offset

  [[nodiscard]] bool is_output() const {
    return kind == SignalKind::digital_output || kind == SignalKind::analog_output;
  }
  [[nodiscard]] bool is_digital() const {
    return kind == SignalKind::digital_input || kind == SignalKind::digital_output;
  }
  [[nodiscard]] bool is_of_bits() const {
    return table == SignalTable::coil || table == SignalTable::discrete_input;
  }
};

}  // namespace stanok::drives
