#include "simulation/reference/reference_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stanok::simulation {
namespace {

using Point = Mesh::Point;

constexpr std::size_t leaf_max = 8;     // triangles
constexpr std::size_t depth_max = 64;   // of a tree that is halved at each node
constexpr float same_distance = 1e-4F;  // as a part of it: so near are triangles of one edge

// C. Ericson, Real-Time Collision Detection (2005), 5.1.5: the regions of corners and edges first.
Point nearest_point(const StlTriangle& triangle, const Point& p) {
  const auto& [a, b, c] = triangle;
  const Point ab = b - a;
  const Point ac = c - a;
  const float d1 = ab.dot(p - a);
  const float d2 = ac.dot(p - a);
  if (d1 <= 0.0F && d2 <= 0.0F) return a;
  const float d3 = ab.dot(p - b);
  const float d4 = ac.dot(p - b);
  if (d3 >= 0.0F && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) return a + d1 / (d1 - d3) * ab;
  const float d5 = ab.dot(p - c);
  const float d6 = ac.dot(p - c);
  if (d6 >= 0.0F && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float whole = va + vb + vc;
  return a + vb / whole * ab + vc / whole * ac;
}

// Where distances can be told, and seen from a side.
bool is_usable(const StlTriangle& triangle) {
  constexpr float place_max_mm = 1e5F;
  for (const Point& corner : triangle) {
    if (!(corner.cwiseAbs().maxCoeff() < place_max_mm)) return false;
  }
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() > 0.0F;
}

}  // namespace

Expected<ReferenceSurface, std::string> reference_of_stl(std::string_view bytes) {
  auto triangles = triangles_of_stl(bytes);
  if (!triangles) return Unexpected(triangles.error().text);
  std::erase_if(*triangles, [](const StlTriangle& one) { return !is_usable(one); });
  if (triangles->empty()) return Unexpected(std::string("the file has no triangle with an area"));
  return ReferenceSurface(std::move(*triangles));
}

float ReferenceSurface::Box::squared_distance(const Point& place) const {
  return (place.cwiseMax(low).cwiseMin(high) - place).squaredNorm();
}

ReferenceSurface::ReferenceSurface(std::vector<StlTriangle> triangles)
    : triangles_(std::move(triangles)) {
  nodes_.reserve(2 * triangles_.size() / leaf_max + 2);
  grow(0, triangles_.size());
}

ReferenceSurface::Box ReferenceSurface::box_of(std::size_t first, std::size_t behind) const {
  Box box{triangles_[first][0], triangles_[first][0]};
  for (std::size_t k = first; k < behind; ++k) {
    for (const Point& corner : triangles_[k]) {
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
  }
  return box;
}

// Halves along the longest side of the box.
void ReferenceSurface::grow(std::size_t first, std::size_t behind) {
  const std::size_t number = nodes_.size();
  nodes_.push_back({.box = box_of(first, behind),
                    .first = static_cast<std::uint32_t>(first),
                    .behind = static_cast<std::uint32_t>(behind)});
  if (behind - first <= leaf_max) return;
  Eigen::Index axis = 0;
  (nodes_[number].box.high - nodes_[number].box.low).maxCoeff(&axis);
  const std::size_t middle = first + (behind - first) / 2;
  const auto at = [&](std::size_t k) {
    return triangles_.begin() + static_cast<std::ptrdiff_t>(k);
  };
  std::nth_element(
      at(first), at(middle), at(behind), [axis](const StlTriangle& a, const StlTriangle& b) {
        return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
      });
  grow(first, middle);
  nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[number].behind = 0;
  grow(middle, behind);
}

void ReferenceSurface::look(const StlTriangle& triangle, const Point& place,
                            Nearest& nearest) const {
  const Point way = place - nearest_point(triangle, place);
  const float squared = way.squaredNorm();
  if (squared > nearest.squared * (1.0F + same_distance)) return;
  const Point normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
  const float squareness = squared > 0.0F ? normal.dot(way) / std::sqrt(squared) : 1.0F;
  const bool is_nearer = squared < nearest.squared * (1.0F - same_distance);
  if (is_nearer || std::abs(squareness) > std::abs(nearest.squareness))
    nearest.squareness = squareness;
  nearest.squared = std::min(nearest.squared, squared);
}

double ReferenceSurface::deviation(const Point& place) const {
  Nearest nearest{.squared = std::numeric_limits<float>::max(), .squareness = 0.0F};
  std::array<std::uint32_t, depth_max> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    const Node& node = nodes_[number];
    if (node.box.squared_distance(place) > nearest.squared * (1.0F + same_distance)) continue;
    if (node.behind > 0) {
      for (std::uint32_t k = node.first; k < node.behind; ++k) look(triangles_[k], place, nearest);
      continue;
    }
    // The nearer branch is looked at first.
    std::array<std::uint32_t, 2> branches{node.first, number + 1};
    if (nodes_[branches[0]].box.squared_distance(place) <
        nodes_[branches[1]].box.squared_distance(place))
      std::swap(branches[0], branches[1]);
    for (const std::uint32_t branch : branches) waiting[count++] = branch;
  }
  const double distance = std::sqrt(static_cast<double>(nearest.squared));
  return nearest.squareness < 0.0F ? -distance : distance;
}

}  // namespace stanok::simulation
