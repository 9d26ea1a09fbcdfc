#include "simulation/solid/stl_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <optional>

namespace stanok::simulation {
namespace {

constexpr std::size_t header_bytes = 84;    // 80 of text, then the number of triangles
constexpr std::size_t triangle_bytes = 50;  // normal, three corners, two bytes of attributes
constexpr std::size_t normal_bytes = 12;

static_assert(std::endian::native == std::endian::little, "STL numbers are little-endian");

using Triangles = Expected<std::vector<Solid::Triangle>, StlRefusal>;

StlRefusal no_stl(std::string text) {
  return {"E7020", std::move(text), "export the blank anew as binary or ASCII STL"};
}

StlRefusal too_many(std::size_t triangles) {
  return {"E7023",
          fmt::format("the surface has {} triangles, at most {} are allowed", triangles,
                      stl_triangles_max),
          "export the blank with a coarser tolerance"};
}

std::size_t announced_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() == header_bytes + triangle_bytes * announced_triangles(bytes);
}

// -0 becomes 0, so that equal corners have equal bits.
Solid::Corner plain(const Solid::Corner& corner) {
  return corner + Solid::Corner::Zero();
}

Triangles binary_triangles(std::string_view bytes) {
  const std::size_t count = announced_triangles(bytes);
  if (count > stl_triangles_max) return Unexpected(too_many(count));
  std::vector<Solid::Triangle> triangles(count);
  for (std::size_t k = 0; k < count; ++k) {
    const char* const begin = bytes.data() + header_bytes + triangle_bytes * k + normal_bytes;
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), begin, sizeof numbers);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangles[k][corner] = plain(Eigen::Map<const Solid::Corner>(numbers.data() + 3 * corner));
      if (!triangles[k][corner].allFinite())
        return Unexpected(no_stl(fmt::format("a corner of triangle {} is no number", k + 1)));
    }
  }
  return triangles;
}

// ASCII: solid NAME { facet normal x y z outer loop { vertex x y z } x 3 endloop endfacet }
// endsolid NAME.
class AsciiReader {
 public:
  explicit AsciiReader(std::string_view text) : rest_(text) {}

  Triangles read() {
    while (take_word("solid")) {
      skip_line();
      while (take_word("facet")) {
        if (!read_facet()) return Unexpected(fault());
        if (triangles_.size() > stl_triangles_max) return Unexpected(too_many(triangles_.size()));
      }
      if (!take_word("endsolid")) return Unexpected(fault());
      skip_line();
    }
    if (!next_word().empty()) return Unexpected(fault());
    return std::move(triangles_);
  }

 private:
  bool read_facet() {
    Solid::Corner normal;
    Solid::Triangle triangle;
    if (!take_word("normal") || !take_corner(normal)) return false;
    if (!take_word("outer") || !take_word("loop")) return false;
    for (Solid::Corner& corner : triangle) {
      if (!take_word("vertex") || !take_corner(corner) || !corner.allFinite()) return false;
      corner = plain(corner);
    }
    triangles_.push_back(triangle);
    return take_word("endloop") && take_word("endfacet");
  }

  bool take_corner(Solid::Corner& corner) {
    for (float& number : corner) {
      std::string_view word = next_word();
      const std::size_t length = word.size();
      if (word.starts_with('+')) word.remove_prefix(1);
      const char* const end = word.data() + word.size();
      const auto [behind, error] = std::from_chars(word.data(), end, number);
      if (error != std::errc() || behind != end) return false;
      rest_.remove_prefix(length);
    }
    return true;
  }

