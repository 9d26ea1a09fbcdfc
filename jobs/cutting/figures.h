// The figures that an identification finds, in one list each: what they are called in every face,
// with the SI unit, and how people read them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jobs/cutting/found_figures.h"

namespace stanok::jobs {

struct Figure {
  std::string_view name;       // power_lag_s
  std::string_view name_read;  // the same in the unit in which people read it: power_lag_ms
  std::string_view title;      // lag of the sensor
  std::string_view unit;       // ms
  double factor = 1.0;         // of that unit
  int digits = 0;
  process::Estimate estimate{};

  // In the unit in which people read it.
  [[nodiscard]] process::Estimate read() const {
    return {factor * estimate.value, factor * estimate.low, factor * estimate.high};
  }
};
using Figures = std::vector<Figure>;

// `coefficient_n`: C of the material, which gives the efficiency; 0: it is not known.
[[nodiscard]] Figures figures_of(const process::TurningFit& fit, double coefficient_n);
[[nodiscard]] Figures figures_of(const process::MillingFit& fit, double efficiency);
[[nodiscard]] Figures figures_of(const process::GrindingFit& fit);

}  // namespace stanok::jobs
