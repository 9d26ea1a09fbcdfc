// GrindingLobes: the width of a ground surface up to which waves do not grow, over the speed of the
// part.
//
// Waves are left on the part and on the wheel, and each is met again after its own turn. With the
// receptance G of the machine along the infeed, k' the normal force for a unit of width and layer,
// k_c' the stiffness of the contact for a unit of width, G_r the volume of part ground for one of
// wheel, and b the width,
//   (1/k') (1 / (1 - g_w e^(-s T_w)) + (v_w / (G_r v_s)) / (1 - g_s e^(-s T_s))) + 1/k_c' + b G = 0
// (R. Snoeys, D. Brown, Dominating parameters in grinding wheel and workpiece regenerative chatter,
// 10th MTDR Conf. 1969, 325). The contact of wheel and part is l long and evens out waves shorter
// than that: what is met again is the mean over it, so that g = sin(x)/x, x = pi f l / v with v the
// speed of the surface that carries the wave (I. Inasaki, B. Karpuschewski, H.-S. Lee, Grinding
// chatter, CIRP Annals 50 (2001) 515). Waves of the wheel are long and grow for minutes; those of
// the part are evened out where it turns slowly.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "process/chatter/cutting_process.h"
#include "process/chatter/stability_lobes.h"

namespace stanok::process {

class GrindingLobes {
 public:
  // `process` has modes_x, positive force and radii.
  explicit GrindingLobes(const CuttingProcess& process);

  // The least width that is not stable at a speed of the part (depth_mm of the point); nothing:
  // every width is stable.
  [[nodiscard]] std::optional<LobePoint> limit_at(double speed_rev_per_min) const;

 private:
  // The width at which the equation has a root at omega; real ones are borders of stability.
  [[nodiscard]] std::complex<double> width_at(double omega, double part_turn_s) const;

  // What a layer of the part takes off the wheel.
  [[nodiscard]] double wheel_weight(double part_turn_s) const;
  [[nodiscard]] std::vector<double> frequencies(double part_turn_s) const;

  CuttingProcess process_;
  double omega_from_ = 0.0;
  double omega_to_ = 0.0;
  double omega_step_max_ = 0.0;
};

}  // namespace stanok::process
