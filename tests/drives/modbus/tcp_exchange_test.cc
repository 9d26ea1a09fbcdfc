// Answers of Modbus TCP with every field of their head wrong: none is believed.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <functional>
#include <thread>

#include "drives/modbus/modbus_link.h"

namespace stanok::drives {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int unit = 7;

// Answers each request as `answer` says.
class Answering {
 public:
  explicit Answering(std::function<Bytes(const Bytes&)> answer) : answer_(std::move(answer)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    thread_ = std::thread([this] { serve(); });
  }
  ~Answering() {
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;

  [[nodiscard]] int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

 private:
  void serve() {
    for (int client = 0; (client = ::accept(listener_, nullptr, nullptr)) >= 0;) {
      Bytes request(MODBUS_TCP_MAX_ADU_LENGTH);
      for (ssize_t count = 0; (count = ::recv(client, request.data(), request.size(), 0)) > 0;) {
        const Bytes answer = answer_({request.begin(), request.begin() + count});
        ::send(client, answer.data(), answer.size(), MSG_NOSIGNAL);
      }
      ::close(client);
    }
  }

  std::function<Bytes(const Bytes&)> answer_;
  int listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
  std::thread thread_;
};

// To a request for two registers: 0x1234 and 0xFFFE.
Bytes right_answer(const Bytes& request) {
  return {request[0], request[1], 0, 0, 0, 7, request[6], 3, 4, 0x12, 0x34, 0xFF, 0xFE};
}

class TcpExchangeTest : public ::testing::Test {
 protected:
  // What the link says of two registers from register 5 on.
  std::optional<ExchangeError> outcome(std::function<Bytes(const Bytes&)> answer,
                                       ModbusRequest request = {
                                           .function = Function::read_registers, .read = {5, 2}}) {
    const Answering server(std::move(answer));
    BusConfig config;
    config.kind = BusKind::modbus_tcp;
    config.host = "127.0.0.1";
    config.port = server.port();
    ModbusLink link(config);
    link.wait_at_most(std::chrono::seconds(2));
    link.connect();
    EXPECT_TRUE(link.is_connected());
    image.assign(10, 0);
    return link.exchange(unit, std::span(&request, 1), image);
  }

  std::vector<std::uint16_t> image;
};

TEST_F(TcpExchangeTest, ReadsWhatTheUnitAnswers) {
  Bytes asked;
  EXPECT_EQ(outcome([&](const Bytes& request) {
              asked = request;
              return right_answer(request);
            }),
            std::nullopt);
  EXPECT_EQ(Bytes(asked.begin() + 2, asked.end()), (Bytes{0, 0, 0, 6, unit, 3, 0, 5, 0, 2}));
  EXPECT_EQ(image[5], 0x1234);
  EXPECT_EQ(image[6], 0xFFFE);
}

// Every byte of the head, the function and the count, with every other value.
TEST_F(TcpExchangeTest, BelievesNoAnswerWithAWrongHead) {
  for (std::size_t place = 0; place < 9; ++place) {
    for (const int wrong : {0, 1, 2, 6, 8, 127, 254, 255}) {
      bool is_right = false;
      const auto error = outcome([&](const Bytes& request) {
        Bytes answer = right_answer(request);
        is_right = answer[place] == wrong;
        answer[place] = static_cast<std::uint8_t>(wrong);
        answer.resize(60);  // whatever length is believed is there
        if (is_right) answer.resize(13);
        return answer;
      });
      EXPECT_EQ(error.has_value(), !is_right) << "byte " << place << " is " << wrong;
      EXPECT_TRUE(is_right || image[5] == 0) << "byte " << place << " is " << wrong;
    }
  }
}

TEST_F(TcpExchangeTest, TellsAnExceptionFromAWrongAnswer) {
  EXPECT_EQ(outcome([](const Bytes& request) {
              return Bytes{request[0], request[1], 0, 0, 0, 3, unit, 0x83, 2};
            }),
            ExchangeError::exception);
  EXPECT_EQ(outcome([](const Bytes& request) {
              return Bytes{request[0], request[1], 0, 0, 0, 3, unit + 1, 0x83, 2};
            }),
            ExchangeError::mangled);
}

// A write is answered with where it went.
TEST_F(TcpExchangeTest, BelievesNoWriteThatWentElsewhere) {
  const ModbusRequest write{.function = Function::write_registers, .written = {3, 2}};
  for (const int first : {3, 4}) {
    const auto error = outcome(
        [&](const Bytes& request) {
          return Bytes{request[0], request[1], 0,  0, 0,
                       6,          unit,       16, 0, static_cast<std::uint8_t>(first),
                       0,          2};
        },
        write);
    EXPECT_EQ(error.has_value(), first != 3);
  }
}

}  // namespace
}  // namespace stanok::drives
