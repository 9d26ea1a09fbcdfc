#include "daemon/desk/dispatch.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>

#include "daemon/desk/operator_command.h"
#include "daemon/desk/table_loading.h"
#include "daemon/desk/tables/entry_doubt.h"
#include "daemon/host/unix_time.h"
#include "daemon/report/drive_report.h"
#include "daemon/report/inventory.h"
#include "daemon/report/position_report.h"
#include "daemon/report/search_report.h"
#include "daemon/scope/scope_desk.h"
#include "protocol/contract/discovery.h"
#include "protocol/contract/json_text.h"
#include "protocol/contract/version.h"

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

Asker asker_of(const SessionState& session) {
  return {session.id, session.peer};
}

Unexpected<Failure> no_such_drive(const std::string& drive) {
  return fail(FailureKind::refused, "E6050", "there is no drive " + drive);
}

json journal_json(const Journal* journal) {
  if (journal == nullptr) return {{"records", json::array()}, {"error", nullptr}};
  const auto fault = journal->fault();
  return {{"records", journal->actions()}, {"error", fault ? json(*fault) : json(nullptr)}};
}

}  // namespace

json channel_names(const config::MachineFile& file) {
  json channels = json::array();
  for (const auto& channel : file.machine.channels)
    channels.push_back({{"id", channel.id}, {"name", channel.name}});
  return channels;
}

json greeting(RunningMachine& machine, const SessionState& session) {
  const config::MachineFile& file = machine.file();
  return {{"server", "stanokd"},          {"version", protocol::version},
          {"api", protocol::api_version}, {"machine", file.machine.name},
          {"cycle", machine.cycles()},    {"channels", channel_names(file)},
          {"session", session.id},        {"role", protocol::role_name(session.role)}};
}

Dispatch::Dispatch(RunningMachine& machine, DaemonDescription description,
                   std::function<void()> on_shutdown)
    : machine_(machine),
      description_(std::move(description)),
      desk_(machine, notes_),
      touches_(machine, desk_),
      programs_(machine),
      queue_(machine, desk_, control_, notes_, description_.state_directory / "queue.txt"),
      surfaces_(machine),
      logs_(machine),
      kept_answers_(description_.keep_tables),
      report_(machine, notes_),
      service_{.started = std::chrono::steady_clock::now(), .on_shutdown = std::move(on_shutdown)} {
  desk_.watch([this](const channels::OperatorEvent& accepted) {
    queue_.note(accepted);
    note_seen(accepted);
  });
}

void Dispatch::note_seen(const channels::OperatorEvent& accepted) const {
  if (!acknowledges_alarms(accepted.action())) return;
  for (const auto& channel : machine_.file().machine.channels) {
    const auto notes = notes_.find(channel.id);
    const bool is_meant = accepted.channel == 0 || accepted.channel == channel.id;
    if (is_meant && notes != notes_.end())
      command_log().note_seen(channel.id, notes->second.alarms_acknowledged);
  }
}

