// Session: one client's connection: lines in, lines out, and what was agreed with it.
//
// Never waits and never throws into the server: a client that goes, hangs or floods ends its own
// session only. Lives as long as something of it is under way in Asio; belongs to the server's
// thread.
#pragma once

#include <array>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "daemon/dispatch.h"
#include "daemon/output_queue.h"
#include "protocol/frame_reader.h"

namespace stanok::daemon {

class Session : public std::enable_shared_from_this<Session> {
 public:
  using Socket = boost::asio::local::stream_protocol::socket;
  using Time = std::chrono::steady_clock::time_point;
  using OnFrame = std::function<void(Session& session, const protocol::Frame& frame)>;
  using OnEnd = std::function<void(int id)>;

  // Takes id, role and peer of the connection's credentials.
  Session(Socket socket, int id);

  // `on_end` is called once, when no more frames will come.
  void start(OnFrame on_frame, OnEnd on_end);

  // Sends a line; a client that has not read for too long is dropped instead.
  void send(std::string line);
  [[nodiscard]] bool has_room_for_status() const { return output_.has_room_for_status(); }

  // Tells the client why, and ends the session when it has read that, or at `last_word_until`.
  void drop(const std::string& code, const std::string& reason);
  [[nodiscard]] bool is_dropped() const { return dropping_; }
  [[nodiscard]] bool has_overstayed(Time now) const { return dropping_ && now > last_word_until_; }
  void close();

  [[nodiscard]] SessionState& state() { return state_; }
  // Whether a frame has been begun before `time` and is not finished.
  [[nodiscard]] bool has_frame_begun_before(Time time) const {
    return frames_.is_within_frame() && frame_begun_ < time;
  }

 private:
  void read();
  void take(std::size_t bytes);
  void write();

  Socket socket_;
  SessionState state_;
  protocol::FrameReader frames_;
  Time frame_begun_{};
  OutputQueue output_;
  std::array<char, 16384> received_{};
  OnFrame on_frame_;
  OnEnd on_end_;
  bool dropping_ = false;
  Time last_word_until_{};
};

}  // namespace stanok::daemon
