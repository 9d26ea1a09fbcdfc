// FixedText<N>: a short text as plain data, for what crosses into the real-time cycle. Longer text
// is cut behind a whole character.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "base/rt_safe.h"
#include "base/utf8.h"

namespace stanok {

template <std::size_t N>
struct FixedText {
  std::array<char, N> characters{};  // ends with at least one NUL

  constexpr FixedText() = default;
  constexpr FixedText(std::string_view text) RT_SAFE {  // NOLINT: a text is a text
    const std::string_view kept = cut_to(text, N - 1);
    std::copy(kept.begin(), kept.end(), characters.begin());
  }
  [[nodiscard]] constexpr std::string_view view() const RT_SAFE {
    const auto end = std::find(characters.begin(), characters.end(), '\0');
    return {characters.begin(), end};
  }
  [[nodiscard]] constexpr bool empty() const RT_SAFE { return characters[0] == '\0'; }
  friend constexpr bool operator==(const FixedText&, const FixedText&) = default;

  // Behind what is there, as far as it fits.
  constexpr FixedText& append(std::string_view text) RT_SAFE {
    const std::size_t length = view().size();
    const std::string_view kept = cut_to(text, N - 1 - length);
    std::copy(kept.begin(), kept.end(), characters.begin() + static_cast<std::ptrdiff_t>(length));
    return *this;
  }
  constexpr FixedText& append(long number) RT_SAFE {
    constexpr std::size_t digits_max = 20;
    std::array<char, digits_max> digits{};
    std::size_t first = digits_max;
    auto rest = static_cast<unsigned long>(number);
    if (number < 0) {
      append("-");
      rest = 0UL - rest;
    }
    do {
      digits[--first] = static_cast<char>('0' + rest % 10);
      rest /= 10;
    } while (rest != 0);
    return append(std::string_view(digits.data() + first, digits_max - first));
  }
};

}  // namespace stanok
