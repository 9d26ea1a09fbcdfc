// What the reports of all identifications share: the table of figures with their intervals, and
// their JSON.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jobs/cutting/figures.h"
#include "process/identify/drive_fit.h"

namespace stanok::client {

// For standard output, with what the intervals are.
[[nodiscard]] std::string figures_text(const jobs::Figures& figures);

// {name: {value, low, high}}, in SI units.
[[nodiscard]] nlohmann::ordered_json figures_json(const jobs::Figures& figures);
// Noise, residual and how the idle power divides; `rev_per_min`: the greatest of the record.
void add_drive_json(nlohmann::ordered_json& json, const process::DriveFit& fit, double rev_per_min);
// `{idle power}; {readings}, {noise}, {residual}`, a line.
[[nodiscard]] std::string drive_text(const process::DriveFit& fit, double rev_per_min);
[[nodiscard]] std::string quality_text(int readings, double noise, double residual_w);

// The greatest speed of rows.
template <class Row>
double speed_max(const std::vector<Row>& rows) {
  double most = 0.0;
  for (const Row& row : rows) most = std::max(most, row.rev_per_min);
  return most;
}

}  // namespace stanok::client
