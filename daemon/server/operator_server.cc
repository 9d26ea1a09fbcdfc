#include "daemon/server/operator_server.h"

#include <spdlog/spdlog.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "daemon/desk/stop_desk.h"
#include "daemon/server/frame_turns.h"
#include "daemon/server/session.h"
#include "protocol/contract/discovery.h"
#include "protocol/contract/json_text.h"
#include "protocol/contract/version.h"

namespace stanok::daemon {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using nlohmann::json;

constexpr auto tick_period = std::chrono::milliseconds(10);
constexpr auto socket_look_period = std::chrono::milliseconds(500);

// The description of all methods is long and always the same: as answer_line makes it, of a text
// that is made once.
std::string discovery_line(const json& id) {
  static const std::string text =
      protocol::json_text(protocol::discovery_document(protocol::version));
  return R"({"id":)" + protocol::json_text(id) + R"(,"jsonrpc":"2.0","result":)" + text + "}\n";
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

struct OperatorServer::Parts final : Counter {
  Parts(ListeningSocket& listening, RunningMachine& machine, DaemonDescription description,
        const ServerLimits& limits)
      : reception(listening, machine, *this, limits),
        timer(io),
        socket(listening),
        dispatch(machine, std::move(description), [this] { reception.end(); }) {}

  // From the reception's thread.
  void on_arrival(std::shared_ptr<Session> session) override;
  void on_frame(std::shared_ptr<Session> session, protocol::TextFrame frame,
                const AskedAt& asked_at) override;
  void on_departure(int session) override;
  void on_stop_answered(const Asker& asker, const protocol::RpcRequest& request,
                        const CommandResult& outcome) override {
    dispatch.command_log().note(asker, request, outcome);
  }
  void on_stop_accepted(const channels::OperatorEvent& stop) override;
  void on_end() override { io.stop(); }

  void answer_frame(const std::shared_ptr<Session>& session, const protocol::TextFrame& frame,
                    const AskedAt& asked_at);
  void serve_turns();
  void serve_turn();
  void serve();
  void tick();
  void look_after_socket(SteadyTime now);
  void push_status(SteadyTime now);
  void push_event(const channels::Event& event);

  // First: what the other members still hold of its sessions goes before it.
  Reception reception;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> work{io.get_executor()};
  asio::steady_timer timer;
  ListeningSocket& socket;
  SteadyTime next_look_at_socket{};
  Dispatch dispatch;
  FrameTurns turns;
  bool is_turn_posted = false;
  std::map<int, std::shared_ptr<Session>> sessions;
};

void OperatorServer::Parts::on_arrival(std::shared_ptr<Session> session) {
  asio::post(io,
             [this, session = std::move(session)] { sessions.emplace(session->id(), session); });
}

void OperatorServer::Parts::on_frame(std::shared_ptr<Session> session, protocol::TextFrame frame,
                                     const AskedAt& asked_at) {
  asio::post(io, [this, session = std::move(session), frame = std::move(frame), asked_at] {
    const auto precedence =
        session->role() == protocol::Role::observer ? Precedence::looks_on : Precedence::works;
    turns.add(session->id(), precedence, [this, session, frame, asked_at] {
      answer_frame(session, frame, asked_at);
      session->frame_is_done_soon();
    });
    serve_turns();
  });
}

// Behind what it has asked for before.
void OperatorServer::Parts::on_departure(int session) {
  asio::post(io, [this, session] {
    turns.add(session, Precedence::works, [this, session] {
      sessions.erase(session);
      dispatch.forget(session);
      turns.forget(session);
    });
    serve_turns();
  });
}

// One turn at a time, so that what has come meanwhile is looked at before the next one.
void OperatorServer::Parts::serve_turns() {
  if (is_turn_posted || !turns.has_waiting()) return;
  is_turn_posted = true;
  asio::post(io, [this] {
    is_turn_posted = false;
    try {
      serve_turn();
    } catch (...) {
      serve_turns();
      throw;
    }
    serve_turns();
  });
}

void OperatorServer::Parts::serve_turn() {
  const auto turn = turns.next();
  if (!turn) return;
  const auto begun = std::chrono::steady_clock::now();
  turn->task();
  turns.charge(turn->session, std::chrono::steady_clock::now() - begun);
}

void OperatorServer::Parts::on_stop_accepted(const channels::OperatorEvent& stop) {
  asio::post(io, [this, stop] { dispatch.note_stop(stop); });
}

void OperatorServer::Parts::answer_frame(const std::shared_ptr<Session>& session,
                                         const protocol::TextFrame& frame,
                                         const AskedAt& asked_at) {
  const auto request = protocol::parse_request(frame.text);
  if (!request) {
    return session->send_soon(protocol::failure_line(request.error().id, request.error().failure));
  }
  if (request->method == "rpc.discover" && request->parameters.empty() && request->wants_answer)
    return session->send_soon(discovery_line(request->id));
  dispatch.set_clients(reception.clients());
  session->state().asked_at = asked_at;
  dispatch.handle(session->state(), *request,
                  [asker = std::weak_ptr<Session>(session), id = request->id,
                   wanted = request->wants_answer](const CommandResult& outcome) {
                    const auto alive = asker.lock();
                    if (alive) alive->note_role(alive->state().role);
                    if (!alive || !wanted) return;
                    alive->send_soon(outcome ? protocol::answer_line(id, *outcome)
                                             : protocol::failure_line(id, outcome.error()));
                  });
}

void OperatorServer::Parts::tick() {
  timer.expires_after(tick_period);
  timer.async_wait([this](const error_code& error) {
    if (error) return;
    tick();
    const auto now = std::chrono::steady_clock::now();
    dispatch.tick(now);
    push_status(now);
    look_after_socket(now);
  });
}

// A file that somebody has removed keeps no new client out for long.
void OperatorServer::Parts::look_after_socket(SteadyTime now) {
  if (now < next_look_at_socket) return;
  next_look_at_socket = now + socket_look_period;
  if (socket.is_there()) return;
  try {
    socket.renew();
    spdlog::error("the socket {} was removed; a new one was created", socket.path().string());
    reception.listen_on(socket.release());
  } catch (const SocketError& error) {
    spdlog::error("the socket was removed: {}; the daemon tries again", error.what());
  }
}

void OperatorServer::Parts::push_status(SteadyTime now) {
  // However many look at the same.
  std::map<std::pair<json, int>, json> snapshots;
  for (const auto& [id, session] : sessions) {
    Subscription& subscription = session->state().subscription;
    if (!subscription.is_due(now) || !session->has_room_for_status()) continue;
    const auto [snapshot, is_new] =
        snapshots.try_emplace({subscription.topics(), subscription.channel()});
    if (is_new) snapshot->second = dispatch.snapshot(subscription);
    if (auto status = subscription.status(snapshot->second, now)) {
      session->send_soon(protocol::notification_line("status", *status));
    }
  }
}

void OperatorServer::Parts::push_event(const channels::Event& event) {
  for (const auto& [id, session] : sessions) {
    Subscription& subscription = session->state().subscription;
    const bool is_elsewhere =
        subscription.channel() != 0 && event.channel != subscription.channel();
    if (!subscription.wants("events") || is_elsewhere) continue;
    json parameters = event_json(event);
    parameters["seq"] = subscription.next_seq();
    session->send_soon(protocol::notification_line("event", parameters));
  }
}

// Until the reception ends it. A fault costs the request that led to it; the machine is stopped.
void OperatorServer::Parts::serve() {
  while (!io.stopped()) {
    try {
      io.run();
    } catch (const std::exception& fault) {
      reception.fail();
      spdlog::critical("the operator server failed: {}; the machine is stopped", fault.what());
    }
  }
}

OperatorServer::OperatorServer(ListeningSocket& socket, RunningMachine& machine,
                               DaemonDescription description, ServerLimits limits)
    : parts_(std::make_unique<Parts>(socket, machine, std::move(description), limits)) {}

OperatorServer::~OperatorServer() = default;

void OperatorServer::run() {
  const std::jthread reception([parts = parts_.get()] { parts->reception.run(); });
  parts_->tick();
  parts_->serve();
}

void OperatorServer::end() {
  parts_->reception.end();
}

void OperatorServer::fail() {
  parts_->reception.fail();
}

bool OperatorServer::has_failed() const {
  return parts_->reception.has_failed();
}

void OperatorServer::on_event(const channels::Event& event) {
  asio::post(parts_->io, [parts = parts_.get(), event] {
    parts->dispatch.on_event(event);
    parts->push_event(event);
  });
}

void OperatorServer::on_reply(const channels::OperatorReply& reply) {
  if (StopDesk::is_ours(reply)) return parts_->reception.on_reply(reply);
  asio::post(parts_->io, [parts = parts_.get(), reply] { parts->dispatch.on_reply(reply); });
}

}  // namespace stanok::daemon
