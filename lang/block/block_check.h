// The rules of a block that can be checked without the modal state.
#pragma once

#include <optional>

#include "lang/block/block_codes.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

// Everything about a block that is known without the modal state: unknown codes, codes that exclude
// each other, words that nothing can use. `channel` nullptr: what depends on the channel is left
// out. Words whose value is computed later count as present.
[[nodiscard]] std::optional<BlockFault> check_block(const BlockWords& words,
                                                    const ChannelWords* channel,
                                                    const ChannelDialect& dialect);

// G4 with a time that looks like milliseconds: worth a warning when the program is loaded.
[[nodiscard]] bool dwells_suspiciously_long(const BlockWords& words);

// Parts of the rules that the execution of a block checks again, with the modal state.

// Words that every block may have: F, S and T.
inline constexpr LetterSet always_allowed = letters_of("FST");
// In the Fanuc dialect D is modal: G41 and G42 without D take the last one.
[[nodiscard]] constexpr LetterSet allowed_everywhere(const TextRules& rules) {
  return rules.is_fanuc() ? always_allowed | letters_of("D") : always_allowed;
}
// 0: the set is empty.
[[nodiscard]] char first_letter(LetterSet set);
// The word that holds the time of G4. X and U are axis words elsewhere, F and S feed and speed:
// they are G4's only when nothing else in the block can want them.
[[nodiscard]] char dwell_word(const BlockWords& words, const BlockCodes& codes);
// Nothing uses these words; `channel` nullptr: it is not known.
[[nodiscard]] BlockFault unused_word(LetterSet unused, const ChannelDescription* channel);
// A master channel has no axes and no spindle.
[[nodiscard]] std::optional<BlockFault> check_master(const BlockWords& words,
                                                     const ChannelDescription& channel);
// The letters that may say `,A`, `,C` or `,R` in a block with these codes, whatever is active.
[[nodiscard]] LetterSet plain_corners_of(const BlockWords& words, const BlockCodes& codes,
                                         const ChannelDescription& channel);
// The code that needs axis words has none.
[[nodiscard]] std::optional<BlockFault> missing_axes(const BlockCodes& codes, AxisWordCount count);

}  // namespace stanok::lang
