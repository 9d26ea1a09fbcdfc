#include "gateway/cell/machine_reader.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <stdexcept>

#include "gateway/cell/topics.h"
#include "gateway/outbox/wall_clock.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::gateway {
namespace {

namespace asio = boost::asio;
using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto again_after = 1s;
// A daemon tells its state several times a second.
constexpr auto silence_max = 30s;
// Histories are asked for when the state says that there is something new, and now and then.
constexpr auto history_period_min = 250ms;
constexpr auto history_period_max = 30s;

json some_of(const json& object, std::initializer_list<const char*> names) {
  json some = json::object();
  for (const char* name : names) some[name] = object.value(name, json());
  return some;
}

// The same members of every channel, under its number.
json of_channels(const json& state, std::initializer_list<const char*> names) {
  json channels = json::object();
  const json all = state.value("channels", json::object());
  for (const auto& [number, channel] : all.items()) channels[number] = some_of(channel, names);
  return {{"channels", std::move(channels)}};
}

// What the spindles are asked for: what is measured never stays the same.
json ordered(const json& spindles) {
  json all = json::array();
  if (!spindles.is_array()) return all;
  for (const json& one : spindles)
    all.push_back(some_of(one, {"id", "direction", "commanded_rev_min"}));
  return all;
}

}  // namespace

MachineReader::MachineReader(const asio::any_io_executor& executor, MachineAddress address,
                             std::string prefix, double rate_hz, Outbox& outbox, StateBoard& board)
    : executor_(executor),
      address_(std::move(address)),
      prefix_(std::move(prefix)),
      rate_hz_(rate_hz),
      board_(board),
      events_(address_.name, outbox) {}

asio::awaitable<void> MachineReader::run() {
  std::string told;
  while (true) {
    std::string ended;
    try {
      connection_ = std::make_shared<protocol::MachineConnection>(executor_);
      co_await follow();
    } catch (const std::exception& error) {
      ended = error.what();
    }
    connection_->close();
    show(topic::state, {{"connected", false}});
    if (ended != told) spdlog::warn("{}: {}; trying again", address_.name, ended);
    told = ended;
    asio::steady_timer pause(executor_, again_after);
    co_await pause.async_wait(asio::as_tuple(asio::use_awaitable));
  }
}

asio::awaitable<void> MachineReader::follow() {
  state_ = followed_ = json();
  is_history_new_ = true;
  counted_ = Clock::now();
  if (!co_await connection_->connect(address_.socket))
    throw std::runtime_error("no daemon at " + address_.socket.string());
  co_await greet();
  spdlog::info("{}: connected to {}", address_.name, address_.socket.string());
  while (true) {
    take_notification(co_await next_message());
    const auto now = Clock::now();
    const bool is_due = is_history_new_ && now - read_ >= history_period_min;
    if (!state_.is_null() && (is_due || now - read_ >= history_period_max)) co_await read_history();
  }
}

asio::awaitable<void> MachineReader::greet() {
  const json hello = co_await next_message();
  if (hello.value("method", "") != "hello")
    throw std::runtime_error("the program that listens at " + address_.socket.string() +
                             " has no free connection for the gateway, or is not a daemon");
  json role{{"role", "observer"}, {"name", "stanok-gateway"}};
  static_cast<void>(co_await ask("session.role", std::move(role)));
  const auto asked = Clock::now();
  const json info = co_await ask("system.info", json::object());
  DaemonStart start = daemon_start(info.value("pid", 0), info.value("uptime_s", 0.0), asked);
  const json history = info.value("history", json());
  if (history.is_string()) start.history = history.get<std::string>();
  events_.meet(start);
  json subscription{{"topics", {"machine", "channels", "events"}}, {"rate_hz", rate_hz_}};
  static_cast<void>(co_await ask("subscribe", std::move(subscription)));
}

asio::awaitable<json> MachineReader::ask(std::string method, json parameters) {
  const int id = ++last_id_;
  std::string line = protocol::request_line(id, method, parameters);
  line.pop_back();
  if (!co_await connection_->send(std::move(line)))
    throw std::runtime_error("the connection was closed");
  while (true) {
    json message = co_await next_message();
    if (message.value("id", json()) != id) {
      take_notification(message);
    } else if (message.contains("error")) {
      throw std::runtime_error(method + ": " + message["error"].value("message", ""));
    } else {
      co_return message.value("result", json());
    }
  }
}

