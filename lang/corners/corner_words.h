// From the words `,C` and `,R` of a block to the corner that they ask for.
#pragma once

#include "lang/block/active_block.h"

namespace stanok::lang {

// Sets block.end.corner, in mm in W; the block fails where the words cannot be used.
void read_corner(ActiveBlock& block);

}  // namespace stanok::lang
