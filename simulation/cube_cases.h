// Marching cubes: for every choice of corners inside, the triangles between the edges that are cut.
//
// Corner c lies at x = bit 0, y = bit 1, z = bit 2 of c. Edge e runs along axis e / 4; its other
// two coordinates are bits 0 and 1 of e, for the axes behind it in cyclic order. The cases are
// derived from the rule for one face, not typed: see cube_cases.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace stanok::simulation {

using EdgeTriangle = std::array<std::uint8_t, 3>;

// `inside`: bit c for corner c. Counter-clockwise from outside.
[[nodiscard]] const std::vector<EdgeTriangle>& cube_triangles(unsigned inside);

}  // namespace stanok::simulation
