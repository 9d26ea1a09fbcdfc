#include "client/offline/process/identify/identify_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "client/offline/process/identify/power_picture.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;
using process::TurningFit;

ordered_json estimate_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

double speed_max(const CutLog& log) {
  double most = 0.0;
  for (const process::CutRow& row : log.record.rows) most = std::max(most, row.rev_per_min);
  return most;
}

// C over C / eta.
Estimate efficiency_of(const IdentifyReport& report) {
  const Estimate& quotient = report.fit.coefficient_n;
  return {.value = report.coefficient_n / quotient.value,
          .low = report.coefficient_n / quotient.high,
          .high = report.coefficient_n / quotient.low};
}

std::vector<PowerPoint> points_of(const IdentifyReport& report) {
  std::vector<PowerPoint> points;
  for (std::size_t k = 0; k < report.log.record.rows.size(); ++k) {
    const double power = report.log.record.rows[k].power_w;
    if (std::isfinite(power))
      points.push_back({report.log.time_s[k], power, report.fit.fitted_w[k]});
  }
  return points;
}

}  // namespace

std::string to_text(const IdentifyReport& report) {
  const TurningFit& fit = report.fit;
  TextTable table({"quantity", "value", "from", "to", "unit"});
  const auto add = [&](const std::string& name, const Estimate& estimate, const char* unit,
                       int digits) {
    table.add_row({name, fmt::format("{:.{}f}", estimate.value, digits),
                   fmt::format("{:.{}f}", estimate.low, digits),
                   fmt::format("{:.{}f}", estimate.high, digits), unit});
  };
  add("C / efficiency", fit.coefficient_n, "N", 1);
  if (report.coefficient_n > 0.0) add("efficiency", efficiency_of(report), "", 4);
  add("exponent y", fit.exponent, "", 4);
  const Estimate lag_ms{
      .value = 1e3 * fit.lag_s.value, .low = 1e3 * fit.lag_s.low, .high = 1e3 * fit.lag_s.high};
  add("lag of the sensor", lag_ms, "ms", 2);
  add("idle power, with n", fit.idle_linear, "W min", 5);
  if (fit.idle_square) add("idle power, with n^2", *fit.idle_square, "W min^2", 8);
  const double n = speed_max(report.log);
  return table.text(Terminal(STDOUT_FILENO)) +
         fmt::format(
             "intervals hold the value with 95 % probability\n"
             "idle power {:.1f} W at {:.0f} rev/min; {} readings, noise {:.1f} % of the "
             "cutting power, {:.1f} W left (rms)\n",
             fit.idle_w(n), n, fit.readings, 100.0 * fit.noise, fit.residual_w);
}

ordered_json to_json(const IdentifyReport& report) {
  const TurningFit& fit = report.fit;
  const double n = speed_max(report.log);
  ordered_json json{{"coefficient_over_efficiency_n", estimate_json(fit.coefficient_n)},
                    {"exponent", estimate_json(fit.exponent)},
                    {"power_lag_s", estimate_json(fit.lag_s)},
                    {"idle_linear_w_min", estimate_json(fit.idle_linear)},
                    {"idle_coulomb_part", fit.coulomb_part(n)},
                    {"noise", fit.noise},
                    {"residual_w", fit.residual_w},
                    {"readings", fit.readings}};
  if (fit.idle_square) json["idle_square_w_min2"] = estimate_json(*fit.idle_square);
  if (report.coefficient_n > 0.0) json["efficiency"] = estimate_json(efficiency_of(report));
  return json;
}

std::string process_section(const IdentifyReport& report) {
  const TurningFit& fit = report.fit;
  const double n = speed_max(report.log);
  std::string text = "[process]\n";
  const auto add = [&](const char* key, const Estimate& estimate) {
    text += fmt::format("{} = {:.4f}  # {:.4f} to {:.4f}\n", key, estimate.value, estimate.low,
                        estimate.high);
  };
  if (report.coefficient_n > 0.0) {
    Estimate efficiency = efficiency_of(report);
    efficiency.value = std::min(efficiency.value, 1.0);
    add("efficiency", efficiency);
  }
  add("power_lag", fit.lag_s);
  add("feed_exponent", fit.exponent);
  if (fit.idle_square) {
    text +=
        fmt::format("idle_coulomb_part = {:.4f}  # at {:.0f} rev/min\n", fit.coulomb_part(n), n);
  }
  return text;
}

void draw_picture(const IdentifyReport& report, const std::filesystem::path& file) {
  draw_power_picture(points_of(report), file);
}

}  // namespace stanok::client
