#include "process/grinding/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr std::size_t digits_max = 400;  // of the largest double in fixed point

}  // namespace

std::string number_text(double value) {
  constexpr double readable_max = 1e15;
  constexpr double readable_min = 1e-9;
  const double size = std::abs(value);
  const bool is_readable = value == 0.0 || (size < readable_max && size >= readable_min);
  std::array<char, digits_max> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value,
                    is_readable ? std::chars_format::fixed : std::chars_format::scientific)
          .ptr;
  return {text.data(), end};
}

std::string number_text(double value, int decimals) {
  std::string text = number_text(value);
  const std::size_t point = text.find('.');
  std::size_t has = point == std::string::npos ? 0 : text.size() - point - 1;
  if (point == std::string::npos && decimals > 0) text += '.';
  for (const std::size_t wanted = checked_size(decimals); has < wanted; ++has) text += '0';
  return text;
}

std::string rounded_text(double value, int decimals) {
  constexpr double readable_max = 1e15;
  if (std::abs(value) >= readable_max) return number_text(value);
  std::array<char, digits_max> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {text.data(), end};
}

}  // namespace stanok::process
