#include "daemon/desk/program_desk.h"

#include <algorithm>
#include <chrono>

#include "base/utf8.h"
#include "daemon/desk/as_it_stands.h"
#include "daemon/desk/part_report.h"
#include "daemon/desk/path_pages.h"
#include "daemon/host/unix_time.h"
#include "daemon/report/inventory.h"
#include "daemon/report/status_report.h"
#include "jobs/dry_run/dry_run.h"
#include "protocol/contract/diagnostic_json.h"
#include "protocol/contract/plane_json.h"
#include "runtime/overlaid_files.h"
#include "runtime/program_files.h"
#include "runtime/simulation.h"
#include "runtime/thread_time.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

CommandResult failed_command(const Failure& failure) {
  return Unexpected<Failure>(failure);
}

std::string program_named_in(const json& parameters) {
  return parameters["program"].get<std::string>();
}

ExpectedVersion expected_version(const json& parameters) {
  const auto version = parameters.find("version");
  if (version == parameters.end()) return {};
  return {version->get<std::string>()};
}

// A piece of a text that begins and ends with whole characters, where it has any.
std::string piece_of(const std::string& text, std::size_t offset, std::size_t bytes_max) {
  if (offset >= text.size()) return {};
  const std::string_view rest = std::string_view(text).substr(offset);
  const std::string_view piece = cut_to(rest, bytes_max);
  return std::string(piece.empty() ? rest.substr(0, bytes_max) : piece);
}

CommandResult read_answer(const std::string& name, const StoredProgram& program,
                          std::size_t offset) {
  std::string piece = piece_of(program.text, offset, ProgramDesk::read_bytes_max);
  const bool is_complete = offset + piece.size() >= program.text.size();
  return json{
      {"program", name},         {"version", program.version}, {"bytes", program.text.size()},
      {"offset", offset},        {"complete", is_complete},    {"exact", is_utf8(program.text)},
      {"text", std::move(piece)}};
}

json check_answer(const std::string& program, const jobs::DryRunResult& result) {
  json diagnostics = json::array();
  for (const Diagnostic& diagnostic : result.diagnostics)
    diagnostics.push_back(json(protocol::diagnostic_json(diagnostic)));
  return {{"program", program},
          {"ok", !has_errors(result.diagnostics)},
          {"blocks", result.blocks},
          {"diagnostics", std::move(diagnostics)},
          {"tilted_planes", json(protocol::plane_json(result.planes))}};
}

json run_json(const channels::RunReport& run, double cycle_s) {
  return {{"channel", run.channel},
          {"program", run.program},
          {"ok", run.ok},
          {"blocks", run.blocks},
          {"time_s", static_cast<double>(run.end_cycle - run.start_cycle) * cycle_s},
          {"path_mm", run.path_mm}};
}

CommandResult estimate_of(const runtime::SimulationOptions& options, const std::stop_token& stop) {
  const auto give_up_at = runtime::processor_time_of_thread() + jobs::Foresight::computing_time_max;
  bool is_given_up = false;
  const auto result = runtime::simulate(options, {}, [&] {
    is_given_up = stop.stop_requested() || runtime::processor_time_of_thread() > give_up_at;
    return is_given_up;
  });
  const std::string& program = options.programs.front().program;
  const auto error =
      std::find_if(result.load_diagnostics.begin(), result.load_diagnostics.end(),
                   [](const auto& told) { return told.diagnostic.severity == Severity::error; });
  if (error != result.load_diagnostics.end())
    return failed_command(failure_of_diagnostic(error->diagnostic));
  if (!result.refusals.empty())
    return failed_command(
        {FailureKind::refused, "", program + ": " + result.refusals.front(), 0, {}});
  json runs = json::array();
  for (const channels::RunReport& run : result.runs) runs.push_back(run_json(run, result.cycle_s));
  return json{{"program", program},
              {"ok", result.ok},
              {"complete", !is_given_up && !result.until_reached},
              {"time_s", result.machine_time_s},
              {"alarm", result.alarms.empty() ? json(nullptr) : alarm_json(result.alarms.front())},
              {"runs", std::move(runs)}};
}

}  // namespace

ProgramDesk::ProgramDesk(RunningMachine& machine) : machine_(machine), process_(machine) {}

ProgramFolder ProgramDesk::folder() const {
  return {machine_.program_root(), runtime::program_format(machine_.file().machine)};
}

void ProgramDesk::list(int session, Answer answer) {
  files_.submit(
      session,
      [root = machine_.program_root()](const std::stop_token&) -> CommandResult {
        return program_list(root);
      },
      [this, answer = std::move(answer)](const CommandResult& outcome) {
        if (!outcome) return answer(outcome);
        json list = *outcome;
        times_.add_to(list["programs"], machine_.runs());
        answer(list);
      });
}

void ProgramDesk::read(int session, const json& parameters, Answer answer) {
  const auto offset = parameters.value("offset", std::size_t{0});
  files_.submit(
      session,
      [folder = folder(), name = program_named_in(parameters),
       offset](const std::stop_token&) -> CommandResult {
        const auto program = folder.read(name);
        return program ? read_answer(name, *program, offset) : failed_command(program.error());
      },
      std::move(answer));
}