asio::awaitable<json> MachineReader::next_message() {
  asio::steady_timer patience(executor_, silence_max);
  patience.async_wait([waits = std::weak_ptr(connection_)](const boost::system::error_code& error) {
    if (const auto alive = waits.lock(); alive && !error) alive->close();
  });
  const auto line = co_await connection_->next_line();
  if (!line) throw std::runtime_error("the connection was closed");
  json message = protocol::json_from_text(*line);
  if (!message.is_object()) throw std::runtime_error("the answer of the daemon is not JSON");
  co_return message;
}

asio::awaitable<void> MachineReader::read_history() {
  is_history_new_ = false;
  read_ = Clock::now();
  const json runs = co_await ask("program.history", json::object());
  std::map<std::string, std::string> versions;
  for (const std::string& program : events_.new_programs(runs))
    versions[program] = co_await version_of(program);
  const json alarms = co_await ask("alarm.history", json::object());
  const json measurements = co_await ask("measurement.history", json::object());
  const json standing = co_await ask("alarm.list", json::object());
  try {
    events_.take_runs(runs, versions);
    events_.take_alarms(alarms);
    events_.take_measurements(measurements);
  } catch (const DatabaseError& error) {
    // The daemon remembers them, and is asked again.
    is_history_new_ = true;
    spdlog::error("{}: cannot store events, trying again: {}", address_.name, error.what());
  }
  json list = json::array();
  for (const json& alarm : standing.at("alarms"))
    list.push_back(
        some_of(alarm, {"channel", "code", "text", "file", "line", "reaction", "remedy"}));
  show(topic::alarms, {{"alarms", std::move(list)}});
  show(topic::parts, {{"programs", events_.parts()}});
  show(topic::tools, {{"tools", events_.tools()}});
}

// A part behind the end of the text: its version without its lines.
asio::awaitable<std::string> MachineReader::version_of(std::string program) {
  constexpr int behind_the_end = 1'000'000'000;
  json text;
  try {
    json part{{"program", program}, {"offset", behind_the_end}};
    text = co_await ask("program.read", std::move(part));
  } catch (const std::runtime_error&) {
    text = json();  // removed meanwhile, or a line of manual input
  }
  co_return text.is_object() ? text.value("version", "") : "";
}

void MachineReader::take_notification(const json& message) {
  const std::string method = message.value("method", "");
  if (method == "status") take_status(message.value("params", json::object()));
  if (method == "event") is_history_new_ = true;
}

void MachineReader::take_status(const json& parameters) {
  const json changed = parameters.value("state", json::object());
  if (parameters.value("full", false)) state_ = json::object();
  state_.merge_patch(changed);
  const json machine = state_.value("machine", json::object());
  const double cycle_s = 1e-6 * machine.value("cycle_us", 1000.0);
  events_.set_clock(wall_clock_s() - cycle_s * machine.value("cycle", 0.0), cycle_s);
  look_for_changes();
  count_tools();
  show_status();
}

void MachineReader::look_for_changes() {
  json followed = of_channels(state_, {"run", "program_status", "alarm"});
  if (followed == followed_) return;
  followed_ = std::move(followed);
  is_history_new_ = true;
}

void MachineReader::count_tools() {
  constexpr double longest_s = 2.0;  // what lasts longer was not seen
  const auto now = Clock::now();
  const double passed_s = std::chrono::duration<double>(now - counted_).count();
  counted_ = now;
  const json channels = state_.value("channels", json::object());
  for (const auto& [number, channel] : channels.items()) {
    const int tool = channel.value("tool", json::object()).value("number", 0);
    if (tool != 0 && channel.value("program_status", "") == "Running")
      events_.add_tool_time(tool, std::min(passed_s, longest_s));
  }
}

void MachineReader::show_status() {
  json state = of_channels(state_, {"state", "program_status", "held_by"});
  state.update(some_of(state_.value("machine", json::object()), {"on", "idle"}));
  state["connected"] = true;
  show(topic::state, std::move(state));
  json program = of_channels(
      state_, {"program", "file", "line", "block", "situation", "g_codes", "m_codes", "work_offset",
               "coolant", "tool", "spindles", "remaining_s", "override"});
  for (json& channel : program["channels"]) channel["spindles"] = ordered(channel["spindles"]);
  show(topic::program, std::move(program));
  show(topic::positions,
       of_channels(state_, {"position", "to_go", "situation", "units", "diameter", "feed_mm_min"}));
}

void MachineReader::show(std::string_view topic, json content) {
  board_.set(topic_of(prefix_, address_.name, topic), std::move(content));
}

}  // namespace stanok::gateway
