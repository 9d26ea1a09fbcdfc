// What a code does, by name; the names stand in code_actions.def.
#pragma once

#include <cstdint>

namespace stanok::lang {

enum class CodeAction : std::uint8_t {
  unsupported,  // the code is known, but not part of this release
#define CODE_ACTION(name) name,
#include "lang/words/code_actions.def"
#undef CODE_ACTION
};

}  // namespace stanok::lang
