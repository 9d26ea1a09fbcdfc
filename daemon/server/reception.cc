#include "daemon/server/reception.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <thread>
#include <vector>

#include "daemon/desk/stop_desk.h"
#include "daemon/host/processor_share.h"
#include "daemon/host/real_time_rights.h"
#include "daemon/host/signals.h"
#include "daemon/server/orderly_end.h"
#include "daemon/server/session_list.h"

namespace stanok::daemon {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using protocol::FailureKind;
using LocalSocket = asio::local::stream_protocol;

constexpr int reception_priority = 70;  // below the cycle, above the drive buses
constexpr auto round = std::chrono::milliseconds(10);
constexpr auto cycle_wait = std::chrono::milliseconds(1);  // until the cycle may have replied
constexpr auto round_share = std::chrono::milliseconds(5);
// When the system has no descriptors left, accepting is tried again after this time.
constexpr auto accept_retry_pause = std::chrono::milliseconds(20);
// A stop is shorter; what is longer goes the way of all requests.
constexpr std::size_t stop_bytes_max = 4096;
// Who was turned away and sent a stop may wait for its answer.
constexpr auto answer_time = std::chrono::seconds(30);

std::string oversize_answer() {
  return protocol::failure_line(
      nullptr, {FailureKind::invalid_request, "E9001", "a request has at most 1 MiB", 0, {}});
}

// Descriptors that are given up for who knocks when the system has none left: it may be a stop.
class ReserveDescriptors {
 public:
  ReserveDescriptors() { fill_up(); }
  ~ReserveDescriptors() {
    while (give_up_one()) {
    }
  }
  ReserveDescriptors(const ReserveDescriptors&) = delete;
  ReserveDescriptors& operator=(const ReserveDescriptors&) = delete;

  [[nodiscard]] bool is_full() const { return count_ == descriptors_.size(); }
  void fill_up() {
    while (!is_full()) {
      const int descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
      if (descriptor < 0) return;
      descriptors_[count_++] = descriptor;
    }
  }
  bool give_up_one() {
    if (count_ == 0) return false;
    ::close(descriptors_[--count_]);
    return true;
  }

 private:
  std::array<int, 8> descriptors_{};
  std::size_t count_ = 0;
};

}  // namespace

struct Reception::Parts {
  Parts(ListeningSocket& socket, RunningMachine& used, Counter& told, const ServerLimits& given)
      : limits(given),
        machine(used),
        counter(told),
        acceptor(io, LocalSocket(), socket.release()),
        pause(io),
        signals(io),
        stops(used,
              [this](const channels::OperatorEvent& stop) { counter.on_stop_accepted(stop); }),
        ending(used, stops) {
    acceptor.non_blocking(true);
    for (const int number : ending_signals()) signals.add(number);
    await_signal();
  }

  void accept();
  void admit(LocalSocket::socket socket);
  void take_frame(Session& session, const protocol::TextFrame& frame);
  [[nodiscard]] bool take_stop(Session& session, const protocol::TextFrame& frame);
  void forget(int id);
  void await_signal();
  void begin_end(const std::string& why);
  void serve_one_round();
  [[nodiscard]] bool step_end();
  void drop_overdue();
  void close_all();

  ServerLimits limits;
  RunningMachine& machine;
  Counter& counter;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  LocalSocket::acceptor acceptor;
  asio::steady_timer pause;
  asio::signal_set signals;
  StopDesk stops;
  OrderlyEnd ending;
  ProcessorShare share{round_share, round};
  SessionList sessions;
  ReserveDescriptors reserve;
  std::atomic<bool> end_asked{false};
  std::atomic<bool> failed{false};
};

// Somebody must be there before accepting is tried: without descriptors it fails for nobody, too.
void Reception::Parts::accept() {
  acceptor.async_wait(LocalSocket::acceptor::wait_read, [this](const error_code& stopped) {
    if (stopped) return;
    LocalSocket::socket socket(io);
    error_code error;
    error = acceptor.accept(socket, error);
    if (!error) admit(std::move(socket));
    if (!error || error == asio::error::would_block) return accept();
    if (reserve.give_up_one() || sessions.end_oldest_turned_away(std::chrono::steady_clock::now()))
      return accept();
    spdlog::warn("cannot accept a client: {}", error.message());
    pause.expires_after(accept_retry_pause);
    pause.async_wait([this](const error_code& ended) {
      if (!ended) accept();
    });
  });
}

void Reception::Parts::admit(LocalSocket::socket socket) {
  const auto session =
      std::make_shared<Session>(std::move(socket), sessions.next_id(), limits.panel_user);
  const bool has_room =
      reserve.is_full() && (sessions.places_taken() < limits.clients_max || sessions.make_room());
  sessions.add(session);
  session->start(
      [this](Session& from, const protocol::TextFrame& frame) { take_frame(from, frame); },
      [this](int id) { forget(id); });
  if (has_room) {
    session->send(protocol::notification_line("hello", greeting(machine, session->state())));
    counter.on_arrival(session);
  } else {
    session->turn_away("E9008", "there are too many clients", channel_names(machine.file()));
    if (sessions.size() > limits.clients_max + limits.turned_away_max)
      static_cast<void>(sessions.end_oldest_turned_away(std::chrono::steady_clock::now()));
  }
  sessions.count_places();
}

