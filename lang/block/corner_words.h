// The words `,C` and `,R` of a block: the chamfer or the rounding behind its motion.
#pragma once

#include <string_view>

#include "lang/block/active_block.h"

namespace stanok::lang {

inline constexpr std::string_view chamfer_word = ",C";
inline constexpr std::string_view rounding_word = ",R";

[[nodiscard]] constexpr bool is_corner_word(std::string_view name) {
  return name == chamfer_word || name == rounding_word;
}

// Sets block.corner from its words, in mm in W; the block fails where they cannot be used.
void read_corner(ActiveBlock& block);

}  // namespace stanok::lang
