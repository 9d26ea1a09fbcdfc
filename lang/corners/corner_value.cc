#include "lang/corners/corner_value.h"

#include <cmath>
#include <string>

#include "lang/block/block_check.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {

namespace {

// That says the same without a comma; 0: none does.
char letter_without_comma(std::string_view name, const TextRules& rules) {
  if (!rules.is_linuxcnc()) return name[1];
  return name == rounding_word ? 'A' : '\0';
}

}  // namespace

void find_plain_corners(ActiveBlock& block, const BlockCodes& codes) {
  const LetterSet possible = plain_corners_of(block.words, codes, block.channel);
  if (possible == 0) return;
  const Code* const motion = motion_of(codes);
  if (codes.axis_user != nullptr && codes.axis_user != motion) return;
  const bool is_line = motion != nullptr || block.modal.code(Group::motion) == g(1);
  if (!is_line) return;
  block.end.plain_corners = block.words.letters & possible & plain_corner_letters &
                            ~block.channel_words.letters() & ~codes.words;
  if (block.modal.code(Group::length) != g(43, 5))
    block.end.plain_corners |= block.words.letters & possible & square_chamfer_letters;
}

std::optional<CornerValue> corner_value(const ActiveBlock& block, std::string_view name) {
  if (const NamedWord* const word = block.words.called(name))
    return CornerValue{word->value, {0, -1, std::string(name)}};
  const auto plain = [&](char letter) {
    return (block.end.plain_corners & letter_bit(letter)) != 0;
  };
  const char letter = letter_without_comma(name, block.words.rules);
  if (letter != 0 && plain(letter)) {
    // The sign of R, I and K says where the next move goes (B-64304EN-1, 4.4): it is not needed.
    const double value = block.value(letter);
    return CornerValue{letter == 'R' ? std::abs(value) : value, {letter, -1, {}}};
  }
  if (name != chamfer_word) return std::nullopt;
  for (const char square : {'I', 'K'}) {
    if (plain(square)) return CornerValue{std::abs(block.value(square)), {square, -1, {}}};
  }
  return std::nullopt;
}

}  // namespace stanok::lang
