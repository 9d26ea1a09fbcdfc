// Bodies are the sets of points that triangles join (union-find with path halving).
#include "simulation/offcuts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace stanok::simulation {
namespace {

class Bodies {
 public:
  explicit Bodies(const Mesh& mesh) : parent_(mesh.points.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& [a, b, c] : mesh.triangles) {
      join(a, b);
      join(b, c);
    }
  }

  [[nodiscard]] std::uint32_t of(std::uint32_t point) {
    while (parent_[point] != point) {
      parent_[point] = parent_[parent_[point]];
      point = parent_[point];
    }
    return point;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) { parent_[of(a)] = of(b); }

  std::vector<std::uint32_t> parent_;
};

// Of each body by its name; below 0: a hollow.
std::map<std::uint32_t, double> volumes_of(const Mesh& mesh, Bodies& bodies) {
  std::map<std::uint32_t, double> volumes;
  for (const auto& triangle : mesh.triangles)
    volumes[bodies.of(triangle[0])] += mesh.volume_under(triangle);
  return volumes;
}

void drop_unused_points(Mesh& mesh) {
  constexpr std::uint32_t unused = 0xffffffffU;
  std::vector<std::uint32_t> place(mesh.points.size(), unused);
  std::vector<Mesh::Point> points;
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& point : triangle) {
      if (place[point] == unused) {
        place[point] = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh.points[point]);
      }
      point = place[point];
    }
  }
  mesh.points = std::move(points);
}

}  // namespace

Offcuts take_off_offcuts(Mesh& mesh) {
  Bodies bodies(mesh);
  const std::map<std::uint32_t, double> volumes = volumes_of(mesh, bodies);
  if (volumes.size() < 2) return {};
  const auto part = std::ranges::max_element(
      volumes, [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto is_loose = [&](std::uint32_t body) {
    return body != part->first && volumes.at(body) > 0.0;
  };
  Offcuts offcuts;
  for (const auto& [body, volume_mm3] : volumes) {
    if (!is_loose(body)) continue;
    ++offcuts.count;
    offcuts.volume_mm3 += volume_mm3;
  }
  if (offcuts.count == 0) return offcuts;
  std::erase_if(mesh.triangles,
                [&](const auto& triangle) { return is_loose(bodies.of(triangle[0])); });
  drop_unused_points(mesh);
  return offcuts;
}

}  // namespace stanok::simulation
