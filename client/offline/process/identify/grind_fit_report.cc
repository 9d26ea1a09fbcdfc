#include "client/offline/process/identify/grind_fit_report.h"

#include <cmath>

#include "client/offline/process/identify/figure_table.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::GrindingFit;

int readings_of(const jobs::GrindLog& log) {
  int count = 0;
  for (const process::GrindRow& row : log.record.rows) count += std::isfinite(row.power_w) ? 1 : 0;
  return count;
}

}  // namespace

std::string to_text(const GrindFitReport& report) {
  const GrindingFit& fit = report.fit;
  FigureTable table;
  table.add("stiffness C", fit.stiffness_n_per_m, {.name = "N/um", .factor = 1e-6, .digits = 3});
  table.add("force factor C_p", fit.force_factor, {.name = "N/mm", .digits = 4});
  table.add("exponent alpha", fit.force_exponent, {.name = "", .digits = 4});
  table.add("idle power", fit.idle_w, {.name = "W", .digits = 1});
  table.add("lag of the sensor", fit.lag_s, {.name = "ms", .factor = 1e3, .digits = 1});
  return table.text() + quality_text(readings_of(report.log), fit.noise, fit.residual_w);
}

ordered_json to_json(const GrindFitReport& report) {
  const GrindingFit& fit = report.fit;
  return {{"stiffness_n_per_m", figure_json(fit.stiffness_n_per_m)},
          {"force_factor", figure_json(fit.force_factor)},
          {"force_exponent", figure_json(fit.force_exponent)},
          {"idle_w", figure_json(fit.idle_w)},
          {"power_lag_s", figure_json(fit.lag_s)},
          {"noise", fit.noise},
          {"residual_w", fit.residual_w},
          {"readings", readings_of(report.log)}};
}

void draw_picture(const GrindFitReport& report, const std::filesystem::path& file) {
  draw_power_picture(power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w),
                     file);
}

}  // namespace stanok::client
