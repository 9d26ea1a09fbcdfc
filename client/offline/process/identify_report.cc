#include "client/offline/process/identify_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "client/terminal/text_table.h"
#include "recording/plot/gnuplot.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;
using process::TurningFit;
using recording::gnuplot_text;
using recording::number;

constexpr std::size_t shown_points_max = 6000;

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

// Time, reading, fit and what is left of them.
std::string rows_of_picture(const IdentifyReport& report) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < report.log.record.rows.size(); ++k)
    if (std::isfinite(report.log.record.rows[k].power_w)) rows.push_back(k);
  const std::size_t stride = 1 + rows.size() / shown_points_max;
  std::string text = "$power << END\n";
  for (std::size_t k = 0; k < rows.size(); k += stride) {
    const double power = report.log.record.rows[rows[k]].power_w;
    const double fitted = report.fit.fitted_w[rows[k]];
    text += number(report.log.time_s[rows[k]]) + " " + number(power) + " " + number(fitted) + " " +
            number(power - fitted) + "\n";
  }
  return text + "END\n";
}

std::string panel(const char* title, const char* label, const std::string& plot) {
  return "set label 1 " + gnuplot_text(title) +
         " at graph 0, graph 1.08 left font ',15' textcolor rgb '#2b2f33'\nset ylabel " +
         gnuplot_text(label) + "\nplot " + plot + "\n";
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

std::string picture_script(const IdentifyReport& report, const std::filesystem::path& file) {
  const bool is_png = file.extension() == ".png";
  std::string text = rows_of_picture(report);
  text += std::string("set terminal ") +
          (is_png ? "pngcairo enhanced background rgb 'white' font 'Sans,12'"
                  : "svg enhanced background rgb 'white' font 'Sans,14'") +
          " size 1100,800\nset output " + gnuplot_text(std::filesystem::absolute(file).string()) +
          "\nset encoding utf8\nset border 3 lc rgb '#9aa3a9' lw 1\n"
          "set tics nomirror out scale 0.6 textcolor rgb '#4a4f54'\n"
          "set grid lc rgb '#e7eaec' lw 1 lt 1\n"
          "set key at graph 1, graph 1.13 right top horizontal maxrows 1 Left reverse samplen 2 "
          "textcolor rgb '#2b2f33'\n"
          "set multiplot layout 2,1 margins 0.08,0.96,0.08,0.93 spacing 0,0.13\n";
  text += panel("Power of the spindle", "N_d [W]",
                "$power using 1:2 with points pt 7 ps 0.25 lc rgb '#9aa3a9' title 'recorded', \\\n"
                "  $power using 1:3 with lines lw 1.5 lc rgb '#1f4e79' title 'model'");
  text += "set xlabel 'time [s]'\n";
  text += panel("What the model leaves", "recorded - model [W]",
                "$power using 1:4 with points pt 7 ps 0.25 lc rgb '#c8553d' title 'residual'");
  return text + "unset multiplot\nunset output\n";
}

void draw_picture(const IdentifyReport& report, const std::filesystem::path& file) {
  if (const auto error = recording::draw(picture_script(report, file)))
    throw std::runtime_error("cannot draw " + file.string() + ": " + error->text);
}

}  // namespace stanok::client
