// Executes one ISO block: the rules of a block that need its modal state, then its actions in their
// fixed order.
#pragma once

#include <string>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/contract/command.h"

namespace stanok::lang {

// Executes the block: its commands are in block.queue, the modal state is the one after it. On
// failure block.faults.first is set and the modal state is of no use any more. A block that awaits
// the position of the axes is executed in two parts (block.awaits_position).
void execute_block(ActiveBlock& block);

// The most frequent block straight into its command, past the queue: G0 or G1 (or neither) with
// axis words and F. False, with the modal state as it was, when the block is not of this kind or
// has a fault; execute_block then does or explains it.
[[nodiscard]] bool execute_simple_move(ActiveBlock& block, Move& move);

// The blocks of a contour that a cycle refers to, as the commands that they give: executed for
// themselves, with corners cut, from `modal` on, without radius compensation; the
// program's own state stays as it is. On failure `problem` says why.
struct ContourCommands {
  std::vector<Command> commands;
  std::string problem;
};
[[nodiscard]] ContourCommands commands_of(ActiveBlock& block, const Contour& contour,
                                          ModalState modal);

}  // namespace stanok::lang
