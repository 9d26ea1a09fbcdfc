// Rasterised with a depth buffer at twice the size, normals interpolated; then shaded pixel by
// pixel: two lights that stand with the eye, shadows in corners from the depths round about, a dark
// line where the depth jumps.
#include "simulation/picture/shaded_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stanok::simulation {
namespace {

constexpr int samples = 2;         // a side of a pixel
constexpr float raw_part = 0.02F;  // of a cell: nearer to the blank's surface is uncut
const Eigen::Vector3f raw_colour(0.80F, 0.74F, 0.62F);
const Eigen::Vector3f cut_colour(0.56F, 0.68F, 0.80F);

struct Fragment {
  float depth = std::numeric_limits<float>::infinity();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // in the axes of the camera
  float raw = 0.0F;

  [[nodiscard]] bool is_part() const { return depth < std::numeric_limits<float>::infinity(); }
};

struct Buffer {
  Raster pixels;
  std::vector<Fragment> fragments;

  [[nodiscard]] Fragment& at(int x, int y) { return fragments[pixels.place(x, y)]; }
  [[nodiscard]] const Fragment& at(int x, int y) const { return fragments[pixels.place(x, y)]; }
  [[nodiscard]] bool has(int x, int y) const { return pixels.has(x, y); }
};

struct Corner {
  Eigen::Vector3f place;  // pixel, pixel, depth in mm
  Eigen::Vector3f normal;
  float raw = 0.0F;
};

float area(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float x, float y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

void draw(Buffer& buffer, const std::array<Corner, 3>& corners) {
  const auto& [a, b, c] = corners;
  const float whole = area(a.place, b.place, c.place.x(), c.place.y());
  if (whole == 0.0F) return;
  const auto [left, right] = std::minmax({a.place.x(), b.place.x(), c.place.x()});
  const auto [top, bottom] = std::minmax({a.place.y(), b.place.y(), c.place.y()});
  const int x_from = std::max(0, static_cast<int>(std::ceil(left - 0.5F)));
  const int x_to = std::min(buffer.pixels.columns - 1, static_cast<int>(std::floor(right - 0.5F)));
  const int y_from = std::max(0, static_cast<int>(std::ceil(top - 0.5F)));
  const int y_to = std::min(buffer.pixels.rows - 1, static_cast<int>(std::floor(bottom - 0.5F)));
  for (int y = y_from; y <= y_to; ++y) {
    for (int x = x_from; x <= x_to; ++x) {
      const float px = static_cast<float>(x) + 0.5F;
      const float py = static_cast<float>(y) + 0.5F;
      const float wa = area(b.place, c.place, px, py) / whole;
      const float wb = area(c.place, a.place, px, py) / whole;
      const float wc = 1.0F - wa - wb;
      if (wa < 0.0F || wb < 0.0F || wc < 0.0F) continue;
      const float depth = wa * a.place.z() + wb * b.place.z() + wc * c.place.z();
      Fragment& fragment = buffer.at(x, y);
      if (depth >= fragment.depth) continue;
      fragment = {depth, wa * a.normal + wb * b.normal + wc * c.normal,
                  wa * a.raw + wb * b.raw + wc * c.raw};
    }
  }
}

Buffer rasterised(const LitSurface& surface, const Camera& camera, const Vector& centre,
                  double scale, int width, int height) {
  Buffer buffer{{width, height}, {}};
  buffer.fragments.resize(buffer.pixels.cells());
  const Eigen::Matrix3f axes = camera.axes().cast<float>();
  const Eigen::Vector3f middle = centre.cast<float>();
  std::vector<Corner> corners;
  corners.reserve(surface.mesh.points.size());
  const auto zoom = static_cast<float>(scale);
  for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
    const Eigen::Vector3f seen = axes * (surface.mesh.points[i] - middle);
    corners.push_back({{static_cast<float>(width) / 2.0F + zoom * seen.x(),
                        static_cast<float>(height) / 2.0F - zoom * seen.y(), seen.z()},
                       axes * surface.normals[i],
                       surface.is_raw[i] != 0 ? 1.0F : 0.0F});
  }
  for (const auto& [a, b, c] : surface.mesh.triangles) {
    const std::array<Corner, 3> triangle{corners[a], corners[b], corners[c]};
    // Its back is seen: counter-clockwise from outside is clockwise in rows that grow downwards.
    if (area(triangle[0].place, triangle[1].place, triangle[2].place.x(), triangle[2].place.y()) >=
        0.0F)
      continue;
    draw(buffer, triangle);
  }
  return buffer;
}

// How much of the sky the pixel sees, 0 to 1, by the depths on two rings round it.
float openness(const Buffer& buffer, int x, int y, float pixels_per_mm) {
  constexpr std::array<std::array<int, 2>, 8> ring{
      {{2, 0}, {1, 1}, {0, 2}, {-1, 1}, {-2, 0}, {-1, -1}, {0, -2}, {1, -1}}};
  const float here = buffer.at(x, y).depth;
  float hidden = 0.0F;
  float weight = 0.0F;
  for (const int radius : {3, 8}) {
    for (const auto& [dx, dy] : ring) {
      const int u = x + dx * radius;
      const int v = y + dy * radius;
      weight += 1.0F;
      if (!buffer.has(u, v) || !buffer.at(u, v).is_part()) continue;
      const float rise =
          (here - buffer.at(u, v).depth) * pixels_per_mm / static_cast<float>(radius);
      hidden += std::clamp(rise - 1.0F, 0.0F, 1.5F) / 1.5F;
    }
  }
  return 1.0F - 0.55F * hidden / weight;
}

bool is_outline(const Buffer& buffer, int x, int y, float pixels_per_mm) {
  constexpr float jump = 7.0F;  // pixels of depth to the next pixel but one
  const float here = buffer.at(x, y).depth;
  for (const auto& [dx, dy] :
       {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
    if (!buffer.has(x + dx, y + dy)) continue;
    const Fragment& there = buffer.at(x + dx, y + dy);
    if (!there.is_part() || (there.depth - here) * pixels_per_mm > jump) return true;
  }
  return false;
}

Eigen::Vector3f shaded(const Buffer& buffer, int x, int y, float pixels_per_mm) {
  static const Eigen::Vector3f key = Eigen::Vector3f(-0.45F, 0.65F, -0.75F).normalized();
  static const Eigen::Vector3f fill = Eigen::Vector3f(0.8F, 0.1F, -0.5F).normalized();
  static const Eigen::Vector3f glint = (key + Eigen::Vector3f(0.0F, 0.0F, -1.0F)).normalized();
  const Fragment& fragment = buffer.at(x, y);
  if (is_outline(buffer, x, y, pixels_per_mm)) return {0.16F, 0.18F, 0.22F};
  const Eigen::Vector3f normal = fragment.normal.normalized();
  const float light =
      0.36F + 0.66F * std::max(0.0F, normal.dot(key)) + 0.30F * std::max(0.0F, normal.dot(fill));
  const float shine = 0.18F * std::pow(std::max(0.0F, normal.dot(glint)), 30.0F);
  const Eigen::Vector3f colour = (1.0F - fragment.raw) * cut_colour + fragment.raw * raw_colour;
  const float open = openness(buffer, x, y, pixels_per_mm);
  return (open * light * colour).array() + shine;
}

// One pixel of the picture from its samples.
std::uint32_t pixel(const Buffer& buffer, int x, int y, float pixels_per_mm) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float covered = 0.0F;
  for (int dy = 0; dy < samples; ++dy) {
    for (int dx = 0; dx < samples; ++dx) {
      const int u = x * samples + dx;
      const int v = y * samples + dy;
      if (!buffer.at(u, v).is_part()) continue;
      covered += 1.0F;
      sum += shaded(buffer, u, v, pixels_per_mm).cwiseMin(1.0F);
    }
  }
  constexpr float whole = 255.0F / (samples * samples);
  const auto byte = [&](float value) {
    return static_cast<std::uint32_t>(std::lround(value * whole));
  };
  return byte(covered) << 24U | byte(sum.x()) << 16U | byte(sum.y()) << 8U | byte(sum.z());
}

// Whether the material on a ray through a point of the grid begins or ends at most `within` of it.
// Points of a surface lie on rays.
bool ends_a_ray(const Material& material, const Vector& point_K, double within) {
  const Grid& grid = material.grid();
  for (int axis = 0; axis < 3; ++axis) {
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    const auto cell = [&](int k) {
      const double place = (point_K[k] - grid.origin[k]) / grid.cell[k];
      return std::clamp(static_cast<int>(std::floor(place)), 0, grid.count[k] - 1);
    };
    bool ends = false;
    material.family(axis).visit(material.ray(axis, cell(first), cell(second)),
                                [&](const Interval& piece) {
                                  ends = ends || std::abs(piece.from - point_K[axis]) < within ||
                                         std::abs(piece.to - point_K[axis]) < within;
                                });
    if (ends) return true;
  }
  return false;
}

}  // namespace

