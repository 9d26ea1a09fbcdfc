// From the action that a row of the code table names to its function.
#pragma once

#include "lang/block/active_block.h"
#include "lang/words/code_action.h"

namespace stanok::lang {

using Action = void (*)(ActiveBlock&, CodeNumber);

// The action must be one that is supported.
[[nodiscard]] Action function_of(CodeAction action);

}  // namespace stanok::lang
