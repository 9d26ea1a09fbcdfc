// The server's loop: poll, move the drives to now, answer.
#include "plant/modbus/modbus_server.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stop_token>
#include <utility>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::plant {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int pending_connections = 64;
constexpr std::chrono::milliseconds late_by{400};
// Without requests the drives are moved this often, so that their watchdogs run.
constexpr int idle_ms = 20;
// Longest wait for the rest of a request, and for a client to take its answer.
constexpr std::uint32_t patience_us = 50'000;

ServerError error(const std::string& what) {
  return ServerError(what + ": " + modbus_strerror(errno));
}

int bound_port(int socket) {
  sockaddr_in address{};
  socklen_t length = sizeof(address);
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length) != 0) {
    throw error("no port");
  }
  return ntohs(address.sin_port);
}

void set_patience(modbus_t* context) {
  modbus_set_byte_timeout(context, 0, patience_us);
  modbus_set_indication_timeout(context, 0, patience_us);
  // libmodbus sleeps this long before some exceptions.
  modbus_set_response_timeout(context, 0, 1000);
}

}  // namespace

ModbusServer::ModbusServer(ServerConfig config, const std::vector<SimulatedDriveConfig>& drives)
    : config_(std::move(config)),
      bank_(drives, config_.modules, 1.0 / config_.rate_hz),
      epoch_(Clock::now()) {
  STANOK_ASSERT(config_.rate_hz > 0.0);
}

ModbusServer::~ModbusServer() {
  stop();
}

void ModbusServer::start() {
  STANOK_ASSERT(!thread_.joinable());
  if (is_serial()) {
    open_serial_line();
  } else {
    listen();
  }
  set_patience(context_.get());
  wake_ = eventfd(0, EFD_CLOEXEC);
  STANOK_ASSERT(wake_ >= 0);
  thread_ = std::jthread([this](const std::stop_token& stop_requested) { run(stop_requested); });
}

void ModbusServer::listen() {
  context_.reset(modbus_new_tcp(config_.host.c_str(), config_.port));
  if (context_ == nullptr) {
    throw error(config_.host);
  }
  listener_ = modbus_tcp_listen(context_.get(), pending_connections);
  if (listener_ < 0) {
    throw error(config_.host + ":" + std::to_string(config_.port));
  }
  config_.port = bound_port(listener_);
}

void ModbusServer::open_serial_line() {
  context_.reset(modbus_new_rtu(config_.rtu_device.c_str(), config_.baud, 'N', 8, 1));
  if (context_ == nullptr || modbus_connect(context_.get()) != 0) {
    throw error(config_.rtu_device);
  }
  listener_ = modbus_get_socket(context_.get());
}

void ModbusServer::stop() {
  if (!thread_.joinable()) {
    return;
  }
  thread_.request_stop();
  thread_.join();
  hang_up();
  if (is_serial()) {
    modbus_set_socket(context_.get(), listener_);
    modbus_close(context_.get());
  } else {
    close(listener_);
  }
  close(wake_);
}

void ModbusServer::hang_up() noexcept {
  late_.clear();
  serial_requests_.clear();
  for (const int client : clients_) close(client);
  clients_.clear();
}

// The root of the thread. The drives go on to move, or trip their watchdogs, when it serves again.
void ModbusServer::run(const std::stop_token& stop_requested) {
  const std::stop_callback wake(stop_requested, [this] { eventfd_write(wake_, 1); });
  while (!stop_requested.stop_requested()) {
    try {
      serve_until(stop_requested);
    } catch (...) {
      hang_up();
      std::this_thread::sleep_for(std::chrono::milliseconds{idle_ms});
    }
  }
}

void ModbusServer::serve_until(const std::stop_token& stop_requested) {
  while (!stop_requested.stop_requested()) {
    std::vector<pollfd> polled = {{wake_, POLLIN, 0}, {listener_, POLLIN, 0}};
    for (const int client : clients_) {
      polled.push_back({client, POLLIN, 0});
    }
    const int ready = poll(polled.data(), polled.size(), poll_timeout_ms());
    bank_.advance_to(Clock::now() - epoch_);
    answer_late_ones();
    if (ready == 0) {
      serial_requests_.clear();  // silence ends a request that is not complete
      continue;
    }
    for (std::size_t i = 2; i < polled.size(); ++i) {
      if (polled[i].revents != 0 && serve_client(polled[i].fd) == Connection::ends) {
        drop(polled[i].fd);
      }
    }
    if (polled[1].revents != 0) {
      is_serial() ? serve_serial_line() : accept_client();
    }
  }
}

int ModbusServer::poll_timeout_ms() const {
  auto wait = std::chrono::milliseconds{idle_ms};
  for (const LateAnswer& late : late_) {
    wait = std::min(wait, std::chrono::ceil<std::chrono::milliseconds>(late.due - Clock::now()));
  }
  return static_cast<int>(std::max(wait, std::chrono::milliseconds{0}).count());
}

