#include "lang/run/block_runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/text/number.h"
#include "lang/text/reporter.h"
#include "lang/tree/parser.h"
#include "lang/tree/plain_block.h"
#include "lang/words/code_system.h"

namespace stanok::lang {
namespace {

// LinuxCNC begins with radii and feed per minute, on lathes too.
void begin_as_linuxcnc(ModalState& modal) {
  modal.codes[Group::diameter] = g(8);
  modal.codes[Group::feed_mode] = g(94);
}

// G92 and G52, which LinuxCNC keeps behind M2 and M30, and from a line by hand into a program.
void keep_shifts(ModalState& modal, const FrameSettings& of) {
  modal.frames.local_shift = of.local_shift;
  modal.frames.axis_shift = of.axis_shift;
  modal.frames.axis_shift_active = of.axis_shift_active;
}

// The words of a block, with their spans, from its tree.
std::vector<IsoWord> places_of_words(const Source& source, const Span& block_span) {
  auto block = Parser::parse_block(source, block_span);
  return block ? std::move(block->words) : std::vector<IsoWord>{};
}

// A word that is missing is there in the text where its variable is vacant.
void note_left_out(BlockFault& fault, LetterSet left_out) {
  constexpr auto codes_of_missing_words =
      std::to_array<std::string_view>({"E4007", "E4020", "E4021", "E4023"});
  if (std::ranges::find(codes_of_missing_words, fault.code) == codes_of_missing_words.end()) return;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((left_out & letter_bit(letter)) == 0) continue;
    fault.notes.push_back({std::string("the word ") + letter +
                               " is left out because its variable is vacant, as the variable of an "
                               "argument is when the call of the macro does not have it",
                           {}});
  }
}

}  // namespace

BlockRunner::BlockRunner(BlockState& state, Vm& vm, RunStage& run, ParameterStore& parameters)
    : state_(state),
      vm_(vm),
      run_(run),
      parameters_(parameters),
      corners_(state.channel_words),
      compensation_(state.channel_words),
      text_values_(parameters) {
  stand_in_default();
}

void BlockRunner::reset() {
  state_.queue.clear();
  delivered_ = {};
  written_offset_ = 0;
  corners_.reset();
  compensation_.reset();
  state_.states.clear();
  state_.blocks = 0;
  has_rest_ = false;
}

void BlockRunner::begin(const AxisValues& position_B) {
  ModalState& modal = state_.modal;
  const TextRules& rules = vm_.file().source.rules();
  modal = default_state(rules, {standing_.tool.active, standing_.tool.edge});
  if (rules.is_linuxcnc()) begin_in_standing_offsets(modal);
  modal.position_W = modal.frame().work_from_base(position_B);
}

// LinuxCNC drops no offset where a program begins: G55 and G92 by hand hold in it.
void BlockRunner::begin_in_standing_offsets(ModalState& modal) const {
  const FrameSettings& frames = standing_.frames;
  keep_shifts(modal, frames);
  if (frames.is_carried) return;
  modal.codes[Group::work_offset] = standing_.codes[Group::work_offset];
  take_work_offset(modal, state_.tables, frames.work_offset_number);
}

void BlockRunner::begin_line(const AxisValues& position_B) {
  state_.modal = standing_;
  state_.modal.adopt_position(position_B);
}

ModalState BlockRunner::default_state(const TextRules& rules, const ToolInPlace& tool) const {
  ModalState modal = default_modal_state(state_.channel.kind);
  if (rules.is_linuxcnc()) begin_as_linuxcnc(modal);
  modal.tool.active = tool.number;
  modal.tool.edge = tool.edge;
  modal.geometry = state_.channel_words.geometry();
  take_work_offset(modal, state_.tables, modal.frames.work_offset_number);
  return modal;
}

void BlockRunner::stand_in_default() {
  standing_ =
      default_state(state_.channel.rules, {state_.modal.tool.active, state_.modal.tool.edge});
}

void BlockRunner::stand_behind_program(ProgramLeft left) {
  const FrameSettings shifts = left == ProgramLeft::ended ? state_.modal.frames : standing_.frames;
  const bool keeps = vm_.program().files[0]->source.rules().is_linuxcnc();
  stand_in_default();
  if (keeps) keep_shifts(standing_, shifts);
}

void BlockRunner::take_tool(const ToolInPlace& tool) {
  standing_.tool.active = tool.number;
  standing_.tool.edge = tool.edge;
}

