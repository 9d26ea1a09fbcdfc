// The solid that an STL file describes, binary or ASCII, as the blank of a workpiece.
//
// It is taken only where its surface is closed: each edge of a triangle is the edge of another one,
// which runs it the other way, at exactly the same corners. Several shells, also one inside of
// another as a hollow, are one solid. Lengths are those of the file, which has no unit. Not for the
// real-time cycle; about a second for the largest file.
#pragma once

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "simulation/solid/stl_triangles.h"

namespace stanok::simulation {

struct Solid {
  using Corner = StlCorner;
  using Triangle = StlTriangle;

  std::vector<Triangle> triangles;
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // of the box around it
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  double volume = 0.0;  // > 0
};

// How often the surface may lie over itself, on average over the box around it.
inline constexpr double stl_layers_max = 32.0;

// Of the whole bytes of a file. E7021: not closed; E7022: no volume, or inside out; E7020 and E7023
// as of stl_triangles.h, E7023 also for too many layers.
[[nodiscard]] Expected<Solid, StlRefusal> solid_of_stl(std::string_view bytes);

}  // namespace stanok::simulation
