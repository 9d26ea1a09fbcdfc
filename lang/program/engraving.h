// G47 of Haas, the engraving of a text: blocks of a tree with it become calls of `engrave_block` in
// mill/engrave.nc, which the text then includes.
//
// Source: Haas mill operator's manual, G47. P0: the text is the comment of the block. P1: so is a
// serial number, of as many digits as it has #, which is that of #599 and becomes one more; digits
// in place of # are the first number. P32 to P126: the character of that number. X Y is the lower
// left corner of the text, I its direction, J the height of the letters, R the level between
// strokes, Z the depth, F and E the feeds along strokes and into the material.
#pragma once

#include "lang/text/reporter.h"
#include "lang/tree/tree.h"

namespace stanok::lang {

// The text of an operator's line then has the #include before its statement: true.
bool make_engravings(StatementList& tree, Reporter& reporter);

}  // namespace stanok::lang
