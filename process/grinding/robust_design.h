// A cycle for a process that is known within limits only: stiffness, sharpness of the wheel and
// allowance lie in a box, and one table must do for all of it.
//
// What a table does is worst in the corners of the box: a stiff system with a sharp wheel comes to
// its removal sooner and further, so that it burns; a soft one with a dull wheel is bent more and
// leaves more at the end; more allowance lies above the first row, less of it is met by its feed.
// The table of the corner that has the least boundary is taken, its feeds are lowered until no
// corner burns or is bent too far, then the wheel stands at the last X until the sizes of all
// corners lie within the band, and the last X is moved into its middle. Where that cannot be the
// findings name the corners. A first row for the greatest allowance comes before the table.
#pragma once

#include <string>
#include <vector>

#include "process/grinding/cycle_design.h"

namespace stanok::process {

// How far the true values may lie to either side.
struct Spread {
  double stiffness = 0.0;     // part of it, below 1
  double force_factor = 0.0;  // part of C_p: the wheel is sharper or duller
  double allowance_mm = 0.0;

  [[nodiscard]] bool is_none() const {
    return stiffness == 0.0 && force_factor == 0.0 && allowance_mm == 0.0;
  }
};

struct Corner {
  GrindingProcess process;
  double allowance_mm = 0.0;
  std::string name;           // "stiffness x 0.8, force x 1.3, allowance 0.32 mm"
  Verification verification;  // without samples
};

struct RobustDesign {
  CycleDesign design;  // of the sheet itself; what corners say is among its findings
  std::vector<Corner> corners;
};

// The law as a part of another allowance meets it: without the rows above, or begun earlier with
// its first feed.
[[nodiscard]] InfeedLaw law_from(const InfeedLaw& law, double allowance_mm);

[[nodiscard]] Expected<RobustDesign, Findings> design_robust(const DesignRequest& request,
                                                             const Spread& spread);

}  // namespace stanok::process
