#include "web/server/websocket_relay.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <nlohmann/json.hpp>

#include "protocol/contract/discovery.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"
#include "protocol/contract/method_table.h"
#include "protocol/contract/version.h"
#include "web/server/geometry_frame.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using nlohmann::json;

// Requests of the page count from 1.
constexpr int id_of_role_request = 0;
constexpr auto open_time_max = std::chrono::seconds(10);
constexpr auto silence_max = std::chrono::seconds(30);
constexpr std::size_t stop_bytes_max = 4096;  // as in the daemon
// The page is told within a second.
constexpr auto stop_answered_within = std::chrono::milliseconds(900);

std::string without_line_end(std::string line) {
  if (line.ends_with('\n')) line.pop_back();
  return line;
}

// A frame is one message, as a line is on the socket: a line end in it is a blank between words.
std::string as_one_line(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return message;
}

protocol::Failure refusal_of(std::string code, std::string message) {
  return {protocol::FailureKind::refused, std::move(code), std::move(message), 0, {}};
}

// A network may have kept it: without what the page had seen it would be as new as its arrival.
bool hides_its_age(const protocol::RpcRequest& request) {
  const protocol::Method* method = protocol::find_method(request.method);
  if (method == nullptr || method->effect != protocol::Effect::begins_motion) return false;
  const auto given = protocol::checked_parameters(*method, request.parameters);
  return given && !given->contains("seen_cycle");
}

bool is_method(const json& message, const char* method) {
  return message.is_object() && message.value("method", json()) == method;
}

}  // namespace

WebSocketRelay::WebSocketRelay(std::shared_ptr<ClientStream> stream, WebSession session)
    : stream_(std::move(stream)),
      websocket_(*stream_),
      machine_(stream_->get_executor()),
      write_end_(stream_->get_executor(), asio::steady_timer::time_point::max()),
      read_end_(stream_->get_executor(), asio::steady_timer::time_point::max()),
      session_(std::move(session)) {}

void WebSocketRelay::set_bounds() {
  stream_->next_layer().expires_never();
  websocket::stream_base::timeout times{};
  times.handshake_timeout = open_time_max;
  times.idle_timeout = silence_max;
  times.keep_alive_pings = true;
  websocket_.set_option(times);
  websocket_.read_message_max(protocol::frame_bytes_max);
  websocket_.auto_fragment(false);
}

asio::awaitable<void> WebSocketRelay::serve(Request request, std::filesystem::path socket,
                                            IsKey is_key) {
  const bool is_accepted = co_await accept(std::move(request));
  if (!is_accepted) co_return close();
  const bool is_known = co_await has_shown_key(std::move(is_key));
  if (!is_known) co_return close();
  socket_ = std::move(socket);
  const bool has_entered = co_await enter();
  if (!has_entered) co_return close();
  is_reading_ = true;
  asio::co_spawn(stream_->get_executor(), pass_to_machine(shared_from_this()), asio::detached);
  if (has_place_) {
    co_await pass_to_browser();
  } else {
    static_cast<void>(co_await read_end_.async_wait(asio::as_tuple(asio::use_awaitable)));
  }
  close();
}

asio::awaitable<bool> WebSocketRelay::accept(Request request) {
  set_bounds();
  const auto [error] =
      co_await websocket_.async_accept(request, asio::as_tuple(asio::use_awaitable));
  websocket_.text(true);
  co_return !error;
}

// Who sends nothing has not used the cookie; any other message is one without the key.
asio::awaitable<bool> WebSocketRelay::has_shown_key(IsKey is_key) {
  step_begun_ = std::chrono::steady_clock::now();
  const auto message = co_await next_message();
  step_begun_.reset();
  if (!message) co_return false;
  const json shown = protocol::json_from_text(*message);
  const json parameters = is_method(shown, "session.key") ? shown.value("params", json()) : json();
  const json key = parameters.is_object() ? parameters.value("key", json()) : json();
  co_return is_key(key.is_string() ? key.get<std::string>() : std::string());
}

// Nothing: the browser has gone, or sent what is no text.
asio::awaitable<std::optional<std::string>> WebSocketRelay::next_message() {
  const auto [error, bytes] =
      co_await websocket_.async_read(received_, asio::as_tuple(asio::use_awaitable));
  if (error || !websocket_.got_text()) co_return std::nullopt;
  std::string message = boost::beast::buffers_to_string(received_.data());
  received_.consume(received_.size());
  co_return message;
}

