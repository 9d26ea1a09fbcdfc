#include "simulation/turning_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace stanok::simulation {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int nose_corners = 72;            // r (1 - cos(pi / 72)) = r / 1000
constexpr double edge_default = 12.0;       // mm, the common size 12 of ISO 1832
constexpr double nose_min = 1e-3;           // mm
constexpr double half_angle_side = 40.0;    // deg: an insert of 80 deg (form C) for two sides
constexpr double half_angle_middle = 27.5;  // deg: one of 55 deg (form D) for one side

// Imaginary tip from the centre of the nose in (Z, X), orientations 1 to 8 as in LinuxCNC.
constexpr std::array<PlanePoint, 10> tip_directions{
    {{0, 0}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}, {0, 0}}};

PlanePoint tip_of(const ToolShape& tool) {
  return tip_directions[static_cast<std::size_t>(tool.orientation)];
}

// Directions of both edges from the nose, rad from Z towards X; front - back in (0, pi).
struct Edges {
  double one = 0.0;
  double other = 0.0;
};

Edges edges_of(const ToolShape& tool) {
  constexpr double rad_per_deg = pi / 180.0;
  if (tool.angle_front != tool.angle_back) {
    const double one = std::min(tool.angle_front, tool.angle_back) * rad_per_deg;
    const double other = std::max(tool.angle_front, tool.angle_back) * rad_per_deg;
    if (other - one > pi) return {other, one + 2.0 * pi};
    return {one, other};
  }
  const PlanePoint tip = tip_of(tool);
  const double middle = std::atan2(-tip.x, -tip.z);
  const double half =
      (tip.z != 0.0 && tip.x != 0.0 ? half_angle_side : half_angle_middle) * rad_per_deg;
  return {middle - half, middle + half};
}

double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z);
}

// Andrew's monotone chain.
Polygon hull_of(Polygon points) {
  std::ranges::sort(points, [](const PlanePoint& a, const PlanePoint& b) {
    return a.z < b.z || (a.z == b.z && a.x < b.x);
  });
  Polygon hull;
  const auto extend = [&](const PlanePoint& point, std::size_t least) {
    while (hull.size() >= least + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const PlanePoint& point : points) extend(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], lower);
  hull.pop_back();
  return hull;
}

struct PolygonStretch {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_empty() const { return from >= to; }
  void include(double value) {
    from = std::min(from, value);
    to = std::max(to, value);
  }
};

// Where the polygon is on the line on which `fixed` has that value, along the other coordinate.
PolygonStretch stretch_at(const Polygon& polygon, double PlanePoint::* fixed, double value,
                          double PlanePoint::* free) {
  PolygonStretch stretch;
  const PlanePoint* a = &polygon.back();
  for (const PlanePoint& b : polygon) {
    const double before = a->*fixed - value;
    const double behind = b.*fixed - value;
    if ((before <= 0.0) != (behind <= 0.0)) {
      const double part = before / (before - behind);
      stretch.include(a->*free + part * (b.*free - a->*free));
    }
    a = &b;
  }
  return stretch;
}

PolygonStretch extent_of(const Polygon& polygon, double PlanePoint::* coordinate) {
  PolygonStretch stretch;
  for (const PlanePoint& point : polygon) stretch.include(point.*coordinate);
  return stretch;
}

// The part on this side of the axis; the other side cuts the same ring.
Polygon clipped_to_side(const Polygon& polygon, double side) {
  Polygon clipped;
  PlanePoint a = polygon.back();
  for (const PlanePoint& b : polygon) {
    const double before = a.x * side;
    const double behind = b.x * side;
    if ((before >= 0.0) != (behind >= 0.0))
      clipped.push_back({a.z + (b.z - a.z) * before / (before - behind), 0.0});
    if (behind >= 0.0) clipped.push_back({b.z, behind});
    a = b;
  }
  return clipped;
}

struct Ring {
  const Polygon& polygon;  // x >= 0
  SpindleAxis axis;
};

// Calls visit(ray, from, to) for every stretch that the ring covers.
template <class Visitor>
void visit_along_axis(const Material& material, const Ring& ring, const RayWindow& window,
                      Visitor&& visit) {
  const Grid& grid = material.grid();
  const PolygonStretch radii = extent_of(ring.polygon, &PlanePoint::x);
  const PolygonStretch heights = extent_of(ring.polygon, &PlanePoint::z);
  for (int second = window.second_from; second < window.second_to; ++second) {
    const double y = grid.middle(1, second) - ring.axis.y;
    for (int first = window.first_from; first < window.first_to; ++first) {
      const double x = grid.middle(0, first) - ring.axis.x;
      const double radius = std::sqrt(x * x + y * y);
      if (radius <= radii.from || radius >= radii.to) continue;
      const std::size_t ray = material.ray(2, first, second);
      if (!material.family(2).may_meet(ray, static_cast<float>(heights.from),
                                       static_cast<float>(heights.to)))
        continue;
      const PolygonStretch z = stretch_at(ring.polygon, &PlanePoint::x, radius, &PlanePoint::z);
      if (!z.is_empty()) visit(ray, z.from, z.to);
    }
  }
}

