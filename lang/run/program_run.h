// One run of a program: the machine that executes compiled code and plain lines.
//
// All of its state is explicit (stack, slots, frames, queue), so that it can stop after any
// instruction: at a bound of work, with a command, or at a Request whose answer is owed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/actions/actions.h"
#include "lang/actions/gvector.h"
#include "lang/block/active_block.h"
#include "lang/block/command_queue.h"
#include "lang/block/modal_state.h"
#include "lang/block/predefined_parameter.h"
#include "lang/block/radius_compensation.h"
#include "lang/contract/active_codes.h"
#include "lang/program/code.h"
#include "lang/program/program.h"
#include "lang/run/block_search.h"
#include "lang/run/interpreter.h"
#include "lang/text/limits.h"
#include "lang/tree/builtin.h"
#include "lang/tree/value.h"
#include "lang/words/channel_dialect.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

// #1 to #30 belong to a call of an O-line or G65.
inline constexpr std::size_t local_parameter_count = 30;

class ProgramRun : private ContourSource, private Parameters {
 public:
  ProgramRun(const ChannelDescription& channel, Tables& tables);

  void start(std::shared_ptr<const Program> program, const AxisValues& position_B);
  void start_line(std::shared_ptr<const Program> program, const AxisValues& position_B);
  // Block search (program_run_search.cc).
  void stop_before(const StopPlace& place);
  [[nodiscard]] std::optional<Diagnostic> start_at(std::shared_ptr<const Program> program,
                                                   const AxisValues& position_B,
                                                   const StopPlace& place);
  void forget_lines() { line_state_lasts_ = false; }
  [[nodiscard]] Passed pass_fault();
  [[nodiscard]] Step next(Command& command);
  void answer(const Answer& answer);
  void set_block_skip(std::uint16_t levels) { block_skip_ = levels; }

  [[nodiscard]] const Diagnostic& error() const { return error_; }
  [[nodiscard]] Origin origin() const;
  [[nodiscard]] std::uint64_t blocks() const { return block_; }
  [[nodiscard]] std::vector<CodeChange> take_code_changes() { return code_changes_.take(); }
  [[nodiscard]] std::uint64_t steps() const {
    return instructions_ + std::uint64_t{limits::steps_of_block} * block_;
  }
  void renew_steps() { renewed_at_ = steps(); }

 private:
  enum class Phase { idle, running, ended, failed };

  // What becomes of the answer to the Request delivered last.
  enum class AnswerUse {
    position_only,
    push_truth,
    push_number,
    push_text,
    input_result,
    statement,
    restore_state,
    fail_run,
    probe,
    probe_or_alarm,
    restart,
    overhang
  };

  // RS274 parameters that belong to one call: #1 to #30 and #<name>.
  struct LocalParameters {
    std::array<double, local_parameter_count> numbered{};
    std::vector<double> named;  // by slot; global ones are not used
  };

  // What only some calls keep until they return.
  struct CallContext {
    std::optional<LocalParameters> of_caller;      // the called text has parameters of its own
    std::optional<BlockWords> arguments;           // of G65 and user codes
    const UserCode* user_code = nullptr;           // built in again while its macro runs
    std::optional<std::size_t> file_slots_before;  // where the file's variables were
  };

  // A function or subprogram that is being executed.
  struct Frame {
    std::uint16_t file = 0;
    std::uint32_t position = 0;              // next instruction
    std::size_t slots = 0;                   // first local slot
    std::size_t stack = 0;                   // height of the stack at entry
    const FunctionCode* function = nullptr;  // nullptr: text of a file
    int program_number = 0;                  // M98, G65; 0: a whole file
    bool subprogram = false;                 // M98, G65, call, O-line: M99 returns from here
    int repeats = 0;                         // L: calls still to be made
    std::uint32_t entry = 0;
    std::unique_ptr<CallContext> context;
  };

