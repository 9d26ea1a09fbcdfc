// Connections of libmodbus and what its error numbers mean.
#include "drives/modbus/modbus_link.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "base/assert.h"

namespace stanok::drives {
namespace {

// Devices answer within a second or not at all.
constexpr std::chrono::seconds late_at_most{1};

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

// Reads and forgets what arrives within the time. False: nothing did.
bool discard(int descriptor, std::chrono::milliseconds time) {
  pollfd line{.fd = descriptor, .events = POLLIN, .revents = 0};
  std::array<char, MODBUS_RTU_MAX_ADU_LENGTH> bytes{};
  return poll(&line, 1, static_cast<int>(time.count())) > 0 &&
         read(descriptor, bytes.data(), bytes.size()) > 0;
}

}  // namespace

ModbusLink::ModbusLink(const BusConfig& config)
    : context_(new_context(config)),
      endpoint_(endpoint_of(config)),
      is_serial_(config.kind == BusKind::modbus_rtu) {
  if (context_ == nullptr) {
    return;  // libmodbus refused the device or address: a link that never connects
  }
  modbus_set_error_recovery(context_.get(), MODBUS_ERROR_RECOVERY_NONE);
}

void ModbusLink::wait_at_most(std::chrono::nanoseconds time) {
  if (context_ == nullptr) {
    return;
  }
  constexpr std::int64_t second_us = 1'000'000;
  const std::int64_t time_us = std::chrono::ceil<std::chrono::microseconds>(time).count();
  const auto seconds = static_cast<std::uint32_t>(time_us / second_us);
  const auto microseconds = static_cast<std::uint32_t>(time_us % second_us);
  modbus_set_response_timeout(context_.get(), seconds, microseconds);
  modbus_set_byte_timeout(context_.get(), seconds, microseconds);
}

ModbusLink::~ModbusLink() {
  close();
}

void ModbusLink::connect() {
  close();
  connected_ = context_ != nullptr && modbus_connect(context_.get()) == 0;
  if (connected_) {
    if (std::exchange(answer_is_behind_, false)) discard_late_answer();
    modbus_flush(context_.get());
  }
}

// Until the line has been silent; no longer than other drives can do without it.
void ModbusLink::discard_late_answer() {
  using std::chrono::milliseconds;
  constexpr milliseconds awaited{20};
  constexpr milliseconds silence{5};  // above 3.5 characters at 9,600 baud
  constexpr int frames = 2;
  const int descriptor = modbus_get_socket(context_.get());
  if (!discard(descriptor, awaited)) return;
  for (int bytes = 0; bytes < frames * MODBUS_RTU_MAX_ADU_LENGTH; ++bytes) {
    if (!discard(descriptor, silence)) return;
  }
}

void ModbusLink::close() {
  if (connected_) {
    modbus_close(context_.get());
    connected_ = false;
  }
}

std::optional<ExchangeError> ModbusLink::exchange(int unit, std::span<const ModbusRequest> requests,
                                                  std::span<std::uint16_t> image) {
  if (!connected_) {
    return ExchangeError::not_connected;
  }
  modbus_set_slave(context_.get(), unit);
  for (const ModbusRequest& request : requests) {
    forget_what_was_not_asked();
    errno = 0;
    const bool is_done =
        is_serial_ ? carry_out(request, image) : tcp_.carry_out(*context_, unit, request, image);
    if (is_done) {
      continue;
    }
    return give_up();
  }
  return std::nullopt;
}

// By errno, which libmodbus set or left at 0.
ExchangeError ModbusLink::give_up() {
  const int error_number = errno;
  answer_is_behind_ = is_answer_of_before(error_number);
  const ExchangeError error = answer_is_behind_   ? ExchangeError::timeout
                              : error_number == 0 ? ExchangeError::mangled
                                                  : error_of(error_number);
  // An answer that is behind is late as well; a wrong check sum alone may be noise.
  if (error == ExchangeError::timeout && error_number != EMBBADCRC) {
    late_until_ = std::chrono::steady_clock::now() + late_at_most;
  }
  if (error != ExchangeError::exception) {
    close();
  }
  return error;
}

// A frame with a right check sum and another unit, function or length answers an earlier request.
// What has a wrong one may be the end of such an answer, soon after a time-out. The answer to the
// present request is then on its way.
bool ModbusLink::is_answer_of_before(int error_number) const {
  if (!is_serial_) return false;
  if (error_number != 0 && error_number != EMBBADCRC) return error_number > EMBXGTAR;
  return std::chrono::steady_clock::now() < late_until_;
}

// A serial line has no transaction numbers: what has arrived before a request goes out would be
// taken for its answer, and every later answer would be that of the request before.
void ModbusLink::forget_what_was_not_asked() {
  if (is_serial_) modbus_flush(context_.get());
}

std::optional<ExchangeError> ModbusLink::exchange(SignalBlock& block) {
  if (!connected_) {
    return ExchangeError::not_connected;
  }
  modbus_set_slave(context_.get(), block.unit);
  forget_what_was_not_asked();
  errno = 0;
  const bool is_done =
      is_serial_ ? carry_out(block) == block.count() : tcp_.carry_out(*context_, block);
  if (!is_done) {
    return give_up();
  }
  return std::nullopt;
}

int ModbusLink::carry_out(SignalBlock& block) {
  modbus_t* const context = context_.get();
  switch (block.table) {
    case SignalTable::coil:
      return block.is_output
                 ? modbus_write_bits(context, block.first, block.count(), block.bits.data())
                 : modbus_read_bits(context, block.first, block.count(), block.bits.data());
    case SignalTable::discrete_input:
      return modbus_read_input_bits(context, block.first, block.count(), block.bits.data());
    case SignalTable::holding_register:
      return block.is_output
                 ? modbus_write_registers(context, block.first, block.count(), block.words.data())
                 : modbus_read_registers(context, block.first, block.count(), block.words.data());
    case SignalTable::input_register:
      return modbus_read_input_registers(context, block.first, block.count(), block.words.data());
  }
  return -1;
}

// False: libmodbus set errno, or, with errno 0, the answer has not the length that was asked for.
bool ModbusLink::carry_out(const ModbusRequest& request, std::span<std::uint16_t> image) {
  const RegisterRun& written = request.written;
  const RegisterRun& read = request.read;
  std::uint16_t* const registers = image.data();
  switch (request.function) {
    case Function::read_registers:
      return modbus_read_registers(context_.get(), read.first, read.count,
                                   registers + read.first) == read.count;
    case Function::write_register:
      return modbus_write_register(context_.get(), written.first, registers[written.first]) == 1;
    case Function::write_registers:
      return modbus_write_registers(context_.get(), written.first, written.count,
                                    registers + written.first) == written.count;
    case Function::write_and_read_registers:
      return modbus_write_and_read_registers(context_.get(), written.first, written.count,
                                             registers + written.first, read.first, read.count,
                                             registers + read.first) == read.count;
  }
  return false;
}

}  // namespace stanok::drives
