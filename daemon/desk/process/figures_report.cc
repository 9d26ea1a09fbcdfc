// What a recorded cut tells of drive, material and machine.

#include <algorithm>
#include <filesystem>

#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "daemon/desk/log_folder.h"
#include "daemon/desk/process/process_answers.h"
#include "daemon/desk/process/process_desk.h"
#include "jobs/cutting/identification.h"
#include "protocol/contract/fields_json.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::Estimate;
using protocol::Failure;

constexpr std::size_t rows_read_max = 1'000'000;  // cycles of a log, some hundred bytes each
constexpr double force_ratio_usual = 0.4;         // tangential over normal force of a wheel
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

json found_json(const jobs::Identification& found) {
  return {{"figures", figures_json(found.figures)},
          {"noise", found.noise},
          {"residual_w", found.residual_w},
          {"readings", found.readings},
          {"fit", protocol::fields_json(jobs::fit_fields(found.verdict))},
          {"power", jobs::thinned(found.power, ProcessDesk::rows_max,
                                  jobs::columns_named(jobs::power_columns(),
                                                      {"time_s", "recorded_w", "model_w"}))},
          {"text", found.text}};
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
  const auto stock = jobs::stock_of_text(request.parameters.value("stock", std::string()));
  if (!stock) {
    return nothing_told(
        "give the stock before the cut as Z:RADIUS or Z:RADIUS:HARDNESS in mm and HB with falling "
        "Z, "
        "for example 0:32:200,-20:33:240");
  }
  return found_json(jobs::identify(
      jobs::LoggedTurning{.log = request.log,
                          .reading = {.channel = request.channel,
                                      .spindle = request.spindle(),
                                      .stock = *stock,
                                      .bounds = request.bounds},
                          .coefficient_n = request.parameters.value("coefficient", 0.0)}));
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
  return found_json(jobs::identify(jobs::LoggedPlunge{
      .log = request.log, .reading = asked, .sheet = sheet.process, .process_text = file->text}));
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
  return found_json(jobs::identify(
      jobs::LoggedMilling{.log = request.log,
                          .reading = asked,
                          .cut_text = file->text,
                          .efficiency = request.parameters.value("efficiency", 1.0)}));
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
