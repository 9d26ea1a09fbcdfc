#include "client/offline/process/identify/identify_report.h"

#include "client/offline/process/identify/figure_table.h"
#include "jobs/cutting/found_figures.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;
using process::TurningFit;

// C over C / eta.
Estimate efficiency_of(const IdentifyReport& report) {
  return jobs::quotient(report.coefficient_n, report.fit.coefficient_n);
}

double speed_of(const IdentifyReport& report) {
  return speed_max(report.log.record.rows);
}

}  // namespace

std::string to_text(const IdentifyReport& report) {
  const TurningFit& fit = report.fit;
  FigureTable table;
  table.add("C / efficiency", fit.coefficient_n, {.name = "N", .digits = 1});
  if (report.coefficient_n > 0.0)
    table.add("efficiency", efficiency_of(report), {.name = "", .digits = 4});
  table.add("exponent y", fit.exponent, {.name = "", .digits = 4});
  table.add_drive(fit);
  return table.text() + drive_text(fit, speed_of(report));
}

ordered_json to_json(const IdentifyReport& report) {
  ordered_json json{{"coefficient_over_efficiency_n", figure_json(report.fit.coefficient_n)},
                    {"exponent", figure_json(report.fit.exponent)}};
  add_drive_json(json, report.fit, speed_of(report));
  if (report.coefficient_n > 0.0) json["efficiency"] = figure_json(efficiency_of(report));
  return json;
}

std::string process_section(const IdentifyReport& report) {
  return jobs::process_section(report.fit, speed_of(report), report.coefficient_n);
}

void draw_picture(const IdentifyReport& report, const std::filesystem::path& file) {
  draw_power_picture(power_points(report.log.time_s, report.log.record.rows, report.fit.fitted_w),
                     file);
}

}  // namespace stanok::client
