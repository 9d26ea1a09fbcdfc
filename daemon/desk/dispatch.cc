#include "daemon/desk/dispatch.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>

#include "daemon/desk/drive_report.h"
#include "daemon/desk/inventory.h"
#include "daemon/desk/operator_command.h"
#include "daemon/desk/table_loading.h"
#include "protocol/discovery.h"
#include "protocol/json_text.h"
#include "protocol/version.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
using protocol::Method;

constexpr double usual_rate_hz = 10.0;

Unexpected<Failure> fail(FailureKind kind, const char* code, std::string text, int channel = 0) {
  return Unexpected<Failure>(Failure{kind, code, std::move(text), channel, {}});
}

}  // namespace

void log_command(const SessionState& session, const protocol::Request& request,
                 const Outcome& outcome) {
  const std::string parameters = protocol::json_text(request.parameters);
  if (outcome) {
    spdlog::info("session {} ({}): {} {}: done", session.id, session.peer, request.method,
                 parameters);
  } else {
    spdlog::warn("session {} ({}): {} {}: {} {}", session.id, session.peer, request.method,
                 parameters, outcome.error().code, outcome.error().message);
  }
}

json greeting(const config::MachineFile& file, const SessionState& session) {
  json channels = json::array();
  for (const auto& channel : file.machine.channels) {
    channels.push_back({{"id", channel.id}, {"name", channel.name}});
  }
  return {{"server", "stanokd"},
          {"version", protocol::version},
          {"api", protocol::api_version},
          {"machine", file.machine.name},
          {"channels", std::move(channels)},
          {"session", session.id},
          {"role", protocol::role_name(session.role)}};
}

Dispatch::Dispatch(RunningMachine& machine, DaemonDescription description,
                   std::function<void()> on_shutdown)
    : machine_(machine),
      description_(std::move(description)),
      on_shutdown_(std::move(on_shutdown)),
      desk_(machine, notes_),
      report_(machine, notes_),
      started_(std::chrono::steady_clock::now()) {}

const std::map<std::string_view, Dispatch::Query>& Dispatch::queries() {
  static const std::map<std::string_view, Query> table = {
      {"machine.status", [](Dispatch& d, const json&) { return d.report_.machine(); }},
      {"channel.list", [](Dispatch& d, const json&) { return d.report_.channel_list(); }},
      {"channel.status",
       [](Dispatch& d, const json& p) { return d.report_.channel(d.channel_or_first(p)); }},
      {"program.list",
       [](Dispatch& d, const json&) { return program_list(d.machine_.program_root()); }},
      {"program.history",
       [](Dispatch& d, const json& p) { return d.report_.program_history(p.value("channel", 0)); }},
      {"kinematics.list",
       [](Dispatch& d, const json& p) { return d.report_.kinematics_list(d.channel_or_first(p)); }},
      {"kinematics.status",
       [](Dispatch& d, const json& p) { return d.report_.kinematics(d.channel_or_first(p)); }},
      {"process.status",
       [](Dispatch& d, const json& p) { return d.report_.process(d.channel_or_first(p)); }},
      {"drive.list", [](Dispatch& d, const json&) { return drive_list(d.machine_); }},
      {"drive.status", [](Dispatch& d, const json&) { return drive_status(d.machine_); }},
      {"alarm.list",
       [](Dispatch& d, const json& p) { return d.report_.alarms_standing(p.value("channel", 0)); }},
      {"alarm.history",
       [](Dispatch& d, const json& p) { return d.report_.alarm_history(p.value("channel", 0)); }},
      {"tool.list", [](Dispatch& d, const json&) { return tool_list(d.machine_); }},
      {"tool.save", [](Dispatch& d, const json&) { return tables_text(d.machine_); }},
      {"offset.list", [](Dispatch& d, const json&) { return offset_list(d.machine_); }},
      {"workpiece.status", [](Dispatch& d, const json&) { return workpiece_status(d.machine_); }},
      {"log.status", [](Dispatch& d, const json&) { return log_status(d.machine_); }},
      {"system.info", [](Dispatch& d, const json&) { return d.system_info(); }},
      {"rpc.discover",
       [](Dispatch&, const json&) { return protocol::discovery_document(protocol::version); }},
  };
  return table;
}

