// The normal force of grinding as a power of the rate of removal: P = C_p B (Q V)^alpha.
//
// Q in mm2/rad, V the surface speed of the part in m/min (the seed's V_delta), B the width in mm,
// P in N. The paper's equation (7) is lost in print; (8) is this law solved for Q.
#pragma once

#include "process/grinding/grinding_process.h"

namespace stanok::process {

class ForceLaw {
 public:
  explicit ForceLaw(const GrindingProcess& process);

  // P of a removal Q >= 0, N.
  [[nodiscard]] double force_n(double removal_mm2_per_rad) const;
  // Q of a force P >= 0, mm2/rad: equation (8) of the paper for P = C delta.
  [[nodiscard]] double removal_mm2_per_rad(double force_n) const;
  // P = factor a^alpha of a layer a in mm.
  [[nodiscard]] double factor_of_layer() const { return factor_of_layer_; }
  [[nodiscard]] double exponent() const { return exponent_; }
  // dP/da at a layer a > 0, N/mm: the stiffness of the cut.
  [[nodiscard]] double cutting_stiffness_n_per_mm(double layer_mm) const;

 private:
  double factor_;           // C_p B V^alpha
  double factor_of_layer_;  // the same times R_eq^alpha
  double exponent_;
};

}  // namespace stanok::process
