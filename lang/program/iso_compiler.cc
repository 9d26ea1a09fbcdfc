#include "lang/program/iso_compiler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/block/block_check.h"
#include "lang/block/predefined_parameter.h"
#include "lang/words/code_system.h"

namespace stanok::lang {
namespace {

// Of the Fanuc dialect; the code of the alarm is the sum of the number and the value.
constexpr double alarm_variable = 3000.0;
constexpr double stop_variable = 3006.0;
constexpr double first_alarm_of_haas = 1000.0;
constexpr double abort_code = 1000.0;  // of (ABORT,...): U1000

bool is_code(const IsoWord& word) {
  return word.name.letter == 'G' || word.name.letter == 'M';
}

CodeList& list_of(BlockWords& words, char letter) {
  return letter == 'G' ? words.g : words.m;
}

// The span of the word that a fault names; the whole block when it names none.
Span span_of(const BlockTemplate& made, const WordName& name) {
  for (const IsoWord& word : made.places) {
    const bool same_letter = word.name.letter == name.letter && word.name.name == name.name;
    if (same_letter && (name.code < 0 || word.name.code == name.code) &&
        (name.letter != 0 || !name.name.empty())) {
      return word.span;
    }
  }
  return made.span;
}

}  // namespace

void IsoCompiler::compile(const IsoBlock& block) {
  for (const ActiveComment& comment : block.comments) {
    if (comment.aborts) code_.push_number(abort_code, comment.text.span);
    if (!expressions_.require(comment.text, Type::string, "the message")) return;
    if (comment.aborts) {
      code_.emit(Op::terminate, comment.text.span);
      continue;
    }
    code_.emit(Op::message, comment.text.span, 0, 0, static_cast<std::uint16_t>(comment.kind));
  }
  BlockTemplate made;
  made.span = code_.statement_span();
  compile_words(block, made);
  compile_spindle(block, made);
  if (compile_stop_variable(block)) return;
  compile_settings(block.settings);
  made.words.rules = file_.source.rules();
  check_template(made);
  const bool jumps = made.words.m.has(m(97)) || (made.words.m.has(m(99)) && made.words.has('P'));
  if (jumps) context_.program.jumps = true;
  if (block.words.empty() && !block.spindle) return;
  file_.blocks.push_back(std::move(made));
  code_.emit(Op::block, code_.statement_span(),
             static_cast<std::uint32_t>(file_.blocks.size() - 1));
}

void IsoCompiler::compile_words(const IsoBlock& block, BlockTemplate& made) {
  for (const IsoWord& word : block.words) {
    IsoWord place;
    place.span = word.span;
    place.name = word.name;
    made.places.push_back(std::move(place));
    const auto constant = symbols_.constant_of(word.value);
    if (constant && constant->type == Type::number && !(is_code(word) && word.name.code < 0)) {
      add_constant_word(word, constant->number, made);
    } else if (expressions_.require(word.value, Type::number, "the value of a word")) {
      add_computed_word(word, made);
    }
  }
}

void IsoCompiler::add_constant_word(const IsoWord& word, double value, BlockTemplate& made) {
  BlockWords& words = made.words;
  if (is_code(word)) {
    list_of(words, word.name.letter).add(static_cast<CodeNumber>(word.name.code));
  } else if (word.name.letter != 0) {
    const LetterSet bit = letter_bit(word.name.letter);
    words.letters |= bit;
    if (word.whole) words.whole |= bit;
    words.values[word.name.letter] = value;
  } else {
    words.named.push_back({word.name.name, value});
  }
}

// The value of a named word is no number until it is computed: feed laws name it in their errors.
void IsoCompiler::add_computed_word(const IsoWord& word, BlockTemplate& made) {
  BlockWords& words = made.words;
  ComputedWord computed;
  if (is_code(word)) {
    CodeList& list = list_of(words, word.name.letter);
    computed.kind =
        word.name.letter == 'G' ? ComputedWord::Kind::g_code : ComputedWord::Kind::m_code;
    computed.index = static_cast<std::uint16_t>(list.count);
    list.add(code_computed_later);
  } else if (word.name.letter != 0) {
    computed.letter = word.name.letter;
    words.letters |= letter_bit(word.name.letter);
    if (file_.source.rules().is_fanuc()) words.whole |= letter_bit(word.name.letter);
  } else {
    computed.kind = ComputedWord::Kind::named;
    computed.index = static_cast<std::uint16_t>(words.named.size());
    words.named.push_back({word.name.name, std::nan("")});
  }
  made.computed.push_back(computed);
}

void IsoCompiler::compile_spindle(const IsoBlock& block, BlockTemplate& made) {
  if (!block.spindle || !expressions_.require(*block.spindle, Type::number, "the spindle")) return;
  ComputedWord computed;
  computed.kind = ComputedWord::Kind::spindle;
  made.computed.push_back(computed);
  made.words.spindle_named = true;
}

// #3000=1 (TEXT) ends the program with an alarm, #3006=1 (TEXT) stops it with a message: in the
// Fanuc dialect, alone in a block. False: the block does something else.
bool IsoCompiler::compile_stop_variable(const IsoBlock& block) {
  const bool alone = block.settings.size() == 1 && block.words.empty();
  if (!alone || !file_.source.rules().is_fanuc()) return false;
  const auto& [target, value] = block.settings[0];
  if (target.node != Node::parameter) return false;
  const auto number = symbols_.constant_of(target.children[0]);
  const bool ends = number && number->number == alarm_variable;
  if (!ends && !(number && number->number == stop_variable)) return false;
  if (!expressions_.require(value, Type::number, "the number of the message")) return true;
  if (ends) {
    const bool haas = file_.source.rules().is_haas();
    code_.push_number(haas ? first_alarm_of_haas : alarm_variable, target.span);
    code_.emit(Op::compute, target.span, 0, 0, static_cast<std::uint16_t>(Operation::add));
    code_.push_text(block.remark, target.span);
    code_.emit(Op::terminate, target.span);
    return true;
  }
  code_.emit(Op::pop, target.span);
  code_.push_text(block.remark, target.span);
  code_.emit(Op::message, target.span, 0, 0, static_cast<std::uint16_t>(Message::Kind::message));
  BlockTemplate made;
  made.span = code_.statement_span();
  made.words.m.add(m(0));
  file_.blocks.push_back(std::move(made));
  code_.emit(Op::block, file_.blocks.back().span,
             static_cast<std::uint32_t>(file_.blocks.size() - 1));
  return true;
}

// All values of the block are computed before the first setting takes effect.
void IsoCompiler::compile_settings(const std::vector<ParameterSetting>& settings) {
  if (settings.empty()) return;
  std::vector<SettingTarget> targets;
  for (const ParameterSetting& setting : settings) {
    const auto target = compile_setting(setting);
    if (!target) return;
    targets.push_back(*target);
  }
  file_.settings.push_back(std::move(targets));
  code_.emit(Op::settings, settings.front().target.span,
             static_cast<std::uint32_t>(file_.settings.size() - 1));
}

std::optional<SettingTarget> IsoCompiler::compile_setting(const ParameterSetting& setting) {
  const Expression& parameter = setting.target;
  SettingTarget target;
  if (parameter.node == Node::parameter) {
    if (!expressions_.require(parameter.children[0], Type::number, "the parameter number"))
      return std::nullopt;
    expressions_.note_use(parameter, ParameterAccess::set);
  } else if (parameter.node == Node::r_parameter) {
    target.kind = SettingTarget::Kind::r_parameter;
    target.slot = static_cast<std::uint32_t>(parameter.number);
    if (parameter.number > 999.0) {
      reporter_.error("E3015", parameter.span, "there is no R-parameter of this number",
                      "R0 to R999 exist");
      return std::nullopt;
    }
  } else {
    target.kind = SettingTarget::Kind::named;
    target.slot = symbols_.named_parameter_slot(parameter.text);
    if (find_predefined_parameter(parameter.text) != nullptr) {
      reporter_.error("E3013", parameter.span, "`#<" + parameter.text + ">` is predefined",
                      "cannot be changed");
      return std::nullopt;
    }
  }
  if (!expressions_.require(setting.value, Type::number, "the value of a parameter"))
    return std::nullopt;
  return target;
}

void IsoCompiler::check_template(const BlockTemplate& made) {
  if (dwells_suspiciously_long(made.words)) {
    reporter_
        .warning("W410", span_of(made, {'P', -1, {}}), "a dwell of 100 s or more", "milliseconds?")
        .help.push_back("the unit is seconds: use e.g. `G4 P0.5`");
  }
  auto fault = check_block(made.words, channel_, context_.dialect);
  if (!fault) return;
  name_codes_as_written(*fault, made.words.rules.code_system);
  Diagnostic& diagnostic = reporter_.error(fault->code, span_of(made, fault->word),
                                           std::move(fault->message), std::move(fault->label));
  diagnostic.notes = std::move(fault->notes);
  diagnostic.help = std::move(fault->help);
}

}  // namespace stanok::lang
