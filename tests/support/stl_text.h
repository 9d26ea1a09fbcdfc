// STL files for tests: boxes and prisms, written as the format says, binary and ASCII.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace stanok::testing {

using StlPoint = std::array<double, 3>;
using StlTriangle = std::array<StlPoint, 3>;
using StlTriangles = std::vector<StlTriangle>;

inline void append(StlTriangles& all, const StlTriangles& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// A straight prism along Z over a convex polygon, counter-clockwise from above.
inline StlTriangles stl_prism(const std::vector<std::array<double, 2>>& polygon, double low,
                              double high) {
  StlTriangles all;
  const auto at = [&](std::size_t k, double z) {
    const auto& corner = polygon[k % polygon.size()];
    return StlPoint{corner[0], corner[1], z};
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    all.push_back({at(k, low), at(k + 1, low), at(k + 1, high)});
    all.push_back({at(k, low), at(k + 1, high), at(k, high)});
    if (k == 0 || k + 1 == polygon.size()) continue;
    all.push_back({at(0, high), at(k, high), at(k + 1, high)});
    all.push_back({at(0, low), at(k + 1, low), at(k, low)});
  }
  return all;
}

inline StlTriangles stl_box(const StlPoint& low, const StlPoint& high) {
  return stl_prism({{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}},
                   low[2], high[2]);
}

// Of so many corners on a circle about the Z axis.
inline StlTriangles stl_cylinder(double radius, double low, double high, int corners) {
  std::vector<std::array<double, 2>> polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return stl_prism(polygon, low, high);
}

inline double regular_polygon_area(double radius, int corners) {
  return corners / 2.0 * radius * radius * std::sin(2.0 * std::numbers::pi / corners);
}

inline StlTriangles inside_out(StlTriangles triangles) {
  for (StlTriangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

inline std::string ascii_stl(const StlTriangles& triangles) {
  std::ostringstream text;
  text.precision(9);
  text << "solid made for a test\n";
  for (const StlTriangle& triangle : triangles) {
    text << "  facet normal 0 0 0\n    outer loop\n";
    for (const StlPoint& point : triangle)
      text << "      vertex " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid made for a test\n";
  return text.str();
}

inline std::string binary_stl(const StlTriangles& triangles) {
  std::string bytes(80, ' ');
  const auto put = [&bytes](const auto& value) {
    std::array<char, sizeof value> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.append(raw.data(), raw.size());
  };
  put(static_cast<std::uint32_t>(triangles.size()));
  for (const StlTriangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) put(0.0F);
    for (const StlPoint& point : triangle) {
      for (const double value : point) put(static_cast<float>(value));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

}  // namespace stanok::testing
