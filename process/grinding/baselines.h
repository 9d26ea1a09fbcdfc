// Cycles that a design is compared with.
#pragma once

#include "process/grinding/plunge.h"

namespace stanok::process {

// The constant feed that is safe to the end, Q_end all the way: its time to size, s. In closed
// form: at the end the wheel stands deflection and one layer below size.
[[nodiscard]] double constant_safe_time_s(const GrindingProcess& process, double allowance_mm);

// Three feeds as 4 : 2 : 1, switched when 30 % and 12 % of the allowance are left (the example of a
// grinding machine's manual that the paper cites), as fast as the boundary permits: its time, s.
[[nodiscard]] double three_step_time_s(const GrindingProcess& process, double allowance_mm,
                                       const PlungeOptions& simulation);

}  // namespace stanok::process
