#include "process/grinding/stability.h"

#include "process/grinding/force_law.h"

namespace stanok::process {

double stability_margin(const GrindingProcess& process) {
  const double zeta = damping_ratio(process);
  const double limit_n_per_mm = 2.0 * process.stiffness_n_per_m / 1000.0 * zeta * (1.0 + zeta);
  const double layer_mm = process.removal_end_mm2_per_rad / removal_radius_mm(process);
  return limit_n_per_mm / ForceLaw(process).cutting_stiffness_n_per_mm(layer_mm);
}

}  // namespace stanok::process
