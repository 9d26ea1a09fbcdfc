#include "simulation/material.h"

#include <algorithm>
#include <cmath>

#include "simulation/solid/solid_rays.h"

namespace stanok::simulation {
namespace {

// Both halves of a ring on a ray that passes the axis at `distance`; the middle of the ray is at 0.
void add_ring(RayFamily& family, std::size_t ray, double distance, double outer, double inner) {
  if (distance >= outer) return;
  const double half = std::sqrt(outer * outer - distance * distance);
  if (distance >= inner) return family.add(ray, -half, half);
  const double hollow = std::sqrt(inner * inner - distance * distance);
  family.add(ray, -half, -hollow);
  family.add(ray, hollow, half);
}

void fill_cylinder(Material& material, const Blank& blank, int axis) {
  const Grid& grid = material.grid();
  const int first_axis = (axis + 1) % 3;
  const int second_axis = (axis + 2) % 3;
  const double outer = blank.size.x() / 2.0;
  const double inner = blank.size.y() / 2.0;
  for (int second = 0; second < grid.count[second_axis]; ++second) {
    for (int first = 0; first < grid.count[first_axis]; ++first) {
      const double u = grid.middle(first_axis, first);
      const double v = grid.middle(second_axis, second);
      RayFamily& family = material.family(axis);
      const std::size_t ray = material.ray(axis, first, second);
      if (axis == 2) {
        const double radius = std::hypot(u, v);
        if (radius < outer && radius >= inner) family.add(ray, 0.0, blank.size.z());
      } else {
        add_ring(family, ray, std::abs(axis == 0 ? u : v), outer, inner);
      }
    }
  }
}

}  // namespace

Material::Material(const Blank& blank, const Grid& grid)
    : grid_(grid),
      families_{RayFamily(grid.rays(0)), RayFamily(grid.rays(1)), RayFamily(grid.rays(2))} {
  for (int axis = 0; axis < 3; ++axis) {
    if (blank.kind == BlankKind::cylinder) {
      fill_cylinder(*this, blank, axis);
      continue;
    }
    if (blank.kind == BlankKind::solid) {
      fill_solid(*this, *blank.solid, blank.scale, axis);
      continue;
    }
    for (std::size_t ray = 0; ray < family(axis).size(); ++ray) {
      family(axis).add(ray, 0.0, blank.size[axis]);
    }
  }
}

double Material::subtract(int axis, std::size_t ray, double from, double to) {
  const double taken = families_[axis].subtract(ray, from, to);
  if (taken > 0.0 && marks_) marks_->note(axis, ray, from, to);
  return taken;
}

RayWindow Material::window(int axis, const Bounds& bounds) const {
  const auto range = [&](int k, int& from, int& to) {
    const int count = grid_.count[k];
    const double low = (bounds.low[k] - grid_.origin[k]) / grid_.cell[k] - 0.5;
    const double high = (bounds.high[k] - grid_.origin[k]) / grid_.cell[k] - 0.5;
    from = static_cast<int>(std::ceil(std::clamp(low, 0.0, static_cast<double>(count))));
    to = static_cast<int>(std::floor(std::clamp(high, -1.0, count - 1.0))) + 1;
  };
  RayWindow window;
  range((axis + 1) % 3, window.first_from, window.first_to);
  range((axis + 2) % 3, window.second_from, window.second_to);
  return window;
}

Bounds Material::bounds() const {
  Bounds bounds{grid_.origin, grid_.origin};
  for (int k = 0; k < 3; ++k) bounds.high[k] += grid_.cell[k] * grid_.count[k];
  return bounds;
}

double Material::volume() const {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) sum += family(axis).length() * section(axis);
  return sum / 3.0;
}

}  // namespace stanok::simulation
