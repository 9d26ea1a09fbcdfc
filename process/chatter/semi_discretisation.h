// SemiDiscretisation: whether a cut at one speed and depth is stable, from the motion itself.
//
// The delayed term of M q'' + C q' + K q = -b H(t) (q(t) - q(t - T)) is held constant over short
// steps, so that one tooth period becomes a matrix; the cut is stable while all its eigenvalues lie
// within the unit circle (T. Insperger, G. Stepan, Updated semi-discretization method for periodic
// delay-differential equations, Int. J. Numer. Meth. Engng 61 (2004) 117). The coefficients of the
// teeth are taken as they are at each time, not their mean: so it finds what short cuts do, the
// period doubling too.
#pragma once

#include "process/chatter/cutting_process.h"

namespace stanok::process {

class SemiDiscretisation {
 public:
  explicit SemiDiscretisation(const CuttingProcess& process) : process_(process) {}

  // By how much a wave grows from tooth to tooth: the largest absolute eigenvalue; stable below 1.
  [[nodiscard]] double growth(double speed_rev_per_min, double depth_mm) const;

  // The least depth that is not stable, found between 0 and `depth_max`; depth_max: none is.
  [[nodiscard]] double limit_at(double speed_rev_per_min, double depth_max_mm) const;

 private:
  CuttingProcess process_;
};

}  // namespace stanok::process
