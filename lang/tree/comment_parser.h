// Comments in ISO blocks: most say nothing, (MSG,...), (DEBUG,...) and (PRINT,...) become messages.
#pragma once

#include "lang/tree/token_cursor.h"

namespace stanok::lang {

// From its opening parenthesis. False, with a report: it is at fault.
bool parse_comment(TokenCursor& cursor, IsoBlock& block);

// Parts of the texts that messages and printed lines become.
[[nodiscard]] Expression string_expression(std::string text, const Span& span);
// left + right
[[nodiscard]] Expression concatenated(Expression left, Expression right);
// str (value, decimals)
[[nodiscard]] Expression as_text(Expression value, int decimals);

}  // namespace stanok::lang
