// The axis words of a block: their values in mm and deg (radius), as programmed.
#pragma once

#include "lang/block/block_codes.h"

namespace stanok::lang {

// Takes the axis words out of the block: those of the axes' own names, then U, V
// and W of a lathe channel, as far as no code of the block uses them otherwise.
void collect_axis_words(ActiveBlock& block);
void collect_incremental_words(ActiveBlock& block, const BlockCodes& codes);
// Whether an axis is programmed in mm: all that are not rotary, and C on the polar face.
[[nodiscard]] bool is_length(const ActiveBlock& block, AxisIndex axis);

// The axes of the active plane; the channel may lack one.
struct PlaneAxes {
  AxisIndex first;
  AxisIndex second;
};
[[nodiscard]] PlaneAxes plane_axes(const ActiveBlock& block);

// The words `@` and `^` stand for X and Y; fails where they cannot (polar_words.cc).
void collect_polar_words(ActiveBlock& block);

// Polar input, G16, and the words `@` and `^` (polar_words.cc).
// Puts the point that radius and angle mean into the values of the block, given from zero. `user`:
// the code that has the axis words; the modes of the block are in force.
void take_polar_words(ActiveBlock& block, const Code& user);
// The same for the next hole of a block with repeats.
void repeat_polar_words(ActiveBlock& block);

}  // namespace stanok::lang
