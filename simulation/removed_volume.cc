#include "simulation/removed_volume.h"

#include "simulation/surface_mesh.h"

namespace stanok::simulation {

Removal removal_of(const Workpiece& workpiece) {
  const double by_rays = workpiece.report().removed_mm3();
  Removal removal{.blocks = workpiece.report().blocks()};
  if (by_rays <= 0.0) return removal;
  const double left = surface_of(workpiece.material()).volume();
  const Material blank(workpiece.blank(), workpiece.material().grid());
  removal.volume_mm3 = surface_of(blank).volume() - left;
  for (BlockRemoval& block : removal.blocks) block.volume_mm3 *= removal.volume_mm3 / by_rays;
  return removal;
}

}  // namespace stanok::simulation
