#include "client/offline/process/identify/figure_table.h"

#include <fmt/format.h>
#include <unistd.h>

namespace stanok::client {

using nlohmann::ordered_json;
using process::DriveFit;
using process::Estimate;

void FigureTable::add(const std::string& quantity, const Estimate& estimate,
                      const FigureUnit& unit) {
  const auto number = [&](double value) {
    return fmt::format("{:.{}f}", unit.factor * value, unit.digits);
  };
  table_.add_row(
      {quantity, number(estimate.value), number(estimate.low), number(estimate.high), unit.name});
}

void FigureTable::add_drive(const DriveFit& fit) {
  add("lag of the sensor", fit.lag_s, {.name = "ms", .factor = 1e3, .digits = 2});
  add("idle power, with n", fit.idle_linear, {.name = "W min", .digits = 5});
  if (fit.idle_square)
    add("idle power, with n^2", *fit.idle_square, {.name = "W min^2", .digits = 8});
}

std::string FigureTable::text() const {
  return table_.text(Terminal(STDOUT_FILENO)) + "intervals hold the value with 95 % probability\n";
}

ordered_json figure_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

void add_drive_json(ordered_json& json, const DriveFit& fit, double rev_per_min) {
  json["power_lag_s"] = figure_json(fit.lag_s);
  json["idle_linear_w_min"] = figure_json(fit.idle_linear);
  json["idle_coulomb_part"] = fit.coulomb_part(rev_per_min);
  json["noise"] = fit.noise;
  json["residual_w"] = fit.residual_w;
  json["readings"] = fit.readings;
  if (fit.idle_square) json["idle_square_w_min2"] = figure_json(*fit.idle_square);
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
