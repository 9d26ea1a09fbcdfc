// The surface of what is left, as triangles: marching cubes over the crossings of the three
// families of rays.
//
// Inside and outside of the grid's points come from one family, so that they never contradict each
// other; where an edge of the grid changes sides, the ray along it says where (the middle, where it
// says nothing). A face of a cube with two crossings pairs is cut so that the corners inside are
// apart, for both cubes that share it: the surface is closed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulation/material.h"

namespace stanok::simulation {

struct Mesh {
  using Point = Eigen::Vector3f;
  std::vector<Point> points;  // in K, mm
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Triangle> triangles;  // counter-clockwise from outside

  [[nodiscard]] double volume() const;  // mm³
  // The volume of the pyramid over the triangle, its top in the origin; below 0 when seen from
  // inside.
  [[nodiscard]] double volume_under(const Triangle& triangle) const;
};

[[nodiscard]] Mesh surface_of(const Material& material);

// A part of the surface, with the tool that made each of its points; 0: none did. Parts beside each
// other share the points on their edge.
struct Patch {
  Mesh mesh;
  std::vector<int> tools;
};
[[nodiscard]] Patch patch_of(const Material& material, const CubeWindow& cubes);

}  // namespace stanok::simulation
