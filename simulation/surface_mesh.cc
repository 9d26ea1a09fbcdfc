// Points of the grid are the middles of its cells and one layer more all round, which is outside.
#include "simulation/surface_mesh.h"

#include <algorithm>
#include <cmath>

#include "simulation/cube_cases.h"

namespace stanok::simulation {
namespace {

constexpr std::uint32_t no_point = 0xffffffffU;
// Points keep off the corners of a cube, so that no triangle shrinks to nothing.
constexpr double part_min = 0.01;
// A crossing so far beside its edge is on it but for the steps of the cut; parts of a cell.
constexpr double beside_max = 0.25;

// The points of the surface on the edges of two layers of the grid: along X and Y in the layer, and
// along Z to the next one.
struct Layer {
  std::vector<std::uint8_t> inside;
  std::array<std::vector<std::uint32_t>, 3> points;
};

class Builder {
 public:
  explicit Builder(const Material& material)
      : material_(material),
        grid_(material.grid()),
        points_{grid_.count[0] + 2, grid_.count[1] + 2} {}

  Mesh build() {
    Layer below = layer(-1);
    for (int k = -1; k < grid_.count[2]; ++k) {
      Layer above = layer(k + 1);
      connect(k, below, above);
      polygonise(below, above);
      below = std::move(above);
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::size_t at(int i, int j) const { return points_.place(i + 1, j + 1); }

  [[nodiscard]] bool is_inside(int i, int j, int k) const {
    if (i < 0 || j < 0 || k < 0 || i >= grid_.count[0] || j >= grid_.count[1] ||
        k >= grid_.count[2])
      return false;
    return material_.family(2).contains(material_.ray(2, i, j), grid_.middle(2, k));
  }

  Layer layer(int k) {
    Layer layer;
    const std::size_t size = points_.cells();
    layer.inside.assign(size, 0);
    for (auto& points : layer.points) points.assign(size, no_point);
    for (int j = 0; j < grid_.count[1]; ++j) {
      for (int i = 0; i < grid_.count[0]; ++i) layer.inside[at(i, j)] = is_inside(i, j, k) ? 1 : 0;
    }
    for (int j = -1; j <= grid_.count[1]; ++j) {
      for (int i = -1; i <= grid_.count[0]; ++i) {
        if (i < grid_.count[0] && layer.inside[at(i, j)] != layer.inside[at(i + 1, j)])
          layer.points[0][at(i, j)] = crossing(0, {i, j, k}, layer);
        if (j < grid_.count[1] && layer.inside[at(i, j)] != layer.inside[at(i, j + 1)])
          layer.points[1][at(i, j)] = crossing(1, {i, j, k}, layer);
      }
    }
    return layer;
  }

  // Points on the edges along Z between both layers; they belong to the lower one.
  void connect(int k, Layer& below, const Layer& above) {
    for (int j = 0; j < grid_.count[1]; ++j) {
      for (int i = 0; i < grid_.count[0]; ++i) {
        if (below.inside[at(i, j)] != above.inside[at(i, j)])
          below.points[2][at(i, j)] = crossing(2, {i, j, k}, below);
      }
    }
  }

  // Between the grid point `node` of the layer and the next one along `axis`; the path leaves the
  // part when the first of them is inside.
  std::uint32_t crossing(int axis, const PerAxis<int>& node, const Layer& layer) {
    const bool leaves = layer.inside[at(node[0], node[1])] != 0;
    const double low = grid_.middle(axis, node[axis]);
    double part = 0.5;
    double beside_min = beside_max;
    const std::size_t ray = material_.ray(axis, node[axis + 1], node[axis + 2]);
    material_.family(axis).visit(ray, [&](const Interval& piece) {
      const double end = leaves ? piece.to : piece.from;
      const double along = (end - low) / grid_.cell[axis];
      const double beside = std::max(-along, along - 1.0);
      if (beside > beside_min) return;
      beside_min = beside;
      part = std::clamp(along, part_min, 1.0 - part_min);
    });
    Vector point;
    for (int k = 0; k < 3; ++k) point[k] = grid_.middle(k, node[k]);
    point[axis] += part * grid_.cell[axis];
    mesh_.points.push_back(point.cast<float>());
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  void polygonise(const Layer& below, const Layer& above) {
    for (int j = -1; j < grid_.count[1]; ++j) {
      for (int i = -1; i < grid_.count[0]; ++i) {
        unsigned inside = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
          const Layer& layer = (corner & 4U) != 0 ? above : below;
          const int di = (corner & 1U) != 0 ? 1 : 0;
          const int dj = (corner & 2U) != 0 ? 1 : 0;
          inside |= static_cast<unsigned>(layer.inside[at(i + di, j + dj)]) << corner;
        }
        if (inside == 0 || inside == 255) continue;
        for (const EdgeTriangle& triangle : cube_triangles(inside)) {
          mesh_.triangles.push_back({point_on(triangle[0], i, j, below, above),
                                     point_on(triangle[1], i, j, below, above),
                                     point_on(triangle[2], i, j, below, above)});
        }
      }
    }
  }

  // Edge numbers: cube_cases.h.
  [[nodiscard]] std::uint32_t point_on(unsigned edge, int i, int j, const Layer& below,
                                       const Layer& above) const {
    const int first = static_cast<int>(edge & 1U);
    const int second = static_cast<int>(edge >> 1U & 1U);
    switch (edge / 4) {
      case 0:
        return (second != 0 ? above : below).points[0][at(i, j + first)];
      case 1:
        return (first != 0 ? above : below).points[1][at(i + second, j)];
      default:
        return below.points[2][at(i + first, j + second)];
    }
  }

  const Material& material_;
  const Grid& grid_;
  Raster points_;  // of a layer
  Mesh mesh_;
};

}  // namespace

// By the divergence theorem.
double Mesh::volume() const {
  double sum = 0.0;
  for (const Triangle& triangle : triangles) sum += volume_under(triangle);
  return sum;
}

double Mesh::volume_under(const Triangle& triangle) const {
  const auto corner = [&](std::size_t k) { return points[triangle[k]].cast<double>().eval(); };
  return corner(0).dot(corner(1).cross(corner(2))) / 6.0;
}

Mesh surface_of(const Material& material) {
  return Builder(material).build();
}

}  // namespace stanok::simulation
