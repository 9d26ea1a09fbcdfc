// The beginning of a .npy file, version 1.0: type and shape of the numbers behind it, in C order
// (numpy.lib.format of NumPy's documentation). Padded, so that the numbers begin at a multiple of
// 64 bytes.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace stanok::jobs {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

// "<f8" for double, "|i1" for a byte.
template <class Number>
  requires std::floating_point<Number> || std::signed_integral<Number>
[[nodiscard]] std::string npy_type() {
  const std::string order = sizeof(Number) == 1 ? "|" : "<";
  return order + (std::floating_point<Number> ? "f" : "i") + std::to_string(sizeof(Number));
}

[[nodiscard]] std::string npy_header(std::string_view type, std::span<const std::int64_t> shape);

}  // namespace stanok::jobs
