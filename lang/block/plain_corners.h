// Chamfers, roundings and angles of lines that are written as plain letters: C, R and A of G1.
//
// Lathes of Fanuc have them so by parameter 3405: G1 X50 C2, G1 Z-20 R5, G1 Z-30 A135. Letters that
// are axes of the channel stay axes. Source: Fanuc operator's manual B-64304EN-1, direct drawing
// dimension programming.
#pragma once

#include "lang/block/active_block.h"
#include "lang/block/block_codes.h"

namespace stanok::lang {

// Whether letters may be such words in a block with these codes, whatever is active.
[[nodiscard]] bool may_have_plain_corners(const BlockWords& words, const BlockCodes& codes,
                                          const ChannelDescription& channel);

// Notes which letters of the block are such words: when its codes are known.
void find_plain_corners(ActiveBlock& block, const BlockCodes& codes);

}  // namespace stanok::lang
