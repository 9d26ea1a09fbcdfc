// The elastic system under the force of the cut: one step of time solves for the layer and the
// deflection that belong together.
#pragma once

#include "process/grinding/force_law.h"
#include "process/grinding/grinding_process.h"

namespace stanok::process {

class ElasticSystem {
 public:
  ElasticSystem(const GrindingProcess& process, double time_step_s);

  // One step to where a rigid wheel would take a layer of `rigid_layer_mm` (negative: it is away
  // from the surface). Returns the layer it takes, >= 0, mm.
  double advance(double rigid_layer_mm);

  [[nodiscard]] double deflection_mm() const { return y_; }
  [[nodiscard]] double force_n() const { return force_n_; }

 private:
  // The layer a >= 0 at which the cut's force and the system's resistance balance.
  double balanced_layer_mm(double free_force_n);

  ForceLaw force_;
  double exponent_inverse_;
  double mass_;     // N s2/mm
  double damping_;  // N s/mm
  double step_s_;
  double resistance_;  // N/mm against the end of the step: C + 2 b/h + 4 m/h^2

  double y_ = 0.0;    // mm
  double dy_ = 0.0;   // mm/s
  double ddy_ = 0.0;  // mm/s2
  double force_n_ = 0.0;
  double power_ = 0.0;         // a^alpha of the last step
  double power_before_ = 0.0;  // and of the one before
};

}  // namespace stanok::process
