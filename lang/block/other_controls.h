// Blocks that a control the code is known from understands as something else: refused with both
// meanings named, never executed with the wrong one.
//
// A text of the Fanuc dialect has a code system: what the systems contradict each other in is
// clear.
//
// Sources: operator's manuals of Fanuc lathes (code systems A, B, C) and machining centres, of
// Haas lathes and mills, and the G-code reference of LinuxCNC; docs/reference/language.md, "Where
// conventions differ", names what cannot be told apart. Codes whose own words have two meanings
// check them where they are executed.
#pragma once

#include <optional>

#include "lang/block/active_block.h"
#include "lang/block/block_codes.h"

namespace stanok::lang {

// `has_axis_words`: those that no code of the block takes count too. `modal` nullptr, when the
// program is loaded: what depends on the modal state is left out.
struct BlockMeaning {
  const BlockWords& words;
  const BlockCodes& codes;
  ChannelKind kind = ChannelKind::mill;
  bool has_axis_words = false;
  const ModalState* modal = nullptr;
};
[[nodiscard]] std::optional<BlockFault> other_meaning(const BlockMeaning& block);

// A word that Fanuc controls count in thousandths when it has no decimal point, or in ms: its
// value. In the other dialects it is what is written.
[[nodiscard]] double value_or_thousandths(const ActiveBlock& block, char letter);

// Fails the block when a word without decimal point is a length of `largest` or more: controls that
// count such words in thousandths mean another one.
void refuse_thousandths(ActiveBlock& block, char letter, double largest, std::string_view what);

// What the parameter of this number is on controls of Fanuc that is a variable of the program in
// the dialects stanok and linuxcnc. Empty: nothing, or the same here.
[[nodiscard]] std::string_view meaning_on_fanuc(int number);
[[nodiscard]] bool is_position_on_fanuc(int number);

}  // namespace stanok::lang