// Connects to the daemon, lowers the role, and shows its greeting.
asio::awaitable<bool> WebSocketRelay::enter() {
  step_begun_ = std::chrono::steady_clock::now();  // until the greeting is written
  const bool is_connected = co_await machine_.connect(socket_);
  std::optional<std::string> greeting;
  if (is_connected) greeting = co_await machine_.next_line();
  if (!greeting) {
    co_await turn_away("", "no daemon answers at " + socket_.string());
    co_return false;
  }
  json hello = protocol::json_from_text(*greeting);
  if (is_method(hello, "dropped")) co_return co_await greet_without_place(std::move(*greeting));
  if (!is_method(hello, "hello")) {
    static_cast<void>(co_await show(*greeting));
    co_return false;
  }
  has_place_ = true;
  const bool is_lowered = co_await lower_role();
  if (!is_lowered) {
    co_await turn_away("", "the daemon did not accept the role of the user");
    co_return false;
  }
  const auto granted = protocol::role_named(hello["params"].value("role", ""));
  const auto role = std::min(granted.value_or(protocol::Role::observer), session_.identity.role);
  hello["params"]["role"] = protocol::role_name(role);
  hello["params"]["user"] = session_.identity.name;
  co_return co_await show(protocol::json_text(hello));
}

// The page needs a greeting to send stops, and is told why it gets nothing else.
asio::awaitable<bool> WebSocketRelay::greet_without_place(std::string dropped) {
  machine_.close();
  const json told = protocol::json_from_text(dropped)["params"];
  const json hello = {{"server", "stanokd"},
                      {"version", protocol::version},
                      {"api", protocol::api_version},
                      {"machine", ""},
                      {"cycle", 0},
                      {"channels", told.value("channels", json::array())},
                      {"session", 0},
                      {"role", protocol::role_name(session_.identity.role)},
                      {"user", session_.identity.name}};
  if (!co_await show(without_line_end(protocol::notification_line("hello", hello))))
    co_return false;
  co_return co_await show(std::move(dropped));
}

// Nothing of the browser is passed on before the daemon has answered this.
asio::awaitable<bool> WebSocketRelay::lower_role() {
  const json identity = {{"role", protocol::role_name(session_.identity.role)},
                         {"name", session_.identity.name}};
  const std::string request = protocol::request_line(id_of_role_request, "session.role", identity);
  if (!co_await machine_.send(without_line_end(request))) co_return false;
  while (const auto line = co_await machine_.next_line()) {
    const json answer = protocol::json_from_text(*line);
    if (!answer.is_object() || answer.value("id", json()) != id_of_role_request) continue;
    co_return answer.contains("result");
  }
  co_return false;
}

asio::awaitable<bool> WebSocketRelay::show(std::string message, FrameKind kind) {
  while (is_writing_)
    static_cast<void>(co_await write_end_.async_wait(asio::as_tuple(asio::use_awaitable)));
  is_writing_ = true;
  websocket_.text(kind == FrameKind::text);
  step_begun_ = std::chrono::steady_clock::now();
  const auto [error, bytes] =
      co_await websocket_.async_write(asio::buffer(message), asio::as_tuple(asio::use_awaitable));
  step_begun_.reset();
  is_writing_ = false;
  write_end_.cancel();
  co_return !error;
}

asio::awaitable<void> WebSocketRelay::turn_away(std::string code, std::string reason) {
  const json why = {{"code", code.empty() ? json() : json(code)}, {"reason", reason}};
  const std::string line = protocol::notification_line("dropped", why);
  if (!co_await show(without_line_end(line))) co_return;
  const websocket::close_reason close_reason(websocket::close_code::try_again_later);
  const auto [ignored] =
      co_await websocket_.async_close(close_reason, asio::as_tuple(asio::use_awaitable));
  static_cast<void>(ignored);
}

// The next page of a geometry is asked for when this one is written.
asio::awaitable<bool> WebSocketRelay::pass(std::string line) {
  auto geometry = geometry_of(line);
  if (!geometry) co_return co_await show(std::move(line));
  const bool is_told = co_await show(std::move(geometry->message));
  if (!is_told) co_return false;
  const bool is_shown = co_await show(std::move(geometry->frame), FrameKind::binary);
  if (!is_shown || geometry->more.empty()) co_return is_shown;
  co_return co_await machine_.send(std::move(geometry->more));
}

