#include "lang/corners/corner_value.h"

#include <string>

namespace stanok::lang {

std::optional<CornerValue> corner_value(const ActiveBlock& block, std::string_view name) {
  if (const NamedWord* const word = block.words.called(name))
    return CornerValue{word->value, {0, -1, std::string(name)}};
  const char letter = name[1];
  if ((block.plain_corners & letter_bit(letter)) == 0) return std::nullopt;
  return CornerValue{block.value(letter), {letter, -1, {}}};
}

}  // namespace stanok::lang
