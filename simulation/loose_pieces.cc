// Pieces are the sets of points that triangles join (union-find with path halving).
#include "simulation/loose_pieces.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace stanok::simulation {
namespace {

class Pieces {
 public:
  explicit Pieces(const Mesh& mesh) : parent_(mesh.points.size()) {
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

// Of each piece by its name; below 0: a hollow.
std::map<std::uint32_t, double> volumes_of(const Mesh& mesh, Pieces& pieces) {
  std::map<std::uint32_t, double> volumes;
  for (const auto& triangle : mesh.triangles)
    volumes[pieces.of(triangle[0])] += mesh.volume_under(triangle);
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

LoosePieces take_off_loose_pieces(Mesh& mesh) {
  Pieces pieces(mesh);
  const std::map<std::uint32_t, double> volumes = volumes_of(mesh, pieces);
  if (volumes.size() < 2) return {};
  const auto part = std::ranges::max_element(
      volumes, [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto is_loose = [&](std::uint32_t piece) {
    return piece != part->first && volumes.at(piece) > 0.0;
  };
  LoosePieces loose;
  for (const auto& [piece, volume_mm3] : volumes) {
    if (!is_loose(piece)) continue;
    ++loose.count;
    loose.volume_mm3 += volume_mm3;
  }
  if (loose.count == 0) return loose;
  std::erase_if(mesh.triangles,
                [&](const auto& triangle) { return is_loose(pieces.of(triangle[0])); });
  drop_unused_points(mesh);
  return loose;
}

}  // namespace stanok::simulation
