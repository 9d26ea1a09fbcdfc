// What has been cut off a workpiece, measured between the surfaces of its blank and of what is
// left.
//
// Rays count cells at faces along them whole or not at all; the surface knows from the rays across
// where the face is, some ten times better (docs/programmer/workpiece.md). Blocks share it as the
// rays have counted.
#pragma once

#include <vector>

#include "simulation/workpiece.h"

namespace stanok::simulation {

struct Removal {
  double volume_mm3 = 0.0;
  std::vector<BlockRemoval> blocks;  // that removed something, in the order of the run
};

// Builds both surfaces: for the end of a cut, not for each of its steps.
[[nodiscard]] Removal removal_of(const Workpiece& workpiece);

}  // namespace stanok::simulation
