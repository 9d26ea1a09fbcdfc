// The known name that a mistyped one most likely means.
#pragma once

#include <span>
#include <string_view>

namespace stanok::config {

// Smallest number of insertions, deletions, replacements and swaps of neighbours that make `b` of
// `a` (optimal string alignment distance).
[[nodiscard]] int typing_distance(std::string_view a, std::string_view b);

// Empty when none is close: more than a third of the name would have to change.
[[nodiscard]] std::string_view nearest_key(std::string_view name,
                                           std::span<const std::string_view> known);

}  // namespace stanok::config
