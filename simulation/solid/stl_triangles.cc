#include "simulation/solid/stl_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace stanok::simulation {
namespace {

constexpr std::size_t header_bytes = 84;  // 80 of text, then the number of triangles
constexpr std::size_t normal_bytes = 12;

static_assert(std::endian::native == std::endian::little, "STL numbers are little-endian");

using Triangles = Expected<std::vector<StlTriangle>, StlRefusal>;

StlRefusal no_stl(std::string text) {
  return {"E7020", std::move(text), "export it anew as binary or ASCII STL"};
}

StlRefusal too_many(std::size_t triangles) {
  return {"E7023",
          fmt::format("the surface has {} triangles, at most {} are allowed", triangles,
                      stl_triangles_max),
          "export it with a coarser tolerance"};
}

std::size_t announced_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() == header_bytes + stl_triangle_bytes * announced_triangles(bytes);
}

// -0 becomes 0, so that equal corners have equal bits.
StlCorner plain(const StlCorner& corner) {
  return corner + StlCorner::Zero();
}

Triangles binary_triangles(std::string_view bytes) {
  const std::size_t count = announced_triangles(bytes);
  if (count > stl_triangles_max) return Unexpected(too_many(count));
  std::vector<StlTriangle> triangles(count);
  for (std::size_t k = 0; k < count; ++k) {
    const char* const begin = bytes.data() + header_bytes + stl_triangle_bytes * k + normal_bytes;
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), begin, sizeof numbers);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangles[k][corner] = plain(Eigen::Map<const StlCorner>(numbers.data() + 3 * corner));
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
    StlCorner normal;
    StlTriangle triangle;
    if (!take_word("normal") || !take_corner(normal)) return false;
    if (!take_word("outer") || !take_word("loop")) return false;
    for (StlCorner& corner : triangle) {
      if (!take_word("vertex") || !take_corner(corner) || !corner.allFinite()) return false;
      corner = plain(corner);
    }
    triangles_.push_back(triangle);
    return take_word("endloop") && take_word("endfacet");
  }

  bool take_corner(StlCorner& corner) {
    for (float& number : corner) {
      std::string_view word = next_word();
      const std::size_t length = word.size();
      if (word.starts_with('+')) word.remove_prefix(1);
      const auto [behind, error] = std::from_chars(word.begin(), word.end(), number);
      if (error != std::errc() || behind != word.end()) return false;
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
  std::vector<StlTriangle> triangles_;
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
      header_bytes + stl_triangle_bytes * announced_triangles(bytes), bytes.size())));
}

}  // namespace

Expected<std::vector<StlTriangle>, StlRefusal> triangles_of_stl(std::string_view bytes) {
  if (bytes.size() > stl_bytes_max) return Unexpected(stl_too_large(bytes.size()));
  auto triangles = triangles_of(bytes);
  if (triangles && triangles->empty()) return Unexpected(no_stl("the file has no triangles"));
  return triangles;
}

StlRefusal stl_too_large(std::size_t bytes) {
  return {"E7023",
          fmt::format("the file has {} MiB, at most {} are allowed", (bytes >> 20U) + 1,
                      stl_bytes_max >> 20U),
          "export it as binary STL, or with a coarser tolerance"};
}

}  // namespace stanok::simulation