const std::map<std::string_view, Dispatch::Handler>& Dispatch::handlers() {
  static const std::map<std::string_view, Handler> table = {
      {"machine.status", [](Dispatch& d, const json&) { return d.report_.machine(); }},
      {"channel.list", [](Dispatch& d, const json&) { return d.report_.channel_list(); }},
      {"channel.status",
       [](Dispatch& d, const json& p) { return d.report_.channel(d.channel_or_first(p)); }},
      {"channel.position",
       [](Dispatch& d, const json& p) {
         const WordTerms terms = p.value("why", 0) != 0 ? WordTerms::all : WordTerms::none;
         return position_report(d.machine_, d.channel_or_first(p), terms);
       }},
      {"channel.control", [](Dispatch& d, Call call) { d.control_channel(std::move(call)); }},
      {"channel.watch",
       [](Dispatch& d, const Call& call) {
         return subscribe(call, {"channels", "events"}, d.channel_or_first(call.parameters));
       }},
      {"program.list",
       [](Dispatch& d, Call call) { d.programs_.list(call.session.id, std::move(call.answer)); }},
      {"program.read",
       [](Dispatch& d, Call call) {
         d.programs_.read(call.session.id, call.parameters, std::move(call.answer));
       }},
      {"program.write", [](Dispatch& d, Call call) { d.write_program(std::move(call)); }},
      {"program.remove", [](Dispatch& d, Call call) { d.remove_program(std::move(call)); }},
      {"program.check",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.programs_.check(call.session.id, call.parameters, channel, std::move(call.answer));
       }},
      {"program.estimate",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.programs_.estimate(call.session.id, call.parameters, channel, std::move(call.answer));
       }},
      {"process.grinding",
       [](Dispatch& d, Call call) {
         d.programs_.grinding(call.session.id, call.parameters, std::move(call.answer));
       }},
      {"tool.history", [](Dispatch& d, const json&) { return d.desk_.tables().history(); }},
      {"program.picture",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.programs_.picture(call.session.id, call.parameters, channel, std::move(call.answer));
       }},
      {"process.stability",
       [](Dispatch& d, Call call) {
         d.programs_.process().stability(call.session.id, call.parameters, std::move(call.answer));
       }},
      {"process.figures",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.programs_.process().figures(call.session.id, call.parameters, channel,
                                       std::move(call.answer));
       }},
      {"process.forces",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.programs_.process().forces(call.session.id, call.parameters, channel,
                                      std::move(call.answer));
       }},
      {"process.cancel",
       [](Dispatch& d, const Call& call) -> CommandResult {
         d.programs_.process().cancel(call.session.id);
         return json{{"accepted", true}};
       }},
      {"program.check_cancel",
       [](Dispatch& d, const Call& call) -> CommandResult {
         d.programs_.cancel_check(call.session.id);
         return json{{"accepted", true}};
       }},
      {"program.path",
       [](Dispatch& d, const Call& call) {
         return d.programs_.path(call.parameters, d.channel_or_first(call.parameters));
       }},
      {"program.history",
       [](Dispatch& d, const json& p) { return d.report_.program_history(p.value("channel", 0)); }},
      {"queue.list",
       [](Dispatch& d, const json& p) { return d.queue_.list(p.value("channel", 0)); }},
      {"queue.add",
       [](Dispatch& d, Call call) { d.change_queue(std::move(call), &ProgramQueue::add); }},
      {"queue.remove",
       [](Dispatch& d, Call call) { d.change_queue(std::move(call), &ProgramQueue::remove); }},
      {"queue.move",
       [](Dispatch& d, Call call) { d.change_queue(std::move(call), &ProgramQueue::move); }},
      {"queue.start", [](Dispatch& d, const Call& call) { return d.start_queue(call); }},
      {"queue.stop",
       [](Dispatch& d, const Call& call) {
         return d.queue_.stop(d.channel_or_first(call.parameters), call.session.peer);
       }},
      {"kinematics.list",
       [](Dispatch& d, const json& p) { return d.report_.kinematics_list(d.channel_or_first(p)); }},
      {"kinematics.status",
       [](Dispatch& d, const json& p) { return d.report_.kinematics(d.channel_or_first(p)); }},
      {"drive.list", [](Dispatch& d, const json&) { return drive_list(d.machine_); }},
      {"drive.status", [](Dispatch& d, const json&) { return drive_status(d.machine_); }},
      {"drive.reset", [](Dispatch& d, const Call& call) { return d.reset_drive(call); }},
      {"drive.fault", [](Dispatch& d, const Call& call) { return d.make_drive_fail(call); }},
      {"alarm.list",
       [](Dispatch& d, const json& p) { return d.report_.alarms_standing(p.value("channel", 0)); }},
      {"alarm.history",
       [](Dispatch& d, const json& p) { return d.report_.alarm_history(p.value("channel", 0)); }},
      {"measurement.history",
       [](Dispatch& d, const json& p) { return d.measurements_.history(p.value("channel", 0)); }},
      {"tool.list", [](Dispatch& d, const json&) { return tool_list(d.machine_); }},
      {"tool.get", [](Dispatch& d, const Call& call) { return d.tool_get(call.parameters); }},
      {"tool.load", [](Dispatch& d, Call call) { d.load_tables(std::move(call)); }},
      {"tool.touch",
       [](Dispatch& d, Call call) { d.touch(std::move(call), &TouchDesk::touch_tool); }},
      {"offset.touch",
       [](Dispatch& d, Call call) { d.touch(std::move(call), &TouchDesk::touch_offset); }},
      {"offset.undo", [](Dispatch& d, Call call) { d.undo_touch(std::move(call)); }},
      {"tool.save", [](Dispatch& d, const json&) { return tables_text(d.machine_); }},
      {"offset.list", [](Dispatch& d, const json&) { return offset_list(d.machine_); }},
      {"process.status",
       [](Dispatch& d, const json& p) { return d.report_.process(d.channel_or_first(p)); }},
      {"workpiece.status", [](Dispatch& d, const json&) { return workpiece_status(d.machine_); }},
      {"workpiece.surface",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.surfaces_.surface(call.session.id, call.parameters, channel, std::move(call.answer));
       }},
      {"workpiece.allow",
       [](Dispatch& d, const Call& call) { return d.allow_workpieces(call.parameters); }},
      {"scope.signals",
       [](Dispatch& d, const json&) { return scope_signal_list(d.machine_.file().machine); }},
      {"scope.start",
       [](Dispatch& d, const Call& call) {
         return start_scope(d.machine_.scope(), d.machine_.file().machine, call.parameters);
       }},
      {"scope.stop",
       [](Dispatch& d, const Call&) -> CommandResult {
         d.machine_.scope().stop();
         return json{{"accepted", true}};
       }},
      {"scope.read",
       [](Dispatch& d, const json& p) {
         return scope_reading(d.machine_.scope(), d.machine_.file().machine, p);
       }},
      {"history.logs",
       [](Dispatch& d, Call call) { d.logs_.list(call.session.id, std::move(call.answer)); }},
      {"history.verify",
       [](Dispatch& d, Call call) {
         d.logs_.verify(call.session.id, call.parameters, std::move(call.answer));
       }},
      {"history.path",
       [](Dispatch& d, Call call) {
         const int channel = d.channel_or_first(call.parameters);
         d.logs_.path(call.session.id, call.parameters, channel, std::move(call.answer));
       }},
      {"machine.journal",
       [](Dispatch& d, const json&) { return journal_json(d.description_.journal); }},
      {"log.status", [](Dispatch& d, const json&) { return log_status(d.machine_); }},
      {"log.start", [](Dispatch& d, const Call&) { return d.start_log(); }},
      {"log.stop", [](Dispatch& d, const Call&) { return d.stop_log(); }},
      {"subscribe",
       [](Dispatch&, const Call& call) { return subscribe(call, call.parameters["topics"], 0); }},
      {"session.role", [](Dispatch&, const Call& call) { return lower_role(call); }},
      {"system.info", [](Dispatch& d, const json&) { return d.system_info(); }},
      // NOLINTNEXTLINE(performance-unnecessary-value-param): a handler of this kind answers itself
      {"system.shutdown", [](Dispatch& d, Call call) { d.shut_down(call); }},
      {"rpc.discover",
       [](Dispatch&, const json&) { return protocol::discovery_document(protocol::version); }},
  };
  return table;
}

