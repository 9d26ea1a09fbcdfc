#include "daemon/operator_server.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <vector>

#include "daemon/orderly_end.h"
#include "daemon/session.h"
#include "daemon/signals.h"

namespace stanok::daemon {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
using LocalSocket = asio::local::stream_protocol;

constexpr auto tick_period = std::chrono::milliseconds(10);
// When the system has no descriptors left, accepting is tried again after this time.
constexpr auto accept_pause = std::chrono::milliseconds(100);

std::string oversize_line() {
  return protocol::failure_line(
      nullptr, {FailureKind::invalid_request, "E9001", "a request has at most 1 MiB", 0, {}});
}

json event_json(const channels::Event& event) {
  const auto text_or_null = [](std::string_view text) {
    return text.empty() ? json(nullptr) : json(text);
  };
  return {{"cycle", event.cycle},
          {"channel", event.channel},
          {"code", text_or_null(event.code.view())},
          {"text", event.text.view()},
          {"line", event.tag.line}};
}

}  // namespace

struct OperatorServer::Parts {
  Parts(ListeningSocket& socket, RunningMachine& machine, DaemonDescription description,
        ServerLimits given)
      : limits(given),
        acceptor(io, LocalSocket(), socket.release()),
        timer(io),
        pause(io),
        signals(io),
        dispatch(machine, std::move(description), [this] { begin_end("on request"); }),
        ending(machine) {
    for (const int number : ending_signals()) signals.add(number);
  }

  void accept();
  void admit(LocalSocket::socket socket);
  void answer_frame(Session& session, const protocol::Frame& frame);
  [[nodiscard]] std::size_t clients() const;
  bool make_room();
  void forget(int id);
  void await_signal();
  void begin_end(const std::string& why);
  void tick();
  void push_status(SteadyTime now);
  void drop_overdue(SteadyTime now);
  void push_event(const channels::Event& event);
  [[nodiscard]] std::vector<std::shared_ptr<Session>> all_sessions() const;

  ServerLimits limits;
  asio::io_context io{1};
  LocalSocket::acceptor acceptor;
  asio::steady_timer timer;
  asio::steady_timer pause;
  asio::signal_set signals;
  Dispatch dispatch;
  OrderlyEnd ending;
  std::map<int, std::shared_ptr<Session>> sessions;
  int last_session = 0;
};

void OperatorServer::Parts::accept() {
  acceptor.async_accept([this](const error_code& error, LocalSocket::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      admit(std::move(socket));
      return accept();
    }
    spdlog::warn("cannot accept a client: {}", error.message());
    pause.expires_after(accept_pause);
    pause.async_wait([this](const error_code& stopped) {
      if (!stopped) accept();
    });
  });
}

void OperatorServer::Parts::admit(LocalSocket::socket socket) {
  const auto session = std::make_shared<Session>(std::move(socket), ++last_session);
  const bool has_room = clients() < limits.clients_max || make_room();
  sessions.emplace(session->state().id, session);
  session->start([this](Session& from, const protocol::Frame& frame) { answer_frame(from, frame); },
                 [this](int id) { forget(id); });
  if (!has_room) return session->drop("E9008", "too many clients");
  dispatch.set_clients(clients());
  session->send(protocol::notification_line("hello", dispatch.hello(session->state())));
}

// Who has been told to go lingers until it has read that, but has no place any more.
std::size_t OperatorServer::Parts::clients() const {
  return static_cast<std::size_t>(
      std::count_if(sessions.begin(), sessions.end(),
                    [](const auto& entry) { return !entry.second->is_dropped(); }));
}

// Ends the session of the observer who has been here longest.
bool OperatorServer::Parts::make_room() {
  const auto observer = std::find_if(sessions.begin(), sessions.end(), [](const auto& entry) {
    return !entry.second->is_dropped() && entry.second->state().role == protocol::Role::observer;
  });
  if (observer == sessions.end()) return false;
  observer->second->drop("E9008", "an operator needs the place");
  return true;
}

void OperatorServer::Parts::forget(int id) {
  sessions.erase(id);
  dispatch.forget(id);
  dispatch.set_clients(clients());
}

