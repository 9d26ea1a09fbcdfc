#include "client/offline/process/identify/milling_fit_report.h"

#include <algorithm>

#include "client/offline/process/identify/figure_table.h"
#include "client/offline/process/identify/keyed_text.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;

Estimate times(double factor, const Estimate& estimate) {
  return {.value = factor * estimate.value,
          .low = factor * estimate.low,
          .high = factor * estimate.high};
}

Estimate force_of(const MillingFitReport& report) {
  return times(report.efficiency, report.fit.force_n_per_mm2);
}

Estimate edge_of(const MillingFitReport& report) {
  return times(report.efficiency, report.fit.edge_n_per_mm);
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
  Estimate edge = edge_of(report);
  edge.value = std::max(edge.value, 0.0);
  return with_figures(cut_file, {{.key = "force", .estimate = force_of(report), .digits = 1},
                                 {.key = "edge_force", .estimate = edge, .digits = 2}});
}

void draw_picture(const MillingFitReport& report, const std::filesystem::path& file) {
  draw_power_picture(power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w),
                     file);
}

}  // namespace stanok::client