void Dispatch::handle(SessionState& session, const protocol::RpcRequest& request, Answer answer) {
  const Method* method = protocol::find_method(request.method);
  const auto parameters = admitted_parameters(machine_.file(), session.role, method, request);
  if (!parameters) return answer(Unexpected<Failure>(parameters.error()));
  const Call call{session, *method, request, *parameters, std::move(answer)};
  if (!method->action.empty()) return command(call);
  const auto handler = handlers().find(method->name);
  if (handler == handlers().end())
    return call.answer(
        fail(FailureKind::internal, "", "the daemon has no handler for " + request.method));
  if (const Query* query = std::get_if<Query>(&handler->second))
    return call.answer((*query)(*this, call.parameters));
  if (const Task* task = std::get_if<Task>(&handler->second)) return (*task)(*this, call);
  const CommandResult outcome = std::get<Order>(handler->second)(*this, call);
  if (method->effect != protocol::Effect::looks)
    command_log().note(asker_of(session), request, outcome);
  call.answer(outcome);
}

void Dispatch::forget(int session) {
  control_.forget(session);
  programs_.forget(session);
  surfaces_.forget(session);
  logs_.forget(session);
  note_control();
  tell_control();
}

void Dispatch::note_control() {
  for (const auto& channel : machine_.file().machine.channels)
    notes_[channel.id].controlled_by = control_.holder(channel.id);
}

