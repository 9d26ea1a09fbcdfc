#include "client/offline/process/identify/grind_fit_report.h"

#include <cmath>

#include "client/offline/process/identify/figure_table.h"
#include "client/offline/process/identify/power_picture.h"

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
  return figures_text(jobs::figures_of(fit)) +
         quality_text(readings_of(report.log), fit.noise, fit.residual_w);
}

ordered_json to_json(const GrindFitReport& report) {
  ordered_json json = figures_json(jobs::figures_of(report.fit));
  json["noise"] = report.fit.noise;
  json["residual_w"] = report.fit.residual_w;
  json["readings"] = readings_of(report.log);
  return json;
}

void draw_picture(const GrindFitReport& report, const std::filesystem::path& file) {
  draw_power_picture(
      jobs::power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w), file);
}

}  // namespace stanok::client
