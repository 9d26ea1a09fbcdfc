#include "lang/actions/action_table.h"

#include "base/assert.h"
#include "lang/actions/actions.h"

namespace stanok::lang {

Action function_of(CodeAction action) {
  switch (action) {
    case CodeAction::unsupported:
      break;
#define CODE_ACTION(name) \
  case CodeAction::name:  \
    return name;
#include "lang/words/code_actions.def"
#undef CODE_ACTION
  }
  STANOK_ASSERT(false && "a row whose code is not supported is refused before");
  return nullptr;
}

}  // namespace stanok::lang
