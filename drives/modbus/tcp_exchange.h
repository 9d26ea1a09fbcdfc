// TcpExchange: requests of Modbus TCP over a connection of libmodbus whose answers are looked at
// to the last field of their head.
//
// libmodbus believes an answer of any unit and of any length that its head says. Behind a gateway
// to serial lines the answer of another unit has positions of another axis. So the frames are made
// and taken apart here (Modbus Messaging on TCP/IP 1.0b, 3.1), and libmodbus connects, waits and
// receives. Errors are told in errno, as libmodbus does. Belongs to one thread.
#pragma once

#include <modbus/modbus.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drives/modbus/exchange_plan.h"
#include "drives/modbus/signal_exchange.h"

namespace stanok::drives {

class TcpExchange {
 public:
  // What is written comes from the image of the registers, what is read goes there. False: errno.
  [[nodiscard]] bool carry_out(modbus_t& context, int unit, const ModbusRequest& request,
                               std::span<std::uint16_t> image);
  [[nodiscard]] bool carry_out(modbus_t& context, SignalBlock& block);

 private:
  using Bytes = std::span<const std::uint8_t>;

  void begin(int unit, int function);
  void add(int word);
  void add(std::span<const std::uint16_t> words);
  void add_bits(Bytes bits);
  // Where and how much is written.
  [[nodiscard]] std::array<std::uint8_t, 4> last_four() const;
  // Sends it; the answer behind its function code. Nothing: errno.
  [[nodiscard]] std::optional<Bytes> ask(modbus_t& context);
  [[nodiscard]] bool is_answered_with(modbus_t& context, Bytes wanted);
  [[nodiscard]] bool read_registers(modbus_t& context, std::span<std::uint16_t> into);

  std::uint16_t transaction_ = 0;
  std::vector<std::uint8_t> request_;
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> answer_{};
};

}  // namespace stanok::drives