  // Where a numbered program stands.
  struct NumberedProgramPlace {
    std::uint16_t file = 0;
    std::uint32_t position = 0;
    bool other_file = false;  // found by its name: its variables are new for the call
    int number = 0;
    int repeats = 1;
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
  [[nodiscard]] bool reaches_stop();
  [[nodiscard]] bool is_called_from(const std::vector<std::uint32_t>& calls) const;
  void begin_modal_state(const AxisValues& position_B);
  void continue_modal_state(const AxisValues& position_B);
  void begin();
  Step advance(Command& command, int& work);
  void fail_endless();
  int run_code(int bound);
  [[nodiscard]] Step failed_or(Step other) const {
    return phase_ == Phase::failed ? Step::failed : other;
  }
  Step deliver(CommandQueue& queue, Command& command);
  bool compensate();
  void fail_compensation(CompensationFault fault);
  [[nodiscard]] Passed adopt_words(ActiveBlock& block);
  bool run_plain_line(Command& command);
  // Executes words_; `places` nullptr: found in the text when they are needed.
  void execute(const Span& block_span, const std::vector<IsoWord>* places, int actions_done = 0);
  void follow_flow(const ActiveBlock& block);
  void end_program(ProgramEndKind kind);
  void read_tables_again();
  void take_statement_answer(const Answer& answer);
  void take_probe_answer(const Answer& answer, bool alarm_when_missed);
  void fail_with_answer(std::string_view code, const Answer& answer);

  // program_run_code.cc: one instruction
  void step();
  int compute_ahead(int bound);  // program_run_compute.cc
  void execute_instruction(const Instruction& instruction);
  bool execute_memory(const Instruction& instruction);
  bool execute_jump(const Instruction& instruction);
  bool execute_array(const Instruction& instruction);
  void execute_effect(const Instruction& instruction);
  void compute(const Instruction& instruction);
  void call_builtin(const Instruction& instruction);
  void run_block(const Instruction& instruction);
  void send_message(const Instruction& instruction);

  // program_run_system_value.cc
  void push_system_value(const Instruction& instruction);
  [[nodiscard]] std::optional<double> spindle_speed(double id) const;
  [[nodiscard]] std::optional<double> modal_code_of_group(double index) const;

  // program_run_parameter.cc
  void load_parameter(const Instruction& instruction);
  void take_settings(const std::vector<SettingTarget>& targets);
  bool take_settings(const std::vector<TextSetting>& settings);
  // Stores the value of #number; false, with the reason, when it cannot be set.
  bool store_numbered_parameter(double number, double value, ValueFault& fault);
  std::optional<double> numbered(double number, ValueFault& fault) override;
  std::optional<double> named(const std::string& name, ValueFault& fault) override;
  std::optional<double> named_value(std::uint32_t slot, ValueFault& fault) const;
  std::optional<std::uint32_t> slot_to_set(const std::string& name) override;
  [[nodiscard]] ParameterView parameter_view() const;
  void keep_channel_parameters();
  void begin_parameters();
  LocalParameters exchange_local_parameters(LocalParameters parameters);
  [[nodiscard]] LocalParameters fresh_local_parameters() const;

  // program_run_contour.cc
  [[nodiscard]] Contour contour(int first, int last) override;
  // The piece of plain text that holds `line`, from there on, and the instruction behind it.
  struct PlainPlace {
    PlainCursor cursor;
    std::uint32_t position = 0;
  };
  [[nodiscard]] std::optional<PlainPlace> plain_place(std::uint32_t line) const;
  void go_behind_line(std::uint32_t line);
  void run_contour(std::uint32_t first, std::uint32_t last);
  void leave_contour();

  // program_run_array.cc
  void make_array(const Instruction& instruction);
  void fill_array(std::size_t count);
  bool enter_in_ledger(Object& array, std::size_t bytes);
  void put_element(Object& array, std::size_t element, Value value);
  void store_reference(const Value& reference, Value value);
  bool pop_element(std::size_t indices, std::shared_ptr<Object>& array, std::size_t& element);
  Value* referred(const Value& reference);

  // program_run_request.cc
  void ask(Request request, AnswerUse use);
  void ask_builtin(const Instruction& instruction);
  void ask_value(const Instruction& instruction);
  void ask_kinematics();
  [[nodiscard]] bool check_own_kinematics();
  void ask_overhang(const Instruction& instruction);
  [[nodiscard]] std::optional<ToolOverhang> overhang_of(const Instruction& instruction);
  void finish_overhang();
  void take_feed_law_directive(const Instruction& instruction);  // program_run_feed_law.cc
  void order_force_control(const Instruction& instruction);      // program_run_adaptive.cc
  void terminate();
  void announce_workpiece(const Instruction& instruction);
  bool check_workpiece(const std::vector<double>& arguments);
  void ask_table(const Instruction& instruction);
  bool name_offset(std::size_t first, Request& request);
  bool name_tool_value(std::size_t first, bool by_number, Request& request);
  void read_shared(const Instruction& instruction);
  void write_shared(const Instruction& instruction);
  void combine_shared(const Instruction& instruction);
  void send_shared(const Instruction& instruction, Request request);
  bool pop_shared_element(const Instruction& instruction, Request& request);
  void take_mark(const Instruction& instruction);
  std::optional<int> mark_of(double number);
  std::optional<int> channel_of(double number, bool refuse_own);

