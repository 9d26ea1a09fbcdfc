#include "client/offline/process/identify/identify_report.h"

#include "client/offline/process/identify/figure_table.h"
#include "client/offline/process/identify/power_picture.h"
#include "jobs/cutting/found_figures.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;

jobs::Figures figures_of(const IdentifyReport& report) {
  return jobs::figures_of(report.fit, report.coefficient_n);
}

double speed_of(const IdentifyReport& report) {
  return speed_max(report.log.record.rows);
}

}  // namespace

std::string to_text(const IdentifyReport& report) {
  return figures_text(figures_of(report)) + drive_text(report.fit, speed_of(report));
}

ordered_json to_json(const IdentifyReport& report) {
  ordered_json json = figures_json(figures_of(report));
  add_drive_json(json, report.fit, speed_of(report));
  return json;
}

std::string process_section(const IdentifyReport& report) {
  return jobs::process_section(report.fit, speed_of(report), report.coefficient_n);
}

void draw_picture(const IdentifyReport& report, const std::filesystem::path& file) {
  draw_power_picture(
      jobs::power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w), file);
}

}  // namespace stanok::client
