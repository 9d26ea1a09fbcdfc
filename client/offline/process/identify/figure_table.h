// What the reports of all identifications share: a table of figures with their intervals, their
// JSON, and the rows in which a power was recorded.
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/offline/process/identify/power_picture.h"
#include "client/terminal/text_table.h"
#include "process/identify/drive_fit.h"

namespace stanok::client {

struct FigureUnit {
  std::string name;
  double factor = 1.0;  // of the unit in which it is known
  int digits = 0;
};

class FigureTable {
 public:
  void add(const std::string& quantity, const process::Estimate& estimate, const FigureUnit& unit);
  // Idle power and lag.
  void add_drive(const process::DriveFit& fit);
  // For standard output, with what the intervals are.
  [[nodiscard]] std::string text() const;

 private:
  TextTable table_{{"quantity", "value", "from", "to", "unit"}};
};

[[nodiscard]] nlohmann::ordered_json figure_json(const process::Estimate& estimate);
// Lag, idle power, noise and residual; `rev_per_min`: the greatest of the record.
void add_drive_json(nlohmann::ordered_json& json, const process::DriveFit& fit, double rev_per_min);
// `{idle power}; {readings}, {noise}, {residual}`, a line.
[[nodiscard]] std::string drive_text(const process::DriveFit& fit, double rev_per_min);
[[nodiscard]] std::string quality_text(int readings, double noise, double residual_w);

// Of rows with a power, as recorded and as fitted.
template <class Row>
std::vector<PowerPoint> power_points(const std::vector<double>& time_s,
                                     const std::vector<Row>& rows,
                                     const std::vector<double>& fitted_w);

// The greatest speed of rows.
template <class Row>
double speed_max(const std::vector<Row>& rows);

template <class Row>
std::vector<PowerPoint> power_points(const std::vector<double>& time_s,
                                     const std::vector<Row>& rows,
                                     const std::vector<double>& fitted_w) {
  std::vector<PowerPoint> points;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::isfinite(rows[k].power_w)) points.push_back({time_s[k], rows[k].power_w, fitted_w[k]});
  }
  return points;
}

template <class Row>
double speed_max(const std::vector<Row>& rows) {
  double most = 0.0;
  for (const Row& row : rows) most = std::max(most, row.rev_per_min);
  return most;
}

}  // namespace stanok::client
