// The values of `,A`, `,C` and `,R` in a block, also where they are written without a comma.
//
// Lathes of Fanuc have them so by parameter 3405: G1 X50 C2, G1 Z-20 R5, G1 Z-30 A135. Letters that
// are axes of the channel stay axes. Source: Fanuc operator's manual B-64304EN-1, direct drawing
// dimension programming.
#pragma once

#include <optional>
#include <string_view>

#include "lang/block/active_block.h"
#include "lang/block/block_codes.h"

namespace stanok::lang {

struct CornerValue {
  double value = 0.0;
  WordName place;
};

// Notes which letters of the block are such words: when its codes are known.
void find_plain_corners(ActiveBlock& block, const BlockCodes& codes);

[[nodiscard]] inline bool has_corner_words(const ActiveBlock& block) {
  return !block.words.named.empty() || block.end.plain_corners != 0;
}

// `name`: with its comma. Nothing: the block has no such word.
[[nodiscard]] std::optional<CornerValue> corner_value(const ActiveBlock& block,
                                                      std::string_view name);

}  // namespace stanok::lang