  // Takes the next word if it is this one, in capitals or not.
  bool take_word(std::string_view wanted) {
    const std::string_view word = next_word();
    const bool is_it = std::ranges::equal(word, wanted, [](char a, char b) {
      return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
    if (is_it) rest_.remove_prefix(word.size());
    return is_it;
  }

  std::string_view next_word() {
    while (!rest_.empty() && is_blank(rest_.front())) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    return rest_.substr(0, rest_.find_first_of(" \t\r\n"));
  }

  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  [[nodiscard]] StlRefusal fault() const {
    return no_stl(fmt::format("line {} is not as in an ASCII STL file", line_));
  }

  std::string_view rest_;
  std::size_t line_ = 1;
  std::vector<Solid::Triangle> triangles_;
};

Triangles triangles_of(std::string_view bytes) {
  if (is_binary(bytes)) return binary_triangles(bytes);
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = std::min(bytes.find_first_not_of(blanks), bytes.size());
  const std::string_view first = bytes.substr(begin, 5);
  if (first == "solid" || first == "SOLID") return AsciiReader(bytes.substr(begin)).read();
  if (bytes.size() < header_bytes)
    return Unexpected(no_stl(fmt::format("{} bytes are no STL file", bytes.size())));
  return Unexpected(no_stl(fmt::format(
      "a binary STL file of {} triangles has {} bytes, this one has {}", announced_triangles(bytes),
      header_bytes + triangle_bytes * announced_triangles(bytes), bytes.size())));
}

// A number for each corner of each triangle, equal for equal corners.
std::vector<std::uint32_t> numbered_corners(const std::vector<Solid::Triangle>& triangles) {
  const auto corner = [&](std::uint32_t place) -> const Solid::Corner& {
    return triangles[place / 3][place % 3];
  };
  const auto compared = [&](std::uint32_t a, std::uint32_t b) {
    const Solid::Corner& p = corner(a);
    const Solid::Corner& q = corner(b);
    for (int k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    }
    return 0;
  };
  std::vector<std::uint32_t> order(3 * triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return compared(a, b) < 0; });
  std::vector<std::uint32_t> numbers(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || compared(order[k - 1], order[k]) != 0;
    numbers[order[k]] = is_new ? order[k] : numbers[order[k - 1]];
  }
  return numbers;
}

// An edge of a triangle; `low` and `high` are numbers of corners, which are also their places.
struct Edge {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  int direction = 0;  // 1 from low to high, -1 back
};

// Edges that are not run as often one way as the other.
struct OpenEdges {
  std::size_t count = 0;
  std::uint32_t corner = 0;  // of the first one
};

OpenEdges open_edges(const std::vector<Solid::Triangle>& triangles) {
  const std::vector<std::uint32_t> corners = numbered_corners(triangles);
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t from = corners[k];
    const std::uint32_t to = corners[k % 3 == 2 ? k - 2 : k + 1];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  OpenEdges open;
  for (std::size_t k = 0; k < edges.size();) {
    const Edge& first = edges[k];
    int sum = 0;
    for (; k < edges.size() && edges[k].low == first.low && edges[k].high == first.high; ++k)
      sum += edges[k].direction;
    if (sum == 0) continue;
    if (open.count == 0) open.corner = first.low;
    ++open.count;
  }
  return open;
}

void measure(Solid& solid) {
  solid.low = solid.high = solid.triangles.front().front().cast<double>();
  for (const Solid::Triangle& triangle : solid.triangles) {
    for (const Solid::Corner& corner : triangle) {
      solid.low = solid.low.cwiseMin(corner.cast<double>());
      solid.high = solid.high.cwiseMax(corner.cast<double>());
    }
  }
  // Pyramids over the triangles, their tops in one corner of the box.
  for (const Solid::Triangle& triangle : solid.triangles) {
    const Eigen::Vector3d a = triangle[0].cast<double>() - solid.low;
    const Eigen::Vector3d b = triangle[1].cast<double>() - solid.low;
    const Eigen::Vector3d c = triangle[2].cast<double>() - solid.low;
    solid.volume += a.dot(b.cross(c)) / 6.0;
  }
}

// How often the surface lies over itself, seen along the axis where it does most.
double layers_of(const Solid& solid) {
  Eigen::Vector3d shadows = Eigen::Vector3d::Zero();
  for (const Solid::Triangle& triangle : solid.triangles) {
    const Eigen::Vector3d first = (triangle[1] - triangle[0]).cast<double>();
    const Eigen::Vector3d second = (triangle[2] - triangle[0]).cast<double>();
    shadows += first.cross(second).cwiseAbs() / 2.0;
  }
  const Eigen::Vector3d size = solid.high - solid.low;
  const Eigen::Vector3d faces(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  return shadows.cwiseQuotient(faces).maxCoeff();
}

std::optional<StlRefusal> refusal_of(const Solid& solid) {
  const OpenEdges open = open_edges(solid.triangles);
  if (open.count != 0) {
    const Solid::Corner& at = solid.triangles[open.corner / 3][open.corner % 3];
    return StlRefusal{
        "E7021",
        fmt::format(
            "the surface is not closed: {} edges have no second triangle, the first at {:g}, "
            "{:g}, {:g}",
            open.count, at.x(), at.y(), at.z()),
        "repair the file, or export a solid instead of a surface"};
  }
  if (solid.volume < 0.0) {
    return StlRefusal{"E7022",
                      "the surface is inside out: its triangles run clockwise from outside",
                      "turn the normals over in the program that made the file"};
  }
  if (!((solid.high - solid.low).minCoeff() > 0.0) || !(solid.volume > 0.0))
    return StlRefusal{"E7022", "the surface encloses no volume", "export a solid"};
  if (const double layers = layers_of(solid); layers > stl_layers_max) {
    return StlRefusal{"E7023",
                      fmt::format("the surface lies over itself {:.0f} times, at most {:.0f} are "
                                  "allowed",
                                  layers, stl_layers_max),
                      "export the outer faces of the blank alone"};
  }
  return std::nullopt;
}

}  // namespace

Expected<Solid, StlRefusal> solid_of_stl(std::string_view bytes) {
  if (bytes.size() > stl_bytes_max) return Unexpected(stl_too_large(bytes.size()));
  auto triangles = triangles_of(bytes);
  if (!triangles) return Unexpected(triangles.error());
  if (triangles->empty()) return Unexpected(no_stl("the file has no triangles"));
  Solid solid;
  solid.triangles = std::move(*triangles);
  measure(solid);
  if (auto refusal = refusal_of(solid)) return Unexpected(std::move(*refusal));
  return solid;
}

StlRefusal stl_too_large(std::size_t bytes) {
  return {"E7023",
          fmt::format("the file has {} MiB, at most {} are allowed", (bytes >> 20U) + 1,
                      stl_bytes_max >> 20U),
          "export the blank as binary STL, or with a coarser tolerance"};
}

}  // namespace stanok::simulation
