// The known name that a mistyped one most likely means: "did you mean 'feed_max'?"
#pragma once

#include <span>
#include <string_view>

namespace stanok {

// Smallest number of insertions, deletions, replacements and swaps of neighbours that make `b` of
// `a` (optimal string alignment distance); upper and lower case are the same.
[[nodiscard]] int typing_distance(std::string_view a, std::string_view b);

// Empty when none is close: more than `edits_max` would be needed. Of equals the first.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string_view> known, int edits_max);

// The same where at most a third of the name would have to change.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string_view> known);

}  // namespace stanok