void Dispatch::handle(SessionState& session, const protocol::Request& request, Answer answer) {
  const Method* method = protocol::find_method(request.method);
  const auto parameters = admitted_parameters(machine_.file(), session.role, method, request);
  if (!parameters) return answer(Unexpected<Failure>(parameters.error()));
  if (!method->action.empty()) {
    // Sessions may go before the answer comes; the log entry must not need them.
    return command(session, *method, *parameters,
                   [who = session, request, answer = std::move(answer)](const Outcome& outcome) {
                     log_command(who, request, outcome);
                     answer(outcome);
                   });
  }
  if (const auto query = queries().find(method->name); query != queries().end()) {
    return answer(query->second(*this, *parameters));
  }
  if (method->name == "tool.get") return answer(tool_get(*parameters));
  if (method->name == "tool.load") return load_tables(session, *parameters, std::move(answer));
  if (method->name == "channel.control")
    return control_channel(session, *parameters, std::move(answer));
  if (protocol::noun(*method) == "log") {
    const Outcome outcome = method->name == "log.start" ? start_log() : stop_log();
    log_command(session, request, outcome);
    return answer(outcome);
  }
  if (protocol::noun(*method) == "drive") {
    const auto obstacle = control_.obstacle_to_all(session.id);
    const Outcome outcome =
        obstacle ? Unexpected<Failure>(*obstacle) : command_drive(*method, *parameters);
    log_command(session, request, outcome);
    return answer(outcome);
  }
  if (method->name == "workpiece.allow") {
    const bool allowed = parameters->value("on", 1) != 0;
    machine_.allow_workpieces(allowed);
    log_command(session, request, json());
    return answer(json{{"allowed", allowed}});
  }
  if (method->name == "system.shutdown") {
    log_command(session, request, json());
    answer(json{{"accepted", true}});
    return on_shutdown_();
  }
  answer(change_session(session, *method, *parameters));
}

void Dispatch::forget(int session) {
  control_.forget(session);
  note_control();
  tell_control();
}

void Dispatch::note_control() {
  for (const auto& channel : machine_.file().machine.channels)
    notes_[channel.id].controlled_by = control_.holder(channel.id);
}

// Answered when the cycle knows it: from then on nothing of others begins there.
void Dispatch::control_channel(const SessionState& session, const json& parameters, Answer answer) {
  const int channel = channel_or_first(parameters);
  const bool takes = parameters.value("on", 1) != 0;
  const auto obstacle = takes ? control_.take(channel, session) : std::nullopt;
  if (obstacle) return answer(Unexpected<Failure>(*obstacle));
  if (!takes) control_.give_back(channel, session.id);
  note_control();
  tell_control(channel, [this, channel, takes, id = session.id,
                         answer = std::move(answer)](const Outcome& outcome) {
    if (!outcome && takes) {
      control_.give_back(channel, id);
      note_control();
    }
    if (!outcome) return answer(outcome);
    answer(json{{"channel", channel}, {"controlled_by", control_.holder(channel)}});
  });
}

// Sessions end without a word, and an order may find no room: what the cycle was not told yet.
void Dispatch::tell_control() {
  for (const auto& channel : machine_.file().machine.channels) {
    if (told_control_[channel.id] != control_.session_with(channel.id))
      tell_control(channel.id, [](const Outcome&) {});
  }
}

void Dispatch::tell_control(int channel, Answer answer) {
  constexpr int not_known = -1;
  channels::OperatorEvent event;
  event.action = channels::OperatorAction::channel_control;
  event.channel = channel;
  event.number = control_.session_with(channel);
  told_control_[channel] = event.number;
  desk_.submit(event, WaitFor::accepted,
               [this, channel, answer = std::move(answer)](const Outcome& outcome) {
                 if (!outcome) told_control_[channel] = not_known;
                 answer(outcome);
               });
}

Outcome Dispatch::start_log() const {
  const auto started = machine_.start_log();
  if (!started)
    return fail(FailureKind::refused, "E9011",
                "a log is being written: " + machine_.recording_status().log_file);
  if (!*started) return fail(FailureKind::refused, "E9013", started->error().text);
  return json{{"path", (*started)->string()}};
}

Outcome Dispatch::stop_log() const {
  const auto stopped = machine_.stop_log();
  if (!stopped) return fail(FailureKind::refused, "E9012", "no log is being written");
  return json{{"path", stopped->string()}};
}

