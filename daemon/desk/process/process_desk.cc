#include "daemon/desk/process/process_desk.h"

#include "config/files/chatter_file.h"
#include "daemon/desk/as_it_stands.h"
#include "daemon/desk/log_folder.h"
#include "daemon/desk/process/process_answers.h"
#include "jobs/foresight/foresight.h"
#include "process/chatter/lobes_study.h"
#include "runtime/program_files.h"
#include "runtime/thread_time.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

constexpr double speed_from_usual = 1000.0;  // rev/min
constexpr double speed_to_usual = 20000.0;
constexpr int speeds_usual = 400;

// Null: every depth is stable.
json depth_json(double depth_mm) {
  return std::isfinite(depth_mm) ? json(depth_mm) : json(nullptr);
}

const char* name_of_cut(process::CutKind kind) {
  if (kind == process::CutKind::turning) return "turning";
  return kind == process::CutKind::grinding ? "grinding" : "milling";
}

json cut_json(const process::PlannedCut& cut) {
  return {{"speed_rev_per_min", cut.speed_rev_per_min},
          {"depth_mm", cut.depth_mm},
          {"limit_mm", depth_json(cut.limit_mm)},
          {"stable", cut.is_stable()},
          {"better_speed_rev_per_min",
           cut.better_speed > 0.0 ? json(cut.better_speed) : json(nullptr)}};
}

json study_json(const std::string& name, const process::LobesStudy& study) {
  json limits = json::array();
  for (const process::LimitAt& limit : study.limits)
    limits.push_back({limit.speed_rev_per_min, depth_json(limit.depth_mm), limit.chatter_hz});
  json best = json::array();
  for (const process::LimitAt& limit : study.best) {
    best.push_back({{"speed_rev_per_min", limit.speed_rev_per_min},
                    {"depth_mm", depth_json(limit.depth_mm)},
                    {"chatter_hz", limit.chatter_hz}});
  }
  json cuts = json::array();
  for (const process::PlannedCut& cut : study.cuts) cuts.push_back(cut_json(cut));
  return {{"program", name},
          {"kind", name_of_cut(study.kind)},
          {"always_stable_mm", depth_json(study.always_mm)},
          {"limits", std::move(limits)},
          {"best", std::move(best)},
          {"cuts", std::move(cuts)}};
}

Expected<process::LobesRequest, Failure> lobes_request(const json& parameters) {
  process::LobesRequest request;
  request.speed_from = parameters.value("from", speed_from_usual);
  request.speed_to = parameters.value("to", speed_to_usual);
  if (!(request.speed_from < request.speed_to))
    return nothing_told("the first speed is above the last");
  request.count = parameters.value("count", speeds_usual);
  if (parameters.value("method", "zeroth-order") == "semi-discretisation")
    request.method = process::LobesMethod::semi_discretisation;
  if (parameters.contains("speed") != parameters.contains("depth"))
    return nothing_told("a planned cut needs both a speed and a depth");
  if (parameters.contains("speed")) {
    request.programmed.push_back({.speed_rev_per_min = parameters["speed"].get<double>(),
                                  .depth_mm = parameters["depth"].get<double>()});
  }
  return request;
}

}  // namespace

Unexpected<Failure> nothing_told(const std::string& reason) {
  return Unexpected<Failure>(Failure{FailureKind::refused, "E9024", reason, 0, {}});
}

Unexpected<Failure> wrong_file(const config::ConfigError& error, const std::string& name) {
  const config::ConfigFault& fault = error.faults().front();
  const int line = static_cast<int>(fault.line);
  const int column = static_cast<int>(fault.column);
  const Place place{name, line, column, line, column};
  return Unexpected<Failure>({FailureKind::program_error, "E9102", fault.text, 0, place});
}

jobs::GivesUp gives_up_when(const std::stop_token& stop) {
  const auto end = runtime::processor_time_of_thread() + jobs::Foresight::computing_time_max;
  return [stop, end] { return stop.stop_requested() || runtime::processor_time_of_thread() > end; };
}

ProgramFolder ProcessDesk::folder() const {
  return {machine_.program_root(), runtime::program_format(machine_.file().machine)};
}

void ProcessDesk::stability(int session, const json& parameters, Answer answer) {
  work_.cancel(session);
  auto request = lobes_request(parameters);
  if (!request) return answer(Unexpected<Failure>(request.error()));
  work_.submit(
      session,
      [folder = folder(), name = parameters["program"].get<std::string>(),
       request = std::move(*request)](const std::stop_token& stop) mutable -> CommandResult {
        const auto file = folder.read(name);
        if (!file) return Unexpected<Failure>(file.error());
        try {
          request.process = config::read_chatter_file(file->path);
        } catch (const config::ConfigError& error) {
          return wrong_file(error, name);
        }
        const auto gives_up = gives_up_when(stop);
        const process::LobesStudy study = process::study_lobes(request, gives_up);
        if (gives_up()) return nothing_told("this number of speeds takes too long; request fewer");
        return study_json(name, study);
      },
      std::move(answer));
}

void ProcessDesk::figures(int session, const json& parameters, int channel, Answer answer) {
  work_.cancel(session);
  const auto log = log_named(machine_.recording_status(), parameters["file"].get<std::string>());
  if (!log) return answer(Unexpected<Failure>(log.error()));
  work_.submit(session, figures_from(*log, channel, folder(), parameters), std::move(answer));
}

void ProcessDesk::forces(int session, const json& parameters, int channel, Answer answer) {
  work_.cancel(session);
  runtime::SimulationOptions now = simulation_as_it_stands(machine_);
  jobs::ForecastJob job{.machine = std::move(now.file),
                        .program_roots = std::move(now.program_roots),
                        .program = parameters["program"].get<std::string>(),
                        .text = {},
                        .channel = channel,
                        .schemes = std::move(now.schemes)};
  work_.submit(session, forces_along(std::move(job), folder(), parameters), std::move(answer));
}

}  // namespace stanok::daemon
