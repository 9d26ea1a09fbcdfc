#include "simulation/solid/solid_rays.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace stanok::simulation {
namespace {

// A way through the surface on a ray: into the material where `step` is 1, out of it where -1.
struct Crossing {
  std::uint32_t ray = 0;
  float position = 0.0F;
  int step = 0;
};

// Where a triangle's edge passes a row: along the row, and along the rays.
struct Passage {
  double column = 0.0;
  double position = 0.0;
};

bool is_before(const Vector& a, const Vector& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

class Crossings {
 public:
  Crossings(const Grid& grid, double scale, int axis)
      : grid_(grid), scale_(scale), axis_(axis), first_((axis + 1) % 3), second_((axis + 2) % 3) {}

  void add(const Solid::Triangle& triangle) {
    std::array<Vector, 3> corners;
    std::array<int, 3> rows{};  // the first one behind each corner
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = scale_ * triangle[k].cast<double>();
      rows[k] = grid_.first_behind(second_, corners[k][second_]);
    }
    const auto [low, high] = std::ranges::minmax(rows);
    for (int row = std::max(low, 0); row < std::min(high, grid_.count[second_]); ++row)
      add_row(corners, rows, row);
  }

  std::vector<Crossing> sorted() && {
    std::ranges::sort(crossings_, [](const Crossing& a, const Crossing& b) {
      if (a.ray != b.ray) return a.ray < b.ray;
      if (a.position != b.position) return a.position < b.position;
      return a.step > b.step;
    });
    return std::move(crossings_);
  }

 private:
  // One edge runs over the row upwards, one downwards: between them lies the triangle.
  void add_row(const std::array<Vector, 3>& corners, const std::array<int, 3>& rows, int row) {
    Passage up;
    Passage down;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (rows[k] <= row && row < rows[next]) up = passage(corners[k], corners[next], row);
      if (rows[next] <= row && row < rows[k]) down = passage(corners[k], corners[next], row);
    }
    // Counter-clockwise, seen against the axis, it looks along the axis: there is the way out.
    const int step = up.column > down.column ? -1 : 1;
    if (up.column > down.column) std::swap(up, down);
    const int end = std::min(grid_.first_behind(first_, down.column), grid_.count[first_]);
    for (int column = std::max(grid_.first_behind(first_, up.column), 0); column < end; ++column) {
      const double part = (grid_.middle(first_, column) - up.column) / (down.column - up.column);
      const double position = up.position + part * (down.position - up.position);
      const auto ray = static_cast<std::uint32_t>(grid_.across(axis_).place(column, row));
      crossings_.push_back({ray, static_cast<float>(position), step});
    }
  }

  // The same to the bit from both triangles of an edge.
  [[nodiscard]] Passage passage(const Vector& one, const Vector& other, int row) const {
    const bool is_in_order = is_before(one, other);
    const Vector& from = is_in_order ? one : other;
    const Vector& to = is_in_order ? other : one;
    const double part =
        (grid_.middle(second_, row) - from[second_]) / (to[second_] - from[second_]);
    return {from[first_] + part * (to[first_] - from[first_]),
            from[axis_] + part * (to[axis_] - from[axis_])};
  }

  const Grid& grid_;
  double scale_;
  int axis_;
  int first_;
  int second_;
  std::vector<Crossing> crossings_;
};

}  // namespace

void fill_solid(Material& material, const Solid& solid, double scale, int axis) {
  Crossings crossings(material.grid(), scale, axis);
  for (const Solid::Triangle& triangle : solid.triangles) crossings.add(triangle);
  int depth = 0;
  float begin = 0.0F;
  for (const Crossing& crossing : std::move(crossings).sorted()) {
    if (depth <= 0 && depth + crossing.step > 0) begin = crossing.position;
    const bool leaves = depth > 0 && depth + crossing.step <= 0;
    depth += crossing.step;
    if (leaves && crossing.position > begin)
      material.family(axis).add(crossing.ray, begin, crossing.position);
  }
}

}  // namespace stanok::simulation
