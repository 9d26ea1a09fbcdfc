// Turns ISO blocks into commands: plain lines, blocks with computed words, and what comes with
// them (radius compensation, the active codes, passing a faulty block).
//
// Owner: ProgramExecution, on the thread of the preparation. Owns the compensation stage between
// blocks and their delivery, and the rest of a block that waits for its position. What a block does
// to the flow of the program it only says: the calls are not its business. Invariant: the commands
// of one block are delivered before the next block is executed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lang/block/radius_compensation.h"
#include "lang/contract/changed_rows.h"
#include "lang/contract/meaning.h"
#include "lang/corners/corner_stage.h"
#include "lang/program/code.h"
#include "lang/run/block_state.h"
#include "lang/run/interpreter.h"
#include "lang/run/parameter_store.h"
#include "lang/run/vm.h"
#include "lang/tree/text_value.h"

namespace stanok::lang {

class BlockRunner {
 public:
  // What became of a plain line.
  enum class LineResult {
    nothing,  // it has no block, or the run has failed
    command,  // it made its command without the queue
    block     // its words are to be executed
  };

  // All must outlive this.
  BlockRunner(BlockState& state, Vm& vm, RunStage& run, ParameterStore& parameters);

  // A run begins with the default modal state, or with that in which the channel stands.
  void reset();
  void begin(const AxisValues& position_B);
  void begin_line(const AxisValues& position_B);
  void emit_first_commands();

  // The channel stands from here on in the modal state of now; in the default one.
  void stand_as_now() { standing_ = state_.modal; }
  void stand_in_default();
  // The same behind a program; LinuxCNC keeps G92 and G52: of its end, or, where it was broken off
  // with blocks read that were not executed, of before its start.
  enum class ProgramLeft { ended, broken_off };
  void stand_behind_program(ProgramLeft left);
  // The machine has this tool in place; a run begins with it.
  void take_tool(const ToolInPlace& tool);
  // An operator has changed these rows: what stands of them is as they are now.
  void take_changed_rows(const ChangedRows& rows);
  void follow_lengths();
  [[nodiscard]] Meaning standing() const;

  // Reads the next plain line.
  [[nodiscard]] LineResult take_line(Command& command);
  // Puts the computed values into a copy of the constants of a block; false when the run failed.
  [[nodiscard]] bool take_block(const Instruction& instruction);
  // Where the commands of the block just read come from, and at which call it stands.
  void begin_block();
  [[nodiscard]] BlockFlow execute();
  // Before the block calls the program of its M code; false when the run has failed.
  [[nodiscard]] bool take_words_before_call(CodeNumber m_code);
  // The block is to be executed again, from where it waited for an answer. Asked once.
  [[nodiscard]] bool take_rest() { return std::exchange(has_rest_, false); }
  void fail(BlockFault fault);

  // Commands pass through corners and radius compensation before they are delivered: those given
  // out are in compensated(), and compensate() leads the next one through; false: nothing was to
  // do.
  [[nodiscard]] bool compensating() const { return corners_.engaged() || compensation_.engaged(); }
  [[nodiscard]] CommandQueue& compensated() { return compensation_.ready(); }
  bool compensate();

  // A move with `,C` or `,R` waits for the next one.
  [[nodiscard]] bool holds_corner() const { return corners_.holds(); }

  // The channel has been given this: of a length the positions that it tells are those of its tip.
  void note_delivered(const Payload& command);
  // The channel tells that the axes stand at `position_B`, or at least the queue is empty.
  void adopt_position(const AxisValues& position_B);
  // The active work offset is the one that the program itself has written, where it has.
  void take_written_offset();
  void take_probe_answer(const Answer& answer);

  // What M2 and M30 reset, as commands before the end itself.
  void emit_end(ProgramEndKind kind);

  // Behind a faulty block; see Interpreter::pass_fault.
  [[nodiscard]] Passed pass_fault();

  // What gives the words their meaning is noted where it has changed.
  void note_meaning();
  [[nodiscard]] std::vector<MeaningChange> take_meanings() { return meanings_.take(); }

 private:
  // Where a block stands; `words` nullptr: they are found in the text when they are needed.
  struct BlockPlace {
    Span span;
    const std::vector<IsoWord>* words = nullptr;
    BlockProgress done;
  };
  bool take_settings(const std::vector<TextSetting>& settings);
  bool take_computed_word(const ComputedWord& word);
  void leave_out(const ComputedWord& word);
  void fail_text(std::string_view text, std::uint32_t line, const ValueFault& fault);
  void begin_in_standing_offsets(ModalState& modal) const;
  [[nodiscard]] bool select_stages(const ActiveBlock& block, const AxisValues& start_W);
  void fail_earlier(FaultOfCommand fault);
  [[nodiscard]] Passed adopt_words(ActiveBlock& block);

  [[nodiscard]] ModalState default_state(const TextRules& rules, const ToolInPlace& tool) const;

  BlockState& state_;
  ModalState standing_;     // while nothing runs; its position says nothing
  ToolLength delivered_;    // the one of the modal state may be on its way
  int written_offset_ = 0;  // by the program; 0: none
  Vm& vm_;
  RunStage& run_;
  ParameterStore& parameters_;
  CornerStage corners_;  // before radius compensation
  CompensationStage compensation_;
  MeaningChanges meanings_;
  TextValues text_values_;  // of the plain line
  BlockPlace place_;        // of the current block
  bool has_rest_ = false;   // of it, behind the answer to its first part
};

// Why a block cannot be executed, at the word of it that is meant.
[[nodiscard]] Diagnostic diagnostic_of(BlockFault fault, const Source& source,
                                       const Span& block_span, const std::vector<IsoWord>& places);

}  // namespace stanok::lang
