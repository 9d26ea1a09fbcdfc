// The words `,C` and `,R` of a block, the chamfer or the rounding behind its motion, and `,A`, the
// angle of its line.
#pragma once

#include <string_view>

#include "lang/words/block_words.h"

namespace stanok::lang {

inline constexpr std::string_view chamfer_word = ",C";
inline constexpr std::string_view rounding_word = ",R";

inline constexpr std::string_view angle_word = ",A";

// The letters that say the same without a comma, where a lathe channel has them so.
inline constexpr LetterSet plain_corner_letters =
    letter_bit('A') | letter_bit('C') | letter_bit('R');

// And those of a chamfer behind a move of Z alone, and of X alone.
inline constexpr LetterSet square_chamfer_letters = letter_bit('I') | letter_bit('K');

// A of a line on lathes of LinuxCNC is the radius of a rounding. Source: its example
// nc_files/lathe_g70_71_demo.ngc, `G1 X10 A0.2` in a profile.
inline constexpr LetterSet rounding_letter_of_linuxcnc = letter_bit('A');

[[nodiscard]] constexpr bool is_corner_word(std::string_view name) {
  return name == chamfer_word || name == rounding_word || name == angle_word;
}

}  // namespace stanok::lang
