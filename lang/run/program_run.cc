#include "lang/run/program_run.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/block/macro_arguments.h"
#include "lang/text/reporter.h"
#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

// Instructions or lines without a command that one call of next() executes.
constexpr int work_bound = 20000;

constexpr std::size_t input_result_parameter = 5399;  // of M66

// The words of a block, with their spans, from its tree.
std::vector<IsoWord> places_of_words(const Source& source, const Span& block_span) {
  auto block = Parser::parse_block(source, block_span);
  return block ? std::move(block->words) : std::vector<IsoWord>{};
}

}  // namespace

Step ProgramRun::next(Command& command) {
  if (answer_owed_) return Step::waiting;
  if (phase_ == Phase::running && steps() - renewed_at_ > steps_max_) fail_endless();
  int work = 0;
  const Step step = advance(command, work);
  instructions_ += static_cast<std::uint64_t>(work);
  return step;
}

// At the statement that would come next: the run is somewhere in its loop.
void ProgramRun::fail_endless() {
  const std::vector<Span>& spans = file().spans;
  const std::size_t next = std::min<std::size_t>(frames_.back().position, spans.size() - 1);
  fail_at(plain_.at != plain_.end ? span_of_line(file().source, plain_.line) : spans[next], "E8005",
          "the program computed " + std::to_string(channel_.bounds.steps / 1'000'000) +
              " million steps without moving, waiting or asking",
          "it was here then");
}

Step ProgramRun::advance(Command& command, int& work) {
  for (; work < work_bound; ++work) {
    if (compensation_.engaged()) {
      if (!compensation_.ready().empty()) return deliver(compensation_.ready(), command);
      if (compensate()) continue;
    }
    if (!queue_.empty()) return deliver(queue_, command);
    if (phase_ != Phase::running) return failed_or(Step::ended);
    if (rest_) {
      const RestOfBlock rest = *std::exchange(rest_, std::nullopt);
      execute(rest.span, rest.places, rest.actions_done);
      continue;
    }
    if (stop_ && reaches_stop()) return failed_or(Step::stopped);
    if (plain_.at == plain_.end) {
      work += run_code(work_bound - work);
    } else if (run_plain_line(command)) {
      return Step::command;
    }
  }
  return Step::working;
}

// The next instruction with an effect and, except in a search, the computing ones before it;
// returns how many these were.
int ProgramRun::run_code(int bound) {
  if (contour_return_) {
    leave_contour();
    return 0;
  }
  const int computed = stop_ ? 0 : compute_ahead(bound);
  step();
  return computed;
}

Step ProgramRun::deliver(CommandQueue& queue, Command& command) {
  queue.take(command);
  const auto* request = std::get_if<Request>(&command.payload);
  answer_owed_ = request != nullptr;
  if (answer_owed_ && request->kind == RequestKind::input_wait)
    answer_use_ = AnswerUse::input_result;
  if (answer_owed_ && request->kind == RequestKind::probe_result)
    answer_use_ = request->statement ? AnswerUse::probe_or_alarm : AnswerUse::probe;
  return Step::command;
}

// Leads one command through radius compensation, at the end of a run what is held there. False when
// nothing was to do.
bool ProgramRun::compensate() {
  if (queue_.empty()) {
    if (phase_ == Phase::running) return false;
    compensation_.finish();
    return !compensation_.ready().empty();
  }
  Command command;
  queue_.take(command);
  if (auto fault = compensation_.take(command)) fail_compensation(std::move(*fault));
  return true;
}

// Executes the next plain line. True when it made `command` without the queue.
bool ProgramRun::run_plain_line(Command& command) {
  const char* const start = plain_.at;
  const std::uint32_t line = plain_.line;
  if (!read_plain_line(plain_.at, plain_.end, plain_.surroundings, words_, text_values_)) {
    STANOK_ASSERT(text_values_.faulty());
    fail_text(text_values_.fault_text(), line, text_values_.fault());
    return false;
  }
  ++plain_.line;
  if (!text_values_.settings().empty() && !take_settings(text_values_.settings())) return false;
  if (words_.empty()) return false;
  const Origin origin{frames_.back().file, line};
  ++block_;
  Move* move = std::get_if<Move>(&command.payload);
  if (move == nullptr) move = &command.payload.emplace<Move>();
  ActiveBlock block(words_, around_, line);
  if (!compensation_.engaged() && execute_simple_move(block, *move)) {
    command.origin = origin;
    command.block = block_;
    code_changes_.note(block_, modal_.codes);
    return true;
  }
  const auto offset = static_cast<std::size_t>(start - file().source.text().data());
  const auto length = static_cast<std::uint32_t>(file().source.line_at(offset).size());
  execute({offset, length, line}, nullptr);
  return false;
}

