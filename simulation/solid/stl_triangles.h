// The triangles of an STL file, binary or ASCII: of a blank, or of the surface that a part is to
// have.
//
// A binary file is one whose size is that of its number of triangles, whatever its title says.
// Lengths are those of the file, which has no unit. Not for the real-time cycle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stanok::simulation {

using StlCorner = Eigen::Vector3f;
using StlTriangle = std::array<StlCorner, 3>;  // counter-clockwise from outside

// Code of the catalogue, what is wrong, and what to do about it.
struct StlRefusal {
  std::string code;
  std::string text;
  std::string help;
};

// Of a binary file: normal, three corners, two bytes of attributes.
inline constexpr std::size_t stl_triangle_bytes = 50;

inline constexpr std::size_t stl_triangles_max = 500'000;
inline constexpr std::size_t stl_bytes_max = std::size_t{160} << 20;

// Of the whole bytes of a file; one at least, all of finite numbers. E7020: no STL file, or a
// damaged one; E7023: too large.
[[nodiscard]] Expected<std::vector<StlTriangle>, StlRefusal> triangles_of_stl(
    std::string_view bytes);
[[nodiscard]] StlRefusal stl_too_large(std::size_t bytes);

}  // namespace stanok::simulation
