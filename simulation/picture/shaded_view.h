// A surface seen from one side in parallel projection, lit, with outlines: a picture without paper.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/surface_mesh.h"

namespace stanok::simulation {

// What all views of a surface share.
struct LitSurface {
  const Mesh& mesh;
  std::vector<Eigen::Vector3f> normals;  // of the points, outwards
  std::vector<std::uint8_t> is_raw;      // of the points: they lie on the blank, nothing was cut
};

// `mesh` is of what is left of `blank` in `grid`.
[[nodiscard]] LitSurface lit(const Mesh& mesh, const Blank& blank, const Grid& grid);

struct Camera {
  std::string name;                  // for people
  Vector towards = Vector::UnitY();  // the way it looks, in K
  Vector up = Vector::UnitZ();

  // Coordinates right, up and away from the eye.
  [[nodiscard]] Eigen::Matrix3d axes() const;
};

// Rows from the top, 32 bit a pixel as cairo has them (ARGB, premultiplied); what is no part is
// transparent.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

// `centre`, in K, comes to the middle.
[[nodiscard]] Image render(const LitSurface& surface, const Camera& camera, const Vector& centre,
                           double pixels_per_mm, int width, int height);

}  // namespace stanok::simulation
