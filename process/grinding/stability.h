// Regenerative stability of the cut: does a wave left in the surface grow from turn to turn?
//
// The cut meets what it left one revolution ago with the stiffness k = dP/da. With many periods of
// the system within a revolution the limit does not depend on the speed: stable for
// k < 2 C zeta (1 + zeta) (J. Tlusty, Manufacturing Processes and Equipment, 2000, ch. 9). The
// power law makes the cut stiffest where the layer is thinnest: at the end of the cycle.
#pragma once

#include "process/grinding/grinding_process.h"

namespace stanok::process {

// 2 C zeta (1 + zeta) over the stiffness of the cut at Q_end; below 1 waves grow.
[[nodiscard]] double stability_margin(const GrindingProcess& process);

// By how much the wave that grows most is higher after a revolution; below 1 all of them die out.
// |e^(s tau)| of the roots of m s^2 + b s + C + k (1 - e^(-s tau)) = 0, one for each whole number
// of waves in a revolution.
[[nodiscard]] double wave_growth(const GrindingProcess& process);

}  // namespace stanok::process