// `axis` 0 or 1: rays along X or Y, one layer of z after the other.
template <class Visitor>
void visit_across(const Material& material, const Ring& ring, int axis, const RayWindow& window,
                  Visitor&& visit) {
  const Grid& grid = material.grid();
  const bool along_x = axis == 0;  // its rays are numbered by y, z; those along Y by z, x
  const int z_from = along_x ? window.second_from : window.first_from;
  const int z_to = along_x ? window.second_to : window.first_to;
  const int side_from = along_x ? window.first_from : window.second_from;
  const int side_to = along_x ? window.first_to : window.second_to;
  const double centre = along_x ? ring.axis.x : ring.axis.y;
  for (int k = z_from; k < z_to; ++k) {
    const PolygonStretch radii =
        stretch_at(ring.polygon, &PlanePoint::z, grid.middle(2, k), &PlanePoint::x);
    if (radii.is_empty()) continue;
    for (int side = side_from; side < side_to; ++side) {
      const double beside =
          along_x ? grid.middle(1, side) - ring.axis.y : grid.middle(0, side) - ring.axis.x;
      const double outer = radii.to * radii.to - beside * beside;
      if (outer <= 0.0) continue;
      const std::size_t ray = along_x ? material.ray(0, side, k) : material.ray(1, k, side);
      const double inner = radii.from * radii.from - beside * beside;
      const double out = std::sqrt(outer);
      if (inner <= 0.0) {
        visit(ray, centre - out, centre + out);
      } else {
        const double in = std::sqrt(inner);
        visit(ray, centre - out, centre - in);
        visit(ray, centre + in, centre + out);
      }
    }
  }
}

Bounds bounds_of_ring(const Ring& ring) {
  const double radius = extent_of(ring.polygon, &PlanePoint::x).to;
  const PolygonStretch z = extent_of(ring.polygon, &PlanePoint::z);
  return {{ring.axis.x - radius, ring.axis.y - radius, z.from},
          {ring.axis.x + radius, ring.axis.y + radius, z.to}};
}

// Sum of `at(axis, ray, from, to)` over all that the ring covers, as a volume.
template <class Length>
double sum_over_ring(const Material& material, const Polygon& polygon, const SpindleAxis& axis,
                     Length&& length_of) {
  double volume = 0.0;
  for (const double side : {1.0, -1.0}) {
    const Polygon half = clipped_to_side(polygon, side);
    if (half.size() < 3) continue;
    const Ring ring{half, axis};
    const Bounds bounds = bounds_of_ring(ring);
    if (!bounds.meets(material.bounds())) continue;
    for (int family = 0; family < 3; ++family) {
      double length = 0.0;
      const auto visit = [&](std::size_t ray, double from, double to) {
        length += length_of(family, ray, from, to);
      };
      const RayWindow window = material.window(family, bounds);
      if (family == 2) {
        visit_along_axis(material, ring, window, visit);
      } else {
        visit_across(material, ring, family, window, visit);
      }
      volume += length * material.section(family) / 3.0;
    }
  }
  return volume;
}

}  // namespace

Polygon insert_of(const ToolShape& tool, double shrunk) {
  const Edges edges = edges_of(tool);
  const PlanePoint tip = tip_of(tool);
  const double middle = (edges.one + edges.other) / 2.0;
  // A sharp insert is set back along its middle, a round one by its radius first.
  const double radius = std::max(tool.radius - shrunk, nose_min);
  const double back = std::max(0.0, shrunk - tool.radius) /
                      std::max(0.1, std::sin((edges.other - edges.one) / 2.0));
  const PlanePoint centre{-tip.z * tool.radius + back * std::cos(middle),
                          -tip.x * tool.radius + back * std::sin(middle)};
  Polygon points;
  for (int i = 0; i < nose_corners; ++i) {
    const double angle = 2.0 * pi * i / nose_corners;
    points.push_back({centre.z + radius * std::cos(angle), centre.x + radius * std::sin(angle)});
  }
  const double length = tool.flute_length > 0.0 ? tool.flute_length : edge_default;
  for (const auto& [direction, outward] : {std::pair{edges.one, edges.one - pi / 2.0},
                                           std::pair{edges.other, edges.other + pi / 2.0}}) {
    points.push_back({centre.z + length * std::cos(direction) + radius * std::cos(outward),
                      centre.x + length * std::sin(direction) + radius * std::sin(outward)});
  }
  return hull_of(std::move(points));
}

Polygon swept(const Polygon& insert, PlanePoint from, PlanePoint to) {
  Polygon points;
  points.reserve(2 * insert.size());
  for (const PlanePoint& place : {from, to}) {
    for (const PlanePoint& point : insert) points.push_back({point.z + place.z, point.x + place.x});
  }
  return hull_of(std::move(points));
}

double remove_ring(Material& material, const Polygon& polygon, const SpindleAxis& axis) {
  return sum_over_ring(material, polygon, axis,
                       [&](int family, std::size_t ray, double from, double to) {
                         return material.subtract(family, ray, from, to);
                       });
}

double covered_by_ring(const Material& material, const Polygon& polygon, const SpindleAxis& axis) {
  return sum_over_ring(material, polygon, axis,
                       [&](int family, std::size_t ray, double from, double to) {
                         return material.family(family).overlap(ray, from, to);
                       });
}

}  // namespace stanok::simulation
