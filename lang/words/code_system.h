// G codes of Fanuc lathes in code systems A and C, by those of B: what they are called here.
//
// Source: Fanuc Series 0i-TD, operator's manual (lathe system) B-64304EN-1, chapter 3, table 3.1.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/contract/dialect.h"
#include "lang/words/block_fault.h"
#include "lang/words/block_words.h"

namespace stanok::lang {

// The code here of one that is written in `system`; nothing: the system has no such code.
[[nodiscard]] std::optional<CodeNumber> translated_code(CodeNumber written, CodeSystem system);

// The code of `system` that is `code` here; `code` itself where it is called the same.
[[nodiscard]] CodeNumber code_as_written(CodeNumber code, CodeSystem system);

// A message that names codes by their names here, with those that the programmer knows: "`G77`
// needs X and Z" is "`G90` needs X and Z" in system A.
[[nodiscard]] std::string text_as_written(std::string_view text, CodeSystem system);

// The same for all texts of a fault.
void name_codes_as_written(BlockFault& fault, CodeSystem system);

// Translates all codes of a block; false when one does not exist in the system.
[[nodiscard]] bool translate_codes(CodeList& codes, CodeSystem system);

// What says the same in the system as a code that it does not have; empty: nothing is known.
[[nodiscard]] std::string_view instead_of_code(CodeNumber written, CodeSystem system);

}  // namespace stanok::lang
