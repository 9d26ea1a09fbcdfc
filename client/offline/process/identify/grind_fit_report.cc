#include "client/offline/process/identify/grind_fit_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>

#include "client/offline/process/identify/power_picture.h"
#include "client/terminal/text_table.h"

namespace stanok::client {
namespace {

using nlohmann::ordered_json;
using process::Estimate;
using process::GrindingFit;

ordered_json figure_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

int readings_of(const GrindLog& log) {
  int count = 0;
  for (const process::GrindRow& row : log.record.rows) count += std::isfinite(row.power_w) ? 1 : 0;
  return count;
}

// `key = value` of a line, without what stands before and behind; npos: another line.
struct KeyPlace {
  std::size_t value = std::string::npos;
  std::size_t end = 0;
};

KeyPlace place_of_key(const std::string& line, const std::string& key) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos || line.compare(begin, key.size(), key) != 0) return {};
  const std::size_t equals = line.find_first_not_of(" \t", begin + key.size());
  if (equals == std::string::npos || line[equals] != '=') return {};
  const std::size_t value = line.find_first_not_of(" \t", equals + 1);
  if (value == std::string::npos) return {};
  return {.value = value, .end = line.find_last_not_of(" \t\r") + 1};
}

}  // namespace

std::string to_text(const GrindFitReport& report) {
  const GrindingFit& fit = report.fit;
  TextTable table({"quantity", "value", "from", "to", "unit"});
  const auto add = [&](const char* name, const Estimate& estimate, const char* unit, double part,
                       int digits) {
    table.add_row({name, fmt::format("{:.{}f}", part * estimate.value, digits),
                   fmt::format("{:.{}f}", part * estimate.low, digits),
                   fmt::format("{:.{}f}", part * estimate.high, digits), unit});
  };
  constexpr double n_per_um = 1e-6;
  add("stiffness C", fit.stiffness_n_per_m, "N/um", n_per_um, 3);
  add("force factor C_p", fit.force_factor, "N/mm", 1.0, 4);
  add("exponent alpha", fit.force_exponent, "", 1.0, 4);
  add("idle power", fit.idle_w, "W", 1.0, 1);
  add("lag of the sensor", fit.lag_s, "ms", 1e3, 1);
  return table.text(Terminal(STDOUT_FILENO)) +
         fmt::format(
             "intervals hold the value with 95 % probability\n"
             "{} readings, noise {:.1f} % of the cutting power, {:.1f} W left (rms)\n",
             readings_of(report.log), 100.0 * fit.noise, fit.residual_w);
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

std::string with_figures(const std::string& process_file, const GrindingFit& fit) {
  struct Figure {
    std::string key;
    Estimate estimate;
    int digits;
  };
  const std::array<Figure, 3> figures{{{"stiffness", fit.stiffness_n_per_m, 0},
                                       {"force_factor", fit.force_factor, 4},
                                       {"force_exponent", fit.force_exponent, 4}}};
  std::string text;
  for (std::size_t begin = 0; begin < process_file.size();) {
    const std::size_t end = std::min(process_file.find('\n', begin), process_file.size());
    std::string line = process_file.substr(begin, end - begin);
    for (const Figure& figure : figures) {
      const KeyPlace place = place_of_key(line, figure.key);
      if (place.value == std::string::npos) continue;
      // A number of TOML has a point or is an integer; these keys take both.
      line = line.substr(0, place.value) +
             fmt::format("{:.{}f}  # {:.{}f} to {:.{}f}", figure.estimate.value, figure.digits,
                         figure.estimate.low, figure.digits, figure.estimate.high, figure.digits) +
             line.substr(place.end);
      break;
    }
    text += line;
    if (end < process_file.size()) text += "\n";
    begin = end + 1;
  }
  return text;
}

void draw_picture(const GrindFitReport& report, const std::filesystem::path& file) {
  std::vector<PowerPoint> points;
  for (std::size_t k = 0; k < report.log.record.rows.size(); ++k) {
    const double power = report.log.record.rows[k].power_w;
    if (std::isfinite(power))
      points.push_back({report.log.time_s[k], power, report.fit.fitted_w[k]});
  }
  draw_power_picture(points, file);
}

}  // namespace stanok::client
