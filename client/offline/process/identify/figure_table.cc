#include "client/offline/process/identify/figure_table.h"

#include <fmt/format.h>
#include <unistd.h>

#include "client/terminal/text_table.h"

namespace stanok::client {

using nlohmann::ordered_json;
using process::DriveFit;
using process::Estimate;

std::string figures_text(const jobs::Figures& figures) {
  TextTable table{{"quantity", "value", "from", "to", "unit"}};
  for (const jobs::Figure& figure : figures) {
    const auto number = [&](double value) { return fmt::format("{:.{}f}", value, figure.digits); };
    const Estimate read = figure.read();
    table.add_row({std::string(figure.title), number(read.value), number(read.low),
                   number(read.high), std::string(figure.unit)});
  }
  return table.text(Terminal(STDOUT_FILENO)) + "intervals hold the value with 95 % probability\n";
}

ordered_json figures_json(const jobs::Figures& figures) {
  ordered_json json = ordered_json::object();
  for (const jobs::Figure& figure : figures) {
    json[std::string(figure.name)] = {{"value", figure.estimate.value},
                                      {"low", figure.estimate.low},
                                      {"high", figure.estimate.high}};
  }
  return json;
}

void add_drive_json(ordered_json& json, const DriveFit& fit, double rev_per_min) {
  json["idle_coulomb_part"] = fit.coulomb_part(rev_per_min);
  json["noise"] = fit.noise;
  json["residual_w"] = fit.residual_w;
  json["readings"] = fit.readings;
}

std::string drive_text(const DriveFit& fit, double rev_per_min) {
  return fmt::format("idle power {:.1f} W at {:.0f} rev/min; ", fit.idle_w(rev_per_min),
                     rev_per_min) +
         quality_text(fit.readings, fit.noise, fit.residual_w);
}

std::string quality_text(int readings, double noise, double residual_w) {
  return fmt::format("{} readings, noise {:.1f} % of the cutting power, {:.1f} W left (rms)\n",
                     readings, 100.0 * noise, residual_w);
}

}  // namespace stanok::client
