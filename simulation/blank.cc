#include "simulation/blank.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::simulation {
namespace {

// What a ray takes: itself, and when the part is shown its share of the surface (two crossings with
// place, normal and index, four triangles).
constexpr double bytes_per_ray = 240.0;
constexpr double resolution_step = 1e-3;  // mm, to which the resolution that fits is rounded up

Vector extent(const Blank& blank) {
  if (blank.kind != BlankKind::cylinder) return blank.size;
  return {blank.size.x(), blank.size.x(), blank.size.z()};
}

bool has_volume(const Blank& blank) {
  if (blank.kind == BlankKind::unknown) return false;
  if (!blank.size.allFinite() || !blank.zero.allFinite()) return false;
  if (blank.kind == BlankKind::solid && !(blank.solid && blank.scale > 0.0)) return false;
  if (blank.kind != BlankKind::cylinder) return blank.size.minCoeff() > 0.0;
  return blank.size.x() > 0.0 && blank.size.z() > 0.0 && blank.size.y() >= 0.0 &&
         blank.size.y() < blank.size.x();
}

BlankRefusal too_fine(const Blank& blank, double bytes, std::uint64_t memory_max) {
  const double fits = blank.resolution * std::sqrt(bytes / static_cast<double>(memory_max));
  const double rounded = std::ceil(fits / resolution_step) * resolution_step;
  const Vector size = extent(blank);
  return {"E9203",
          fmt::format("a blank of {:g} x {:g} x {:g} mm at {:g} mm takes {:.0f} MiB of {} MiB; a "
                      "resolution of {:g} mm fits",
                      size.x(), size.y(), size.z(), blank.resolution, std::ceil(bytes / 1048576.0),
                      memory_max >> 20U, rounded)};
}

}  // namespace

Expected<Grid, BlankRefusal> grid_of(const Blank& blank, std::uint64_t memory_max) {
  if (!blank.unknown_because.empty()) {
    return Unexpected(BlankRefusal{"E9205", blank.unknown_because});
  }
  if (!has_volume(blank)) {
    return Unexpected(
        BlankRefusal{"E9202", "the sizes of the blank make neither a box nor a cylinder"});
  }
  if (!(blank.resolution > 0.0)) {
    return Unexpected(BlankRefusal{"E9202", "the resolution of the blank is not above 0 mm"});
  }
  const Vector size = extent(blank);
  const double area = size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  const double bytes = bytes_per_ray * area / (blank.resolution * blank.resolution);
  if (!(bytes <= static_cast<double>(memory_max))) {
    return Unexpected(too_fine(blank, bytes, memory_max));
  }
  Grid grid;
  for (int k = 0; k < 3; ++k) {
    const double cells = std::max(1.0, std::round(size[k] / blank.resolution));
    grid.count[k] = static_cast<int>(cells);
    grid.cell[k] = size[k] / cells;
  }
  if (blank.kind == BlankKind::cylinder) grid.origin = {-size.x() / 2.0, -size.y() / 2.0, 0.0};
  if (blank.kind == BlankKind::solid) grid.origin = blank.scale * blank.solid->low;
  return grid;
}

double volume_of(const Blank& blank) {
  if (blank.kind == BlankKind::box) return blank.size.prod();
  if (blank.kind == BlankKind::solid) return std::pow(blank.scale, 3.0) * blank.solid->volume;
  const double outer = blank.size.x() / 2.0;
  const double inner = blank.size.y() / 2.0;
  return std::numbers::pi * (outer * outer - inner * inner) * blank.size.z();
}

double distance_to_surface(const Blank& blank, const Vector& point_K) {
  const double ends = std::min(std::abs(point_K.z()), std::abs(blank.size.z() - point_K.z()));
  if (blank.kind == BlankKind::cylinder) {
    const double radius = std::hypot(point_K.x(), point_K.y());
    const double outer = std::abs(radius - blank.size.x() / 2.0);
    const double inner = blank.size.y() > 0.0 ? std::abs(radius - blank.size.y() / 2.0) : outer;
    return std::min({ends, outer, inner});
  }
  double nearest = ends;
  for (int k = 0; k < 2; ++k) {
    nearest = std::min({nearest, std::abs(point_K[k]), std::abs(blank.size[k] - point_K[k])});
  }
  return nearest;
}

}  // namespace stanok::simulation
