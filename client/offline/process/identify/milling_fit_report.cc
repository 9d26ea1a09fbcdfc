#include "client/offline/process/identify/milling_fit_report.h"

#include "client/offline/process/identify/figure_table.h"
#include "client/offline/process/identify/power_picture.h"
#include "jobs/cutting/found_figures.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

jobs::Figures figures_of_milling(const MillingFitReport& report) {
  return jobs::figures_of(report.fit, report.efficiency);
}

double speed_of_milling(const MillingFitReport& report) {
  return speed_max(report.log.record.rows);
}

}  // namespace

std::string to_text(const MillingFitReport& report) {
  return figures_text(figures_of_milling(report)) +
         drive_text(report.fit, speed_of_milling(report));
}

ordered_json to_json(const MillingFitReport& report) {
  ordered_json json = figures_json(figures_of_milling(report));
  json["efficiency"] = report.efficiency;
  add_drive_json(json, report.fit, speed_of_milling(report));
  return json;
}

std::string with_figures(const std::string& cut_file, const MillingFitReport& report) {
  return jobs::with_figures(cut_file, jobs::cut_forces(report.fit, report.efficiency));
}

void draw_picture(const MillingFitReport& report, const std::filesystem::path& file) {
  draw_power_picture(
      jobs::power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w), file);
}

}  // namespace stanok::client
