#include "simulation/solid/stl_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace stanok::simulation {
namespace {

// A number for each corner of each triangle, equal for equal corners.
std::vector<std::uint32_t> numbered_corners(const std::vector<Solid::Triangle>& triangles) {
  const auto corner = [&](std::uint32_t place) -> const Solid::Corner& {
    return triangles[place / 3][place % 3];
  };
  const auto compared = [&](std::uint32_t a, std::uint32_t b) {
    const Solid::Corner& p = corner(a);
    const Solid::Corner& q = corner(b);
    for (int k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    }
    return 0;
  };
  std::vector<std::uint32_t> order(3 * triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return compared(a, b) < 0; });
  std::vector<std::uint32_t> numbers(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || compared(order[k - 1], order[k]) != 0;
    numbers[order[k]] = is_new ? order[k] : numbers[order[k - 1]];
  }
  return numbers;
}

// An edge of a triangle; `low` and `high` are numbers of corners, which are also their places.
struct Edge {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  int direction = 0;  // 1 from low to high, -1 back
};

// Edges that are not run as often one way as the other.
struct OpenEdges {
  std::size_t count = 0;
  std::uint32_t corner = 0;  // of the first one
};

OpenEdges open_edges(const std::vector<Solid::Triangle>& triangles) {
  const std::vector<std::uint32_t> corners = numbered_corners(triangles);
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t from = corners[k];
    const std::uint32_t to = corners[k % 3 == 2 ? k - 2 : k + 1];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  OpenEdges open;
  for (std::size_t k = 0; k < edges.size();) {
    const Edge& first = edges[k];
    int sum = 0;
    for (; k < edges.size() && edges[k].low == first.low && edges[k].high == first.high; ++k)
      sum += edges[k].direction;
    if (sum == 0) continue;
    if (open.count == 0) open.corner = first.low;
    ++open.count;
  }
  return open;
}

void measure(Solid& solid) {
  solid.low = solid.high = solid.triangles.front().front().cast<double>();
  for (const Solid::Triangle& triangle : solid.triangles) {
    for (const Solid::Corner& corner : triangle) {
      solid.low = solid.low.cwiseMin(corner.cast<double>());
      solid.high = solid.high.cwiseMax(corner.cast<double>());
    }
  }
  // Pyramids over the triangles, their tops in one corner of the box.
  for (const Solid::Triangle& triangle : solid.triangles) {
    const Eigen::Vector3d a = triangle[0].cast<double>() - solid.low;
    const Eigen::Vector3d b = triangle[1].cast<double>() - solid.low;
    const Eigen::Vector3d c = triangle[2].cast<double>() - solid.low;
    solid.volume += a.dot(b.cross(c)) / 6.0;
  }
}

// How often the surface lies over itself, seen along the axis where it does most.
double layers_of(const Solid& solid) {
  Eigen::Vector3d shadows = Eigen::Vector3d::Zero();
  for (const Solid::Triangle& triangle : solid.triangles) {
    const Eigen::Vector3d first = (triangle[1] - triangle[0]).cast<double>();
    const Eigen::Vector3d second = (triangle[2] - triangle[0]).cast<double>();
    shadows += first.cross(second).cwiseAbs() / 2.0;
  }
  const Eigen::Vector3d size = solid.high - solid.low;
  const Eigen::Vector3d faces(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  return shadows.cwiseQuotient(faces).maxCoeff();
}

std::optional<StlRefusal> refusal_of(const Solid& solid) {
  const OpenEdges open = open_edges(solid.triangles);
  if (open.count != 0) {
    const Solid::Corner& at = solid.triangles[open.corner / 3][open.corner % 3];
    return StlRefusal{
        "E7021",
        fmt::format(
            "the surface is not closed: {} edges have no second triangle, the first at {:g}, "
            "{:g}, {:g}",
            open.count, at.x(), at.y(), at.z()),
        "repair the file, or export a solid instead of a surface"};
  }
  if (solid.volume < 0.0) {
    return StlRefusal{"E7022",
                      "the surface is inside out: its triangles run clockwise from outside",
                      "turn the normals over in the program that made the file"};
  }
  if (!((solid.high - solid.low).minCoeff() > 0.0) || !(solid.volume > 0.0))
    return StlRefusal{"E7022", "the surface encloses no volume", "export a solid"};
  if (const double layers = layers_of(solid); layers > stl_layers_max) {
    return StlRefusal{"E7023",
                      fmt::format("the surface lies over itself {:.0f} times, at most {:.0f} are "
                                  "allowed",
                                  layers, stl_layers_max),
                      "export the outer faces of the blank alone"};
  }
  return std::nullopt;
}

}  // namespace

Expected<Solid, StlRefusal> solid_of_stl(std::string_view bytes) {
  auto triangles = triangles_of_stl(bytes);
  if (!triangles) return Unexpected(triangles.error());
  Solid solid;
  solid.triangles = std::move(*triangles);
  measure(solid);
  if (auto refusal = refusal_of(solid)) return Unexpected(std::move(*refusal));
  return solid;
}

}  // namespace stanok::simulation
