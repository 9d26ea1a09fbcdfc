// The boundary of permitted removal over the remaining allowance, and what it permits at best.
//
//   D(H) = min(Q_max, L(H))        L(H) = Q_end + (Q_max - Q_end) H / H_crit
//
// or, where experiments gave a curve, L through its points, straight between them.
// Q_max is the removal whose force bends the elastic system by the permitted deflection (equation
// (8) of the paper); L is the burn line. Above Q_max the part is bent too far; above L its surface
// burns. Where nothing is left (H <= 0) L stays at Q_end.
#pragma once

#include <vector>

#include "process/grinding/grinding_process.h"

namespace stanok::process {

class Boundary {
 public:
  explicit Boundary(const GrindingProcess& process);

  [[nodiscard]] double removal_max() const { return removal_max_; }  // Q_max, mm2/rad
  [[nodiscard]] double removal_end() const { return removal_end_; }  // Q_end, mm2/rad
  // L(H) and D(H), mm2/rad, of a remaining allowance in mm.
  [[nodiscard]] double burn_line(double allowance_mm) const;
  [[nodiscard]] double at(double allowance_mm) const;
  // Of the burn line, from H = 0 to H_crit.
  [[nodiscard]] const std::vector<BurnPoint>& corners() const { return corners_; }

 private:
  double removal_max_;
  double removal_end_;
  std::vector<BurnPoint> corners_;
};

// How far below X = 0 a cycle may have to go, mm: the permitted deflection and some layers of the
// last revolution.
[[nodiscard]] double overrun_max_mm(const GrindingProcess& process);

// No cycle under the boundary can take an allowance in less time, however it feeds, s.
//
// The wheel goes at most d(H) = D(H)/R_eq deeper in a revolution, with H at its end, the least D of
// that revolution; so the number of revolutions is at least the integral of dH / d(H) from 0 to the
// allowance, in closed form (docs/programmer/grinding.md, "The least time").
[[nodiscard]] double least_time_s(const GrindingProcess& process, double allowance_mm);

// What two or more numbers of the sheet say together: the critical allowance beyond the whole one,
// a burn line that rises above Q_max or falls with more allowance, a Q_max that takes the allowance
// in one revolution. Empty when the boundary makes sense. Ranges are checked before.
[[nodiscard]] std::vector<ProcessFault> boundary_faults(const GrindingProcess& process,
                                                        double allowance_mm);

}  // namespace stanok::process
