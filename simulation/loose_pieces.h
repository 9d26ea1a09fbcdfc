// Pieces that the cut has separated from the part: they fall, and are not shown.
#pragma once

#include "simulation/surface_mesh.h"

namespace stanok::simulation {

struct LoosePieces {
  std::size_t count = 0;
  double volume_mm3 = 0.0;
};

// Leaves the piece with the greatest volume, and hollows.
LoosePieces take_off_loose_pieces(Mesh& mesh);

}  // namespace stanok::simulation
