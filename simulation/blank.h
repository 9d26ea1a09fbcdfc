// The blank that a program announces (#workpiece), and the grid in which it is cut.
//
// Frame K, fixed to the blank: axes as the program's at the announcement. Box: origin at the corner
// with the smallest coordinates. Cylinder along Z: origin on its axis at the smaller Z. Solid of an
// STL file: as in the file. Lengths mm.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "base/expected.h"
#include "simulation/picture/raster.h"
#include "simulation/solid/stl_solid.h"

namespace stanok::simulation {

using Vector = Eigen::Vector3d;
using Pose = Eigen::Isometry3d;

enum class BlankKind : std::uint8_t { box, cylinder, solid, unknown };

struct Blank {
  BlankKind kind = BlankKind::box;
  // Box, and the one around a solid: X, Y, Z; cylinder: diameter, inner diameter, length.
  Vector size = Vector::Zero();
  Vector zero = Vector::Zero();  // of the program, in K
  double resolution = 0.5;       // > 0: distance of the rays that carry the material
  std::shared_ptr<const Solid> solid{};
  double scale = 1.0;             // mm for a unit of the solid
  std::string unknown_because{};  // kind unknown; empty: nobody knows
};

// Cells of about one resolution that fill the box round the blank evenly. Rays run through the
// middle of the cells.
struct Grid {
  Vector origin = Vector::Zero();  // smallest corner of the box, in K
  Vector cell = Vector::Ones();
  PerAxis<int> count{};  // cells along X, Y, Z

  [[nodiscard]] double middle(int axis, int index) const {
    return origin[axis] + (index + 0.5) * cell[axis];
  }
  // The first cell whose middle is not below `position`; beyond the grid where there is none.
  [[nodiscard]] int first_behind(int axis, double position) const {
    return static_cast<int>(std::ceil((position - origin[axis]) / cell[axis] - 0.5));
  }
  // The cells of a layer across `axis`: columns along the axis behind it, rows along the next.
  [[nodiscard]] Raster across(int axis) const { return {count[axis + 1], count[axis + 2]}; }
  // Rays along `axis`.
  [[nodiscard]] std::size_t rays(int axis) const { return across(axis).cells(); }
};

inline constexpr std::uint64_t memory_default = std::uint64_t{2} << 30;

struct BlankRefusal {
  std::string code;
  std::string text;
};

// Refuses sizes that are no blank (E9202), an STL file that is not there (E9205) and a resolution
// for which rays, surface and picture would take more than `memory_max` bytes (E9203; the text
// names the resolution that fits).
[[nodiscard]] Expected<Grid, BlankRefusal> grid_of(const Blank& blank,
                                                   std::uint64_t memory_max = memory_default);

// mm³.
[[nodiscard]] double volume_of(const Blank& blank);

// How far a point in K is from the surface of a box or a cylinder, mm, never negative.
[[nodiscard]] double distance_to_surface(const Blank& blank, const Vector& point_K);

}  // namespace stanok::simulation
