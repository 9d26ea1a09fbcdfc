// One Modbus connection, TCP or RTU, over libmodbus: connect, exchange, close.
//
// After any error but a Modbus exception the connection is closed, because a late answer would be
// taken for the answer to the next request. A serial line goes on carrying it: frames of RTU have
// no transaction number, so what arrives behind a time-out may belong to an earlier request. Where
// its sender shows that, it counts as a time-out, and the line is listened to until it is silent
// before the next request. Belongs to one thread.
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
#include "drives/modbus/exchange_plan.h"
#include "drives/modbus/signal_exchange.h"
#include "drives/modbus/tcp_exchange.h"

namespace stanok::drives {

class ModbusLink {
 public:
  explicit ModbusLink(const BusConfig& config);
  virtual ~ModbusLink();
  ModbusLink(const ModbusLink&) = delete;
  ModbusLink& operator=(const ModbusLink&) = delete;

  // The time limit of every answer from now on.
  void wait_at_most(std::chrono::nanoseconds time);

  // Waits at most that time. A link that could not be made is not connected.
  void connect();
  void close();
  [[nodiscard]] bool is_connected() const { return connected_; }

  // Makes the requests in their order until one fails. What is written comes from the image of
  // the registers (register n at place n), what is read goes there.
  [[nodiscard]] virtual std::optional<ExchangeError> exchange(
      int unit, std::span<const ModbusRequest> requests, std::span<std::uint16_t> image);

  // Reads the inputs of the block, or writes its outputs.
  [[nodiscard]] virtual std::optional<ExchangeError> exchange(SignalBlock& block);

  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }

 private:
  // On a serial line, whose answers libmodbus looks at itself.
  [[nodiscard]] bool carry_out(const ModbusRequest& request, std::span<std::uint16_t> image);
  [[nodiscard]] int carry_out(SignalBlock& block);
  [[nodiscard]] ExchangeError give_up();
  [[nodiscard]] bool is_answer_of_before(int error_number) const;
  void discard_late_answer();
  void forget_what_was_not_asked();

  struct Free {
    void operator()(modbus_t* context) const { modbus_free(context); }
  };
  std::unique_ptr<modbus_t, Free> context_;
  std::string endpoint_;
  bool is_serial_;
  TcpExchange tcp_;
  std::chrono::steady_clock::time_point late_until_{};  // an answer of before may arrive until then
  bool answer_is_behind_ = false;                       // to a request that met a late one
  bool connected_ = false;
};

}  // namespace stanok::drives
