// ClientConnection: one connection of a browser: requests and answers, until it becomes a relay to
// the machine or ends.
//
// Bounded in every direction: time and size of a head, of a content, time to take an answer. One
// thread.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "base/expected.h"
#include "web/server/answer.h"
#include "web/server/client_stream.h"
#include "web/server/reception.h"
#include "web/server/websocket_relay.h"

namespace stanok::web {

// What all connections use; outlives them.
struct Services {
  Scheme scheme = Scheme::http;
  Reception& reception;
  Authentication& authentication;
  MachineList& machines;
  // Whether there is room for one more connection to the machine.
  std::function<bool(protocol::Role)> has_room_for_relay_of;
};

class ClientConnection : public std::enable_shared_from_this<ClientConnection> {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr unsigned head_bytes_max = 16U << 10;
  static constexpr unsigned content_bytes_max = 8U << 10;
  static constexpr auto head_time_max = std::chrono::seconds(10);
  static constexpr auto content_time_max = std::chrono::seconds(10);
  static constexpr auto answer_time_max = std::chrono::seconds(30);
  // For the rest of a request that was refused.
  static constexpr auto outlast_time_max = std::chrono::seconds(2);
  static constexpr std::size_t outlast_bytes_max = 1U << 20;

  ClientConnection(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls,
                   const Services& services);

  // Until the connection ends.
  [[nodiscard]] static boost::asio::awaitable<void> serve(std::shared_ptr<ClientConnection> self);

  // nullptr: it is none.
  [[nodiscard]] WebSocketRelay* relay() const { return relay_.get(); }
  // When it last asked something, or began.
  [[nodiscard]] Time asked() const { return asked_; }
  // At once; what is under way fails.
  void close();

 private:
  [[nodiscard]] boost::asio::awaitable<bool> begin();
  [[nodiscard]] boost::asio::awaitable<std::optional<Request>> read();
  [[nodiscard]] boost::asio::awaitable<void> refuse(boost::system::error_code error,
                                                    Request request);
  [[nodiscard]] boost::asio::awaitable<void> outlast();
  [[nodiscard]] boost::asio::awaitable<bool> write(const Answer& answer, const Request& request);
  [[nodiscard]] boost::asio::awaitable<bool> answer(const Request& request);
  // Who asks for a connection to which machine, or why there is none.
  struct Visit {
    WebSession session;
    std::filesystem::path socket;
  };
  [[nodiscard]] Expected<Visit, Answer> visit_of(const Request& request) const;
  [[nodiscard]] boost::asio::awaitable<void> open_relay(Request request);

  const Services& services_;
  std::shared_ptr<ClientStream> stream_;
  boost::beast::flat_buffer received_{head_bytes_max + content_bytes_max};
  std::shared_ptr<WebSocketRelay> relay_;
  Time asked_;
  boost::asio::ip::address from_;
};

}  // namespace stanok::web
