#include "process/grinding/force_law.h"

#include <cmath>

namespace stanok::process {

ForceLaw::ForceLaw(const GrindingProcess& process)
    : factor_(process.force_factor * process.width_mm *
              std::pow(part_surface_speed_m_per_min(process), process.force_exponent)),
      factor_of_layer_(factor_ * std::pow(removal_radius_mm(process), process.force_exponent)),
      exponent_(process.force_exponent) {}

double ForceLaw::force_n(double removal_mm2_per_rad) const {
  return factor_ * std::pow(removal_mm2_per_rad, exponent_);
}

double ForceLaw::removal_mm2_per_rad(double force_n) const {
  return std::pow(force_n / factor_, 1.0 / exponent_);
}

double ForceLaw::cutting_stiffness_n_per_mm(double layer_mm) const {
  return factor_of_layer_ * exponent_ * std::pow(layer_mm, exponent_ - 1.0);
}

}  // namespace stanok::process
