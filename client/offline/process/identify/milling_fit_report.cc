#include "client/offline/process/identify/milling_fit_report.h"

#include "client/offline/process/identify/figure_table.h"
#include "jobs/cutting/found_figures.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;

Estimate force_of(const MillingFitReport& report) {
  return jobs::cut_forces(report.fit, report.efficiency).force_n_per_mm2;
}

Estimate edge_of(const MillingFitReport& report) {
  return jobs::cut_forces(report.fit, report.efficiency).edge_n_per_mm;
}

double speed_of(const MillingFitReport& report) {
  return speed_max(report.log.record.rows);
}

}  // namespace

std::string to_text(const MillingFitReport& report) {
  FigureTable table;
  table.add("force K_t", force_of(report), {.name = "N/mm2", .digits = 1});
  table.add("force of the edge K_te", edge_of(report), {.name = "N/mm", .digits = 2});
  table.add_drive(report.fit);
  return table.text() + drive_text(report.fit, speed_of(report));
}

ordered_json to_json(const MillingFitReport& report) {
  ordered_json json{{"force_n_per_mm2", figure_json(force_of(report))},
                    {"edge_force_n_per_mm", figure_json(edge_of(report))},
                    {"efficiency", report.efficiency}};
  add_drive_json(json, report.fit, speed_of(report));
  return json;
}

std::string with_figures(const std::string& cut_file, const MillingFitReport& report) {
  return jobs::with_figures(cut_file, jobs::cut_forces(report.fit, report.efficiency));
}

void draw_picture(const MillingFitReport& report, const std::filesystem::path& file) {
  draw_power_picture(power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w),
                     file);
}

}  // namespace stanok::client
