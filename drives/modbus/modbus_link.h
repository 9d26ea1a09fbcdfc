// One Modbus connection, TCP or RTU, over libmodbus: connect, exchange, close.
//
// After any error but a Modbus exception the connection is closed, because a late answer would be
// taken for the answer to the next request. Belongs to one thread.
#pragma once

#include <modbus/modbus.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drives/bus.h"
#include "drives/bus_config.h"

namespace stanok::drives {

class ModbusLink {
 public:
  ModbusLink(const BusConfig& config, std::chrono::microseconds response_timeout);
  ~ModbusLink();
  ModbusLink(const ModbusLink&) = delete;
  ModbusLink& operator=(const ModbusLink&) = delete;

  // Waits at most the response timeout. A link that could not be made is not connected.
  void connect();
  void close();
  [[nodiscard]] bool is_connected() const { return connected_; }

  // Function code 23: writes one block and reads the other in one request. Returns no error when
  // `answer` has been filled.
  [[nodiscard]] std::optional<ExchangeError> exchange(int unit, int write_register,
                                                      std::span<const std::uint16_t> command,
                                                      int read_register,
                                                      std::span<std::uint16_t> answer);

  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }

 private:
  struct Free {
    void operator()(modbus_t* context) const { modbus_free(context); }
  };
  std::unique_ptr<modbus_t, Free> context_;
  std::string endpoint_;
  bool connected_ = false;
};

}  // namespace stanok::drives
