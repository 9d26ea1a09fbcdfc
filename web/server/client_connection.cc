#include "web/server/client_connection.h"

#include <algorithm>
#include <array>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

namespace stanok::web {

namespace asio = boost::asio;
namespace http = boost::beast::http;

ClientConnection::ClientConnection(asio::ip::tcp::socket socket, asio::ssl::context* tls,
                                   const Services& services)
    : services_(services),
      stream_(std::make_shared<ClientStream>(std::move(socket), tls)),
      asked_(std::chrono::steady_clock::now()) {
  boost::system::error_code gone;
  from_ = stream_->next_layer().socket().remote_endpoint(gone).address();
}

asio::awaitable<void> ClientConnection::serve(std::shared_ptr<ClientConnection> self) {
  if (!co_await self->begin()) co_return;
  while (auto request = co_await self->read()) {
    self->asked_ = std::chrono::steady_clock::now();
    if (boost::beast::websocket::is_upgrade(*request)) {
      co_await self->open_relay(std::move(*request));
      break;
    }
    if (!co_await self->answer(*request)) break;
  }
  self->close();
}

asio::awaitable<bool> ClientConnection::begin() {
  if (stream_->tls() == nullptr) co_return true;
  stream_->next_layer().expires_after(head_time_max);
  const auto [error] = co_await stream_->tls()->async_handshake(
      asio::ssl::stream_base::server, asio::as_tuple(asio::use_awaitable));
  co_return !error;
}

// Nothing: the connection ends; who sent what cannot be read has been told.
asio::awaitable<std::optional<Request>> ClientConnection::read() {
  http::request_parser<http::string_body> parser;
  parser.header_limit(head_bytes_max);
  parser.body_limit(content_bytes_max);
  stream_->next_layer().expires_after(head_time_max);
  const auto [head_error, head_bytes] = co_await http::async_read_header(
      *stream_, received_, parser, asio::as_tuple(asio::use_awaitable));
  if (head_error) {
    co_await refuse(head_error, parser.release());
    co_return std::nullopt;
  }
  stream_->next_layer().expires_after(content_time_max);
  const auto [error, bytes] =
      co_await http::async_read(*stream_, received_, parser, asio::as_tuple(asio::use_awaitable));
  if (error) {
    co_await refuse(error, parser.release());
    co_return std::nullopt;
  }
  co_return parser.release();
}

asio::awaitable<void> ClientConnection::refuse(boost::system::error_code error, Request request) {
  const bool is_of_http =
      error.category() == http::make_error_code(http::error::bad_method).category();
  if (!is_of_http || error == http::error::end_of_stream || error == http::error::partial_message) {
    co_return;
  }
  request.keep_alive(false);
  const Answer answer =
      error == http::error::header_limit || error == http::error::buffer_overflow
          ? refusal(Status::request_header_fields_too_large,
                    "the header of the request is too long")
      : error == http::error::body_limit
          ? refusal(Status::payload_too_large, "the body of the request is too long")
          : refusal(Status::bad_request, "this is not an HTTP request: " + error.message());
  static_cast<void>(co_await write(answer, request));
  co_await outlast();
}

// What was sent and not read would take the answer with it when the connection ends.
asio::awaitable<void> ClientConnection::outlast() {
  boost::system::error_code ignored;
  ignored = stream_->next_layer().socket().shutdown(asio::socket_base::shutdown_send, ignored);
  stream_->next_layer().expires_after(outlast_time_max);
  std::array<char, 4096> thrown_away{};
  std::size_t left = outlast_bytes_max;
  while (left > 0) {
    const auto [error, bytes] = co_await stream_->next_layer().async_read_some(
        asio::buffer(thrown_away), asio::as_tuple(asio::use_awaitable));
    if (error) co_return;
    left -= std::min(left, bytes);
  }
}

asio::awaitable<bool> ClientConnection::write(const Answer& answer, const Request& request) {
  Response response = response_of(answer, request, services_.scheme);
  http::serializer<false, Response::body_type> serializer(response);
  stream_->next_layer().expires_after(answer_time_max);
  if (request.method() == http::verb::head) {
    const auto [error, bytes] = co_await http::async_write_header(
        *stream_, serializer, asio::as_tuple(asio::use_awaitable));
    co_return !error && response.keep_alive();
  }
  const auto [error, bytes] =
      co_await http::async_write(*stream_, serializer, asio::as_tuple(asio::use_awaitable));
  co_return !error && response.keep_alive();
}

asio::awaitable<bool> ClientConnection::answer(const Request& request) {
  if (const auto obstacle = services_.reception.obstacle(request))
    co_return co_await write(*obstacle, request);
  const Answer answer = co_await services_.reception.answer(request, from_);
  co_return co_await write(answer, request);
}

Expected<ClientConnection::Visit, Answer> ClientConnection::visit_of(const Request& request) const {
  const auto refused = [](Status status, const std::string& text) {
    return Unexpected<Answer>(refusal(status, text));
  };
  constexpr std::string_view prefix = "/ws/";  // and the name of a machine
  if (const auto obstacle = services_.reception.obstacle(request))
    return Unexpected<Answer>(*obstacle);
  const std::string_view path = path_of(request);
  const bool is_named = path.starts_with(prefix) && path.size() > prefix.size();
  if (path != "/ws" && !is_named)
    return refused(Status::not_found, "the path of the WebSocket is /ws");
  // Browsers always tell; nobody else may come with what a browser keeps.
  if (request.count(Field::origin) != 1)
    return refused(Status::forbidden, "a WebSocket needs the header Origin");
  const auto session = services_.authentication.session_of_cookie(request);
  if (!session) return refused(Status::unauthorized, "no session");
  if (!services_.has_room_for_relay_of(session->identity.role))
    return refused(Status::service_unavailable, "too many pages are open");
  const auto* machine = services_.machines.find(is_named ? path.substr(prefix.size()) : "");
  if (machine == nullptr) return refused(Status::not_found, "there is no such machine here");
  return Visit{*session, machine->socket()};
}

asio::awaitable<void> ClientConnection::open_relay(Request request) {
  auto visit = visit_of(request);
  if (!visit) {
    request.keep_alive(false);
    static_cast<void>(co_await write(visit.error(), request));
    co_return;
  }
  relay_ = std::make_shared<WebSocketRelay>(stream_, std::move(visit->session));
  const auto is_key = [this](std::string_view key) {
    return services_.authentication.is_key_of(relay_->session(), key);
  };
  co_await relay_->serve(std::move(request), visit->socket, is_key);
}

void ClientConnection::close() {
  if (relay_ != nullptr) {
    relay_->close();
  } else {
    stream_->close();
  }
}

}  // namespace stanok::web