void Reception::Parts::forget(int id) {
  sessions.forget(id);
  counter.on_departure(id);
}

void Reception::Parts::take_frame(Session& session, const protocol::TextFrame& frame) {
  if (frame.kind == protocol::FrameKind::oversize) return session.send(oversize_answer());
  if (take_stop(session, frame) || session.is_turned_away()) return;
  session.note_frame_handed_on();
  counter.on_frame(session.shared_from_this(), frame, {machine.stops_taken(), machine.cycles()});
}

// False: it is none. What cannot be read is answered where all requests are.
bool Reception::Parts::take_stop(Session& session, const protocol::TextFrame& frame) {
  if (frame.text.size() > stop_bytes_max) return false;
  const auto request = protocol::parse_request(frame.text);
  if (!request) return false;
  const auto answer = [this, asker = session.weak_from_this(),
                       request = *request](const CommandResult& outcome) {
    const auto alive = asker.lock();
    if (!alive) return;
    counter.on_stop_answered({alive->id(), alive->peer()}, request, outcome);
    if (!request.wants_answer) return;
    alive->send(outcome ? protocol::answer_line(request.id, *outcome)
                        : protocol::failure_line(request.id, outcome.error()));
  };
  const bool is_stop = stops.take(session.role(), *request, answer);
  if (is_stop && session.is_turned_away()) session.stay_for(answer_time);
  return is_stop;
}

void Reception::Parts::drop_overdue() {
  const auto now = std::chrono::steady_clock::now();
  for (const auto& session : sessions.all()) {
    if (session->has_overstayed(now)) {
      session->close();
    } else if (session->has_frame_begun_before(now - limits.frame_time_max)) {
      session->drop("E9001", "a request was not finished in time");
      sessions.count_places();
    }
  }
}

// At the end. Where memory has ended, those who are left are cut off with the process.
void Reception::Parts::close_all() {
  try {
    for (const auto& session : sessions.all()) session->close();
  } catch (const std::exception& fault) {
    spdlog::error("clients were not notified of the shutdown: {}", fault.what());
  }
}

void Reception::Parts::await_signal() {
  signals.async_wait([this](const error_code& error, int number) {
    if (error) return;
    begin_end("by " + signal_name(number));
    await_signal();
  });
}

// A second reason hastens nothing: a terminal that is closed sends several signals.
void Reception::Parts::begin_end(const std::string& why) {
  if (ending.has_begun())
    return spdlog::info("asked to end {} while it is already shutting down", why);
  ending.begin(std::chrono::steady_clock::now());
  spdlog::info("ending {}: feed hold, then drives off", why);
}

// Nothing here allocates: it must work when there is no memory left.
bool Reception::Parts::step_end() {
  const auto now = std::chrono::steady_clock::now();
  if (failed || end_asked.exchange(false)) {
    if (!ending.has_begun()) begin_end("on request");
  }
  return ending.step(now);
}

void Reception::Parts::serve_one_round() {
  const auto end = std::chrono::steady_clock::now() + round;
  for (auto now = std::chrono::steady_clock::now(); now < end;
       now = std::chrono::steady_clock::now()) {
    io.run_one_until(stops.waits_for_reply() ? std::min(end, now + cycle_wait) : end);
    while (const auto reply = machine.stop_reply()) stops.on_reply(*reply);
    share.rest_when_used_up();
  }
  stops.tick(std::chrono::steady_clock::now());
  drop_overdue();
  reserve.fill_up();
}

Reception::Reception(ListeningSocket& socket, RunningMachine& machine, Counter& counter,
                     const ServerLimits& limits)
    : parts_(std::make_unique<Parts>(socket, machine, counter, limits)) {}

Reception::~Reception() = default;

void Reception::run() {
  prefer_this_thread(reception_priority);
  parts_->accept();
  while (!parts_->step_end()) {
    try {
      parts_->serve_one_round();
    } catch (const std::exception& fault) {
      spdlog::critical("the reception of clients failed: {}; the machine is stopped", fault.what());
      parts_->failed = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  parts_->close_all();
  parts_->counter.on_end();
}

void Reception::end() {
  parts_->end_asked = true;
}

void Reception::fail() {
  parts_->failed = true;
}

bool Reception::has_failed() const {
  return parts_->failed;
}

std::size_t Reception::clients() const {
  return parts_->sessions.places_taken();
}

void Reception::listen_on(int descriptor) {
  asio::post(parts_->io, [parts = parts_.get(), descriptor] {
    error_code ignored;
    ignored = parts->acceptor.close(ignored);
    parts->acceptor = LocalSocket::acceptor(parts->io, LocalSocket(), descriptor);
    parts->acceptor.non_blocking(true);
    parts->accept();
  });
}

void Reception::on_reply(const channels::OperatorReply& reply) {
  asio::post(parts_->io, [parts = parts_.get(), reply] { parts->stops.on_reply(reply); });
}

}  // namespace stanok::daemon