void OperatorServer::Parts::answer_frame(Session& session, const protocol::Frame& frame) {
  if (frame.kind == protocol::FrameKind::oversize) return session.send(oversize_line());
  const auto request = protocol::parse_request(frame.text);
  if (!request)
    return session.send(protocol::failure_line(request.error().id, request.error().failure));
  const std::weak_ptr<Session> asker = session.weak_from_this();
  dispatch.handle(
      session.state(), *request,
      [asker, id = request->id, wanted = request->wants_answer](const Outcome& outcome) {
        const auto alive = asker.lock();
        if (!alive || !wanted) return;
        alive->send(outcome ? protocol::answer_line(id, *outcome)
                            : protocol::failure_line(id, outcome.error()));
      });
}

// Sessions may end while something is sent to them; the copy keeps the loop whole.
std::vector<std::shared_ptr<Session>> OperatorServer::Parts::all_sessions() const {
  std::vector<std::shared_ptr<Session>> all;
  all.reserve(sessions.size());
  for (const auto& [id, session] : sessions) all.push_back(session);
  return all;
}

void OperatorServer::Parts::tick() {
  timer.expires_after(tick_period);
  timer.async_wait([this](const error_code& error) {
    if (error) return;
    const auto now = std::chrono::steady_clock::now();
    dispatch.tick(now);
    push_status(now);
    drop_overdue(now);
    if (ending.step(now)) return io.stop();
    tick();
  });
}

void OperatorServer::Parts::push_status(SteadyTime now) {
  for (const auto& session : all_sessions()) {
    Subscription& subscription = session->state().subscription;
    if (!subscription.is_due(now) || !session->has_room_for_status()) continue;
    if (auto status = subscription.status(dispatch.snapshot(subscription), now)) {
      session->send(protocol::notification_line("status", *status));
    }
  }
}

void OperatorServer::Parts::drop_overdue(SteadyTime now) {
  for (const auto& session : all_sessions()) {
    if (session->has_overstayed(now)) {
      session->close();
    } else if (session->has_frame_begun_before(now - limits.frame_time_max)) {
      session->drop("E9001", "a request was begun and not finished in time");
    }
  }
}

void OperatorServer::Parts::push_event(const channels::Event& event) {
  for (const auto& session : all_sessions()) {
    Subscription& subscription = session->state().subscription;
    const bool is_elsewhere =
        subscription.channel() != 0 && event.channel != subscription.channel();
    if (!subscription.wants("events") || is_elsewhere) continue;
    json parameters = event_json(event);
    parameters["seq"] = subscription.next_seq();
    session->send(protocol::notification_line("event", parameters));
  }
}

void OperatorServer::Parts::await_signal() {
  signals.async_wait([this](const error_code& error, int number) {
    if (error) return;
    begin_end("by " + signal_name(number));
    await_signal();
  });
}

// A second reason hastens nothing: a terminal that is closed sends several signals.
void OperatorServer::Parts::begin_end(const std::string& why) {
  if (ending.has_begun()) return spdlog::info("asked to end {}, while ending", why);
  spdlog::info("ending {}: feed hold, then drives off", why);
  ending.begin(std::chrono::steady_clock::now());
}

OperatorServer::OperatorServer(ListeningSocket& socket, RunningMachine& machine,
                               DaemonDescription description, ServerLimits limits)
    : parts_(std::make_unique<Parts>(socket, machine, std::move(description), limits)) {
  parts_->await_signal();
}

OperatorServer::~OperatorServer() = default;

void OperatorServer::run() {
  parts_->accept();
  parts_->tick();
  parts_->io.run();
  for (const auto& session : parts_->all_sessions()) session->close();
}

void OperatorServer::end() {
  asio::post(parts_->io, [parts = parts_.get()] { parts->begin_end("on request"); });
}

void OperatorServer::on_event(const channels::Event& event) {
  asio::post(parts_->io, [parts = parts_.get(), event] { parts->push_event(event); });
}

void OperatorServer::on_reply(const channels::OperatorReply& reply) {
  asio::post(parts_->io, [parts = parts_.get(), reply] { parts->dispatch.on_reply(reply); });
}

}  // namespace stanok::daemon