void ProgramRun::execute(const Span& block_span, const std::vector<IsoWord>* places,
                         int actions_done) {
  queue_.set_origin({frames_.back().file, block_span.line}, block_);
  ActiveBlock block(words_, around_, block_span.line);
  block.actions_done = actions_done;
  const AxisValues start_W = modal_.position_W;
  states_.set_level(frames_.size() - 1);
  if (const auto macro = macro_at_hand()) {
    block.fault = check_macro_block(words_, *macro);
    if (!block.fault) return call_macro(*macro);
  } else {
    execute_block(block);
    code_changes_.note(block_, modal_.codes);
  }
  if (block.awaits_position && !block.fault) {
    rest_ = {block_span, places, block.actions_done};
    return;
  }
  if (!block.fault) {
    if (auto fault = compensation_.select(modal_.compensation, start_W)) {
      return fail_compensation(std::move(*fault));
    }
    return follow_flow(block);
  }
  if (places != nullptr) {
    fail_block(std::move(*block.fault), block_span, *places);
  } else {
    fail_block(std::move(*block.fault), block_span, places_of_words(file().source, block_span));
  }
}

void ProgramRun::follow_flow(const ActiveBlock& block) {
  switch (block.flow) {
    case Flow::next:
      break;
    case Flow::end_of_program:
      end_program(block.end_kind);
      break;
    case Flow::call_numbered:
      call_numbered(block.flow_code);
      break;
    case Flow::return_from_subprogram:
      leave_subprogram();
      break;
    case Flow::behind_line:
      go_behind_line(block.flow_line);
      break;
    case Flow::run_contour:
      run_contour(block.contour_line, block.flow_line);
      break;
  }
}

// What M2 and M30 reset is told to the channel before the end itself.
void ProgramRun::end_program(ProgramEndKind kind) {
  phase_ = Phase::ended;
  const bool ends_like_text =
      kind == ProgramEndKind::end_of_text || kind == ProgramEndKind::restart;
  if (is_line_ && ends_like_text) return queue_.emit(ProgramEnd{ProgramEndKind::end_of_line});
  line_state_lasts_ = false;
  code_changes_.note(block_, default_codes(channel_.kind));
  if (modal_.feed_law.kind != FeedLaw::Kind::off) queue_.emit(FeedLawChange{});
  if (modal_.spindle_running) queue_.emit(SpindleCommand{.spindle = -1});
  if (modal_.mist || modal_.flood) queue_.emit(CoolantCommand{});
  const bool overrides_usual =
      modal_.feed_override && modal_.spindle_override && !modal_.adaptive_feed && modal_.feed_stop;
  if (!overrides_usual) queue_.emit(OverrideControl{});
  if (modal_.transformed_axis >= 0) queue_.emit(TransformationChange{});
  queue_.emit(ProgramEnd{kind});
}

// What an operator or a Request may have changed while the axes stood.
void ProgramRun::read_tables_again() {
  ActiveBlock block(words_, around_, span().line);
  read_tool_length_again(block);
  const WorkFrame before = modal_.frame();
  take_work_offset(modal_, tables_, modal_.work_offset_number);
  if (modal_.frame() == before) return;
  modal_.reexpress_position(before);
  queue_.emit(frame_of(modal_));
}

void ProgramRun::answer(const Answer& answer) {
  if (!std::exchange(answer_owed_, false)) return;
  if (answer.position_valid) {
    modal_.adopt_position(answer.position_B);
    compensation_.adopt_position();
  }
  if (queue_.empty()) read_tables_again();
  if (!answer.ok && answer.raises) return fail_with_answer("E5010", answer);
  switch (std::exchange(answer_use_, AnswerUse::position_only)) {
    case AnswerUse::position_only:
      if (!answer.ok) fail_with_answer("E5010", answer);
      break;
    case AnswerUse::push_truth:
      channel_error_ = answer.ok ? "" : answer.text;
      push(value_of(answer.ok));
      break;
    case AnswerUse::push_number:
      if (answer.ok) {
        push(value_of(answer.number / std::exchange(answer_unit_, 1.0)));
      } else {
        fail_with_answer("E6032", answer);
      }
      break;
    case AnswerUse::input_result:
      parameters_[input_result_parameter] = answer.ok ? answer.number : -1.0;
      break;
    case AnswerUse::push_text:
      push(value_of(answer.text));
      break;
    case AnswerUse::statement:
      take_statement_answer(answer);
      break;
    case AnswerUse::restore_state:
      finish_restoring(statement_);
      break;
    case AnswerUse::probe:
      take_probe_answer(answer, false);
      break;
    case AnswerUse::probe_or_alarm:
      take_probe_answer(answer, true);
      break;
    case AnswerUse::overhang:
      finish_overhang();
      break;
    case AnswerUse::restart:
      answer.ok ? begin_again() : end_program(ProgramEndKind::restart);
      break;
    case AnswerUse::fail_run:
      fail_with(std::move(error_after_answer_));
      break;
  }
}

// Where the probe changed, in programmed coordinates of now.
void ProgramRun::take_probe_answer(const Answer& answer, bool alarm_when_missed) {
  probe_.found = answer.ok;
  probe_.position = modal_.frame().work_from_base(answer.probe_B);
  for (std::size_t i = 0; i < channel_.axes.size(); ++i) {
    double& coordinate = probe_.position[i];
    coordinate = modal_.map.to_program(i, answer.ok ? coordinate : modal_.position_W[i]);
  }
  if (!answer.ok && alarm_when_missed) fail("E4320", "the probe did not change", "nothing found");
}

