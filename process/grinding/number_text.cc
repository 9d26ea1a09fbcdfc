#include "process/grinding/number_text.h"

#include <array>
#include <charconv>

#include "base/place.h"

namespace stanok::process {
namespace {

constexpr std::size_t digits_max = 400;  // of the largest double in fixed point

}  // namespace

std::string number_text(double value) {
  std::array<char, digits_max> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
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
  std::array<char, digits_max> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {text.data(), end};
}

}  // namespace stanok::process
