// The machine that executes compiled code: stack, variables, frames of calls, jumps.
//
// It executes what computes and jumps by itself; what asks, calls or acts it hands back, to be
// executed by those who own the effect. All of its state is explicit, so that a run can stop after
// any instruction. Owner: ProgramExecution, on the thread of the preparation. Owns the program
// counter (frame, position, plain lines), the stack and all variables. Invariants: the last frame
// is the one executed; a frame's slots and values lie above those of its caller.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "lang/program/program.h"
#include "lang/run/array_instructions.h"
#include "lang/run/parameter_store.h"
#include "lang/run/run_stage.h"
#include "lang/run/value_stack.h"
#include "lang/tree/value.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

// Plain lines being executed.
struct PlainCursor {
  const char* at = nullptr;
  const char* end = nullptr;
  std::uint32_t line = 0;
  LineRules rules;

  [[nodiscard]] bool at_end() const { return at == end; }
};

// What only some calls keep until they return.
struct CallContext {
  std::optional<LocalParameters> of_caller;  // the called text has parameters of its own
  std::optional<BlockWords> arguments;       // of G65 and user codes
  // Of G66 or G66.1; the lines of the caller that come next.
  bool modal_call = false;
  PlainCursor plain_of_caller;
  const UserCode* user_code = nullptr;           // built in again while its macro runs
  std::optional<std::size_t> file_slots_before;  // where the file's variables were
};

// A function or subprogram that is being executed.
struct CallFrame {
  std::uint16_t file = 0;
  std::uint32_t position = 0;              // next instruction
  std::size_t slots = 0;                   // first local slot
  std::size_t stack = 0;                   // height of the stack at entry
  const FunctionCode* function = nullptr;  // nullptr: text of a file
  int program_number = 0;                  // M98, G65; 0: a whole file
  bool subprogram = false;                 // M98, G65, call, O-line: M99 returns from here
  int repeats = 0;                         // L: calls still to be made
  int block = -1;                          // M97: N with which it begins
  std::uint32_t entry = 0;
  std::unique_ptr<CallContext> context;
};

// How lines of a file are read.
[[nodiscard]] LineRules rules_of(const CompiledFile& file, const PlainLines& lines);

class Vm final : public RunPlace {
 public:
  // Both must outlive this.
  Vm(const ChannelWords& words, RunStage& run) : words_(words), run_(run) {}

  // A run of `program` begins with its first instruction.
  void begin(std::shared_ptr<const Program> program);
  // Once more, with the variables as they are.
  void begin_again();
  // Bit n: blocks that begin with /n are skipped.
  void set_block_skip(std::uint16_t levels) { block_skip_ = levels; }

  // Up to `bound` instructions that only compute; returns how many. Stops before the first that is
  // not of this kind.
  int compute_ahead(int bound);
  // The next instruction. One that the machine does not execute itself is returned, to be executed
  // now; else nullptr.
  const Instruction* step();

  [[nodiscard]] const Program& program() const { return *program_; }
  [[nodiscard]] const CompiledFile& file() const { return *program_->files[frames_.back().file]; }
  [[nodiscard]] CallFrame& frame() { return frames_.back(); }
  [[nodiscard]] const std::vector<CallFrame>& frames() const { return frames_; }
  [[nodiscard]] PlainCursor& plain() { return plain_; }
  [[nodiscard]] ValueStack& stack() { return stack_; }
  // Of the instruction executed last, and of the one or the plain line that comes next.
  [[nodiscard]] const Span& span() const;
  [[nodiscard]] Span next_span() const;
  [[nodiscard]] Origin instruction_origin() const { return {frames_.back().file, span().line}; }
  [[nodiscard]] Origin origin() const;
  [[nodiscard]] WhereItRuns where() const override;

  // Calls. Nothing can be entered where check_call_depth() is false; it has failed the run.
  [[nodiscard]] bool check_call_depth();
  [[nodiscard]] CallFrame frame_at_top(std::uint16_t file) const;
  // Slots above all others: those of a function, and new ones for the variables of its file.
  void add_slots(const FunctionCode& function);
  void renew_file_variables(CallFrame& frame);
  // Moves the arguments of `frame`'s function from the stack to its slots.
  void take_arguments(const CallFrame& frame);
  void enter(CallFrame frame) { frames_.push_back(std::move(frame)); }
  // Leaves the innermost frame; what it had for itself is gone.
  void leave();

  // A number from the stack that must be whole; fails the run otherwise.
  std::optional<int> pop_integer(std::string_view what);

  // The run fails at the instruction executed last, or at `at` in the file being executed.
  void fail(std::string_view code, std::string message, std::string label = {});
  void fail(const ValueFault& fault) { fail(fault.code, fault.message, fault.label); }
  void fail_at(const Span& at, std::string_view code, std::string message, std::string label = {});
  // With the calls that led here, unless it has them.
  void fail_with(Diagnostic diagnostic);
  // What fail() reports.
  [[nodiscard]] Diagnostic diagnostic(std::string_view code, std::string message,
                                      std::string label) const;

 private:
  bool execute(const Instruction& instruction);
  bool execute_constant(const Instruction& instruction);
  bool execute_variable(const Instruction& instruction);
  bool execute_jump(const Instruction& instruction);
  bool execute_texts(const Instruction& instruction);
  void compute(const Instruction& instruction);
  void call_builtin(const Instruction& instruction);
  void push_axis(const Instruction& instruction);
  void store_reference(const Value& reference, Value value);
  [[nodiscard]] const Value& referred(const Value& reference) const;

  const ChannelWords& words_;
  RunStage& run_;
  std::shared_ptr<const Program> program_;
  std::uint16_t block_skip_ = 0;
  ValueStack stack_;
  ArrayInstructions arrays_{stack_};
  std::vector<Value> slots_;
  std::vector<std::size_t> file_slots_;  // first slot of each file
  std::vector<CallFrame> frames_;
  PlainCursor plain_;
};

}  // namespace stanok::lang
