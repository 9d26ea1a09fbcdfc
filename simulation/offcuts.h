// Offcuts: what the cut has separated from the part. They fall, and are not shown.
#pragma once

#include "simulation/surface_mesh.h"

namespace stanok::simulation {

struct Offcuts {
  std::size_t count = 0;
  double volume_mm3 = 0.0;
};

// Leaves the body with the greatest volume, which is the part, and hollows.
Offcuts take_off_offcuts(Mesh& mesh);

}  // namespace stanok::simulation
