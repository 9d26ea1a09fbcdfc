// The rows of the codes of a block: which exist and are available here, which exclude each other,
// which one takes the axis words.
#pragma once

#include <array>
#include <optional>

#include "lang/block/active_block.h"
#include "lang/contract/environment.h"
#include "lang/words/block_fault.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_dialect.h"
#include "lang/words/code_table.h"

namespace stanok::lang {

// How many axis words a block has.
enum class AxisWordCount : std::uint8_t { none, some };

// The rows of all codes of a block and what they claim together.
struct BlockCodes {
  static constexpr std::size_t capacity =
      2 * CodeList::capacity + 5;  // + F, law, S, T, modal motion
  std::array<const Code*, capacity> rows{};
  std::size_t count = 0;
  GroupSet groups = 0;
  LetterSet words = 0;
  const Code* axis_user = nullptr;       // the code that takes the axis words
  const Code* resting_motion = nullptr;  // only becomes the active code of its group

  [[nodiscard]] const Code** begin() { return rows.data(); }
  [[nodiscard]] const Code** end() { return rows.data() + count; }
  [[nodiscard]] const Code* const* begin() const { return rows.data(); }
  [[nodiscard]] const Code* const* end() const { return rows.data() + count; }
  void add(const Code* row) { rows[count++] = row; }
  [[nodiscard]] bool has(Group group) const { return (groups & group_bit(group)) != 0; }
};

// The words of a code beside the axis words, with those that only some channels and dialects have.
// `kind` nullptr: the channel is not known.
[[nodiscard]] LetterSet words_of_code(const Code& code, const ChannelKind* kind,
                                      const TextRules& rules);

// The rows of all codes of a block and the one that takes its axis words, or why they do not go
// together. `kind` nullptr: on any channel.
[[nodiscard]] std::optional<BlockFault> resolve_codes(const BlockWords& words,
                                                      const ChannelKind* kind,
                                                      const ChannelDialect& dialect,
                                                      BlockCodes& codes);

// The motion code of the block; nullptr: it has none.
[[nodiscard]] const Code* motion_of(const BlockCodes& codes);

// The rows of F, S and T, as far as no code of the block has them as its own (feed_speed_tool.cc).
void add_feed_speed_tool(const ActiveBlock& block, BlockCodes& codes);
// Whether a code of the block can be meant for the spindle that `$` names.
[[nodiscard]] bool names_spindle(const BlockCodes& codes);

}  // namespace stanok::lang
