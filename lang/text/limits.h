// How much a program may hold: every limit of the language in one place, so that the checks and
// docs/reference/language.md ("Limits") agree. What has no row here has no limit but the memory of
// the machine.
#pragma once

#include <cstddef>

namespace stanok::lang::limits {

inline constexpr int nesting = 64;  // of braces and O-lines; of brackets, parentheses and signs
inline constexpr std::size_t block_bytes = 4096;
inline constexpr std::size_t statement_bytes = 65536;  // without the bodies of control flow
inline constexpr int operators = 1000;                 // of one expression
inline constexpr int else_ifs = 1000;                  // of one if
inline constexpr std::size_t name_characters = 64;
inline constexpr std::size_t string_bytes = 4096;
inline constexpr std::size_t o_call_arguments = 30;
inline constexpr std::size_t call_depth = 64;  // functions, O-subs, files and macros together
inline constexpr std::size_t files = 256;      // of one program, includes counted
// Of one program; a plain block is none, it is kept as its text. About 1 kB each while it compiles.
inline constexpr std::size_t statements = 1'000'000;
inline constexpr int steps_of_block = 100;  // of the bound of steps, see ProgramBounds
inline constexpr std::size_t array_elements = 1'000'000;
inline constexpr std::size_t run_array_bytes = 64UL << 20;  // all arrays of a run together
inline constexpr int feed_law_steps = 1'000'000;            // up or down, of a modulated law
inline constexpr std::size_t feed_law_points = 1000;        // of a curve
inline constexpr std::size_t diagnostics = 100;             // errors of a file, and warnings of it

}  // namespace stanok::lang::limits
