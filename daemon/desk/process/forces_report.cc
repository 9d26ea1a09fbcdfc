// Forces along a program before it is run, and the program with feeds that
// hold them.

#include <algorithm>
#include <optional>

#include "config/files/chatter_file.h"
#include "daemon/desk/process/process_answers.h"
#include "daemon/desk/process/process_desk.h"
#include "daemon/desk/program_desk.h"
#include "jobs/cutting/cut_columns.h"

namespace stanok::daemon {
namespace {

using jobs::ForecastJob;
using nlohmann::json;
using process::CuttingProcess;
using protocol::Failure;

// A place takes some hundred bytes, that of a milling cut some thousand.
constexpr std::size_t turning_places_max = 500'000;
constexpr std::size_t milling_places_max = 50'000;

struct Wanted {
  double force_n = 0.0;
  double feed_min = 0.0;  // mm per turn
  double feed_max = 0.0;
  double stiffness_n_per_um = 0.0;
  double step_mm = 0.0;
  int tool = 0;
};

Wanted wanted(const json& parameters) {
  return {.force_n = parameters.value("force", 0.0),
          .feed_min = parameters.value("feed_min", 0.0),
          .feed_max = parameters.value("feed_max", 0.0),
          .stiffness_n_per_um = parameters.value("stiffness", 0.0),
          .step_mm = parameters.value("step", 0.0),
          .tool = parameters.value("tool", 0)};
}

// `programmed` and `planned`: the force of a place.
template <class Place>
json forces_json(const std::vector<Place>& places, const jobs::Columns<Place>& columns,
                 double Place::* programmed, double Place::* planned) {
  return {{"force_programmed_max_n", jobs::greatest(places, programmed)},
          {"force_max_n", jobs::greatest(places, planned)},
          {"power_max_w", jobs::greatest(places, &Place::power_w)},
          {"deflection_max_um", jobs::greatest(places, &Place::deflection_um)},
          {"places", jobs::thinned(places, ProcessDesk::rows_max, columns)}};
}

template <class Forecast>
json answer_of(const ForecastJob& job, const Wanted& wanted, const Forecast& forecast,
               json forces) {
  json answer = std::move(forces);
  answer["program"] = job.program;
  answer["blocks"] = forecast.lines.size();
  answer["time_programmed_s"] = forecast.time_programmed_s;
  answer["time_s"] = forecast.time_s;
  answer["text"] = nullptr;
  if (wanted.force_n > 0.0) {
    std::string text = jobs::with_feeds(job.text, forecast.lines);
    if (text.size() <= ProgramDesk::read_bytes_max) answer["text"] = std::move(text);
  }
  return answer;
}

CommandResult turning_forces(ForecastJob job, const Wanted& wanted) {
  job.places_max = turning_places_max;
  const jobs::ForecastRequest request{.job = std::move(job),
                                      .force_n = wanted.force_n,
                                      .feed_min = wanted.feed_min,
                                      .feed_max = wanted.feed_max,
                                      .stiffness_n_per_um = wanted.stiffness_n_per_um};
  const jobs::ForceForecast forecast = jobs::forecast_forces(request);
  json answer =
      answer_of(request.job, wanted, forecast,
                forces_json(forecast.places, jobs::turning_overview(),
                            &jobs::ForcePlace::force_programmed_n, &jobs::ForcePlace::force_n));
  answer["kind"] = "turning";
  return answer;
}

CommandResult milling_forces(ForecastJob job, const Wanted& wanted, const CuttingProcess& cut) {
  job.places_max = milling_places_max;
  const jobs::MillingRequest request{.job = std::move(job),
                                     .cut = cut,
                                     .tool = wanted.tool,
                                     .step_mm = wanted.step_mm,
                                     .force_n = wanted.force_n,
                                     .feed_min = wanted.feed_min,
                                     .feed_max = wanted.feed_max,
                                     .memory_max = workpiece_bytes_max};
  const jobs::MillingForecast forecast = jobs::forecast_milling(request);
  json answer = answer_of(
      request.job, wanted, forecast,
      forces_json(forecast.places, jobs::milling_overview(), &jobs::MillingPlace::force_peak_n,
                  &jobs::MillingPlace::force_planned_n));
  answer["kind"] = "milling";
  return answer;
}

Expected<std::optional<CuttingProcess>, Failure> tool_of(const ProgramFolder& folder,
                                                         const json& parameters) {
  if (!parameters.contains("cut")) return std::optional<CuttingProcess>{};
  const auto name = parameters["cut"].get<std::string>();
  const auto file = folder.read(name);
  if (!file) return Unexpected<Failure>(file.error());
  try {
    const CuttingProcess cut = config::read_chatter_file(file->path);
    if (cut.kind != process::CutKind::milling)
      return nothing_told(name + " is not a file of a milling tool; set kind = \"milling\"");
    return std::optional(cut);
  } catch (const config::ConfigError& error) {
    return wrong_file(error, name);
  }
}

CommandResult forces_told(const ProgramFolder& folder, const json& parameters, ForecastJob job) {
  const auto program = folder.read(job.program);
  if (!program) return Unexpected<Failure>(program.error());
  job.text = program->text;
  std::optional<Diagnostic> fault;
  job.tell = [&fault](const Diagnostic& diagnostic) {
    if (!fault && diagnostic.severity == Severity::error) fault = diagnostic;
  };
  const auto cut = tool_of(folder, parameters);
  if (!cut) return Unexpected<Failure>(cut.error());
  try {
    return *cut ? milling_forces(std::move(job), wanted(parameters), **cut)
                : turning_forces(std::move(job), wanted(parameters));
  } catch (const std::runtime_error& error) {
    if (fault) return Unexpected<Failure>(failure_of_diagnostic(*fault));
    return nothing_told(error.what());
  }
}

}  // namespace

BackgroundWork::Work forces_along(ForecastJob job, const ProgramFolder& folder,
                                  const json& parameters) {
  return [folder, parameters, job = std::move(job)](const std::stop_token& stop) {
    ForecastJob bounded = job;
    bounded.gives_up = gives_up_when(stop);
    return forces_told(folder, parameters, std::move(bounded));
  };
}

}  // namespace stanok::daemon
