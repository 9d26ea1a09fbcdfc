// FixedText<N>: a short text as plain data, for what crosses into the real-time cycle. Longer text
// is cut.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "base/rt_safe.h"

namespace stanok {

template <std::size_t N>
struct FixedText {
  std::array<char, N> characters{};  // ends with at least one NUL

  constexpr FixedText() = default;
  constexpr FixedText(std::string_view text) RT_SAFE {  // NOLINT: a text is a text
    std::copy_n(text.begin(), std::min(text.size(), N - 1), characters.begin());
  }
  [[nodiscard]] constexpr std::string_view view() const RT_SAFE {
    const auto end = std::find(characters.begin(), characters.end(), '\0');
    return {characters.data(), static_cast<std::size_t>(end - characters.begin())};
  }
  [[nodiscard]] constexpr bool empty() const RT_SAFE { return characters[0] == '\0'; }
};

}  // namespace stanok
