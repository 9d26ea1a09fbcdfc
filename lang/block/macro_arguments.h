// Words of a block as arguments of a macro.
//
// As parameters: A is #1, B #2, ... by the table "argument specification I" of Fanuc Macro B. G, L,
// N, O and P have no parameter there.
#pragma once

#include <optional>
#include <string_view>

#include "lang/block/active_block.h"
#include "lang/words/channel_dialect.h"

namespace stanok::lang {

// The number of the parameter that a letter sets; 0 if none.
[[nodiscard]] int parameter_of_argument(char letter);

// The number of the parameter that the second and later I, J and K of a call set ("I2"): argument
// specification II; 0 if none.
[[nodiscard]] int parameter_of_repeated(std::string_view name);

// Why a block cannot be a call of `macro`, if so.
[[nodiscard]] std::optional<BlockFault> check_macro_block(const BlockWords& words,
                                                          const MacroCode& macro);

// The arguments in a block, M of G65 among the letters.
[[nodiscard]] BlockWords arguments_of(const BlockWords& words, const MacroCode& macro);

// The argument called `name` ("X", "x2"), if it was given.
[[nodiscard]] std::optional<double> find_argument(const BlockWords& arguments,
                                                  std::string_view name);

}  // namespace stanok::lang
