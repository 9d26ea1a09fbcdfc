// A server of a few lines for one connection: what it says stands in the test.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <thread>

namespace stanok::client {

// Listens in a temporary directory and hands the one connection it takes to `talk`.
class FakeServer {
 public:
  explicit FakeServer(std::function<void(int)> talk) {
    std::string pattern = (std::filesystem::temp_directory_path() / "stanok-test-XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path().string().copy(address.sun_path, sizeof address.sun_path - 1);
    listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    thread_ = std::thread([this, talk = std::move(talk)] {
      const int connection = ::accept(listener_, nullptr, nullptr);
      talk(connection);
      ::close(connection);
    });
  }
  ~FakeServer() {
    thread_.join();
    ::close(listener_);
    std::filesystem::remove_all(directory_);
  }
  FakeServer(const FakeServer&) = delete;
  FakeServer& operator=(const FakeServer&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return directory_ / "fake.sock"; }

 private:
  std::filesystem::path directory_;
  int listener_ = -1;
  std::thread thread_;
};

inline void say(int connection, const std::string& line) {
  EXPECT_EQ(::send(connection, line.data(), line.size(), MSG_NOSIGNAL),
            static_cast<ssize_t>(line.size()));
}

// One line of the client; its content is not of interest here.
inline std::string heard(int connection) {
  std::string line;
  for (char c = 0; ::recv(connection, &c, 1, 0) == 1 && c != '\n';) line += c;
  return line;
}

inline const std::string hello =
    R"({"jsonrpc":"2.0","method":"hello","params":{"machine":"mill3"}})"
    "\n";

}  // namespace stanok::client
