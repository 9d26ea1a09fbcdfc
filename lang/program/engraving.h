// G47 of Haas, the engraving of a text: blocks of a tree with it become calls of `engrave_block` in
// mill/engrave.nc, which the text then includes.
//
// Source: Haas mill operator's manual, G47. The text is the comment of the block; X Y its lower
// left corner, I its direction, J the height of the letters, R the level between strokes, Z the
// depth, F and E the feeds along strokes and into the material.
#pragma once

#include "lang/text/reporter.h"
#include "lang/tree/tree.h"

namespace stanok::lang {

void make_engravings(StatementList& tree, Reporter& reporter);

}  // namespace stanok::lang
