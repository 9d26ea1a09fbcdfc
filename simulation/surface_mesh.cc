// Points of the grid are the middles of its cells and one layer more all round, which is outside.
#include "simulation/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/cube_cases.h"

namespace stanok::simulation {
namespace {

constexpr std::uint32_t no_point = 0xffffffffU;
// Points keep off the corners of a cube, so that no triangle shrinks to nothing: by so much of a
// cell, and by so many times what positions are rounded to.
constexpr double part_min = 1e-4;
constexpr double roundings_min = 4.0;
// A crossing so far beside its edge is on it but for the steps of the cut; parts of a cell.
constexpr double beside_max = 0.25;

// The points of the surface on the edges of two layers of the grid: along X and Y in the layer, and
// along Z to the next one.
struct Layer {
  std::vector<std::uint8_t> inside;
  std::array<std::vector<std::uint32_t>, 3> points;
};

// How far points keep off the corners along each axis, in parts of a cell.
PerAxis<double> parts_off_corners(const Grid& grid) {
  PerAxis<double> parts{};
  for (int axis = 0; axis < 3; ++axis) {
    const double largest =
        std::max(std::abs(grid.middle(axis, -1)), std::abs(grid.middle(axis, grid.count[axis])));
    const double rounding = largest * std::numeric_limits<float>::epsilon();
    parts[axis] = std::max(part_min, roundings_min * rounding / grid.cell[axis]);
  }
  return parts;
}

class Builder {
 public:
  Builder(const Material& material, const CubeWindow& cubes)
      : material_(material),
        grid_(material.grid()),
        cubes_(cubes),
        points_{cubes.to[0] - cubes.from[0] + 1, cubes.to[1] - cubes.from[1] + 1},
        off_corners_(parts_off_corners(material.grid())) {}

  Patch build() {
    Layer below = layer(cubes_.from[2]);
    for (int k = cubes_.from[2]; k < cubes_.to[2]; ++k) {
      Layer above = layer(k + 1);
      connect(k, below, above);
      polygonise(below, above);
      below = std::move(above);
    }
    return std::move(patch_);
  }

 private:
  [[nodiscard]] std::size_t at(int i, int j) const {
    return points_.place(i - cubes_.from[0], j - cubes_.from[1]);
  }

  [[nodiscard]] bool is_inside(int i, int j, int k) const {
    if (i < 0 || j < 0 || k < 0 || i >= grid_.count[0] || j >= grid_.count[1] ||
        k >= grid_.count[2])
      return false;
    return material_.family(2).contains(material_.ray(2, i, j), grid_.middle(2, k));
  }

  // Calls visit(i, j) for every point of a layer.
  template <class Visitor>
  void visit_points(Visitor&& visit) const {
    for (int j = cubes_.from[1]; j <= cubes_.to[1]; ++j) {
      for (int i = cubes_.from[0]; i <= cubes_.to[0]; ++i) visit(i, j);
    }
  }

  Layer layer(int k) {
    Layer layer;
    const std::size_t size = points_.cells();
    layer.inside.assign(size, 0);
    for (auto& points : layer.points) points.assign(size, no_point);
    visit_points([&](int i, int j) { layer.inside[at(i, j)] = is_inside(i, j, k) ? 1 : 0; });
    visit_points([&](int i, int j) {
      if (i < cubes_.to[0] && layer.inside[at(i, j)] != layer.inside[at(i + 1, j)])
        layer.points[0][at(i, j)] = crossing(0, {{i, j, k}}, layer);
      if (j < cubes_.to[1] && layer.inside[at(i, j)] != layer.inside[at(i, j + 1)])
        layer.points[1][at(i, j)] = crossing(1, {{i, j, k}}, layer);
    });
    return layer;
  }

  // Points on the edges along Z between both layers; they belong to the lower one.
  void connect(int k, Layer& below, const Layer& above) {
    visit_points([&](int i, int j) {
      if (below.inside[at(i, j)] != above.inside[at(i, j)])
        below.points[2][at(i, j)] = crossing(2, {{i, j, k}}, below);
    });
  }

  // Between the grid point `node` of the layer and the next one along `axis`; the path leaves the
  // part when the first of them is inside.
  std::uint32_t crossing(int axis, const PerAxis<int>& node, const Layer& layer) {
    const bool leaves = layer.inside[at(node[0], node[1])] != 0;
    const double low = grid_.middle(axis, node[axis]);
    double part = 0.5;
    double end_found = low;
    double beside_min = beside_max;
    const std::size_t ray = material_.ray(axis, node[axis + 1], node[axis + 2]);
    material_.family(axis).visit(ray, [&](const Interval& piece) {
      const double end = leaves ? piece.to : piece.from;
      const double along = (end - low) / grid_.cell[axis];
      const double beside = std::max(-along, along - 1.0);
      if (beside > beside_min) return;
      beside_min = beside;
      end_found = end;
      part = std::clamp(along, off_corners_[axis], 1.0 - off_corners_[axis]);
    });
    Vector point;
    for (int k = 0; k < 3; ++k) point[k] = grid_.middle(k, node[k]);
    point[axis] += part * grid_.cell[axis];
    patch_.mesh.points.push_back(point.cast<float>());
    if (const CutMarks* marks = material_.marks())
      patch_.tools.push_back(tool_of(*marks, axis, node, end_found));
    return static_cast<std::uint32_t>(patch_.mesh.points.size() - 1);
  }

  // Of the two cells that the edge runs through, the one in which the material ends; a cut that
  // ends on the border between them may stand in the other one.
  [[nodiscard]] int tool_of(const CutMarks& marks, int axis, const PerAxis<int>& node,
                            double end) const {
    PerAxis<int> cell = node;
    const bool is_second = end >= grid_.middle(axis, node[axis]) + grid_.cell[axis] / 2.0;
    for (const int step : {is_second ? 1 : 0, is_second ? 0 : 1}) {
      cell[axis] = std::clamp(node[axis] + step, 0, grid_.count[axis] - 1);
      if (const int tool = marks.tool_at(cell); tool != 0) return tool;
    }
    return 0;
  }

  void polygonise(const Layer& below, const Layer& above) {
    for (int j = cubes_.from[1]; j < cubes_.to[1]; ++j) {
      for (int i = cubes_.from[0]; i < cubes_.to[0]; ++i) {
        unsigned inside = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
          const Layer& layer = (corner & 4U) != 0 ? above : below;
          const int di = (corner & 1U) != 0 ? 1 : 0;
          const int dj = (corner & 2U) != 0 ? 1 : 0;
          inside |= static_cast<unsigned>(layer.inside[at(i + di, j + dj)]) << corner;
        }
        if (inside == 0 || inside == 255) continue;
        for (const EdgeTriangle& triangle : cube_triangles(inside)) {
          patch_.mesh.triangles.push_back({point_on(triangle[0], i, j, below, above),
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
  CubeWindow cubes_;
  Raster points_;  // of a layer
  PerAxis<double> off_corners_;
  Patch patch_;
};

CubeWindow all_cubes_of(const Grid& grid) {
  return {.from = {{-1, -1, -1}}, .to = grid.count};
}

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
  return Builder(material, all_cubes_of(material.grid())).build().mesh;
}

Patch patch_of(const Material& material, const CubeWindow& cubes) {
  return Builder(material, cubes).build();
}

}  // namespace stanok::simulation
