// What a recorded cut tells of drive, material and machine.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "daemon/desk/log_folder.h"
#include "daemon/desk/process/process_answers.h"
#include "daemon/desk/process/process_desk.h"
#include "jobs/cutting/cut_log.h"
#include "jobs/cutting/figures.h"
#include "jobs/cutting/grind_log.h"
#include "jobs/cutting/milling_log.h"
#include "jobs/cutting/power_points.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using jobs::StockStep;
using nlohmann::json;
using process::Estimate;
using protocol::Failure;

constexpr std::size_t rows_read_max = 1'000'000;  // cycles of a log, some hundred bytes each
constexpr std::size_t stock_steps_max = 100;
constexpr double force_ratio_usual = 0.4;  // tangential over normal force of a wheel
constexpr double wheel_speed_usual_m_per_s = 35.0;
constexpr double wheel_efficiency_usual = 0.85;

json figure_json(std::string_view name, const Estimate& estimate) {
  return {
      {"name", name}, {"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

// Each in the unit in which people read it, and in SI units.
json figures_json(const jobs::Figures& figures) {
  json list = json::array();
  for (const jobs::Figure& figure : figures) {
    json& one = list.emplace_back(figure_json(figure.name_read, figure.read()));
    one["si"] = figure_json(figure.name, figure.estimate);
  }
  return list;
}

// Time, power as recorded, power as fitted, of the rows with a reading.
template <class Row>
json power_json(const std::vector<double>& time_s, const std::vector<Row>& rows,
                const std::vector<double>& fitted_w) {
  return jobs::thinned(
      jobs::power_points(time_s, rows, fitted_w), ProcessDesk::rows_max,
      jobs::columns_named(jobs::power_columns(), {"time_s", "recorded_w", "model_w"}));
}

// "0:32,-20:33": from this Z on this radius, mm, with falling Z; nothing: it is not of this form.
std::optional<std::vector<StockStep>> stock_of(const std::string& text) {
  std::vector<StockStep> stock;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto number = [&](double& value) {
    const auto [next, error] = std::from_chars(at, end, value);
    const bool is_number = error == std::errc{} && std::isfinite(value);
    at = next;
    return is_number;
  };
  while (at != end && stock.size() < stock_steps_max) {
    StockStep step;
    if (!number(step.z_mm) || at == end || *at != ':') return std::nullopt;
    ++at;
    if (!number(step.radius_mm) || !(step.radius_mm > 0.0)) return std::nullopt;
    if (!stock.empty() && !(step.z_mm < stock.back().z_mm)) return std::nullopt;
    stock.push_back(step);
    if (at == end) return stock;
    if (*at != ',') return std::nullopt;
    ++at;
  }
  return std::nullopt;
}

struct FiguresRequest {
  json parameters;
  int channel = 1;
  fs::path log;
  ProgramFolder folder;
  jobs::ReadingBounds bounds{};

  [[nodiscard]] int spindle() const { return parameters.value("spindle", 1) - 1; }
};

CommandResult turning_figures(const FiguresRequest& request) {
  const auto stock = stock_of(request.parameters.value("stock", std::string()));
  if (!stock) {
    return nothing_told(
        "give the stock before the cut as Z:RADIUS in mm with falling Z, for example 0:32,-20:33");
  }
  const jobs::CutLog log = jobs::read_cut_log(request.log, {.channel = request.channel,
                                                            .spindle = request.spindle(),
                                                            .stock = *stock,
                                                            .bounds = request.bounds});
  const auto fit = process::fit_turning(log.record);
  if (!fit) return nothing_told(fit.error());
  double rev_per_min = 0.0;
  for (const process::CutRow& row : log.record.rows)
    rev_per_min = std::max(rev_per_min, row.rev_per_min);
  const double coefficient_n = request.parameters.value("coefficient", 0.0);
  return json{{"figures", figures_json(jobs::figures_of(*fit, coefficient_n))},
              {"noise", fit->noise},
              {"residual_w", fit->residual_w},
              {"readings", fit->readings},
              {"power", power_json(log.time_s, log.record.rows, fit->fitted_w)},
              {"text", jobs::process_section(*fit, rev_per_min, coefficient_n)}};
}

CommandResult grinding_figures(const FiguresRequest& request) {
  const std::string name = request.parameters.value("program", std::string());
  const auto file = request.folder.read(name);
  if (!file) return Unexpected<Failure>(file.error());
  process::DesignRequest sheet;
  try {
    sheet = config::read_grinding_file(file->path);
  } catch (const config::ConfigError& error) {
    return wrong_file(error, name);
  }
  const json& given = request.parameters;
  jobs::GrindLogRequest asked{
      .channel = request.channel,
      .spindle = request.spindle(),
      .allowance_mm = sheet.allowance_mm,
      .watts_per_newton = given.value("force_ratio", force_ratio_usual) *
                          given.value("wheel_speed", wheel_speed_usual_m_per_s) /
                          given.value("efficiency", wheel_efficiency_usual),
      .bounds = request.bounds};
  if (given.contains("touch")) asked.touch_mm = given["touch"].get<double>();
  const jobs::GrindLog log = jobs::read_grind_log(request.log, asked);
  const auto fit = process::fit_grinding(log.record, sheet.process);
  if (!fit) return nothing_told(fit.error());
  const auto readings = std::ranges::count_if(
      log.record.rows, [](const process::GrindRow& row) { return std::isfinite(row.power_w); });
  return json{{"figures", figures_json(jobs::figures_of(*fit))},
              {"noise", fit->noise},
              {"residual_w", fit->residual_w},
              {"readings", readings},
              {"power", power_json(log.time_s, log.record.rows, fit->fitted_w)},
              {"text", jobs::with_figures(file->text, *fit)}};
}

CommandResult milling_figures(const FiguresRequest& request) {
  const std::string name = request.parameters.value("program", std::string());
  const auto file = request.folder.read(name);
  if (!file) return Unexpected<Failure>(file.error());
  jobs::MillingLogRequest asked{.channel = request.channel,
                                .spindle = request.spindle(),
                                .cut = {},
                                .tool = request.parameters.value("tool", 0),
                                .memory_max = workpiece_bytes_max,
                                .bounds = request.bounds};
  try {
    asked.cut = config::read_chatter_file(file->path);
  } catch (const config::ConfigError& error) {
    return wrong_file(error, name);
  }
  if (asked.cut.kind != process::CutKind::milling)
    return nothing_told(name + " is not a file of a milling tool; set kind = \"milling\"");
  const jobs::MillingLog log = jobs::read_milling_log(request.log, asked);
  const auto fit = process::fit_milling(log.record);
  if (!fit) return nothing_told(fit.error());
  const double efficiency = request.parameters.value("efficiency", 1.0);
  return json{{"figures", figures_json(jobs::figures_of(*fit, efficiency))},
              {"noise", fit->noise},
              {"residual_w", fit->residual_w},
              {"readings", fit->readings},
              {"power", power_json(log.time_s, log.record.rows, fit->fitted_w)},
              {"text", jobs::with_figures(file->text, jobs::cut_forces(*fit, efficiency))}};
}

CommandResult figures_told(const FiguresRequest& request) {
  if (const auto failure = too_large(request.log)) return Unexpected<Failure>(*failure);
  try {
    const auto kind = request.parameters.value("kind", std::string("turning"));
    auto answer = kind == "grinding"  ? grinding_figures(request)
                  : kind == "milling" ? milling_figures(request)
                                      : turning_figures(request);
    if (answer) {
      (*answer)["file"] = request.log.filename().string();
      (*answer)["kind"] = kind;
    }
    return answer;
  } catch (const std::runtime_error& error) {
    return nothing_told(error.what());
  }
}

}  // namespace

BackgroundWork::Work figures_from(const fs::path& log, int channel, const ProgramFolder& folder,
                                  const json& parameters) {
  return [request = FiguresRequest{.parameters = parameters,
                                   .channel = channel,
                                   .log = log,
                                   .folder = folder}](const std::stop_token& stop) {
    FiguresRequest bounded = request;
    bounded.bounds = {.rows_max = rows_read_max, .gives_up = gives_up_when(stop)};
    return figures_told(bounded);
  };
}

}  // namespace stanok::daemon