// A length counts at once where an operator writes it while the channel stands; a program that
// writes one takes it with its next G43.
void BlockRunner::take_changed_rows(const ChangedRows& rows) {
  ToolLength& length = standing_.tool.length;
  if (rows.has_tool(length.tool, length.edge)) take_row(length, state_.tables);
  FrameSettings& frames = standing_.frames;
  if (rows.has_offset(frames.work_offset_number))
    take_work_offset(standing_, state_.tables, frames.work_offset_number);
}

// The programmed point stays, but for one that machine coordinates gave: there the axes do.
void BlockRunner::follow_lengths() {
  delivered_ = state_.tables.in_force(delivered_);
  ModalState& modal = state_.modal;
  const ToolLength now = state_.tables.in_force(modal.tool.length);
  if (now == modal.tool.length) return;
  if (state_.queue.ends_in_machine()) {
    AxisValues distance_B{};
    for (std::size_t k = 0; k < state_.channel.axes.size(); ++k)
      distance_B[k] = length_along(state_.around, k, modal.tool.length.offset_mm) -
                      length_along(state_.around, k, now.offset_mm);
    modal.shift_position(distance_B);
  }
  modal.tool.length = now;
  meanings_.note(state_.blocks, modal.codes, terms_of(modal));
}

Meaning BlockRunner::standing() const {
  return {standing_.codes, std::make_shared<const MeaningTerms>(terms_of(standing_))};
}

// Frames, tools and lengths are commands; scaling and mirror are known to the interpreter alone.
void BlockRunner::note_meaning() {
  const ModalState& modal = state_.modal;
  const MeaningTerms& known = meanings_.newest_terms();
  const bool terms_hold = !state_.queue.takes_changed_terms() && modal.map.gains() == known.gain &&
                          modal.map.shifts() == known.shift &&
                          modal.tool.radius_offset == known.radius_offset;
  terms_hold ? meanings_.note(state_.blocks, modal.codes)
             : meanings_.note(state_.blocks, modal.codes, terms_of(modal));
}

void BlockRunner::emit_first_commands() {
  state_.queue.set_origin({}, 0);
  meanings_.note(0, state_.modal.codes, terms_of(state_.modal));
  state_.queue.emit(frame_of(state_.modal));
  state_.queue.emit(state_.modal.tool.length);
}

BlockRunner::LineResult BlockRunner::take_line(Command& command) {
  PlainCursor& plain = vm_.plain();
  BlockWords& words = state_.words;
  const char* const start = plain.at;
  const std::uint32_t line = plain.line;
  if (!read_plain_line(plain.at, plain.end, plain.rules, words, text_values_)) {
    STANOK_ASSERT(text_values_.faulty());
    fail_text(text_values_.fault_text(), line, text_values_.fault());
    return LineResult::nothing;
  }
  ++plain.line;
  if (!text_values_.settings().empty() && !take_settings(text_values_.settings()))
    return LineResult::nothing;
  if (words.empty()) return LineResult::nothing;
  ++state_.blocks;
  Move* move = std::get_if<Move>(&command.payload);
  if (move == nullptr) move = &command.payload.emplace<Move>();
  ActiveBlock block = state_.block_at(line);
  if (!compensating() && !state_.calls_modal && execute_simple_move(block, *move)) {
    command.origin = {vm_.frame().file, line};
    command.block = state_.blocks;
    return LineResult::command;
  }
  const Source& source = vm_.file().source;
  const std::size_t offset = source.offset_of(start);
  place_ = {{offset, static_cast<std::uint32_t>(source.line_at(offset).size()), line}, nullptr, {}};
  return LineResult::block;
}

// False when the run has failed.
bool BlockRunner::take_settings(const std::vector<TextSetting>& settings) {
  ValueFault fault;
  for (const TextSetting& setting : settings) {
    if (setting.slot) {
      parameters_.set_named(*setting.slot, setting.value);
    } else if (!parameters_.set_numbered(setting.number, setting.value, fault)) {
      fail_text(setting.text, vm_.plain().line - 1, fault);
      return false;
    }
  }
  return true;
}

bool BlockRunner::take_block(const Instruction& instruction) {
  const BlockTemplate& block = vm_.file().blocks[instruction.operand];
  state_.words = block.words;
  for (auto word = block.computed.rbegin(); word != block.computed.rend(); ++word) {
    if (!take_computed_word(*word)) return false;
  }
  ++state_.blocks;
  place_ = {block.span, &block.places, {}};
  return true;
}

