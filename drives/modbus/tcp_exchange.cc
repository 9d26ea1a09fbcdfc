#include "drives/modbus/tcp_exchange.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

#include "base/place.h"

namespace stanok::drives {
namespace {

constexpr std::size_t head = 7;  // transaction, protocol, length, unit
constexpr std::size_t length_at = 4;
constexpr std::size_t unit_at = 6;
constexpr std::size_t function_at = head;
constexpr std::uint8_t exception_bit = 0x80;

std::uint8_t high(int word) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(word) >> 8U);
}
std::uint8_t low(int word) {
  return static_cast<std::uint8_t>(word);
}
int word_at(std::span<const std::uint8_t> bytes, std::size_t place) {
  return bytes[place] * 256 + bytes[place + 1];
}

bool fail_with(int error) {
  errno = error;
  return false;
}

bool send_all(int socket, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) return false;
    if (sent > 0) bytes = bytes.subspan(checked_size(sent));
  }
  return true;
}

int function_of(const SignalBlock& block) {
  switch (block.table) {
    case SignalTable::coil:
      return block.is_output ? MODBUS_FC_WRITE_MULTIPLE_COILS : MODBUS_FC_READ_COILS;
    case SignalTable::discrete_input:
      return MODBUS_FC_READ_DISCRETE_INPUTS;
    case SignalTable::holding_register:
      return block.is_output ? MODBUS_FC_WRITE_MULTIPLE_REGISTERS
                             : MODBUS_FC_READ_HOLDING_REGISTERS;
    case SignalTable::input_register:
      break;
  }
  return MODBUS_FC_READ_INPUT_REGISTERS;
}

}  // namespace

void TcpExchange::begin(int unit, int function) {
  ++transaction_;
  request_ = {high(transaction_), low(transaction_), 0, 0, 0, 0, low(unit), low(function)};
}

void TcpExchange::add(int word) {
  request_.push_back(high(word));
  request_.push_back(low(word));
}

void TcpExchange::add(std::span<const std::uint16_t> words) {
  request_.push_back(low(static_cast<int>(2 * words.size())));
  for (const std::uint16_t word : words) add(word);
}

void TcpExchange::add_bits(Bytes bits) {
  std::vector<std::uint8_t> packed((bits.size() + 7) / 8);
  for (std::size_t k = 0; k < bits.size(); ++k)
    if (bits[k] != 0) packed[k / 8] = static_cast<std::uint8_t>(packed[k / 8] | 1U << (k % 8));
  request_.push_back(low(static_cast<int>(packed.size())));
  request_.insert(request_.end(), packed.begin(), packed.end());
}

std::array<std::uint8_t, 4> TcpExchange::last_four() const {
  std::array<std::uint8_t, 4> bytes{};
  std::copy(request_.end() - bytes.size(), request_.end(), bytes.begin());
  return bytes;
}

std::optional<TcpExchange::Bytes> TcpExchange::ask(modbus_t& context) {
  const int length = static_cast<int>(request_.size() - unit_at);
  request_[length_at] = high(length);
  request_[length_at + 1] = low(length);
  if (!send_all(modbus_get_socket(&context), request_)) return std::nullopt;
  const int received = modbus_receive_confirmation(&context, answer_.data());
  if (received < 0) return std::nullopt;
  const Bytes answer = Bytes(answer_).first(checked_size(received));
  const bool is_ours = answer.size() > function_at + 1 &&
                       std::equal(answer.begin(), answer.begin() + length_at, request_.begin()) &&
                       word_at(answer, length_at) == static_cast<int>(answer.size() - unit_at) &&
                       answer[unit_at] == request_[unit_at];
  if (is_ours && answer[function_at] == (request_[function_at] | exception_bit)) {
    errno = MODBUS_ENOBASE + answer[function_at + 1];
    return std::nullopt;
  }
  if (!is_ours || answer[function_at] != request_[function_at]) {
    errno = EMBBADDATA;
    return std::nullopt;
  }
  return answer.subspan(function_at + 1);
}

// The answer to a write repeats where and how much was written.
bool TcpExchange::is_answered_with(modbus_t& context, Bytes wanted) {
  const auto answer = ask(context);
  return answer && (std::ranges::equal(*answer, wanted) || fail_with(EMBBADDATA));
}

bool TcpExchange::read_registers(modbus_t& context, std::span<std::uint16_t> into) {
  const auto answer = ask(context);
  if (!answer) return false;
  if (answer->size() != 1 + 2 * into.size() || (*answer)[0] != 2 * into.size())
    return fail_with(EMBBADDATA);
  for (std::size_t k = 0; k < into.size(); ++k)
    into[k] = static_cast<std::uint16_t>(word_at(*answer, 1 + 2 * k));
  return true;
}

bool TcpExchange::carry_out(modbus_t& context, int unit, const ModbusRequest& request,
                            std::span<std::uint16_t> image) {
  const auto part = [&](const RegisterRun& run) {
    return image.subspan(place_of(run.first), place_of(run.count));
  };
  const RegisterRun& written = request.written;
  const RegisterRun& read = request.read;
  begin(unit, static_cast<int>(request.function));
  switch (request.function) {
    case Function::read_registers:
      add(read.first);
      add(read.count);
      return read_registers(context, part(read));
    case Function::write_register: {
      add(written.first);
      add(image[place_of(written.first)]);
      const auto wanted = last_four();
      return is_answered_with(context, wanted);
    }
    case Function::write_registers: {
      add(written.first);
      add(written.count);
      const auto wanted = last_four();
      add(std::span<const std::uint16_t>(part(written)));
      return is_answered_with(context, wanted);
    }
    case Function::write_and_read_registers:
      add(read.first);
      add(read.count);
      add(written.first);
      add(written.count);
      add(std::span<const std::uint16_t>(part(written)));
      return read_registers(context, part(read));
  }
  return fail_with(EINVAL);
}

bool TcpExchange::carry_out(modbus_t& context, SignalBlock& block) {
  begin(block.unit, function_of(block));
  add(block.first);
  add(block.count());
  if (block.is_output) {
    const auto wanted = last_four();
    block.words.empty() ? add_bits(block.bits) : add(std::span<const std::uint16_t>(block.words));
    return is_answered_with(context, wanted);
  }
  if (!block.words.empty()) return read_registers(context, block.words);
  const auto answer = ask(context);
  if (!answer) return false;
  const std::size_t bytes = (block.bits.size() + 7) / 8;
  if (answer->size() != 1 + bytes || (*answer)[0] != bytes) return fail_with(EMBBADDATA);
  for (std::size_t k = 0; k < block.bits.size(); ++k)
    block.bits[k] = static_cast<std::uint8_t>((*answer)[1 + k / 8] >> (k % 8) & 1U);
  return true;
}

}  // namespace stanok::drives
