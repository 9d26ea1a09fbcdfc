// What blocks read and change: modal state, the commands they made, and the block being executed.
//
// Owner: ProgramExecution, on the thread of the preparation. Shared by all who execute blocks or
// emit commands; the surroundings refer to the other members, so that this is neither copied nor
// moved. Invariant: `blocks` is the number of the block whose commands are in the queue.
#pragma once

#include <cstdint>

#include "lang/block/active_block.h"
#include "lang/block/command_queue.h"
#include "lang/block/modal_state.h"
#include "lang/block/probe_result.h"
#include "lang/block/state_stack.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

struct BlockState {
  BlockState(const ChannelDescription& of_channel, Tables& of_machine)
      : channel(of_channel), tables(of_machine), channel_words(of_channel) {}
  BlockState(const BlockState&) = delete;
  BlockState& operator=(const BlockState&) = delete;

  // Commands emitted from here on come from `origin` and the block being executed.
  void begin_commands(const Origin& origin) { queue.set_origin(origin, blocks); }
  // For actions outside a block of the text: the words are those of the block before.
  [[nodiscard]] ActiveBlock block_at(std::uint32_t line) const { return {words, around, line}; }
  // mm per unit of programmed lengths
  [[nodiscard]] double length_unit() const { return modal.inches() ? mm_per_inch : 1.0; }

  const ChannelDescription& channel;
  Tables& tables;
  ChannelWords channel_words;
  ModalState modal;
  CommandQueue queue;
  ProbeResult probe;
  StateStack states;
  bool calls_modal = false;  // G66 or G66.1 is in force
  BlockWords words;          // of the current block
  std::uint64_t blocks = 0;  // ISO blocks executed in this run
  BlockSurroundings around{modal, channel_words, channel, tables, queue, probe, states, nullptr};
};

}  // namespace stanok::lang
