// The power of a record as it was and as the model has it, which the pictures of an identification
// show.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "jobs/columns/columns.h"

namespace stanok::jobs {

struct PowerPoint {
  double time_s = 0.0;
  double recorded_w = 0.0;
  double model_w = 0.0;
};

// time_s, recorded_w, model_w, residual_w.
[[nodiscard]] const Columns<PowerPoint>& power_columns();

// Of rows with a power.
template <class Row>
[[nodiscard]] std::vector<PowerPoint> power_points(const std::vector<double>& time_s,
                                                   const std::vector<Row>& rows,
                                                   const std::vector<double>& fitted_w) {
  std::vector<PowerPoint> points;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::isfinite(rows[k].power_w)) points.push_back({time_s[k], rows[k].power_w, fitted_w[k]});
  }
  return points;
}

}  // namespace stanok::jobs