// A statement whose value nobody reads: a false result must not be lost.
void ProgramRun::take_statement_answer(const Answer& answer) {
  push(value_of(answer.ok));
  if (answer.ok) return;
  channel_error_ = answer.text;
  fail(statement_code_, "`" + std::string(statement_name_) + "` failed: " + answer.text,
       "returned false");
}

// The text of an answer may begin with the code of its reason, and have notes on further lines.
void ProgramRun::fail_with_answer(std::string_view code, const Answer& answer) {
  const std::string_view whole = answer.text;
  const std::string_view text = whole.substr(0, whole.find('\n'));
  const std::size_t blank = text.find(' ');
  const bool coded = text.size() > 2 && (text[0] == 'E' || text[0] == 'A') && is_digit(text[1]) &&
                     blank != std::string_view::npos;
  if (coded) {
    fail(text.substr(0, blank), std::string(text.substr(blank + 1)));
  } else {
    fail(code, text.empty() ? "the channel refused this" : std::string(text));
  }
  for (std::size_t end = text.size(); end < whole.size();) {
    const std::size_t begin = end + 1;
    end = std::min(whole.find('\n', begin), whole.size());
    error_.notes.push_back({std::string(whole.substr(begin, end - begin)), {}});
  }
}

Origin ProgramRun::origin() const {
  if (frames_.empty() || !program_) return {};
  const Frame& frame = frames_.back();
  if (plain_.at != plain_.end) return {frame.file, plain_.line};
  return {frame.file, span().line};
}

const Span& ProgramRun::span() const {
  const CompiledFile& current = file();
  const std::uint32_t next = frames_.back().position;
  const std::size_t index = next == 0 ? 0 : next - 1;
  return current.spans[std::min(index, current.spans.size() - 1)];
}

std::vector<std::string> ProgramRun::call_stack() const {
  std::vector<std::string> lines;
  for (std::size_t i = frames_.size(); i-- > 1;) {
    const Frame& frame = frames_[i];
    const Frame& caller = frames_[i - 1];
    const CompiledFile& calling = *program_->files[caller.file];
    const Place place = calling.source.place(calling.spans[caller.position - 1]);
    std::string name = program_->files[frame.file]->source.name();
    if (frame.program_number != 0) name = "O" + std::to_string(frame.program_number);
    if (frame.function != nullptr) {
      name = frame.function->signature.name + (frame.function->o_subprogram ? "" : "()");
    }
    lines.push_back("in " + name + ", called at " + place.file + ":" + std::to_string(place.line) +
                    ":" + std::to_string(place.column));
  }
  return lines;
}

void ProgramRun::fail(std::string_view code, std::string message, std::string label) {
  fail_at(span(), code, std::move(message), std::move(label));
}

void ProgramRun::fail_at(const Span& at, std::string_view code, std::string message,
                         std::string label) {
  fail_with(diagnostic_at(file().source, code, at, std::move(message), std::move(label)));
}

// A value that stands in the text of a plain line.
void ProgramRun::fail_text(std::string_view text, std::uint32_t line, const ValueFault& fault) {
  const auto offset = static_cast<std::size_t>(text.data() - file().source.text().data());
  fail_at({offset, static_cast<std::uint32_t>(text.size()), line}, fault.code, fault.message,
          fault.label);
}

void ProgramRun::fail_block(BlockFault fault, const Span& block_span,
                            const std::vector<IsoWord>& places) {
  Span at = block_span;
  for (const IsoWord& word : places) {
    const bool same = word.name.letter == fault.word.letter && word.name.name == fault.word.name &&
                      (word.name.letter != 0 || !word.name.name.empty());
    if (same && (fault.word.code < 0 || word.name.code == fault.word.code)) at = word.span;
  }
  Diagnostic diagnostic = diagnostic_at(file().source, fault.code, at, std::move(fault.message),
                                        std::move(fault.label));
  diagnostic.notes = std::move(fault.notes);
  diagnostic.help = std::move(fault.help);
  fail_with(std::move(diagnostic));
  faulty_line_ = block_span.line;
}

// The block at fault may be one before the block at hand.
void ProgramRun::fail_compensation(CompensationFault fault) {
  const Source& source = program_->files[fault.origin.file]->source;
  Diagnostic diagnostic =
      diagnostic_at(source, fault.fault.code, span_of_line(source, fault.origin.line),
                    std::move(fault.fault.message), std::move(fault.fault.label));
  diagnostic.notes.push_back(modal_.origin_of(Group::radius_compensation));
  diagnostic.help = std::move(fault.fault.help);
  fail_with(std::move(diagnostic));
}

// The commands of the faulty block are dropped: motion stops at the end of the block before.
void ProgramRun::fail_with(Diagnostic diagnostic) {
  if (diagnostic.stack.empty()) diagnostic.stack = call_stack();
  error_ = std::move(diagnostic);
  queue_.clear();
  faulty_line_ = 0;
  phase_ = Phase::failed;
}

}  // namespace stanok::lang
