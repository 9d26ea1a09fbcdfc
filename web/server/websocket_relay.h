// WebSocketRelay: what one WebSocket sees of the machine: messages of the daemon's protocol, passed
// on in both directions as they are; pages of geometry become binary frames (geometry_frame.h).
//
// Each has a connection of its own to the daemon, so that session, role, control, the lease of a
// jog and back-pressure stay the daemon's: when the browser goes, the connection goes, and with it
// what it held. Its first message is the key of the session, {"jsonrpc":
// "2.0", "method": "session.key", "params": {"key": ""}}, and stays here. The role is lowered to
// that of its user before another message of the browser is passed on. What begins motion is passed
// on only where it says which cycle was seen when it was asked for (E6073). Nothing is queued here:
// the next message is read when the last one is written, and who takes too long for that loses its
// connection.
//
// A stop goes over a connection of its own as well, so that it waits for nothing which this one has
// asked for, and is said to be unanswered within a second (E9016); where the daemon has no place,
// the browser is told so and its stops are passed on all the same. One thread.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/connection/machine_connection.h"
#include "web/access/sessions.h"
#include "web/server/answer.h"
#include "web/server/client_stream.h"

namespace stanok::web {

class WebSocketRelay : public std::enable_shared_from_this<WebSocketRelay> {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr auto step_time_max = std::chrono::seconds(10);
  // For a browser to end its side when the daemon has gone.
  static constexpr auto outlast_time_max = std::chrono::seconds(2);

  WebSocketRelay(std::shared_ptr<ClientStream> stream, WebSession session);

  // Whether it is the key of the session, which ends otherwise.
  using IsKey = std::function<bool(std::string_view key)>;

  // Takes the request for a WebSocket and serves it until one side ends.
  [[nodiscard]] boost::asio::awaitable<void> serve(Request request, std::filesystem::path socket,
                                                   IsKey is_key);

  [[nodiscard]] const WebSession& session() const { return session_; }
  // The browser does not take what is sent to it or shows no key, or the daemon does not greet.
  [[nodiscard]] bool is_stuck(Time now) const {
    return step_begun_ && now - *step_begun_ > step_time_max;
  }
  // At once; what is under way fails.
  void close();

 private:
  using WebSocket = boost::beast::websocket::stream<ClientStream&>;

  void set_bounds();
  [[nodiscard]] boost::asio::awaitable<bool> accept(Request request);
  [[nodiscard]] boost::asio::awaitable<bool> has_shown_key(IsKey is_key);
  [[nodiscard]] boost::asio::awaitable<std::optional<std::string>> next_message();
  [[nodiscard]] boost::asio::awaitable<bool> enter();
  [[nodiscard]] boost::asio::awaitable<bool> lower_role();
  enum class FrameKind { text, binary };
  [[nodiscard]] boost::asio::awaitable<bool> show(std::string message,
                                                  FrameKind kind = FrameKind::text);
  [[nodiscard]] boost::asio::awaitable<bool> pass(std::string line);
  [[nodiscard]] boost::asio::awaitable<void> turn_away(std::string code, std::string reason);
  [[nodiscard]] boost::asio::awaitable<bool> greet_without_place(std::string dropped);
  [[nodiscard]] boost::asio::awaitable<bool> take(std::string message);
  [[nodiscard]] bool may_stop_by(std::string_view message) const;
  [[nodiscard]] static boost::asio::awaitable<void> stop(std::shared_ptr<WebSocketRelay> self,
                                                         std::string message);
  [[nodiscard]] boost::asio::awaitable<void> pass_to_browser();
  [[nodiscard]] boost::asio::awaitable<void> outlast_browser();
  [[nodiscard]] static boost::asio::awaitable<void> pass_to_machine(
      std::shared_ptr<WebSocketRelay> self);

  std::shared_ptr<ClientStream> stream_;
  WebSocket websocket_;
  protocol::MachineConnection machine_;
  std::filesystem::path socket_;         // of the daemon
  bool has_place_ = false;               // there
  bool is_writing_ = false;              // show is under way
  boost::asio::steady_timer write_end_;  // cancelled when it ends
  bool is_reading_ = false;              // pass_to_machine is under way
  boost::asio::steady_timer read_end_;   // cancelled when it ends
  WebSession session_;
  boost::beast::flat_buffer received_;
  std::optional<Time> step_begun_;  // of what must not take long
};

}  // namespace stanok::web
