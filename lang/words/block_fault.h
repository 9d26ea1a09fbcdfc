// Why a block cannot be executed, and which of its words is meant.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "lang/contract/code_number.h"

namespace stanok::lang {

// Which word of a block is meant: a code, a letter, or (letter 0) the block as a whole.
struct WordName {
  char letter = 0;
  int code = -1;     // G and M: number in tenths
  std::string name;  // named or indexed word
};

// The name of a G code as a word of the block; number in tenths.
[[nodiscard]] inline WordName code_word(CodeNumber code) {
  return {'G', code, {}};
}

// Why a block cannot be executed; its reader adds the place.
struct BlockFault {
  std::string_view code;
  WordName word;
  std::string message;
  std::string label;
  std::vector<Note> notes;
  std::vector<std::string> help;
};

[[nodiscard]] inline BlockFault fault_at(std::string_view code, WordName word, std::string message,
                                         std::string label) {
  return {code, std::move(word), std::move(message), std::move(label), {}, {}};
}

}  // namespace stanok::lang