void ModbusServer::accept_client() {
  const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (client < 0) {
    return;
  }
  const int no_delay = 1;
  setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &no_delay, sizeof(no_delay));
  const timeval patience{.tv_sec = 0, .tv_usec = patience_us};
  setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
  try {
    clients_.push_back(client);
  } catch (...) {
    close(client);
    throw;
  }
}

void ModbusServer::drop(int socket) {
  if (std::erase(clients_, socket) > 0) {
    std::erase_if(late_, [&](const LateAnswer& late) { return late.socket == socket; });
    close(socket);
  }
}

ModbusServer::Connection ModbusServer::serve_client(int socket) {
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> buffer{};
  modbus_set_socket(context_.get(), socket);
  const int length = modbus_receive(context_.get(), buffer.data());
  if (length <= 0) {
    return length < 0 ? Connection::ends : Connection::goes_on;
  }
  return serve(socket, {buffer.begin(), buffer.begin() + length});
}

void ModbusServer::serve_serial_line() {
  std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> buffer{};
  const ssize_t length = read(listener_, buffer.data(), buffer.size());
  if (length <= 0) {
    return;
  }
  serial_requests_.append(std::span(buffer).first(checked_size(length)));
  while (auto request = serial_requests_.next()) {
    static_cast<void>(serve(listener_, std::move(*request)));
  }
}

ModbusServer::Connection ModbusServer::serve(int socket, std::vector<std::uint8_t> request) {
  const std::size_t header = checked_size(modbus_get_header_length(context_.get()));
  const auto kind = bank_.answer_kind(request[header - 1]);
  if (!kind) {
    return refuse_unknown_unit(socket, std::move(request));
  }
  switch (*kind) {
    case AnswerKind::none:
      return Connection::goes_on;
    case AnswerKind::hang_up:
      return Connection::ends;
    case AnswerKind::late:
      late_.push_back({Clock::now() + late_by, socket, std::move(request)});
      return Connection::goes_on;
    case AnswerKind::mangled:
      answer_mangled(socket, request);
      return Connection::goes_on;
    case AnswerKind::normal:
      break;
  }
  return answer(socket, request);
}

ModbusServer::Connection ModbusServer::answer(int socket,
                                              const std::vector<std::uint8_t>& request) {
  const std::size_t header = checked_size(modbus_get_header_length(context_.get()));
  const std::size_t trailer = is_serial() ? 2 : 0;
  const auto pdu = std::span(request).subspan(header, request.size() - header - trailer);
  modbus_mapping_t* registers = bank_.registers_after(request[header - 1], pdu);
  modbus_set_socket(context_.get(), socket);
  const int sent =
      modbus_reply(context_.get(), request.data(), static_cast<int>(request.size()), registers);
  return sent < 0 ? Connection::ends : Connection::goes_on;
}

// On a serial line other units may live, so nobody answers for them.
ModbusServer::Connection ModbusServer::refuse_unknown_unit(int socket,
                                                           std::vector<std::uint8_t> request) {
  if (is_serial()) {
    return Connection::goes_on;
  }
  modbus_set_socket(context_.get(), socket);
  const int sent =
      modbus_reply_exception(context_.get(), request.data(), MODBUS_EXCEPTION_GATEWAY_TARGET);
  return sent < 0 ? Connection::ends : Connection::goes_on;
}

// A frame that is too short and, on TCP, belongs to another transaction; on RTU its CRC is wrong.
void ModbusServer::answer_mangled(int socket, const std::vector<std::uint8_t>& request) {
  std::vector<std::uint8_t> frame(request.begin(), request.begin() + 8);
  if (!is_serial()) {
    frame[0] = static_cast<std::uint8_t>(frame[0] + 1);  // transaction id
    frame[5] = 2;                                        // bytes that follow the header
  }
  const ssize_t sent = is_serial() ? write(socket, frame.data(), frame.size())
                                   : send(socket, frame.data(), frame.size(), MSG_NOSIGNAL);
  static_cast<void>(sent);  // whether it arrives matters to nobody
}

void ModbusServer::answer_late_ones() {
  const auto now = Clock::now();
  std::vector<LateAnswer> due;
  const auto is_due = [&](const LateAnswer& late) { return late.due <= now; };
  std::copy_if(late_.begin(), late_.end(), std::back_inserter(due), is_due);
  std::erase_if(late_, is_due);
  for (const LateAnswer& late : due) {
    const bool is_here = is_serial() || std::ranges::count(clients_, late.socket) > 0;
    if (is_here && answer(late.socket, late.request) == Connection::ends) {
      drop(late.socket);
    }
  }
}

}  // namespace stanok::plant
