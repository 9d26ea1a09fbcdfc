// GeometryBytes: the points of a page of geometry as they travel: Float32 x, y, z (mm) of all, then
// a Uint32 for each (a line, a tool, a time), all little endian, in base64. stanok-web makes binary
// frames of such pages.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace stanok::protocol {

// What a page shows.
enum class GeometryKind : std::uint8_t { path = 1, surface = 2, logged_path = 3 };

class GeometryBytes {
 public:
  void reserve(std::size_t points);
  void add(const std::array<float, 3>& place_mm, std::uint32_t number);
  [[nodiscard]] std::string base64() const;

 private:
  std::string places_;
  std::string numbers_;
};

}  // namespace stanok::protocol
