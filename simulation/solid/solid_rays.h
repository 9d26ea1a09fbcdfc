// Where the rays of a grid run through the solid of an STL file.
//
// Rays of one row of the grid meet the same cut of the surface: each edge of a triangle that passes
// the row is met at a place that both of its triangles share to the bit, so that along each ray
// every way in has its way out. What lies inside of any shell is material.
#pragma once

#include "simulation/material.h"
#include "simulation/solid/stl_solid.h"

namespace stanok::simulation {

// Puts the solid, `scale` mm for a unit of it, on the empty rays along `axis`.
void fill_solid(Material& material, const Solid& solid, double scale, int axis);

}  // namespace stanok::simulation