// The word of a vacant variable does not exist. From the last word of a block to the first, so that
// the places of those before stay.
void BlockRunner::leave_out(const ComputedWord& word) {
  BlockWords& words = state_.words;
  switch (word.kind) {
    case ComputedWord::Kind::letter:
      words.letters &= ~letter_bit(word.letter);
      words.left_out |= letter_bit(word.letter);
      break;
    case ComputedWord::Kind::named:
      words.named.erase(words.named.begin() + word.index);
      break;
    case ComputedWord::Kind::spindle:
      words.spindle_named = false;
      break;
    case ComputedWord::Kind::g_code:
      words.g.remove(word.index);
      break;
    case ComputedWord::Kind::m_code:
      words.m.remove(word.index);
      break;
  }
}

bool BlockRunner::take_computed_word(const ComputedWord& word) {
  BlockWords& words = state_.words;
  const double value = vm_.stack().pop_number();
  if (std::isnan(value)) {
    leave_out(word);
    return true;
  }
  switch (word.kind) {
    case ComputedWord::Kind::letter:
      words.values[word.letter] = value;
      return true;
    case ComputedWord::Kind::named:
      words.named[word.index].value = value;
      return true;
    case ComputedWord::Kind::spindle:
      if (is_integer(value)) {
        words.spindle = static_cast<int>(std::lround(value));
        return true;
      }
      vm_.fail("E3010", "a spindle is a whole number");
      return false;
    case ComputedWord::Kind::g_code:
    case ComputedWord::Kind::m_code:
      break;
  }
  if (!is_integer(value * 10.0) || value < 0.0 || value > 3276.0) {
    vm_.fail("E4004", "the computed value is not a code", "unknown code");
    return false;
  }
  CodeList& list = word.kind == ComputedWord::Kind::g_code ? words.g : words.m;
  const auto written = static_cast<CodeNumber>(std::lround(value * 10.0));
  const bool is_g = word.kind == ComputedWord::Kind::g_code;
  const auto code =
      is_g ? translated_code(written, words.rules.code_system) : std::optional(written);
  if (!code) {
    vm_.fail("E4004", "the code system has no `" + code_text('G', written) + "`", "unknown code");
    return false;
  }
  list.numbers[word.index] = *code;
  return true;
}

void BlockRunner::begin_block() {
  state_.begin_commands({vm_.frame().file, place_.span.line});
  state_.states.set_level(vm_.frames().size() - 1);
}

BlockFlow BlockRunner::execute() {
  ActiveBlock block = state_.block_at(place_.span.line);
  block.done = place_.done;
  const AxisValues start_W = state_.modal.position_W;
  execute_block(block);
  if (block.faults.first) {
    fail(std::move(*block.faults.first));
    return {};
  }
  if (block.awaits_position) {
    place_.done = block.done;
    has_rest_ = true;
    return {};
  }
  return select_stages(block, start_W) ? block.flow : BlockFlow{};
}

bool BlockRunner::take_words_before_call(CodeNumber m_code) {
  ActiveBlock block = state_.block_at(place_.span.line);
  lang::take_words_before_call(block, m_code);
  if (block.faults.first) fail(std::move(*block.faults.first));
  return !block.failed();
}

// What the block asks for whose commands come next; false: the run has failed.
bool BlockRunner::select_stages(const ActiveBlock& block, const AxisValues& start_W) {
  const ModalState& modal = state_.modal;
  if (corners_.holds() && compensation_.changes(modal.compensation)) {
    fail(fault_at("E4151", {}, "a corner needs the next move of the contour",
                  "radius compensation changes here"));
    return false;
  }
  corners_.select(block.end.corner, modal.plane(), start_W);
  if (auto fault = compensation_.select(modal.compensation, start_W)) {
    fail_earlier(std::move(*fault));
    return false;
  }
  return true;
}

// Of what was emitted, or at the end of a run of what is held there.
bool BlockRunner::compensate() {
  Command command;
  if (!corners_.ready().empty()) {
    corners_.ready().take(command);
    if (auto fault = compensation_.take(command)) fail_earlier(std::move(*fault));
    return true;
  }
  if (!state_.queue.empty()) {
    state_.queue.take(command);
    if (auto fault = corners_.take(command)) fail_earlier(std::move(*fault));
    return true;
  }
  if (run_.running()) return false;
  corners_.finish();
  if (!corners_.ready().empty()) return true;
  compensation_.finish();
  return !compensation_.ready().empty();
}

// A block may ask for something before its own new length comes to the channel.
void BlockRunner::adopt_position(const AxisValues& position_B) {
  AxisValues tip_B = position_B;
  for (std::size_t k = 0; k < state_.channel.axes.size(); ++k) {
    const double on_its_way = length_along(state_.around, k, delivered_.offset_mm) -
                              length_along(state_.around, k, state_.modal.tool.length.offset_mm);
    if (on_its_way != 0.0) tip_B[k] += on_its_way;
  }
  state_.modal.adopt_position(tip_B);
  compensation_.adopt_position();
}