LitSurface lit(const Mesh& mesh, const Blank& blank, const Grid& grid) {
  LitSurface surface{mesh, {}, {}};
  surface.normals.assign(mesh.points.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f normal =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    for (const std::uint32_t corner : {a, b, c}) surface.normals[corner] += normal;
  }
  for (Eigen::Vector3f& normal : surface.normals) normal.stableNormalize();
  surface.is_raw.reserve(mesh.points.size());
  const double within = raw_part * blank.resolution;
  if (blank.kind == BlankKind::solid) {
    const Material whole(blank, grid);
    for (const Mesh::Point& point : mesh.points)
      surface.is_raw.push_back(ends_a_ray(whole, point.cast<double>(), within) ? 1 : 0);
    return surface;
  }
  for (const Mesh::Point& point : mesh.points) {
    const double distance = distance_to_surface(blank, point.cast<double>());
    surface.is_raw.push_back(distance < within ? 1 : 0);
  }
  return surface;
}

Eigen::Matrix3d Camera::axes() const {
  const Vector away = towards.normalized();
  const Vector right = away.cross(up).normalized();
  Eigen::Matrix3d rows;
  rows << right.transpose(), right.cross(away).transpose(), away.transpose();
  return rows;
}

Image render(const LitSurface& surface, const Camera& camera, const Vector& centre,
             double pixels_per_mm, int width, int height) {
  const Buffer buffer = rasterised(surface, camera, centre, pixels_per_mm * samples,
                                   width * samples, height * samples);
  Image image{width, height, {}};
  image.pixels.reserve(Raster{width, height}.cells());
  const auto scale = static_cast<float>(pixels_per_mm * samples);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.push_back(pixel(buffer, x, y, scale));
  }
  return image;
}

}  // namespace stanok::simulation
