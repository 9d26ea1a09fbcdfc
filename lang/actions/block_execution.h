// Checks and executes one ISO block: the rules of a block, then its actions in their fixed order.
#pragma once

#include <array>
#include <optional>

#include "lang/block/active_block.h"
#include "lang/words/code_table.h"

namespace stanok::lang {

// The rows of all codes of a block and what they claim together.
struct BlockCodes {
  static constexpr int capacity = 2 * CodeList::capacity + 5;  // + F, law, S, T, modal motion
  std::array<const Code*, capacity> rows{};
  int count = 0;
  GroupSet groups = 0;
  LetterSet words = 0;
  const Code* axis_user = nullptr;  // the code that takes the axis words

  [[nodiscard]] bool has(Group group) const { return (groups & group_bit(group)) != 0; }
};

// The rows of all codes of a block and the one that takes its axis words, or why they do not go
// together (block_codes.cc). `kind` nullptr: on any channel.
[[nodiscard]] std::optional<BlockFault> resolve_codes(const BlockWords& words,
                                                      const ChannelKind* kind,
                                                      const ChannelDialect& dialect,
                                                      BlockCodes& codes);

// Takes the axis words out of the block (axis_words.cc): those of the axes' own names, then U, V
// and W of a lathe channel, as far as no code of the block uses them otherwise.
void collect_axis_words(ActiveBlock& block);
void collect_incremental_words(ActiveBlock& block, const BlockCodes& codes);
// The rows of F, S and T, as far as no code of the block has them as its own (feed_speed_tool.cc).
void add_feed_speed_tool(const ActiveBlock& block, BlockCodes& codes);
// Whether a code of the block can be meant for the spindle that `$` names.
[[nodiscard]] bool names_spindle(const BlockCodes& codes);

// Everything about a block that is known without the modal state: unknown codes, codes that exclude
// each other, words that nothing can use. `channel` nullptr: what depends on the channel is left
// out. Words whose value is computed later count as present.
[[nodiscard]] std::optional<BlockFault> check_block(const BlockWords& words,
                                                    const ChannelWords* channel,
                                                    const ChannelDialect& dialect);

// G4 with a time that looks like milliseconds: worth a warning when the program is loaded.
[[nodiscard]] bool dwells_suspiciously_long(const BlockWords& words);

// Executes the block: its commands are in block.queue, the modal state is the one after it. On
// failure block.fault is set and the modal state is of no use any more. A block that awaits the
// position of the axes is executed in two parts (block.awaits_position).
void execute_block(ActiveBlock& block);

// The most frequent block straight into its command, past the queue: G0 or G1 (or neither) with
// axis words and F. False, with the modal state as it was, when the block is not of this kind or
// has a fault; execute_block then does or explains it.
[[nodiscard]] bool execute_simple_move(ActiveBlock& block, Move& move);

}  // namespace stanok::lang