void Dispatch::load_tables(const SessionState& session, const json& parameters, Answer answer) {
  const auto name = parameters.value("file", std::string("tables"));
  const auto log_and_answer = [who = session, name,
                               answer = std::move(answer)](const Outcome& outcome) {
    protocol::Request request;
    request.method = "tool.load";
    request.parameters = {{"file", name}};
    log_command(who, request, outcome);
    answer(outcome);
  };
  if (const auto obstacle = control_.obstacle_to_all(session.id))
    return log_and_answer(Unexpected<Failure>(*obstacle));
  auto commands = commands_to_load(machine_, parameters["tables"].get<std::string>(), name);
  if (!commands) return log_and_answer(Unexpected<Failure>(commands.error()));
  submit_one_by_one(desk_, std::move(*commands), log_and_answer);
}

Outcome Dispatch::tool_get(const json& parameters) const {
  const int number = parameters.value("number", 0);
  const int edge = parameters.value("edge", 1);
  if (const auto tool = tool_edge(machine_, number, edge)) return *tool;
  return fail(
      FailureKind::refused, "E5021",
      "the table has no tool " + std::to_string(number) + " with edge " + std::to_string(edge));
}

void Dispatch::command(const SessionState& session, const Method& method, const json& parameters,
                       Answer answer) {
  auto event = operator_event(machine_.file(), method, parameters);
  if (!event) return answer(Unexpected<Failure>(event.error()));
  event->stops_before = session.stops_before;
  const channels::OperatorAction action = event->action;
  if (const auto obstacle = control_.obstacle(action, event->channel, session.id))
    return answer(Unexpected<Failure>(*obstacle));
  const bool begins_run = action == channels::OperatorAction::program_run ||
                          action == channels::OperatorAction::mdi ||
                          action == channels::OperatorAction::program_start;
  const bool waits = begins_run && parameters.value("wait", "accepted") == "done";
  desk_.submit(*event, waits ? WaitFor::end_of_run : WaitFor::accepted, std::move(answer));
}

// Drives are reset and made to fail beside the cycle: what they then report enters it as feedback.
Outcome Dispatch::command_drive(const Method& method, const json& parameters) {
  const auto drive = parameters["drive"].get<std::string>();
  const bool makes_fault = method.name == "drive.fault";
  if (makes_fault && machine_.drive_choice() != "embedded") {
    return fail(FailureKind::refused, "E6051",
                "the drives are " + machine_.drive_choice() + ", not simulated by this daemon");
  }
  const bool is_done = makes_fault
                           ? machine_.inject_fault(
                                 drive, *plant::fault_named(parameters["fault"].get<std::string>()))
                           : machine_.reset_drive(drive);
  if (!is_done) return fail(FailureKind::refused, "E6050", "no such drive: " + drive);
  return json{{"accepted", true}};
}

Outcome Dispatch::change_session(SessionState& session, const Method& method,
                                 const json& parameters) {
  if (method.name == "session.role") {
    const auto wanted = parameters["role"] == "observer" ? protocol::Role::observer
                                                         : protocol::Role::machine_operator;
    session.role = std::min(session.role, wanted);
    return json{{"role", protocol::role_name(session.role)}};
  }
  const bool is_watch = method.name == "channel.watch";
  const json topics = is_watch ? json::array({"channels", "events"}) : parameters["topics"];
  const double rate_hz = parameters.value("rate_hz", usual_rate_hz);
  const int channel = is_watch ? channel_or_first(parameters) : 0;
  session.subscription = Subscription(topics, rate_hz, channel);
  return json{{"topics", topics}, {"rate_hz", rate_hz}};
}

int Dispatch::channel_or_first(const json& parameters) const {
  return daemon::channel_or_first(machine_.file(), parameters);
}

json Dispatch::snapshot(const Subscription& subscription) const {
  json state = json::object();
  if (subscription.wants("machine")) state["machine"] = report_.machine();
  if (subscription.wants("drives")) state["drives"] = drive_status(machine_);
  if (!subscription.wants("channels")) return state;
  if (subscription.channel() == 0) {
    state["channels"] = report_.channels();
  } else {
    state["channels"][std::to_string(subscription.channel())] =
        report_.channel(subscription.channel());
  }
  return state;
}

json Dispatch::system_info() const {
  const auto uptime = std::chrono::steady_clock::now() - started_;
  return {{"server", "stanokd"},
          {"version", protocol::version},
          {"api", protocol::api_version},
          {"build", description_.build},
          {"pid", getpid()},
          {"uptime_s", std::chrono::duration<double>(uptime).count()},
          {"machine", machine_.file().machine.name},
          {"machine_file", machine_.file().path.string()},
          {"state_directory", description_.state_directory.string()},
          {"socket", description_.socket.string()},
          {"program_root", machine_.program_root().string()},
          {"clients", clients_}};
}

}  // namespace stanok::daemon
