// The word `,A` of a block: a line by its angle.
//
// The angle leads from the first axis of the plane (X, Z, Y in G17, G18, G19) towards the second,
// in deg. With one coordinate of the plane in the block the angle gives the other. With none the
// end is where the line meets that of the next block, which has its end and its own angle
// (lang/corners/corner_stage.h). Source: Fanuc operator's manual B-63944EN, 13.6; for lathes
// B-64304EN-1, direct drawing dimension programming.
#pragma once

#include "lang/block/active_block.h"
#include "lang/words/code_table.h"

namespace stanok::lang {

// A block without a coordinate moves, too.
void collect_line_angle(ActiveBlock& block);

// Whether the block may have the word: a line at feed. When it is known what the block does.
// `axis_user`: the code that uses its axis words; nullptr: none.
void check_line_angle(ActiveBlock& block, const Code* axis_user);

// Completes the point of the block, or notes what the next block needs for that. Before its motion,
// when plane and G91 are those of the block.
void take_line_angle(ActiveBlock& block);

}  // namespace stanok::lang
