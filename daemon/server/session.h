// Session: one client's connection: lines in, lines out, and what was agreed with it.
//
// Never waits and never throws into the server: a client that goes, hangs or floods ends its own
// session only. Lives as long as something of it is under way in Asio; belongs to the reception's
// thread, but for what says otherwise. Of what it hands on only so much is on its way at a time.
#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "daemon/desk/dispatch.h"
#include "daemon/server/output_queue.h"
#include "protocol/contract/frame_reader.h"

namespace stanok::daemon {

class Session : public std::enable_shared_from_this<Session> {
 public:
  using Socket = boost::asio::local::stream_protocol::socket;
  using Time = std::chrono::steady_clock::time_point;
  using OnFrame = std::function<void(Session& session, const protocol::TextFrame& frame)>;
  using OnEnd = std::function<void(int id)>;

  // Takes role and peer of the connection's credentials. `panel_user` may do everything, as who
  // runs the daemon: it knows its own users and lowers the role of each.
  Session(Socket socket, int id, std::optional<uid_t> panel_user = {});

  // `on_end` is called once, when no more frames will come.
  void start(OnFrame on_frame, OnEnd on_end);

  // Sends a line; a client that has not read for too long is dropped instead.
  void send(std::string line);
  // Any thread.
  void send_soon(std::string line);
  [[nodiscard]] bool has_room_for_status() const { return has_room_for_status_; }

  // A frame is handed on to another thread, which tells when it is done with it.
  void note_frame_handed_on() { ++inflow_.handed_on; }
  void frame_is_done_soon();  // any thread

  // Tells the client that it has no place, and the channels that it may stop. Until `drop_overdue`
  // ends it, frames still come.
  void turn_away(const std::string& code, const std::string& reason,
                 const nlohmann::json& channels);
  [[nodiscard]] bool is_turned_away() const { return farewell_.turned_away; }
  void stay_for(std::chrono::seconds time) { farewell_.last_word_until = now() + time; }

  // Tells the client why, and ends the session when it has read that, or at `last_word_until`.
  void drop(const std::string& code, const std::string& reason);
  [[nodiscard]] bool has_place() const { return !farewell_.dropping && !farewell_.turned_away; }
  // It was turned away, and has had the time to send a stop.
  [[nodiscard]] bool may_be_ended(Time now) const {
    return farewell_.turned_away && now > farewell_.begun + time_for_a_stop;
  }
  [[nodiscard]] bool has_overstayed(Time now) const {
    return !has_place() && now > farewell_.last_word_until;
  }
  void close();

  [[nodiscard]] int id() const { return id_; }
  [[nodiscard]] protocol::Role role() const { return role_; }      // any thread
  void note_role(protocol::Role role) { role_ = role; }            // any thread
  [[nodiscard]] const std::string& peer() const { return peer_; }  // any thread
  // The operator server's, once the session has arrived there.
  [[nodiscard]] SessionState& state() { return state_; }
  // Whether a frame has been begun before `time` and is not finished.
  [[nodiscard]] bool has_frame_begun_before(Time time) const {
    return inflow_.frames.is_within_frame() && !inflow_.rests && inflow_.frame_begun < time;
  }

 private:
  static constexpr int frames_handed_on_max = 16;
  static constexpr std::chrono::milliseconds time_for_a_stop{20};
  // What comes in.
  struct Inflow {
    std::array<char, 4096> received{};
    protocol::FrameReader frames;
    Time frame_begun{};
    int handed_on = 0;   // frames, and not done
    bool rests = false;  // reads on when some are done
  };
  // How the session ends.
  struct Farewell {
    bool dropping = false;
    bool turned_away = false;
    Time begun{};
    Time last_word_until{};
  };

  [[nodiscard]] static Time now() { return std::chrono::steady_clock::now(); }
  void read();
  void go_on();
  void take(std::size_t bytes);
  void write();

  Socket socket_;
  SessionState state_;
  int id_;
  std::string peer_;
  std::atomic<protocol::Role> role_;
  Inflow inflow_;
  OutputQueue output_;
  std::atomic<bool> has_room_for_status_{true};
  OnFrame on_frame_;
  OnEnd on_end_;
  Farewell farewell_;
};

}  // namespace stanok::daemon
