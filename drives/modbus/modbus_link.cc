// Connections of libmodbus and what its error numbers mean.
#include "drives/modbus/modbus_link.h"

#include <cerrno>

#include "base/assert.h"

namespace stanok::drives {
namespace {

modbus_t* new_context(const BusConfig& config) {
  STANOK_ASSERT(config.kind != BusKind::none);
  if (config.kind == BusKind::modbus_rtu) {
    return modbus_new_rtu(config.device.c_str(), config.baud, 'N', 8, 1);
  }
  return modbus_new_tcp(config.host.c_str(), config.port);
}

std::string endpoint_of(const BusConfig& config) {
  if (config.kind == BusKind::modbus_rtu) {
    return config.device;
  }
  return config.host + ":" + std::to_string(config.port);
}

ExchangeError error_of(int error_number) {
  if (error_number == ETIMEDOUT) {
    return ExchangeError::timeout;
  }
  if (error_number >= EMBXILFUN && error_number <= EMBXGTAR) {
    return ExchangeError::exception;
  }
  return error_number > EMBXGTAR ? ExchangeError::mangled : ExchangeError::disconnected;
}

}  // namespace

ModbusLink::ModbusLink(const BusConfig& config, std::chrono::microseconds response_timeout)
    : context_(new_context(config)), endpoint_(endpoint_of(config)) {
  if (context_ == nullptr) {
    return;  // libmodbus refused the device or address: a link that never connects
  }
  const auto seconds = static_cast<std::uint32_t>(response_timeout.count() / 1'000'000);
  const auto microseconds = static_cast<std::uint32_t>(response_timeout.count() % 1'000'000);
  modbus_set_response_timeout(context_.get(), seconds, microseconds);
  modbus_set_byte_timeout(context_.get(), seconds, microseconds);
  modbus_set_error_recovery(context_.get(), MODBUS_ERROR_RECOVERY_NONE);
}

ModbusLink::~ModbusLink() {
  close();
}

void ModbusLink::connect() {
  close();
  connected_ = context_ != nullptr && modbus_connect(context_.get()) == 0;
  if (connected_) {
    modbus_flush(context_.get());
  }
}

void ModbusLink::close() {
  if (connected_) {
    modbus_close(context_.get());
    connected_ = false;
  }
}

std::optional<ExchangeError> ModbusLink::exchange(int unit, int write_register,
                                                  std::span<const std::uint16_t> command,
                                                  int read_register,
                                                  std::span<std::uint16_t> answer) {
  if (!connected_) {
    return ExchangeError::not_connected;
  }
  const int wanted = static_cast<int>(answer.size());
  modbus_set_slave(context_.get(), unit);
  const int received = modbus_write_and_read_registers(
      context_.get(), write_register, static_cast<int>(command.size()), command.data(),
      read_register, wanted, answer.data());
  if (received == wanted) {
    return std::nullopt;
  }
  const ExchangeError error = received == -1 ? error_of(errno) : ExchangeError::mangled;
  if (error != ExchangeError::exception) {
    close();
  }
  return error;
}

}  // namespace stanok::drives
