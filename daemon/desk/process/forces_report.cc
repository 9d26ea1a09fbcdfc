// Forces along a program before it is run, and the program with feeds that
// hold them.

#include <algorithm>
#include <optional>

#include "config/files/chatter_file.h"
#include "daemon/desk/process/process_answers.h"
#include "daemon/desk/process/process_desk.h"
#include "daemon/desk/program_desk.h"
#include "jobs/cutting/force_forecast.h"
#include "jobs/cutting/milling_forecast.h"

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

// A place of either cut; feeds in mm/min.
struct CutAt {
  double path_mm = 0.0;
  double force_programmed_n = 0.0;
  double force_n = 0.0;
  double feed_programmed = 0.0;
  double feed = 0.0;
  double power_w = 0.0;
  double size = 0.0;  // depth of a turning cut, mm; area of a milling cut, mm2
  double deflection_um = 0.0;
};

json cut_at_json(const CutAt& place) {
  return {place.path_mm, place.force_programmed_n,
          place.force_n, place.feed_programmed,
          place.feed,    place.power_w,
          place.size,    place.deflection_um};
}

double greatest(const std::vector<CutAt>& places, double CutAt::* quantity) {
  double most = 0.0;
  for (const CutAt& place : places) most = std::max(most, place.*quantity);
  return most;
}

// The first of the places that come together in a row, with the greatest forces of them: a peak
// is not left out.
std::vector<CutAt> with_peaks(const std::vector<CutAt>& places) {
  std::vector<CutAt> rows;
  const std::size_t stride = 1 + places.size() / ProcessDesk::rows_max;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const CutAt& place = places[k];
    if (k % stride == 0) {
      rows.push_back(place);
      continue;
    }
    CutAt& row = rows.back();
    for (double CutAt::* const peak : {&CutAt::force_programmed_n, &CutAt::force_n, &CutAt::power_w,
                                       &CutAt::size, &CutAt::deflection_um})
      row.*peak = std::max(row.*peak, place.*peak);
  }
  return rows;
}

template <class Forecast>
CommandResult answer_of(const ForecastJob& job, const Wanted& wanted, const Forecast& forecast,
                        const std::vector<CutAt>& places) {
  json answer{{"program", job.program},
              {"blocks", forecast.lines.size()},
              {"force_programmed_max_n", greatest(places, &CutAt::force_programmed_n)},
              {"force_max_n", greatest(places, &CutAt::force_n)},
              {"power_max_w", greatest(places, &CutAt::power_w)},
              {"deflection_max_um", greatest(places, &CutAt::deflection_um)},
              {"time_programmed_s", forecast.time_programmed_s},
              {"time_s", forecast.time_s},
              {"text", nullptr}};
  json rows = json::array();
  for (const CutAt& place : with_peaks(places)) rows.push_back(cut_at_json(place));
  answer["places"] = std::move(rows);
  if (wanted.force_n > 0.0) {
    std::string text = jobs::with_feeds(job.text, forecast.lines);
    if (text.size() <= ProgramDesk::read_bytes_max) answer["text"] = std::move(text);
  }
  return answer;
}

CommandResult turning(ForecastJob job, const Wanted& wanted) {
  job.places_max = turning_places_max;
  const jobs::ForecastRequest request{.job = std::move(job),
                                      .force_n = wanted.force_n,
                                      .feed_min = wanted.feed_min,
                                      .feed_max = wanted.feed_max};
  const jobs::ForceForecast forecast = jobs::forecast_forces(request);
  const double um_per_n = wanted.stiffness_n_per_um > 0.0 ? 1.0 / wanted.stiffness_n_per_um : 0.0;
  std::vector<CutAt> places;
  places.reserve(forecast.places.size());
  for (const jobs::ForcePlace& one : forecast.places) {
    places.push_back({.path_mm = one.path_mm,
                      .force_programmed_n = one.force_programmed_n,
                      .force_n = one.force_n,
                      .feed_programmed = one.feed_programmed * one.rev_per_min,
                      .feed = one.feed * one.rev_per_min,
                      .power_w = one.power_w,
                      .size = one.depth_mm,
                      .deflection_um = one.force_n * um_per_n});
  }
  auto answer = answer_of(request.job, wanted, forecast, places);
  (*answer)["kind"] = "turning";
  return answer;
}

CommandResult milling(ForecastJob job, const Wanted& wanted, const CuttingProcess& cut) {
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
  std::vector<CutAt> places;
  places.reserve(forecast.places.size());
  for (const jobs::MillingPlace& one : forecast.places) {
    places.push_back({.path_mm = one.path_mm,
                      .force_programmed_n = one.force_peak_n,
                      .force_n = one.force_planned_n,
                      .feed_programmed = one.feed_programmed,
                      .feed = one.feed_planned,
                      .power_w = one.power_w,
                      .size = one.area_mm2,
                      .deflection_um = one.deflection_um});
  }
  auto answer = answer_of(request.job, wanted, forecast, places);
  (*answer)["kind"] = "milling";
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

CommandResult told(const ProgramFolder& folder, const json& parameters, ForecastJob job) {
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
    return *cut ? milling(std::move(job), wanted(parameters), **cut)
                : turning(std::move(job), wanted(parameters));
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
    return told(folder, parameters, std::move(bounded));
  };
}

}  // namespace stanok::daemon
