// A turning insert on its way along a part that turns: rings that are taken off all round.
//
// Plane of the cut: z along the axis of the spindle, x the distance from it. The insert is convex
// there, and so is what it sweeps on a straight path: the hull of both places. The swept ring is
// cut exactly, up to the polygon that stands for the round nose. Lengths mm.
#pragma once

#include <vector>

#include "simulation/material.h"
#include "simulation/tool_shape.h"

namespace stanok::simulation {

struct PlanePoint {
  double z = 0.0;
  double x = 0.0;
};
using Polygon = std::vector<PlanePoint>;  // convex, counter-clockwise from z to x

// The insert round its programmed point, the imaginary tip (orientation 1 to 8) or the centre of
// the nose. `shrunk`: every face set back by so much. The shape has no defect.
[[nodiscard]] Polygon insert_of(const ToolShape& tool, double shrunk = 0.0);

// The hull of the insert at both places of its programmed point.
[[nodiscard]] Polygon swept(const Polygon& insert, PlanePoint from, PlanePoint to);

// The axis of the spindle in K, which runs along Z: its X and Y.
struct SpindleAxis {
  double x = 0.0;
  double y = 0.0;
};

// Takes away the ring that the polygon makes when it turns about the axis; mm³.
double remove_ring(Material& material, const Polygon& polygon, const SpindleAxis& axis);
// What the ring covers; mm³.
[[nodiscard]] double covered_by_ring(const Material& material, const Polygon& polygon,
                                     const SpindleAxis& axis);

}  // namespace stanok::simulation
