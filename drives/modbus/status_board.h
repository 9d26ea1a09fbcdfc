// StatusBoard: what operators are told of a bus.
//
// The bus thread writes, anybody reads, under a lock that the cycle never takes.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string_view>

#include "drives/bus.h"
#include "drives/bus_config.h"
#include "drives/bus_statistics.h"
#include "drives/modbus/axis_exchange.h"
#include "drives/modbus/bus_connection.h"
#include "drives/modbus/bus_sensor.h"

namespace stanok::drives {

class StatusBoard {
 public:
  StatusBoard(std::string_view endpoint, const BusConfig& config);

  void count_exchange(std::optional<ExchangeError> error, std::chrono::nanoseconds round_trip);
  void count_signal_request();
  void count_connection(BusConnection::Try tried);
  // A fault of stanok itself ended the round; no drive is in contact. Allocates nothing.
  void tell_own_fault(std::string_view reason);

  void set_connected(bool connected);
  // Drives and sensors by their place in the configuration.
  void tell_drive(std::size_t place, const AxisExchange& exchange);
  void tell_sensor(std::size_t place, const BusSensor& sensor);

  [[nodiscard]] BusStatus status() const;

 private:
  mutable std::mutex mutex_;
  BusStatus status_;
  RoundTripHistogram round_trips_;
};

}  // namespace stanok::drives
