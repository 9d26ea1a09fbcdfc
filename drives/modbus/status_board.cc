#include "drives/modbus/status_board.h"

#include <string>

namespace stanok::drives {

StatusBoard::StatusBoard(std::string_view endpoint, const BusConfig& config) {
  status_.endpoint = std::string(endpoint);
  for (const AxisDriveConfig& drive : drives_of(config)) {
    status_.axes.push_back({.axis = drive.axis});
  }
  for (const VibrationSensorConfig& sensor : config.vibration_sensors) {
    status_.vibration.push_back({.sensor = sensor.name()});
  }
}

void StatusBoard::count_exchange(std::optional<ExchangeError> error,
                                 std::chrono::nanoseconds round_trip) {
  const std::scoped_lock lock(mutex_);
  ++status_.exchanges;
  if (error) {
    ++status_.errors[*error];
  } else {
    round_trips_.add(round_trip);
  }
}

void StatusBoard::count_signal_request() {
  const std::scoped_lock lock(mutex_);
  ++status_.signal_requests;
}

void StatusBoard::count_connection(BusConnection::Try tried) {
  const std::scoped_lock lock(mutex_);
  if (tried == BusConnection::Try::made) ++status_.connections;
  if (tried == BusConnection::Try::failed) ++status_.errors[ExchangeError::not_connected];
}

void StatusBoard::tell_own_fault(std::string_view reason) {
  const std::scoped_lock lock(mutex_);
  ++status_.errors[ExchangeError::own_fault];
  status_.own_fault = reason;
  status_.connected = false;
  for (AxisBusStatus& axis : status_.axes) axis.in_contact = false;
}

void StatusBoard::set_connected(bool connected) {
  const std::scoped_lock lock(mutex_);
  status_.connected = connected;
}

void StatusBoard::tell_drive(std::size_t place, const AxisExchange& exchange) {
  const DriveFeedback& feedback = exchange.feedback();
  const std::scoped_lock lock(mutex_);
  AxisBusStatus& status = status_.axes[place];
  status.in_contact = feedback.valid;
  status.answers = feedback.sequence;
  status.errors = exchange.contact().error_count();
  status.errors_by_kind = exchange.contact().errors();
  status.feedback = feedback;
}

void StatusBoard::tell_sensor(std::size_t place, const BusSensor& sensor) {
  const std::scoped_lock lock(mutex_);
  sensor.tell(status_.vibration[place]);
}

BusStatus StatusBoard::status() const {
  const std::scoped_lock lock(mutex_);
  BusStatus status = status_;
  status.round_trip = round_trips_.summary();
  return status;
}

}  // namespace stanok::drives
