// Triangles of an STL file, text or binary: the surface that a part is to have.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/expected.h"
#include "simulation/surface_mesh.h"

namespace stanok::simulation {

using Corners = std::array<Mesh::Point, 3>;  // counter-clockwise from outside, mm

inline constexpr std::size_t stl_triangles_max = 500'000;

// Or why it cannot be taken. Triangles without an area are left out.
[[nodiscard]] Expected<std::vector<Corners>, std::string> read_stl(
    const std::filesystem::path& file);

}  // namespace stanok::simulation
