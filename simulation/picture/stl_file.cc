// Format: 80 bytes of title, the number of triangles, and for each its normal, its three corners
// and two bytes that are 0; little endian.
#include "simulation/picture/stl_file.h"

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/system_error.h"
#include "simulation/solid/stl_triangles.h"

namespace stanok::simulation {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t title_bytes = 80;
constexpr std::size_t batch = 4096;  // triangles

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

char* put(const Mesh::Point& point, char* to) {
  std::memcpy(to, point.data(), 3 * sizeof(float));
  return to + 3 * sizeof(float);
}

void put_triangle(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, char* to) {
  const Mesh::Point& a = mesh.points[triangle[0]];
  const Mesh::Point& b = mesh.points[triangle[1]];
  const Mesh::Point& c = mesh.points[triangle[2]];
  to = put((b - a).cross(c - a).stableNormalized(), to);
  to = put(c, put(b, put(a, to)));
  std::memset(to, 0, 2);
}

bool write_all(std::FILE* file, const Mesh& mesh, std::string_view title) {
  char head[title_bytes + 4] = {};
  std::memcpy(head, title.data(), std::min(title.size(), title_bytes));
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::memcpy(head + title_bytes, &count, sizeof count);
  if (std::fwrite(head, sizeof head, 1, file) != 1) return false;
  std::vector<char> bytes;
  for (std::size_t from = 0; from < mesh.triangles.size(); from += batch) {
    const std::size_t to = std::min(from + batch, mesh.triangles.size());
    bytes.resize((to - from) * stl_triangle_bytes);
    for (std::size_t i = from; i < to; ++i)
      put_triangle(mesh, mesh.triangles[i], bytes.data() + (i - from) * stl_triangle_bytes);
    if (std::fwrite(bytes.data(), bytes.size(), 1, file) != 1) return false;
  }
  return true;
}

std::string system_error_of(const std::filesystem::path& path) {
  return path.string() + ": " + system_error_text(errno);
}

}  // namespace

std::string write_stl(const Mesh& mesh, const std::filesystem::path& path, std::string_view title) {
  File file(std::fopen(path.c_str(), "wb"), &std::fclose);
  if (file == nullptr) return system_error_of(path);
  const bool is_written = write_all(file.get(), mesh, title);
  if (std::fclose(file.release()) != 0 || !is_written) return system_error_of(path);
  return "";
}

}  // namespace stanok::simulation
