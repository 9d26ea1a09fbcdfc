#include "protocol/contract/geometry_bytes.h"

#include <bit>

#include "protocol/contract/base64.h"

namespace stanok::protocol {
namespace {

constexpr std::size_t word_bytes = 4;

void append_word(std::string& bytes, std::uint32_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
}

}  // namespace

void GeometryBytes::reserve(std::size_t points) {
  places_.reserve(3 * word_bytes * points);
  numbers_.reserve(word_bytes * points);
}

void GeometryBytes::add(const std::array<float, 3>& place_mm, std::uint32_t number) {
  for (const float value : place_mm) append_word(places_, std::bit_cast<std::uint32_t>(value));
  append_word(numbers_, number);
}

std::string GeometryBytes::base64() const {
  return protocol::base64(places_ + numbers_);
}

}  // namespace stanok::protocol
