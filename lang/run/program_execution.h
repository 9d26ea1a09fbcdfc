// One run of a program: composes those who execute it, and hands each instruction, block and answer
// to the one that decides about it.
//
//   Vm                 stack, variables, frames, jumps
//   ValueInstructions  parameters and programmed state       ParameterStore  their values
//   SubprogramCalls    calls and returns                     call_targets    what they call
//   BlockRunner        ISO blocks into commands              BlockState      what blocks change
//   BlockDirectives    messages, #directives, saved state    TextPlaces      contours, lines
//   ChannelRequests    what is asked of the channel          PendingAnswer   what is waited for
//   MacroRequests      variables of the machine
//   RunStage           running, ended or failed, and why
//
// Owner: Interpreter, on the thread of the preparation. A run can stop after any instruction: at a
// bound of work, with a command, or at a ProgramRequest whose answer is owed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lang/contract/meaning.h"
#include "lang/program/program.h"
#include "lang/run/block_directives.h"
#include "lang/run/block_runner.h"
#include "lang/run/block_search.h"
#include "lang/run/block_state.h"
#include "lang/run/channel_requests.h"
#include "lang/run/interpreter.h"
#include "lang/run/macro_requests.h"
#include "lang/run/parameter_store.h"
#include "lang/run/pending_answer.h"
#include "lang/run/run_stage.h"
#include "lang/run/subprogram_calls.h"
#include "lang/run/text_places.h"
#include "lang/run/value_instructions.h"
#include "lang/run/vm.h"
#include "lang/text/limits.h"

namespace stanok::lang {

class ProgramExecution {
 public:
  ProgramExecution(const ChannelDescription& channel, Tables& tables);

  void start(std::shared_ptr<const Program> program, const AxisValues& position_B);
  void start_line(std::shared_ptr<const Program> program, const AxisValues& position_B);
  void stop_before(const StopPlace& place);
  [[nodiscard]] std::optional<Diagnostic> start_at(std::shared_ptr<const Program> program,
                                                   const AxisValues& position_B,
                                                   const StopPlace& place);
  void break_off();
  // What holds while nothing runs, and what changes around it.
  [[nodiscard]] BlockRunner& block_runner() { return blocks_; }
  [[nodiscard]] Passed pass_fault() { return blocks_.pass_fault(); }
  [[nodiscard]] Step next(Command& command);
  void answer(const Answer& answer);
  void set_block_skip(std::uint16_t levels) { vm_.set_block_skip(levels); }

  [[nodiscard]] const Diagnostic& error() const { return run_.error(); }
  [[nodiscard]] Origin origin() const { return vm_.origin(); }
  [[nodiscard]] std::uint64_t blocks() const { return state_.blocks; }
  [[nodiscard]] std::vector<MeaningChange> take_meanings() { return blocks_.take_meanings(); }
  [[nodiscard]] std::uint64_t steps() const {
    return count_.instructions + std::uint64_t{limits::steps_of_block} * state_.blocks;
  }
  void renew_steps() { count_.renewed_at = steps(); }

 private:
  // Steps of work, and how many a run may compute without moving, waiting or asking.
  struct StepCount {
    std::uint64_t instructions = 0;  // and lines without a block
    std::uint64_t renewed_at = 0;    // steps at that time
    std::uint64_t most = 0;          // since then
  };
  void reset(std::shared_ptr<const Program> program);
  void begin();
  Step advance(Command& command, int& work);
  void fail_endless();
  bool stops_here();
  [[nodiscard]] bool run_line(Command& command);
  int run_code(int bound);
  void execute_effect(const Instruction& instruction);
  void execute_block();
  void follow(const BlockFlow& flow);
  void leave_subprogram();
  void leave_for_block(int block);
  void end_text();
  void end_program(ProgramEndKind kind);
  Step deliver(CommandQueue& queue, Command& command);
  [[nodiscard]] Step failed_or(Step other) const { return run_.failed() ? Step::failed : other; }
  void finish(AnswerUse use, const Answer& answer);
  void fail_asker(Diagnostic diagnostic);
  void take_feedback(const Answer& answer);
  void take_probe_answer(AnswerUse use, const Answer& answer);

  BlockState state_;
  RunStage run_;
  Vm vm_;
  ParameterStore parameters_;
  PendingAnswer pending_;
  BlockRunner blocks_;
  TextPlaces texts_;
  SubprogramCalls calls_;
  ValueInstructions values_;
  ChannelRequests requests_;
  MacroRequests macro_requests_;
  BlockDirectives directives_;
  SearchStop stop_;
  StepCount count_;
  bool line_runs_ = false;  // of the operator: the modal state goes on
};

}  // namespace stanok::lang
