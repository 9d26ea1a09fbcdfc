#include "client/operator/operator_client.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include "base/place.h"
#include "base/system_error.h"
#include "client/terminal/interrupts.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/method_table.h"
#include "protocol/contract/socket_location.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto hello_timeout = 5s;
// Answers may be longer than requests; what is longer than this is no answer of ours.
constexpr std::size_t answer_bytes_max = 64U << 20;

sockaddr_un address_of(const std::filesystem::path& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = socket.string();
  if (path.size() >= sizeof address.sun_path) {
    throw ConnectionError(path + ": the name of a socket has at most " +
                          std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  std::copy(path.begin(), path.end(), address.sun_path);
  return address;
}

int connected_descriptor(const std::filesystem::path& socket, ClientPurpose purpose) {
  const sockaddr_un address = address_of(socket);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) throw ConnectionError(socket.string() + ": " + system_error_text(errno));
  // A stop that stands in the row before a daemon which accepts nobody waits no longer than this.
  const timeval wait{.tv_sec = 1, .tv_usec = 0};
  if (purpose == ClientPurpose::stop)
    static_cast<void>(::setsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &wait, sizeof wait));
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    ::close(descriptor);
    if (error == EAGAIN)
      throw ConnectionError("the daemon at " + socket.string() +
                            " accepts no connection: nothing was sent");
    throw ConnectionError("no daemon at " + socket.string() + ": " + system_error_text(error));
  }
  return descriptor;
}

bool is_stop_method(std::string_view name) {
  const protocol::Method* method = protocol::find_method(name);
  return method != nullptr && method->effect == protocol::Effect::stops;
}

// For poll: -1 waits for ever; rounded up, so that the deadline has passed when poll gives up.
int milliseconds_until(const OperatorClient::Deadline& deadline) {
  if (!deadline) return -1;
  const auto rest =
      std::chrono::ceil<std::chrono::milliseconds>(*deadline - OperatorClient::Clock::now());
  return static_cast<int>(
      std::clamp<std::int64_t>(rest.count(), 0, std::numeric_limits<int>::max()));
}

}  // namespace

OperatorClient::OperatorClient(const std::filesystem::path& socket, ClientPurpose purpose)
    : descriptor_(connected_descriptor(socket, purpose)),
      purpose_(purpose),
      frames_(answer_bytes_max) {
  if (purpose_ == ClientPurpose::stop) return;
  try {
    await_greeting(socket);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

void OperatorClient::await_greeting(const std::filesystem::path& socket) {
  const auto first = receive(Clock::now() + hello_timeout);
  if (!first) throw ConnectionError(socket.string() + ": the daemon does not answer");
  if (const auto error = first->find("error"); error != first->end())
    throw ConnectionError(protocol::failure_from_json(*error).message);
  const json method = first->value("method", json());
  if (method != "hello" && method != "dropped")
    throw ConnectionError(socket.string() + ": what listens there is not a stanok daemon");
  hello_ = first->value("params", json::object());
  if (method == "dropped") turned_away_ = hello_.value("reason", "");
}

OperatorClient::~OperatorClient() {
  ::close(descriptor_);
}

Expected<json, protocol::Failure> OperatorClient::call(const std::string& method,
                                                       const json& parameters, Deadline deadline) {
  if (turned_away_ && !is_stop_method(method))
    throw ConnectionError("the daemon ended the connection: " + *turned_away_);
  send(protocol::request_line(++last_id_, method, parameters));
  return wait_on(method, deadline);
}

Expected<json, protocol::Failure> OperatorClient::wait_on(const std::string& method,
                                                          Deadline deadline) {
  while (const auto message = receive(deadline)) {
    if (message->value("id", json()) != last_id_) {
      deliver(*message);
    } else if (const auto error = message->find("error"); error != message->end()) {
      return Unexpected<protocol::Failure>(protocol::failure_from_json(*error));
    } else {
      return message->value("result", json());
    }
  }
  return Unexpected<protocol::Failure>(protocol::Failure{
      protocol::FailureKind::timed_out, "E9016", "no answer to " + method + " in time", 0, {}});
}

void OperatorClient::listen(Deadline deadline) {
  while (const auto message = receive(deadline)) deliver(*message);
}

void OperatorClient::deliver(const json& message) const {
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string()) return;
  const auto parameters = message.value("params", json::object());
  if (*method == "dropped") {
    if (purpose_ == ClientPurpose::stop) return;  // it is answered all the same
    throw ConnectionError("the daemon ended the connection: " + parameters.value("reason", ""));
  }
  if (listener_) listener_(method->get<std::string>(), parameters);
}

std::optional<json> OperatorClient::receive(Deadline deadline) {
  std::array<char, 65536> bytes;  // NOLINT: filled by recv
  while (true) {
    if (const auto frame = frames_.next()) {
      json message = protocol::json_from_text(frame->text);
      if (message.is_object()) return message;
      throw ConnectionError(
          "the answer is not JSON-RPC; check that --socket names the socket of a stanok daemon");
    }
    pollfd wanted{.fd = descriptor_, .events = POLLIN, .revents = 0};
    const int ready = is_interrupted() ? -1 : ::poll(&wanted, 1, milliseconds_until(deadline));
    if (is_interrupted()) throw Interrupted();
    if (ready == 0) return std::nullopt;
    if (ready < 0 && errno != EINTR)
      throw ConnectionError("connection lost: " + system_error_text(errno));
    if (ready < 0) continue;
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    if (count == 0) throw ConnectionError("connection lost: the daemon has gone");
    if (count < 0 && errno != EINTR)
      throw ConnectionError("connection lost: " + system_error_text(errno));
    if (count > 0) frames_.append({bytes.data(), checked_size(count)});
  }
}

void OperatorClient::send(const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t count = ::send(descriptor_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR)
      throw ConnectionError("connection lost: " + system_error_text(errno));
    if (count > 0) rest.remove_prefix(checked_size(count));
  }
}

std::filesystem::path choose_socket(const std::string& named) {
  const auto socket = protocol::chosen_socket(named);
  if (!socket) throw ConnectionError(socket.error());
  return *socket;
}

}  // namespace stanok::client
