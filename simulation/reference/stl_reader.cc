// Binary: 80 bytes of title, the number of triangles, and for each its normal, its three corners
// and two bytes; little endian. Text: `vertex x y z`, three for each triangle. A binary file is one
// whose size is that of its number of triangles, whatever its title says.
#include "simulation/reference/stl_reader.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>

namespace stanok::simulation {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t stl_title_bytes = 80;
constexpr std::size_t stl_head_bytes = stl_title_bytes + 4;
constexpr std::size_t stl_triangle_bytes = 50;
constexpr std::uintmax_t text_bytes_max = 200U << 20;
constexpr float place_max_mm = 1e5F;

using Triangles = Expected<std::vector<Corners>, std::string>;

Unexpected<std::string> refusal(const std::filesystem::path& file, const std::string& reason) {
  return Unexpected<std::string>(file.filename().string() + ": " + reason);
}

bool has_area(const Corners& corners) {
  for (const Mesh::Point& corner : corners) {
    if (!(corner.cwiseAbs().maxCoeff() < place_max_mm)) return false;
  }
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() > 0.0F;
}

// The number of triangles; nothing: it is no binary file.
std::optional<std::size_t> binary_triangles(std::ifstream& file, std::uintmax_t bytes) {
  char head[stl_head_bytes];
  if (!file.read(head, sizeof head)) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, head + stl_title_bytes, sizeof count);
  if (bytes != stl_head_bytes + std::uintmax_t{count} * stl_triangle_bytes) return std::nullopt;
  return count;
}

std::vector<Corners> read_binary(std::ifstream& file, std::size_t count) {
  std::vector<Corners> triangles;
  triangles.reserve(count);
  char bytes[stl_triangle_bytes];
  while (triangles.size() < count && file.read(bytes, sizeof bytes)) {
    Corners corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
      std::memcpy(corners[k].data(), bytes + 3 * sizeof(float) * (k + 1), 3 * sizeof(float));
    if (has_area(corners))
      triangles.push_back(corners);
    else
      --count;
  }
  return triangles;
}

std::vector<Corners> read_text(std::istream& file) {
  std::vector<Corners> triangles;
  Corners corners;
  std::size_t known = 0;
  std::string word;
  while (triangles.size() <= stl_triangles_max && file >> word) {
    if (word != "vertex") continue;
    Mesh::Point& corner = corners[known];
    if (!(file >> corner.x() >> corner.y() >> corner.z())) return {};
    if (++known < corners.size()) continue;
    known = 0;
    if (has_area(corners)) triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace

Triangles read_stl(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) return refusal(path, "it cannot be read");
  const std::string too_many = "more than " + std::to_string(stl_triangles_max) + " triangles";
  std::vector<Corners> triangles;
  if (const auto count = binary_triangles(file, bytes)) {
    if (*count > stl_triangles_max) return refusal(path, too_many);
    triangles = read_binary(file, *count);
  } else {
    if (bytes > text_bytes_max) return refusal(path, "it is too large");
    file.clear();
    file.seekg(0);
    triangles = read_text(file);
  }
  if (triangles.empty()) return refusal(path, "no STL file, or one without a triangle");
  if (triangles.size() > stl_triangles_max) return refusal(path, too_many);
  return triangles;
}

}  // namespace stanok::simulation