// Answered when the cycle knows it: from then on nothing of others begins there.
void Dispatch::control_channel(Call call) {
  const int channel = channel_or_first(call.parameters);
  const bool takes = call.parameters.value("on", 1) != 0;
  const auto obstacle = takes ? control_.take(channel, call.session) : std::nullopt;
  if (obstacle) return call.answer(Unexpected<Failure>(*obstacle));
  if (!takes) control_.give_back(channel, call.session.id);
  note_control();
  tell_control(channel, [this, channel, takes, id = call.session.id,
                         answer = std::move(call.answer)](const CommandResult& outcome) {
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
      tell_control(channel.id, [](const CommandResult&) {});
  }
}

void Dispatch::tell_control(int channel, Answer answer) {
  constexpr int not_known = -1;
  channels::OperatorEvent event;
  const auto session = static_cast<std::int32_t>(control_.session_with(channel));
  event.command = channels::commands::ChannelControl{session};
  event.channel = channel;
  told_control_[channel] = session;
  desk_.submit(event, WaitFor::accepted,
               [this, channel, answer = std::move(answer)](const CommandResult& outcome) {
                 if (!outcome) told_control_[channel] = not_known;
                 answer(outcome);
               });
}

CommandResult Dispatch::start_log() const {
  const auto started = machine_.start_log();
  if (!started)
    return fail(FailureKind::refused, "E9011",
                "a log is already being written: " + machine_.recording_status().log_file);
  if (!*started) return fail(FailureKind::refused, "E9013", started->error().text);
  return json{{"path", (*started)->string()}};
}

CommandResult Dispatch::stop_log() const {
  const auto stopped = machine_.stop_log();
  if (!stopped) return fail(FailureKind::refused, "E9012", "no log is being written");
  return json{{"path", stopped->string()}};
}

void Dispatch::load_tables(Call call) {
  const auto name = call.parameters.value("file", std::string("tables"));
  const auto log_and_answer = [this, who = asker_of(call.session), name,
                               answer = std::move(call.answer)](const CommandResult& outcome) {
    protocol::RpcRequest request;
    request.method = "tool.load";
    request.parameters = {{"file", name}};
    command_log().note(who, request, outcome);
    answer(outcome);
  };
  if (const auto obstacle = control_.obstacle_to_all(call.session.id))
    return log_and_answer(Unexpected<Failure>(*obstacle));
  const bool is_confirmed = call.parameters.value("confirmed", 0) != 0;
  auto commands = commands_to_load(machine_, call.parameters["tables"].get<std::string>(), name,
                                   is_confirmed ? Confirmed::yes : Confirmed::no);
  if (!commands) return log_and_answer(Unexpected<Failure>(commands.error()));
  submit_one_by_one(desk_, std::move(*commands), noted(call.session, log_and_answer));
}

void Dispatch::touch(Call call, Touch way) {
  const int channel = channel_or_first(call.parameters);
  Answer answer = noted(call.session, logged(call, std::move(call.answer), call.parameters));
  const auto obstacle =
      control_.obstacle(channels::OperatorAction::offset_touch, channel, call.session.id);
  if (obstacle) return answer(Unexpected<Failure>(*obstacle));
  (touches_.*way)(call.parameters, channel, std::move(answer));
}

void Dispatch::undo_touch(Call call) {
  Answer answer = noted(call.session, logged(call, std::move(call.answer), call.parameters));
  if (const auto obstacle = control_.obstacle_to_all(call.session.id))
    return answer(Unexpected<Failure>(*obstacle));
  touches_.undo(call.parameters, std::move(answer));
}

// An answer that leaves an entry in the log, with `shown` for the parameters: texts are long.
Answer Dispatch::logged(const Call& call, Answer answer, json shown) const {
  protocol::RpcRequest request;
  request.method = call.request.method;
  request.parameters = std::move(shown);
  return [this, who = asker_of(call.session), request = std::move(request),
          answer = std::move(answer)](const CommandResult& outcome) {
    command_log().note(who, request, outcome);
    answer(outcome);
  };
}

void Dispatch::write_program(Call call) {
  json shown = {{"program", call.parameters["program"]},
                {"bytes", call.parameters["text"].get_ref<const std::string&>().size()}};
  programs_.write(call.session.id, call.parameters,
                  logged(call, std::move(call.answer), std::move(shown)));
}

// Whoever has the channel to itself has its queue, too.
void Dispatch::change_queue(Call call, QueueChange change) {
  const int channel = channel_or_first(call.parameters);
  Answer answer = logged(call, std::move(call.answer), call.parameters);
  const auto obstacle =
      control_.obstacle(channels::OperatorAction::program_run, channel, call.session.id);
  if (obstacle) return answer(Unexpected<Failure>(*obstacle));
  (queue_.*change)(call.parameters, channel, std::move(answer));
}

void Dispatch::remove_program(Call call) {
  programs_.remove(call.session.id, call.parameters,
                   logged(call, std::move(call.answer), call.parameters));
}

CommandResult Dispatch::tool_get(const json& parameters) const {
  const int number = parameters.value("number", 0);
  const int edge = parameters.value("edge", 1);
  if (const auto tool = tool_edge(machine_, number, edge)) return *tool;
  return fail(
      FailureKind::refused, "E5021",
      "the table has no tool " + std::to_string(number) + " with edge " + std::to_string(edge));
}

// What the cycle takes of it comes later, and is looked at there once more.
CommandResult Dispatch::start_queue(const Call& call) {
  const int channel = channel_or_first(call.parameters);
  const AskedAt asked = asked_at(call);
  const auto& machine = machine_.file().machine;
  const double age_s =
      static_cast<double>(machine_.cycles() - asked.cycle) * machine.cycle_us * 1e-6;
  if (asked.cycle >= 0 && age_s > machine.request_age_max_s)
    return fail(FailureKind::refused, "E6073",
                "the sender of the command last saw the state of the machine too long ago",
                channel);
  return queue_.start(channel, {call.session.id, call.session.peer, asked});
}

// What a client says that it saw is no newer than what there was when its request came in.
AskedAt Dispatch::asked_at(const Call& call) {
  AskedAt asked = call.session.asked_at;
  const auto seen = call.parameters.find("seen_cycle");
  if (seen != call.parameters.end()) asked.cycle = std::min(asked.cycle, seen->get<std::int64_t>());
  return asked;
}

// Sessions may go before the answer comes; the log entry must not need them.
void Dispatch::command(const Call& call) {
  const auto log_and_answer = [this, who = asker_of(call.session), request = call.request,
                               answer = call.answer](const CommandResult& outcome) {
    command_log().note(who, request, outcome);
    answer(outcome);
  };
  auto event = operator_event(machine_.file(), call.method, call.parameters);
  if (!event) return log_and_answer(Unexpected<Failure>(event.error()));
  const AskedAt asked = asked_at(call);
  event->stops_before = asked.stops_before;
  event->seen_cycle = asked.cycle;
  event->session = call.session.id;
  if (const auto obstacle = control_.obstacle(event->action(), event->channel, call.session.id))
    return log_and_answer(Unexpected<Failure>(*obstacle));
  if (event->action() == channels::OperatorAction::program_start) {
    if (const auto obstacle = obstacle_to_start(machine_, event->channel, call.parameters))
      return log_and_answer(Unexpected<Failure>(*obstacle));
  }
  if (const auto obstacle = obstacle_to_entry(machine_, *event, call.parameters))
    return log_and_answer(Unexpected<Failure>(*obstacle));
  const bool waits = call.method.effect == protocol::Effect::begins_motion &&
                     call.parameters.value("wait", "accepted") == "done";
  Answer answer = log_and_answer;
  if (protocol::noun(call.method) == "tool" || protocol::noun(call.method) == "offset")
    answer = noted(call.session, std::move(answer));
  desk_.submit(*event, waits ? WaitFor::end_of_run : WaitFor::accepted, std::move(answer));
}

Answer Dispatch::noted(const SessionState& session, Answer answer) {
  return [this, by = session.peer,
          answer = kept_answers_.behind_disk(std::move(answer))](const CommandResult& outcome) {
    if (outcome) desk_.tables().note(by, unix_time_s());
    answer(outcome);
  };
}

// Drives are reset and made to fail beside the cycle: what they then report enters it as feedback.
CommandResult Dispatch::reset_drive(const Call& call) {
  if (const auto obstacle = control_.obstacle_to_all(call.session.id))
    return Unexpected<Failure>(*obstacle);
  const auto drive = call.parameters["drive"].get<std::string>();
  if (!machine_.reset_drive(drive)) return no_such_drive(drive);
  return json{{"accepted", true}};
}

CommandResult Dispatch::make_drive_fail(const Call& call) {
  if (const auto obstacle = control_.obstacle_to_all(call.session.id))
    return Unexpected<Failure>(*obstacle);
  if (machine_.drive_choice() != "embedded") {
    return fail(
        FailureKind::refused, "E6051",
        "the drives are " + machine_.drive_choice() + ", they are not simulated by this daemon");
  }
  const auto drive = call.parameters["drive"].get<std::string>();
  const auto fault = plant::fault_named(call.parameters["fault"].get<std::string>());
  if (!machine_.inject_fault(drive, *fault)) return no_such_drive(drive);
  return json{{"accepted", true}};
}

CommandResult Dispatch::allow_workpieces(const json& parameters) {
  const bool allowed = parameters.value("on", 1) != 0;
  machine_.allow_workpieces(allowed);
  return json{{"allowed", allowed}};
}

void Dispatch::shut_down(const Call& call) {
  command_log().note(asker_of(call.session), call.request, json());
  call.answer(json{{"accepted", true}});
  service_.on_shutdown();
}

CommandResult Dispatch::lower_role(const Call& call) {
  const auto wanted = protocol::role_named(call.parameters["role"].get<std::string>());
  call.session.role = std::min(call.session.role, wanted.value_or(call.session.role));
  // The name is what the client says; who the client is stays behind it. The server of the page
  // says it first: what a browser says afterwards changes nothing.
  const auto name = call.parameters.value("name", std::string());
  if (!name.empty() && !call.session.is_named) {
    call.session.peer = name + " (" + call.session.peer + ")";
    call.session.is_named = true;
  }
  return json{{"role", protocol::role_name(call.session.role)}};
}

CommandResult Dispatch::subscribe(const Call& call, const json& topics, int channel) {
  const double rate_hz = call.parameters.value("rate_hz", usual_rate_hz);
  call.session.subscription = Subscription(topics, rate_hz, channel);
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
  const auto uptime = std::chrono::steady_clock::now() - service_.started;
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
          {"history",
           description_.journal == nullptr ? json(nullptr) : json(description_.journal->id())},
          {"clients", service_.clients}};
}

}  // namespace stanok::daemon
