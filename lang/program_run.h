// One run of a program: the machine that executes compiled code and plain lines.
//
// All of its state is explicit (stack, slots, frames, queue), so that it can stop after any
// instruction: at a bound of work, with a command, or at a Request whose answer is owed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/active_block.h"
#include "lang/builtin.h"
#include "lang/channel_words.h"
#include "lang/code.h"
#include "lang/command_queue.h"
#include "lang/interpreter.h"
#include "lang/modal_state.h"
#include "lang/program.h"
#include "lang/value.h"

namespace stanok::lang {

class ProgramRun {
 public:
  ProgramRun(const ChannelDescription& channel, const Tables& tables);

  void start(std::shared_ptr<const Program> program, const AxisValues& position_B);
  [[nodiscard]] Step next(Command& command);
  void answer(const Answer& answer);
  void set_block_skip(std::uint16_t levels) { block_skip_ = levels; }

  [[nodiscard]] const Diagnostic& error() const { return error_; }
  [[nodiscard]] Origin origin() const;
  [[nodiscard]] std::uint64_t blocks() const { return block_; }

 private:
  enum class Phase { idle, running, ended, failed };

  // What becomes of the answer to the Request delivered last.
  enum class AnswerUse { position_only, push_truth, push_number, statement, fail_run };

  // A function or subprogram that is being executed.
  struct Frame {
    std::uint16_t file = 0;
    std::uint32_t position = 0;              // next instruction
    std::size_t slots = 0;                   // first local slot
    std::size_t stack = 0;                   // height of the stack at entry
    const FunctionCode* function = nullptr;  // nullptr: text of a file
    bool counted_call = false;               // M98 or call: M99 returns here
    int repeats = 0;                         // M98 L: calls still to be made
    std::uint32_t entry = 0;
    std::optional<std::size_t> file_slots_before;  // `call`: where the file's variables were
  };

  // Plain lines being executed.
  struct PlainCursor {
    const char* at = nullptr;
    const char* end = nullptr;
    std::uint32_t line = 0;
    Surroundings surroundings = Surroundings::file_level;
  };

  // program_run.cc
  void reset(std::shared_ptr<const Program> program);
  Step deliver(Command& command);
  bool run_plain_line(Command& command);
  // Executes words_; `places` nullptr: found in the text when they are needed.
  void execute(const Span& block_span, const std::vector<IsoWord>* places);
  void follow_flow(const ActiveBlock& block);
  void end_program(ProgramEndKind kind);
  void read_tables_again();
  void take_statement_answer(const Answer& answer);
  void fail_with_answer(std::string_view code, const Answer& answer);

  // program_run_code.cc: one instruction
  void step();
  void execute_instruction(const Instruction& instruction);
  bool execute_memory(const Instruction& instruction);
  bool execute_jump(const Instruction& instruction);
  bool execute_array(const Instruction& instruction);
  void execute_effect(const Instruction& instruction);
  void call_function(const Callee& callee);
  void compute(const Instruction& instruction);
  void call_builtin(const Instruction& instruction);
  void push_system_value(const Instruction& instruction);
  [[nodiscard]] std::optional<double> modal_code_of_group(double index) const;
  void run_block(const Instruction& instruction);
  void send_message(const Instruction& instruction);
  void return_from_function(bool with_value);
  void access_parameter(const Instruction& instruction);

  // program_run_array.cc
  void make_array(const Instruction& instruction);
  void fill_array(std::size_t count);
  bool pop_element(std::size_t indices, std::shared_ptr<Object>& array, std::size_t& element);
  Value* referred(const Value& reference);

  // program_run_request.cc
  void ask(Request request, AnswerUse use);
  void ask_builtin(const Instruction& instruction);
  void ask_value(const Instruction& instruction);
  void ask_kinematics();
  void terminate();
  void call_file();
  void call_numbered();
  bool check_call_depth();
  std::optional<int> channel_of(double number, bool refuse_own);
  void leave_subprogram();

  // Failing
  void fail(std::string_view code, std::string message, std::string label = {});
  void fail_at(const Span& span, std::string_view code, std::string message,
               std::string label = {});
  void fail_block(BlockFault fault, const Span& block_span, const std::vector<IsoWord>& places);
  void fail_with(Diagnostic diagnostic);
  std::vector<std::string> call_stack() const;

  [[nodiscard]] const CompiledFile& file() const { return *program_->files[frames_.back().file]; }
  // Of the instruction at hand.
  [[nodiscard]] const Span& span() const;
  void push(Value value) { stack_.push_back(std::move(value)); }
  Value pop();
  double pop_number();
  std::optional<int> pop_integer(std::string_view what);

  const ChannelDescription& channel_;
  const Tables& tables_;
  ChannelWords channel_words_;

  std::shared_ptr<const Program> program_;
  Phase phase_ = Phase::idle;
  ModalState modal_;
  CommandQueue queue_;
  BlockSurroundings around_;
  BlockWords words_;  // of the block at hand
  PlainCursor plain_;
  std::uint64_t block_ = 0;  // ISO blocks executed
  std::uint16_t block_skip_ = 0;

  ArrayLedger array_ledger_ = std::make_shared<std::size_t>(0);
  std::vector<Value> stack_;
  std::vector<Value> slots_;
  std::vector<std::size_t> file_slots_;  // first slot of each file
  std::vector<Frame> frames_;
  std::vector<double> parameters_;        // #1 ... #5602
  std::vector<double> named_parameters_;  // NaN: not set
  std::vector<double> r_parameters_;      // R0 ... R999

  bool answer_owed_ = false;
  AnswerUse answer_use_ = AnswerUse::position_only;
  std::string_view statement_code_;  // of the statement that asked
  std::string statement_name_;
  std::string channel_error_;
  Diagnostic error_;
  Diagnostic error_after_answer_;
};

}  // namespace stanok::lang
