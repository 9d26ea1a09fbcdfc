// ReferenceSurface: how far places are from the surface that a part is to have.
//
// The nearest triangle is found in a tree of boxes; a place lies outside where the triangle that is
// seen most squarely of those that are equally near shows it its outside. Immutable: any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "simulation/solid/stl_triangles.h"
#include "simulation/surface_mesh.h"

namespace stanok::simulation {

class ReferenceSurface {
 public:
  // One at least, each with an area, within 1e5 mm.
  explicit ReferenceSurface(std::vector<StlTriangle> triangles);

  // mm; above 0 outside: material is left there; below 0 inside: too much is cut away.
  [[nodiscard]] double deviation(const Mesh::Point& place) const;

 private:
  struct Box {
    Mesh::Point low;
    Mesh::Point high;
    [[nodiscard]] float squared_distance(const Mesh::Point& place) const;
  };
  // Of the tree: a leaf has triangles, others two branches, the second one behind the first.
  struct Node {
    Box box;
    std::uint32_t first = 0;   // triangle, or the second branch
    std::uint32_t behind = 0;  // the last triangle; 0: no leaf
  };
  struct Nearest {
    float squared = 0.0F;
    float squareness = 0.0F;  // of the sight at the triangle, 0 to 1; its sign is the side
  };

  void grow(std::size_t first, std::size_t behind);
  [[nodiscard]] Box box_of(std::size_t first, std::size_t behind) const;
  void look(const StlTriangle& triangle, const Mesh::Point& place, Nearest& nearest) const;

  std::vector<StlTriangle> triangles_;
  std::vector<Node> nodes_;
};

// Of the whole bytes of an STL file, closed or not, without triangles that have no area; or why
// there is none.
[[nodiscard]] Expected<ReferenceSurface, std::string> reference_of_stl(std::string_view bytes);

}  // namespace stanok::simulation
