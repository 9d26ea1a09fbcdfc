#include "lang/run/program_execution.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/assert.h"
#include "lang/block/macro_arguments.h"
#include "lang/program/compile.h"
#include "lang/text/reporter.h"

namespace stanok::lang {
namespace {

// Instructions or lines without a command that one call of next() executes.
constexpr int work_bound = 20000;

// A block search passes a text once, whatever its length: a block has at least two bytes.
constexpr std::uint64_t free_steps_of_byte = limits::steps_of_block / 2;

}  // namespace

ProgramExecution::ProgramExecution(const ChannelDescription& channel, Tables& tables)
    : state_(channel, tables),
      run_(state_.queue),
      vm_(state_.channel_words, run_),
      parameters_(state_.around, vm_),
      blocks_(state_, vm_, run_, parameters_),
      texts_(vm_, state_, parameters_),
      calls_(vm_, state_, parameters_),
      values_(vm_, state_, parameters_),
      requests_(vm_, state_, pending_),
      macro_requests_(vm_, state_, parameters_, pending_, requests_),
      directives_(vm_, run_, state_, pending_, requests_) {}

// How a run begins: a program with the default modal state, a line with that in which the channel
// stands.
void ProgramExecution::start(std::shared_ptr<const Program> program, const AxisValues& position_B) {
  reset(std::move(program));
  line_runs_ = false;
  blocks_.begin(position_B);
  begin();
}

void ProgramExecution::start_line(std::shared_ptr<const Program> program,
                                  const AxisValues& position_B) {
  reset(std::move(program));
  line_runs_ = true;
  blocks_.begin_line(position_B);
  begin();
}

// Text of a file outside braces and subprograms; what stands before it is left out.
std::optional<Diagnostic> ProgramExecution::start_at(std::shared_ptr<const Program> program,
                                                     const AxisValues& position_B,
                                                     const StopPlace& place) {
  start(std::move(program), position_B);
  vm_.frame().file = place.file;
  if (texts_.enter(place.line)) return std::nullopt;
  const Source& source = vm_.file().source;
  Diagnostic diagnostic = diagnostic_at(source, "E6042", source.words_of_line(place.line),
                                        "a program cannot be entered here without calculation",
                                        "inside braces, a function or an O-line");
  run_.end();
  state_.queue.clear();
  return diagnostic;
}

void ProgramExecution::stop_before(const StopPlace& place) {
  stop_.set(place);
  parameters_.begin_search();
}

void ProgramExecution::reset(std::shared_ptr<const Program> program) {
  parameters_.end_search();
  calls_.end_modal();
  parameters_.begin(program);
  vm_.begin(std::move(program));
  blocks_.reset();
  texts_.forget_contour();
  stop_.reset();
  pending_.reset();
  run_.forget_error();
  count_ = {};
  count_.most = state_.channel.bounds.steps;
  for (const auto& one : vm_.program().files) {
    count_.most += free_steps_of_byte * one->source.text().size();
  }
}

void ProgramExecution::begin() {
  blocks_.emit_first_commands();
  run_.begin();
}

Step ProgramExecution::next(Command& command) {
  if (pending_.owed()) return Step::waiting;
  if (run_.running() && steps() - count_.renewed_at > count_.most) fail_endless();
  int work = 0;
  const Step step = advance(command, work);
  blocks_.note_meaning();
  count_.instructions += static_cast<std::uint64_t>(work);
  return step;
}

// At the statement that would come next: the run is somewhere in its loop.
void ProgramExecution::fail_endless() {
  vm_.fail_at(vm_.next_span(), "E8005",
              "an endless loop: " + std::to_string(state_.channel.bounds.steps / 1'000'000) +
                  " million steps without moving, waiting or asking",
              "it was here at that time");
}

Step ProgramExecution::advance(Command& command, int& work) {
  for (; work < work_bound; ++work) {
    if (blocks_.compensating()) {
      if (!blocks_.compensated().empty()) return deliver(blocks_.compensated(), command);
      if (blocks_.compensate()) continue;
    }
    if (!state_.queue.empty()) return deliver(state_.queue, command);
    if (!run_.running()) return failed_or(Step::ended);
    if (line_runs_) blocks_.stand_as_now();
    if (blocks_.take_rest()) {
      execute_block();
      continue;
    }
    if (stop_.active() && stops_here()) return failed_or(Step::stopped);
    if (vm_.plain().at_end()) {
      work += run_code(work_bound - work);
    } else if (run_line(command)) {
      return Step::command;
    }
  }
  return Step::working;
}

// The channel stands as a line had it before the statement that failed; behind a program as behind
// its end; a search has moved nothing.
void ProgramExecution::break_off() {
  if (!line_runs_ && !stop_.active())
    blocks_.stand_behind_program(BlockRunner::ProgramLeft::broken_off);
}

// A line of plain code. True: it is one command, which is all that there is of it.
bool ProgramExecution::run_line(Command& command) {
  const BlockRunner::LineResult result = blocks_.take_line(command);
  if (result == BlockRunner::LineResult::block) execute_block();
  return result == BlockRunner::LineResult::command;
}

// The run has failed when it cannot be entered where the search stops.
bool ProgramExecution::stops_here() {
  if (!stop_.is_reached(vm_, texts_)) return false;
  parameters_.end_search();
  if (state_.modal.compensation.on()) {
    vm_.fail("E6042", "a program cannot be entered while radius compensation is active",
             "search for the block before G41 or G42");
  } else if (blocks_.holds_corner()) {
    vm_.fail("E6042", "a program cannot be entered between the two moves of a corner",
             "search for the block with `,C` or `,R`");
  }
  return true;
}

// The next instruction with an effect and, except in a search, the computing ones before it;
// returns how many these were.
int ProgramExecution::run_code(int bound) {
  if (texts_.in_contour()) {
    texts_.leave_contour();
    return 0;
  }
  const int computed = stop_.active() ? 0 : vm_.compute_ahead(bound);
  if (const Instruction* const instruction = vm_.step()) execute_effect(*instruction);
  return computed;
}

void ProgramExecution::execute_effect(const Instruction& instruction) {
  if (instruction.op == Op::block) {
    if (blocks_.take_block(instruction)) execute_block();
    return;
  }
  if (instruction.op == Op::go_to) return texts_.go_to_number_on_stack();
  if (instruction.op == Op::end_of_text) return end_text();
  const bool done = macro_requests_.execute(instruction) || values_.execute(instruction) ||
                    calls_.execute(instruction) || requests_.execute(instruction) ||
                    directives_.execute(instruction);
  STANOK_ASSERT(done);
}

void ProgramExecution::execute_block() {
  blocks_.begin_block();
  if (state_.calls_modal && calls_.calls_for_blocks()) return calls_.call_modal();
  const auto macro = calls_.macro_of_block();
  if (!macro) {
    const BlockFlow flow = blocks_.execute();
    follow(flow);
    if (state_.calls_modal && flow.moves && run_.running() && calls_.calls_behind_moves())
      calls_.call_modal();
    return;
  }
  if (auto fault = check_macro_block(state_.words, *macro)) {
    return blocks_.fail(std::move(*fault));
  }
  const bool is_m_code = macro->letter == 'M' && macro->user_code != nullptr;
  if (is_m_code && !blocks_.take_words_before_call(static_cast<CodeNumber>(macro->number))) return;
  calls_.call_macro(*macro);
}

void ProgramExecution::follow(const BlockFlow& flow) {
  switch (flow.kind) {
    case Flow::next:
      break;
    case Flow::end_of_program:
      end_program(flow.end_kind);
      break;
    case Flow::call_numbered:
      calls_.call_numbered(flow.code);
      break;
    case Flow::return_from_subprogram:
      flow.block < 0 ? leave_subprogram() : leave_for_block(flow.block);
      break;
    case Flow::call_block:
      if (flow.repeats == 0) break;
      calls_.call_block(flow.repeats, flow.block);
      if (run_.running()) texts_.go_to_block(flow.block);
      break;
    case Flow::end_modal_call:
      calls_.end_modal();
      break;
    case Flow::go_to_block:
      texts_.go_to_block(flow.block);
      break;
    case Flow::behind_line:
      texts_.go_behind_line(flow.line);
      break;
    case Flow::run_contour:
      texts_.run_contour(flow.contour_line, flow.line);
      break;
  }
}

// The main program begins again; the channel is asked before.
void ProgramExecution::leave_subprogram() {
  const auto left = calls_.leave_subprogram();
  if (left == SubprogramCalls::Left::again) return texts_.go_to_block(vm_.frame().block);
  if (left == SubprogramCalls::Left::subprogram) return;
  if (line_runs_) return end_program(ProgramEndKind::restart);
  ProgramRequest request;
  request.kind = RequestKind::program_restart;
  requests_.ask(std::move(request), AnswerUse::restart);
}

// M99 P: to a block of the caller; in the main program to one of its own.
void ProgramExecution::leave_for_block(int block) {
  calls_.leave_subprogram(SubprogramCalls::Repeats::forgotten);
  if (run_.running()) texts_.go_to_block(block);
}

void ProgramExecution::end_text() {
  state_.begin_commands(vm_.instruction_origin());
  if (vm_.frames().size() > 1) return leave_subprogram();
  if (const ProgrammedCurve& curve = state_.modal.curve; curve.open()) {
    return vm_.fail("E4312", "the text ends inside a NURBS curve",
                    curve.has_knots() ? "knots are missing" : "no G5.3");
  }
  end_program(ProgramEndKind::end_of_text);
}

// What M2 and M30 reset is told to the channel before the end itself.
void ProgramExecution::end_program(ProgramEndKind kind) {
  run_.end();
  const bool ends_like_text =
      kind == ProgramEndKind::end_of_text || kind == ProgramEndKind::restart;
  if (line_runs_ && ends_like_text) {
    blocks_.stand_as_now();
    return state_.queue.emit(ProgramEnd{ProgramEndKind::end_of_line});
  }
  if (!ends_like_text) macro_requests_.count_part();
  blocks_.emit_end(kind);
  if (!stop_.active()) blocks_.stand_behind_program(BlockRunner::ProgramLeft::ended);
}

Step ProgramExecution::deliver(CommandQueue& queue, Command& command) {
  queue.take(command);
  blocks_.note_delivered(command.payload);
  if (const auto* const request = std::get_if<ProgramRequest>(&command.payload)) {
    pending_.deliver(*request, command.origin);
  }
  return Step::command;
}

void ProgramExecution::answer(const Answer& answer) {
  if (!pending_.accept()) return;
  if (answer.position_valid) blocks_.adopt_position(answer.position_B);
  if (state_.queue.empty()) blocks_.take_written_offset();
  PendingAnswer::Taken taken = pending_.take(answer);
  if (taken.pushed) vm_.stack().push(std::move(*taken.pushed));
  if (taken.refusal) {
    PendingAnswer::Refusal& refusal = *taken.refusal;
    Diagnostic diagnostic =
        vm_.diagnostic(refusal.code, std::move(refusal.message), std::move(refusal.label));
    diagnostic.notes = std::move(refusal.notes);
    fail_asker(std::move(diagnostic));
  }
  finish(taken.use, answer);
}

// A plain line is no instruction: what it has asked for fails in its own place, not in that of the
// instruction before.
void ProgramExecution::fail_asker(Diagnostic diagnostic) {
  const Origin& asker = pending_.origin();
  const Origin instruction = vm_.instruction_origin();
  const bool is_instruction = asker.file == instruction.file && asker.line == instruction.line;
  if (!is_instruction && asker.line != 0) put_at_block(vm_.program(), asker, diagnostic);
  vm_.fail_with(std::move(diagnostic));
}

// What is done with the answer to a request, where it has no value for the stack.
void ProgramExecution::finish(AnswerUse use, const Answer& answer) {
  switch (use) {
    case AnswerUse::input_result:
      return parameters_.set_input_result(answer.ok ? answer.number : -1.0);
    case AnswerUse::feedback:
      return take_feedback(answer);
    case AnswerUse::restore_state:
      return directives_.finish_restoring();
    case AnswerUse::overhang:
      return directives_.finish_overhang();
    case AnswerUse::probe:
    case AnswerUse::probe_or_alarm:
      return take_probe_answer(use, answer);
    case AnswerUse::work_position:
      return macro_requests_.finish_position();
    case AnswerUse::timer:
      return macro_requests_.finish_timer(answer);
    case AnswerUse::fail_run:
      return vm_.fail_with(pending_.end());
    case AnswerUse::restart:
      if (!answer.ok) return end_program(ProgramEndKind::restart);
      texts_.forget_contour();
      return calls_.begin_again();
    default:
      return;
  }
}

void ProgramExecution::take_feedback(const Answer& answer) {
  if (answer.ok) return;
  const PendingAnswer::Feedback& wanted = pending_.feedback();
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%g", wanted.timeout_s);
  fail_asker(vm_.diagnostic("E5030",
                            "input " + std::to_string(wanted.input) + " did not turn " +
                                (wanted.on ? "on" : "off") + " within " + seconds + " s",
                            "the feedback of this output"));
}

void ProgramExecution::take_probe_answer(AnswerUse use, const Answer& answer) {
  blocks_.take_probe_answer(answer);
  if (!answer.ok && use == AnswerUse::probe_or_alarm)
    fail_asker(vm_.diagnostic("E4320", "the probe did not change", "nothing found"));
}

}  // namespace stanok::lang
