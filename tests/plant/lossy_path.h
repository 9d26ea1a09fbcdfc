// A way between a bus and its drives on which requests are lost: a relay of TCP on loopback.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <random>
#include <thread>

namespace stanok::plant {

// What happens to a request that is lost.
enum class Loss { dropped, connection_closed };

// Carries one connection at a time; each request is lost with the given probability.
class LossyPath {
 public:
  LossyPath(int server_port, Loss loss, double share, unsigned seed)
      : server_port_(server_port), loss_(loss), lost_(share), random_(seed) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(0);
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_, 8), 0);
    thread_ = std::jthread([this](const std::stop_token& stop) { carry(stop); });
  }
  ~LossyPath() {
    thread_.request_stop();
    thread_.join();
    close(listener_);
  }
  LossyPath(const LossyPath&) = delete;
  LossyPath& operator=(const LossyPath&) = delete;

  [[nodiscard]] int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }
  [[nodiscard]] std::uint64_t requests() const { return requests_; }
  [[nodiscard]] std::uint64_t losses() const { return losses_; }

 private:
  enum class Relay { goes_on, ends };

  static sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
  }

  static bool has_data(int socket) {
    pollfd waiting{.fd = socket, .events = POLLIN, .revents = 0};
    return poll(&waiting, 1, 5) == 1;
  }

  void carry(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (!has_data(listener_)) continue;
      const int client = accept(listener_, nullptr, nullptr);
      const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      sockaddr_in address = loopback(server_port_);
      if (connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
        while (!stop.stop_requested() && relay(client, server) == Relay::goes_on) {
        }
      }
      close(server);
      close(client);
    }
  }

  Relay relay(int client, int server) {
    std::array<pollfd, 2> ends = {{{client, POLLIN, 0}, {server, POLLIN, 0}}};
    poll(ends.data(), ends.size(), 20);
    std::array<char, 512> bytes{};
    if (ends[0].revents != 0) {
      const ssize_t count = read(client, bytes.data(), bytes.size());
      if (count <= 0) return Relay::ends;
      ++requests_;
      if (lost_(random_)) {
        ++losses_;
        return loss_ == Loss::dropped ? Relay::goes_on : Relay::ends;
      }
      if (write(server, bytes.data(), static_cast<std::size_t>(count)) != count) return Relay::ends;
    }
    if (ends[1].revents != 0) {
      const ssize_t count = read(server, bytes.data(), bytes.size());
      if (count <= 0) return Relay::ends;
      if (send(client, bytes.data(), static_cast<std::size_t>(count), MSG_NOSIGNAL) != count)
        return Relay::ends;
    }
    return Relay::goes_on;
  }

  int server_port_;
  Loss loss_;
  std::bernoulli_distribution lost_;
  std::minstd_rand random_;
  int listener_ = -1;
  std::atomic<std::uint64_t> requests_{0};
  std::atomic<std::uint64_t> losses_{0};
  std::jthread thread_;
};

}  // namespace stanok::plant
