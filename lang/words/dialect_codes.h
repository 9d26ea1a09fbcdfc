// Codes that a dialect has beside the table of codes, or has instead of a row of it: what Fanuc and
// Haas call by a number of their own, or mean by one that has another meaning everywhere else.
#pragma once

#include "lang/contract/environment.h"
#include "lang/words/code_table.h"

namespace stanok::lang {

// The row of a code of this block where it is not that of the table; nullptr: the table has it, or
// nobody. `kind` nullptr: the channel is not known.
[[nodiscard]] const Code* code_of_dialect(char letter, CodeNumber number, const BlockWords& words,
                                          const ChannelKind* kind);

// M codes that have a meaning on LinuxCNC alone, and here. On other controls they are the builder's
// (M51 to M58 and M61 to M68 of Haas: optional user M codes): a machine file may give them another
// meaning, and without one they have none in the dialects of Fanuc. M73 stays what it is: the cycle
// programs of stanok have it.
[[nodiscard]] bool is_left_to_builders(char letter, CodeNumber number);

// G110 to G129 of Haas: the work offsets of G154 P1 to P20.
inline constexpr CodeNumber first_offset_of_haas = g(110);
inline constexpr CodeNumber last_offset_of_haas = g(129);
[[nodiscard]] constexpr bool is_offset_of_haas(CodeNumber code) {
  return code >= first_offset_of_haas && code <= last_offset_of_haas && code % 10 == 0;
}

}  // namespace stanok::lang
