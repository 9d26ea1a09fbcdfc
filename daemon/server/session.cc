#include "daemon/server/session.h"

#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

namespace stanok::daemon {
namespace {

namespace asio = boost::asio;

// How long a client that is dropped may take to read why.
constexpr auto last_word_time = std::chrono::seconds(2);

using boost::system::error_code;

// Who runs the daemon, and root, may do everything; others were let in by the socket's group.
protocol::Role role_of(const ucred& credentials, std::optional<uid_t> panel_user) {
  const bool is_owner =
      credentials.uid == getuid() || credentials.uid == 0 || credentials.uid == panel_user;
  return is_owner ? protocol::Role::integrator : protocol::Role::machine_operator;
}

SessionState state_of(Session::Socket& socket, int id, std::optional<uid_t> panel_user) {
  SessionState state;
  state.id = id;
  ucred credentials{};
  socklen_t size = sizeof credentials;
  if (getsockopt(socket.native_handle(), SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0) {
    state.role = role_of(credentials, panel_user);
    state.peer =
        "uid " + std::to_string(credentials.uid) + ", pid " + std::to_string(credentials.pid);
  } else {
    state.peer = "unknown";
  }
  return state;
}

}  // namespace

Session::Session(Socket socket, int id, std::optional<uid_t> panel_user)
    : socket_(std::move(socket)),
      state_(state_of(socket_, id, panel_user)),
      id_(id),
      peer_(state_.peer),
      role_(state_.role) {}

void Session::start(OnFrame on_frame, OnEnd on_end) {
  on_frame_ = std::move(on_frame);
  on_end_ = std::move(on_end);
  spdlog::debug("session {} ({}) begins as {}", id_, peer_, protocol::role_name(role()));
  read();
}

void Session::read() {
  socket_.async_read_some(asio::buffer(inflow_.received),
                          [self = shared_from_this()](const error_code& error, std::size_t bytes) {
                            if (error) return self->close();
                            self->take(bytes);
                            self->go_on();
                          });
}

void Session::go_on() {
  if (!socket_.is_open() || farewell_.dropping) return;
  inflow_.rests = inflow_.handed_on >= frames_handed_on_max;
  if (!inflow_.rests) read();
}

void Session::frame_is_done_soon() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] {
    --self->inflow_.handed_on;
    if (!self->inflow_.rests) return;
    self->inflow_.frame_begun = now();
    self->go_on();
  });
}

void Session::take(std::size_t bytes) {
  if (!inflow_.frames.is_within_frame()) inflow_.frame_begun = now();
  inflow_.frames.append({inflow_.received.data(), bytes});
  bool had_frame = false;
  while (const auto frame = inflow_.frames.next()) {
    if (farewell_.dropping || !socket_.is_open()) return;
    on_frame_(*this, *frame);
    had_frame = true;
  }
  if (had_frame) inflow_.frame_begun = now();
}

void Session::send(std::string line) {
  if (farewell_.dropping || !socket_.is_open()) return;
  const bool was_empty = output_.empty();
  if (!output_.push(std::move(line))) return drop("E9009", "the client does not read its messages");
  has_room_for_status_ = output_.has_room_for_status();
  if (was_empty) write();
}

void Session::send_soon(std::string line) {
  asio::post(socket_.get_executor(), [self = shared_from_this(), line = std::move(line)]() mutable {
    self->send(std::move(line));
  });
}

void Session::turn_away(const std::string& code, const std::string& reason,
                        const nlohmann::json& channels) {
  send(protocol::notification_line("dropped",
                                   {{"code", code}, {"reason", reason}, {"channels", channels}}));
  farewell_.turned_away = true;
  farewell_.begun = now();
  stay_for(last_word_time);
}

void Session::drop(const std::string& code, const std::string& reason) {
  if (farewell_.dropping || !socket_.is_open()) return;
  spdlog::warn("session {} ({}) is dropped: {}", id_, peer_, reason);
  const bool was_empty = output_.empty();
  output_.end_with(protocol::notification_line("dropped", {{"code", code}, {"reason", reason}}));
  farewell_.dropping = true;
  stay_for(last_word_time);
  if (was_empty) write();
}

void Session::write() {
  asio::async_write(socket_, asio::buffer(output_.front()),
                    [self = shared_from_this()](const error_code& error, std::size_t) {
                      if (error) return self->close();
                      self->output_.pop_front();
                      self->has_room_for_status_ = self->output_.has_room_for_status();
                      if (!self->output_.empty()) return self->write();
                      if (self->farewell_.dropping) self->close();
                    });
}

void Session::close() {
  error_code ignored;
  if (socket_.is_open()) {
    ignored = socket_.shutdown(Socket::shutdown_both, ignored);
    ignored = socket_.close(ignored);
    spdlog::debug("session {} ({}) ends", id_, peer_);
  }
  if (on_end_) std::exchange(on_end_, nullptr)(id_);
}

}  // namespace stanok::daemon
