// The solid that an STL file describes, binary or ASCII, as the blank of a workpiece.
//
// It is taken only where its surface is closed: each edge of a triangle is the edge of another one,
// which runs it the other way, at exactly the same corners. Several shells, also one inside of
// another as a hollow, are one solid. Lengths are those of the file, which has no unit. Not for the
// real-time cycle; about a second for the largest file.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stanok::simulation {

struct Solid {
  using Corner = Eigen::Vector3f;
  using Triangle = std::array<Corner, 3>;  // counter-clockwise from outside

  std::vector<Triangle> triangles;
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // of the box around it
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  double volume = 0.0;  // > 0
};

// Code of the catalogue, what is wrong, and what to do about it.
struct StlRefusal {
  std::string code;
  std::string text;
  std::string help;
};

inline constexpr std::size_t stl_triangles_max = 500'000;
inline constexpr std::size_t stl_bytes_max = std::size_t{160} << 20;
// How often the surface may lie over itself, on average over the box around it.
inline constexpr double stl_layers_max = 32.0;

// Of the whole bytes of a file. E7020: no STL file, or a damaged one; E7021: not closed; E7022: no
// volume, or inside out; E7023: too large.
[[nodiscard]] Expected<Solid, StlRefusal> solid_of_stl(std::string_view bytes);
[[nodiscard]] StlRefusal stl_too_large(std::size_t bytes);

}  // namespace stanok::simulation
