// The values of `,A`, `,C` and `,R` in a block, also where they are written without a comma
// (lang/block/plain_corners.h).
#pragma once

#include <optional>
#include <string_view>

#include "lang/block/active_block.h"

namespace stanok::lang {

struct CornerValue {
  double value = 0.0;
  WordName place;
};

[[nodiscard]] inline bool has_corner_words(const ActiveBlock& block) {
  return !block.words.named.empty() || block.plain_corners != 0;
}

// `name`: with its comma. Nothing: the block has no such word.
[[nodiscard]] std::optional<CornerValue> corner_value(const ActiveBlock& block,
                                                      std::string_view name);

}  // namespace stanok::lang