bool ProgramDesk::gather(int session, const std::string& program, const std::string& text) {
  Upload& upload = uploads_[session];
  if (upload.program != program) upload = {program, {}};
  std::size_t bytes = text.size();
  for (const auto& [id, other] : uploads_) bytes += other.text.size();
  if (bytes > upload_bytes_max) return false;
  upload.text += text;
  return true;
}

void ProgramDesk::write(int session, const json& parameters, Answer answer) {
  const std::string name = program_named_in(parameters);
  if (!gather(session, name, parameters["text"].get<std::string>())) {
    uploads_.erase(session);
    return answer(failed_command(
        {FailureKind::refused, "E9007", "too much text is being transferred", 0, {}}));
  }
  if (parameters.value("more", 0) != 0) {
    const std::size_t bytes = uploads_[session].text.size();
    return answer(json{{"program", name}, {"version", nullptr}, {"bytes", bytes}});
  }
  std::string text = std::move(uploads_.extract(session).mapped().text);
  files_.submit(
      session,
      [folder = folder(), name, text = std::move(text),
       expected = expected_version(parameters)](const std::stop_token&) -> CommandResult {
        const auto version = folder.write(name, text, expected);
        if (!version) return failed_command(version.error());
        return json{{"program", name}, {"version", *version}, {"bytes", text.size()}};
      },
      std::move(answer));
}

void ProgramDesk::remove(int session, const json& parameters, Answer answer) {
  files_.submit(
      session,
      [folder = folder(), name = program_named_in(parameters),
       expected = expected_version(parameters)](const std::stop_token&) -> CommandResult {
        if (const auto failure = folder.remove(name, expected)) return failed_command(*failure);
        return json{{"program", name}};
      },
      std::move(answer));
}

// With the tables and the schemes of now; the newest check of a session is the one that counts.
void ProgramDesk::check(int session, const json& parameters, int channel, Answer answer) {
  const std::string name = program_named_in(parameters);
  channels::MachineConfig machine = machine_.file().machine;
  machine.tables = machine_.tables();
  const auto output = machine_.newest_output();
  const auto* const of_channel = output.of_channel(channel);
  const int scheme = of_channel == nullptr || of_channel->scheme == 0 ? -1 : of_channel->scheme;
  const auto text = parameters.find("text");
  std::optional<std::string> unsaved;
  if (text != parameters.end()) unsaved = text->get<std::string>();
  const bool is_saved = !unsaved;
  checks_.cancel(session);
  checks_.submit(
      session,
      [machine = std::move(machine), roots = machine_.program_roots(), name, channel, scheme,
       unsaved = std::move(unsaved)](const std::stop_token& stop) -> CommandResult {
        const runtime::ProgramFiles files(roots, runtime::program_format(machine));
        const runtime::OverlaidFiles with_unsaved(files, name, unsaved);
        const auto result = jobs::check_program(machine, channel, scheme, name, with_unsaved,
                                                [&stop] { return stop.stop_requested(); });
        json found = check_answer(name, result);
        const auto checked = with_unsaved.read(name, "");
        found["version"] = checked ? json(version_of((*checked)->text)) : json(nullptr);
        return found;
      },
      [this, name, is_saved, answer = std::move(answer)](const CommandResult& outcome) {
        if (outcome && is_saved) {
          using Verdict = ProgramTimes::Verdict;
          const bool ok = (*outcome)["ok"].get<bool>();
          times_.note_check(name, ok ? Verdict::faultless : Verdict::faulty, unix_time_s());
        }
        answer(outcome);
      });
}

// The machine as it stands, with ideal drives, on a virtual clock; given up like a foresight.
void ProgramDesk::estimate(int session, const json& parameters, int channel, Answer answer) {
  runtime::SimulationOptions options = simulation_as_it_stands(machine_);
  options.programs = {{channel, program_named_in(parameters)}};
  options.until_s = time_ahead_max_s;
  checks_.cancel(session);
  checks_.submit(
      session,
      [options = std::move(options)](const std::stop_token& stop) -> CommandResult {
        return estimate_of(options, stop);
      },
      std::move(answer));
}

void ProgramDesk::picture(int session, const json& parameters, int channel, Answer answer) {
  runtime::SimulationOptions options = simulation_as_it_stands(machine_);
  options.programs = {{channel, program_named_in(parameters)}};
  options.until_s = time_ahead_max_s;
  checks_.cancel(session);
  checks_.submit(session, part_after(std::move(options)), std::move(answer));
}

CommandResult ProgramDesk::path(const json& parameters, int channel) const {
  return path_answer(machine_.planned_path(channel).get(), channel, parameters);
}

void ProgramDesk::tick() {
  files_.tick();
  checks_.tick();
  process_.tick();
}

void ProgramDesk::forget(int session) {
  uploads_.erase(session);
  files_.cancel(session);
  checks_.cancel(session);
  process_.forget(session);
}

}  // namespace stanok::daemon
