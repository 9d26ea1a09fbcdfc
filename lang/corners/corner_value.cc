#include "lang/corners/corner_value.h"

#include <string>

#include "lang/block/block_check.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {

void find_plain_corners(ActiveBlock& block, const BlockCodes& codes) {
  if (!may_have_plain_corners(block.words, codes, block.channel)) return;
  const bool is_line = motion_of(codes) != nullptr || block.modal.code(Group::motion) == g(1);
  if (!is_line) return;
  block.end.plain_corners =
      block.words.letters & plain_corner_letters & ~block.channel_words.letters() & ~codes.words;
}

std::optional<CornerValue> corner_value(const ActiveBlock& block, std::string_view name) {
  if (const NamedWord* const word = block.words.called(name))
    return CornerValue{word->value, {0, -1, std::string(name)}};
  const char letter = name[1];
  if ((block.end.plain_corners & letter_bit(letter)) == 0) return std::nullopt;
  return CornerValue{block.value(letter), {letter, -1, {}}};
}

}  // namespace stanok::lang