asio::awaitable<void> WebSocketRelay::pass_to_browser() {
  while (auto line = co_await machine_.next_line()) {
    const bool is_passed = co_await pass(std::move(*line));
    if (!is_passed) co_return;
  }
  co_await outlast_browser();
}

// Beast's own end of a WebSocket cannot be used while a message is read: when that fails meanwhile,
// each waits for the other for ever. What was written last gets lost when the connection ends with
// something unread.
asio::awaitable<void> WebSocketRelay::outlast_browser() {
  boost::system::error_code ignored;
  auto& socket = stream_->next_layer().socket();
  ignored = socket.shutdown(asio::socket_base::shutdown_send, ignored);
  if (!is_reading_) co_return;
  read_end_.expires_after(outlast_time_max);
  static_cast<void>(co_await read_end_.async_wait(asio::as_tuple(asio::use_awaitable)));
}

asio::awaitable<void> WebSocketRelay::pass_to_machine(std::shared_ptr<WebSocketRelay> self) {
  while (auto message = co_await self->next_message()) {
    if (!co_await self->take(as_one_line(std::move(*message)))) break;
  }
  // The daemon lets go of what this connection held, a jog first of all.
  self->machine_.close();
  self->is_reading_ = false;
  self->read_end_.cancel();
}

// False: the connection it would go to has ended. A stop goes both ways: at once, and behind what
// was asked for before it, the renewals of a jog; there it wants no answer.
asio::awaitable<bool> WebSocketRelay::take(std::string message) {
  if (may_stop_by(message)) {
    json again = protocol::json_from_text(message);
    again.erase("id");
    asio::co_spawn(stream_->get_executor(), stop(shared_from_this(), std::move(message)),
                   asio::detached);
    if (!has_place_) co_return true;
    message = protocol::json_text(again);
  }
  const auto request = protocol::parse_request(message);
  if (has_place_ && !(request && hides_its_age(*request)))
    co_return co_await machine_.send(std::move(message));
  if (request && !request->wants_answer) co_return true;
  const json id = request ? request->id : json();
  const protocol::Failure failure =
      has_place_
          ? refusal_of("E6073", "the page did not report which cycle it has seen (seen_cycle)")
          : refusal_of("E9008", "there are too many clients");
  co_return co_await show(without_line_end(protocol::failure_line(id, failure)));
}

// Refusals of a role are the daemon's, on the connection that has the role.
bool WebSocketRelay::may_stop_by(std::string_view message) const {
  if (message.size() > stop_bytes_max) return false;
  const auto request = protocol::parse_request(message);
  const protocol::Method* method = request ? protocol::find_method(request->method) : nullptr;
  return method != nullptr && method->effect == protocol::Effect::stops &&
         session_.identity.role >= method->role;
}

asio::awaitable<void> WebSocketRelay::stop(std::shared_ptr<WebSocketRelay> self,
                                           std::string message) {
  const auto request = protocol::parse_request(message);
  const auto executor = self->stream_->get_executor();
  const auto own = std::make_shared<protocol::MachineConnection>(executor);
  asio::steady_timer patience(executor, stop_answered_within);
  close_when_over(patience, own);
  const bool is_sent =
      co_await own->connect(self->socket_) && co_await own->send(std::move(message));
  if (is_sent) {
    while (auto line = co_await own->next_line()) {
      const json answer = protocol::json_from_text(*line);
      if (!answer.is_object() || answer.contains("method") || !request->wants_answer) continue;
      static_cast<void>(co_await self->show(std::move(*line)));
      co_return;
    }
  }
  if (!request->wants_answer) co_return;
  const std::string why = is_sent ? "the stop was sent but not answered" : "no daemon answers";
  const protocol::Failure failure{protocol::FailureKind::timed_out,
                                  "E9016",
                                  why + ": use the emergency stop of the machine",
                                  0,
                                  {}};
  static_cast<void>(
      co_await self->show(without_line_end(protocol::failure_line(request->id, failure))));
}

void WebSocketRelay::close() {
  machine_.close();
  stream_->close();
}

}  // namespace stanok::web
