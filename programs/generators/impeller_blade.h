// Impeller_surface.nc: five-axis finishing of an impeller blade with a ball cutter of 6 mm.
//
// A zigzag raster along the span over the cambered, twisted pressure side of one blade, with the
// tool tip programmed (G43.4) and the tool axis leaning from the surface normal towards the table
// axis. The tool axis of the head-table machine for angles B and C is
//   o = (sin B cos C, -sin B sin C, cos B),
// and the blade is shaped so that B stays within 4..35 deg: the pole B = 0 is never crossed and C
// swings smoothly. Zone of the tip: X -26..26, Y -43..43, Z 0..34; zero on the table axis C.
#pragma once

#include "programs/generators/workload.h"

namespace stanok::programs {

[[nodiscard]] Workload impeller_blade(const WorkloadOptions& options);

}  // namespace stanok::programs