void BlockRunner::note_delivered(const Payload& command) {
  if (const auto* const length = std::get_if<ToolLength>(&command)) delivered_ = *length;
  const auto* const request = std::get_if<ProgramRequest>(&command);
  if (request != nullptr && request->kind == RequestKind::offset_table_write)
    written_offset_ = request->number;
}

void BlockRunner::take_written_offset() {
  ModalState& modal = state_.modal;
  if (std::exchange(written_offset_, 0) != modal.frames.work_offset_number) return;
  const WorkFrame before = modal.frame();
  take_work_offset(modal, state_.tables, modal.frames.work_offset_number);
  if (modal.frame() == before) return;
  modal.reexpress_position(before);
  state_.queue.emit(frame_of(modal));
}

// Where the probe changed, in programmed coordinates of now.
void BlockRunner::take_probe_answer(const Answer& answer) {
  const ModalState& modal = state_.modal;
  state_.probe.found = answer.ok;
  state_.probe.rehearsed = answer.rehearsed;
  state_.probe.tool_length_mm = modal.tool.length.offset_mm;
  state_.probe.position = modal.frame().work_from_base(answer.probe_B);
  for (std::size_t i = 0; i < state_.channel.axes.size(); ++i) {
    double& coordinate = state_.probe.position[i];
    coordinate = modal.map.to_program(i, answer.ok ? coordinate : modal.position_W[i]);
  }
}

void BlockRunner::emit_end(ProgramEndKind kind) {
  const ModalState& modal = state_.modal;
  CommandQueue& queue = state_.queue;
  if (modal.feed.law.kind != FeedLaw::Kind::off) queue.emit(FeedLawChange{});
  if (modal.spindles.any_runs) queue.emit(SpindleCommand{.spindle = -1});
  if (modal.switches.mist || modal.switches.flood) queue.emit(CoolantCommand{});
  const bool overrides_usual = modal.switches.feed_override && modal.switches.spindle_override &&
                               !modal.switches.adaptive_feed && modal.switches.feed_stop;
  if (!overrides_usual) queue.emit(OverrideControl{});
  if (modal.transformation.axis >= 0) queue.emit(TransformationChange{});
  queue.emit(ProgramEnd{kind, modal.compensation.on()});
}

// A value that stands in the text of a plain line.
void BlockRunner::fail_text(std::string_view text, std::uint32_t line, const ValueFault& fault) {
  const std::size_t offset = vm_.file().source.offset_of(text);
  vm_.fail_at({offset, static_cast<std::uint32_t>(text.size()), line}, fault.code, fault.message,
              fault.label);
}

void BlockRunner::fail(BlockFault fault) {
  note_left_out(fault, state_.words.left_out);
  const Source& source = vm_.file().source;
  const std::vector<IsoWord> found =
      place_.words == nullptr ? places_of_words(source, place_.span) : std::vector<IsoWord>{};
  const std::vector<IsoWord>& places = place_.words == nullptr ? found : *place_.words;
  vm_.fail_with(diagnostic_of(std::move(fault), source, place_.span, places));
  run_.blame_block(place_.span.line);
}

// The block at fault may be one before the current block.
void BlockRunner::fail_earlier(FaultOfCommand fault) {
  const Source& source = vm_.program().files[fault.origin.file]->source;
  name_codes_as_written(fault.fault, source.rules().code_system);
  Diagnostic diagnostic =
      diagnostic_at(source, fault.fault.code, source.words_of_line(fault.origin.line),
                    std::move(fault.fault.message), std::move(fault.fault.label));
  if (state_.modal.compensation.on())
    diagnostic.notes.push_back(state_.modal.origin_of(Group::radius_compensation));
  diagnostic.help = std::move(fault.fault.help);
  vm_.fail_with(std::move(diagnostic));
}

Diagnostic diagnostic_of(BlockFault fault, const Source& source, const Span& block_span,
                         const std::vector<IsoWord>& places) {
  name_codes_as_written(fault, source.rules().code_system);
  Span at = block_span;
  for (const IsoWord& word : places) {
    const bool same = word.name.letter == fault.word.letter && word.name.name == fault.word.name &&
                      (word.name.letter != 0 || !word.name.name.empty());
    if (same && (fault.word.code < 0 || word.name.code == fault.word.code)) at = word.span;
  }
  Diagnostic diagnostic =
      diagnostic_at(source, fault.code, at, std::move(fault.message), std::move(fault.label));
  diagnostic.notes = std::move(fault.notes);
  diagnostic.help = std::move(fault.help);
  return diagnostic;
}

}  // namespace stanok::lang
