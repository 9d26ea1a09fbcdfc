// Calls of functions, O-subprograms, numbered programs, macros and files, and the way back.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns nothing: the frames lie in the
// machine, the parameters of a call in their store. Invariant: what a call exchanged (parameters,
// variables of its file, the state saved by M73) is put back when it is left, in whatever way.
#pragma once

#include <optional>
#include <string>

#include "lang/block/macro_arguments.h"
#include "lang/run/block_state.h"
#include "lang/run/call_targets.h"
#include "lang/run/parameter_store.h"
#include "lang/run/vm.h"

namespace stanok::lang {

class SubprogramCalls {
 public:
  // All must outlive this.
  SubprogramCalls(Vm& vm, BlockState& state, ParameterStore& parameters);

  // Executes a call, a return, or arg (""); false for other instructions.
  bool execute(const Instruction& instruction);

  // The macro that the current block calls. While a macro of a user code runs, the same code is
  // the built-in one.
  [[nodiscard]] std::optional<MacroCode> macro_of_block() const;
  void call_macro(const MacroCode& macro);
  // G66: behind each block that moves, G66.1: in place of each block. False: none is in force, or
  // its macro runs.
  [[nodiscard]] bool calls_behind_moves() const;
  [[nodiscard]] bool calls_for_blocks() const;
  void call_modal();
  void end_modal();
  // M97: the block has been found; `run_at` goes there.
  void call_block(int repeats, int block);
  // M98 P L and M198 P L: #1 to #30 are those of the caller.
  void call_numbered(CodeNumber code);

  // `again`: at the block of M97, once more.
  enum class Left { subprogram, again, main_program };
  // Whether the calls of L that are still to be made are: M99 P leaves for another block.
  enum class Repeats : std::uint8_t { made, forgotten };
  // M99, M17 or the end of a called text: back to the caller, or once more. Nothing is left when it
  // is the main program.
  Left leave_subprogram(Repeats repeats = Repeats::made);
  // The main program from its first line, in the modal state of the last one.
  void begin_again();

 private:
  // What P and L of a block name.
  struct NumberedCall {
    NumberedProgramPlace place;
    int number = 0;
    int repeats = 1;
  };
  // G66 and G66.1.
  struct ModalCall {
    NumberedCall call;
    MacroCode macro;
    BlockWords words;  // of its block
    // G66: what its macro left in the local variables, which are set once (B-63944EN, 16.6.2).
    std::optional<LocalParameters> locals;
    bool runs = false;
  };
  void make_modal(const MacroCode& macro);
  [[nodiscard]] bool modal_call_runs() const;
  void call_function(const Callee& callee);
  void call_o_subprogram(const Instruction& instruction);
  std::optional<Callee> called_o_subprogram(const OCallCode& call);
  void call_file();
  void call_user_code(const MacroCode& macro);
  void return_from_function(const Instruction& instruction);
  void return_from_o_subprogram(std::optional<double> value);
  std::optional<NumberedCall> numbered_call(CodeNumber code);
  NumberedProgramSearch find_numbered(CodeNumber code, int number);
  [[nodiscard]] CallFrame subprogram_frame(std::uint16_t file) const;
  CallFrame numbered_frame(const NumberedCall& call);
  bool enter_function(CallFrame& frame, const std::string& name);
  void give_arguments(CallFrame& frame, const BlockWords& words, const MacroCode& macro);
  [[nodiscard]] LocalParameters parameters_of(const BlockWords& arguments,
                                              const TextRules& rules) const;
  [[nodiscard]] const TextRules& rules_of(std::uint16_t file) const;
  [[nodiscard]] const BlockWords* current_arguments() const;
  void push_argument(const Instruction& instruction);
  void pop_frame();
  void leave_state_level(std::size_t level);

  Vm& vm_;
  BlockState& state_;
  ParameterStore& parameters_;
  std::optional<ModalCall> modal_;
};

}  // namespace stanok::lang
