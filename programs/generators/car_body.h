// 0003_MB_3D.nc: three-axis finishing of the body of a model car with a ball cutter of 6 mm.
//
// Two operations. First a zigzag raster along the car (Y), joined at the row ends by half circles
// in XY, in four sections with a retract between them. Then one-way rows across the car (X) over
// bonnet, cabin and boot, entered and left on quarter circles in ZX. All coordinates are those of
// the tool tip, so the surface here is the one of the cutter's centre less its radius. Zone: X
// -26..26, Y -43..43, Z -31..0; the workpiece zero lies on the roof.
#pragma once

#include "programs/generators/workload.h"

namespace stanok::programs {

[[nodiscard]] Workload car_body(const WorkloadOptions& options);

// Height of the tip over the base plane, 0..31 mm.
[[nodiscard]] double car_height(double x_mm, double y_mm);

}  // namespace stanok::programs
