// F, S, T and the feed law of a block as rows of the code table, so that they take part in the
// order of effects, and the codes that have an F or S of their own.
#include <algorithm>

#include "lang/block/block_codes.h"
#include "lang/block/feed_law_rules.h"
#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

constexpr Code word_row(char letter, EffectOrder order, Availability availability,
                        CodeAction action, std::string_view title) {
  return {letter, 0, Group::none, 0, order, AxisWords::unused, 0, availability, action, title};
}

constexpr Code feed_word =
    word_row('F', EffectOrder::feed, Availability::everywhere, CodeAction::take_feed, "feed");
constexpr Code speed_word = word_row('S', EffectOrder::speed, Availability::not_master,
                                     CodeAction::take_speed, "spindle speed");
// Behind the spindle of its block, which a law may need, and before the motion.
constexpr Code law_words = word_row(0, EffectOrder::motion_modifier, Availability::not_master,
                                    CodeAction::take_feed_law, "feed law");
constexpr Code tool_word =
    word_row('T', EffectOrder::tool, Availability::not_master, CodeAction::take_tool, "tool");

// G76 has F of its own on lathe channels only.
bool takes_word(const Code& code, char letter, ChannelKind kind) {
  const bool own = code.letter == 'G' && (code.words & letter_bit(letter)) != 0;
  return own && (kind == ChannelKind::lathe || code.number != g(76));
}

bool is_taken(const ActiveBlock& block, const BlockCodes& codes, char letter) {
  if (block.dwell_word == letter) return true;
  return std::any_of(codes.begin(), codes.end(), [&](const Code* code) {
    return takes_word(*code, letter, block.channel.kind);
  });
}

}  // namespace

void add_feed_speed_tool(const ActiveBlock& block, BlockCodes& codes) {
  const bool indexed =
      std::any_of(block.words.named.begin(), block.words.named.end(),
                  [](const NamedWord& word) { return spindle_of_indexed_speed(word).has_value(); });
  for (const Code* const row : {&feed_word, &speed_word, &tool_word}) {
    const bool present = block.has(row->letter) || (row == &speed_word && indexed);
    if (present && !is_taken(block, codes, row->letter)) {
      codes.add(row);
    }
  }
  if (has_feed_law(block.words)) codes.add(&law_words);
}

bool names_spindle(const BlockCodes& codes) {
  constexpr std::array<CodeNumber, 7> threads{g(32), g(33), g(33, 1), g(74), g(76), g(78), g(84)};
  if (codes.has(Group::spindle) || codes.has(Group::spindle_mode)) return true;
  return std::any_of(codes.begin(), codes.end(), [&](const Code* code) {
    return code->letter == 'G' &&
           std::find(threads.begin(), threads.end(), code->number) != threads.end();
  });
}

}  // namespace stanok::lang