  // program_run_call.cc
  void call_function(const Callee& callee);
  void return_from_function(bool with_value);
  void call_o_subprogram(const Instruction& instruction);
  std::optional<Callee> find_o_subprogram(const OCallCode& call);
  void return_from_o_subprogram(bool with_value);
  void call_file();
  void call_numbered(CodeNumber code);
  std::optional<NumberedProgramPlace> find_numbered(int number, bool only_files);
  std::optional<NumberedProgramPlace> named_program(CodeNumber code);
  Frame numbered_frame(const NumberedProgramPlace& place);
  Frame subprogram_frame(std::uint16_t file) const;
  void renew_file_variables(Frame& frame);
  void leave_subprogram();
  void ask_restart();
  void begin_again();
  void pop_frame();
  bool check_call_depth();

  // program_run_macro.cc
  [[nodiscard]] std::optional<MacroCode> macro_at_hand() const;
  void call_macro(const MacroCode& macro);
  void call_user_code(const MacroCode& macro);
  bool enter_function(Frame& frame, const std::string& name);
  [[nodiscard]] LocalParameters parameters_of(const BlockWords& arguments) const;
  [[nodiscard]] const BlockWords* arguments_at_hand() const;
  void push_argument(bool asks_for_presence);

  // program_run_state.cc
  void save_gvector();
  void restore_gvector(bool statement);
  void finish_restoring(bool statement);
  void leave_state_level(std::size_t level);

  // Failing
  void fail(std::string_view code, std::string message, std::string label = {});
  void fail_text(std::string_view text, std::uint32_t line, const ValueFault& fault);
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
  Tables& tables_;
  ChannelWords channel_words_;

  std::shared_ptr<const Program> program_;
  Phase phase_ = Phase::idle;
  std::optional<StopPlace> stop_;
  bool stop_at_hand_ = false;      // what is executed stands in the line of stop_
  bool is_line_ = false;           // an operator's
  bool line_state_lasts_ = false;  // the modal state is that of the line before
  ModalState modal_;
  CodeChanges code_changes_;
  std::uint32_t faulty_line_ = 0;  // of the block whose fault ended the run; 0: another fault did
  CommandQueue queue_;
  CompensationStage compensation_;
  ProbeResult probe_;
  StateStack states_;
  BlockSurroundings around_;
  BlockWords words_;  // of the block at hand
  // The second part of the block at hand, after the answer to its first (ActiveBlock).
  struct RestOfBlock {
    Span span;
    const std::vector<IsoWord>* places = nullptr;
    int actions_done = 0;
  };
  std::optional<RestOfBlock> rest_;
  PlainCursor plain_;
  TextValues text_values_{*this};  // of the plain line at hand
  // G70: what comes behind the contour that is being run.
  struct ContourReturn {
    PlainCursor plain;
    AxisValues start_W{};
  };
  std::optional<ContourReturn> contour_return_;
  std::uint64_t block_ = 0;         // ISO blocks executed
  std::uint64_t instructions_ = 0;  // and lines without a block
  std::uint64_t renewed_at_ = 0;    // steps at that time
  std::uint64_t steps_max_ = 0;     // since then
  std::uint16_t block_skip_ = 0;

  ArrayLedger array_ledger_ = std::make_shared<std::size_t>(0);
  std::vector<Value> stack_;
  std::vector<Value> slots_;
  std::vector<std::size_t> file_slots_;  // first slot of each file
  std::vector<Frame> frames_;
  std::vector<double> parameters_;                    // #1 ... #5602
  std::vector<double> named_parameters_;              // by slot; NaN: not set
  std::map<std::string, double> channel_parameters_;  // #<_name>, from run to run
  std::vector<double> r_parameters_;                  // R0 ... R999
  double o_value_ = 0.0;                              // #<_value>
  bool o_value_returned_ = false;

  bool answer_owed_ = false;
  double answer_unit_ = 1.0;  // mm or deg per unit of the number that is asked for
  AnswerUse answer_use_ = AnswerUse::position_only;
  bool statement_ = false;           // restore_gvector as a statement
  SavedState pending_state_;         // to be restored with the answer
  ToolOverhang pending_overhang_;    // to be set with the answer
  std::string_view statement_code_;  // of the statement that asked
  std::string statement_name_;
  std::string channel_error_;
  Diagnostic error_;
  Diagnostic error_after_answer_;
};

}  // namespace stanok::lang
