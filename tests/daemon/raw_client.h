// RawClient: a client that can misbehave: sends any bytes, reads or does not read.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

namespace stanok::daemon {

class RawClient {
 public:
  explicit RawClient(const std::filesystem::path& socket) : RawClient() {
    EXPECT_TRUE(connect(socket));
  }
  ~RawClient() { ::close(descriptor_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  // A socket is there a moment before anybody listens to it.
  static bool is_answered(const std::filesystem::path& socket) {
    return RawClient().connect(socket);
  }

  // False when the other side has closed or takes no more.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
  void request(int id, const std::string& method,
               const nlohmann::json& parameters = nlohmann::json::object()) {
    send(nlohmann::json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", parameters}}
             .dump() +
         "\n");
  }
  // The next message; discarded when the connection has ended or ten seconds have passed.
  nlohmann::json receive() {
    std::size_t end = 0;
    while ((end = buffer_.find('\n')) == std::string::npos) {
      pollfd wanted{.fd = descriptor_, .events = POLLIN, .revents = 0};
      if (::poll(&wanted, 1, 10'000) != 1) return nlohmann::json::value_t::discarded;
      std::array<char, 65536> bytes{};
      const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
      if (count <= 0) return nlohmann::json::value_t::discarded;
      buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    auto message = nlohmann::json::parse(buffer_.substr(0, end), nullptr, false);
    buffer_.erase(0, end + 1);
    return message;
  }
  // The next message with this id, or of this method; others are passed over.
  nlohmann::json receive(const char* member, const nlohmann::json& value) {
    while (true) {
      auto message = receive();
      if (message.is_discarded() || message.value(member, nlohmann::json()) == value)
        return message;
    }
  }

 private:
  RawClient() : descriptor_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "socket");
  }
  bool connect(const std::filesystem::path& socket) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    socket.string().copy(address.sun_path, sizeof address.sun_path - 1);
    return ::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }

  int descriptor_ = -1;
  std::string buffer_;
};

}  // namespace stanok::daemon
