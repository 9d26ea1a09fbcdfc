// Comments in ISO blocks: most say nothing, (MSG,...), (DEBUG,...) and (PRINT,...) become messages.
#pragma once

#include "lang/tree/token_cursor.h"

namespace stanok::lang {

// From its opening parenthesis. False, with a report: it is at fault.
bool parse_comment(TokenCursor& cursor, IsoBlock& block);

}  // namespace stanok::lang
