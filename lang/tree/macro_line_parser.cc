#include "lang/tree/macro_line_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lang/text/block_number.h"
#include "lang/text/limits.h"
#include "lang/tree/comment_parser.h"

namespace stanok::lang {
namespace {

constexpr std::string_view goto_word = "goto";

// The abbreviations of Fanuc (B-63944EN, 16.8) and what they stand for.
constexpr auto abbreviations =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"wh", "while"},
                                                                  {"go", "goto"},
                                                                  {"en", "end"},
                                                                  {"th", "then"},
                                                                  {"po", "popen"},
                                                                  {"pc", "pclos"},
                                                                  {"dp", "dprnt"},
                                                                  {"bp", "bprnt"}});

}  // namespace

std::string_view macro_keyword(std::string_view folded_name, const TextRules& rules) {
  if (!rules.is_fanuc()) return folded_name;
  const auto* const found = std::ranges::find(
      abbreviations, folded_name, &std::pair<std::string_view, std::string_view>::first);
  return found == abbreviations.end() ? folded_name : found->second;
}

MaybeStatement MacroLineParser::parse_macro_line() {
  cursor_.set_line_ends(LineEnds::significant);
  cursor_.begin_operators();
  const Span span = scanner_.here(static_cast<std::uint32_t>(scanner_.name_ahead().size()));
  const std::string name = keyword_ahead();
  if (name == "if") return parse_if();
  if (name == "while" || name == "wh") return parse_while();
  if (name == goto_word) return parse_goto();
  if (name == "popen" || name == "pclos") return parse_printer_switch();
  if (name == "dprnt" || name == "bprnt") return parse_print();
  if (name == "do") {
    Expression always;
    always.number = 1.0;
    always.span = span;
    return parse_loop(truth_of(std::move(always)), span);
  }
  reporter_.error("E2013", span, "`" + folded(scanner_.name_ahead()) + "` closes no open loop",
                  "no DO of this number is open here");
  return std::nullopt;
}

MaybeExpression MacroLineParser::parse_condition() {
  scanner_.advance(scanner_.name_ahead().size());
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() == '[') return brackets_.parse_condition();
  reporter_
      .error("E2001", scanner_.here(), "the condition of a macro line must be in brackets",
             "expected `[`")
      .help.emplace_back("write e.g. `IF [#1 EQ 2] GOTO 10`");
  return std::nullopt;
}

// The letters that stand here, without the digits behind them.
std::string MacroLineParser::letters_ahead() const {
  std::string name = folded(scanner_.name_ahead());
  while (!name.empty() && is_digit(name.back())) name.pop_back();
  return name;
}

// The keyword that they are, or are short for.
std::string MacroLineParser::keyword_ahead() const {
  return std::string(macro_keyword(letters_ahead(), cursor_.source().rules()));
}

// Reads `word`, which digits may follow directly; false when something else stands here.
bool MacroLineParser::take_word(std::string_view word) {
  scanner_.skip_blanks(LineEnds::significant);
  if (keyword_ahead() != word) return false;
  scanner_.advance(letters_ahead().size());
  return true;
}

MaybeStatement MacroLineParser::parse_if() {
  const Span span = scanner_.here(2);
  If branch;
  branch.is_macro_line = true;
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  branch.condition = std::move(*condition);
  scanner_.skip_blanks(LineEnds::significant);
  if (keyword_ahead() == goto_word) return parse_then(branch);
  const bool has_then = take_word("then");
  const bool needs_none = cursor_.source().rules().is_haas() && !scanner_.at_line_end();
  if (!has_then && !needs_none) {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant),
                              "`GOTO` or `THEN` after the condition");
    return std::nullopt;
  }
  scanner_.skip_blanks(LineEnds::significant);
  if (!scanner_.at_line_end()) return parse_then(branch);
  if (!parse_branches(branch, span)) return std::nullopt;
  return statement_of(std::move(branch));
}

MaybeStatement MacroLineParser::parse_conditional_return() {
  cursor_.set_line_ends(LineEnds::significant);
  cursor_.begin_operators();
  If branch;
  branch.is_macro_line = true;
  auto condition = brackets_.parse_condition();
  if (!condition) return std::nullopt;
  branch.condition = std::move(*condition);
  scanner_.skip_blanks(LineEnds::significant);
  const bool returns = upper_case(scanner_.character()) == 'M' && scanner_.character(1) == '9' &&
                       scanner_.character(2) == '9' && !is_digit(scanner_.character(3));
  if (returns) return parse_then(branch);
  cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`M99` after the condition");
  return std::nullopt;
}

// A jump or a block, whatever THEN is before it.
MaybeStatement MacroLineParser::parse_then(If& branch) {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  auto statement = keyword_ahead() == goto_word ? parse_goto() : iso_.parse_iso();
  if (!statement) return std::nullopt;
  statement->span = scanner_.span_from(start, line);
  branch.then_body.push_back(std::move(*statement));
  return statement_of(std::move(branch));
}

// THEN at the end of its line: blocks up to ELSE or ENDIF.
bool MacroLineParser::parse_branches(If& branch, const Span& opened) {
  StatementList* body = &branch.then_body;
  if (cursor_.depth().braces + cursor_.depth().o_lines >= limits::nesting) {
    reporter_.error("E2030", opened, "more than 64 nested loops and braces", "too deep");
    return false;
  }
  ++cursor_.depth().o_lines;
  bool closed = false;
  while (!closed) {
    if (!scanner_.at_line_end()) scanner_.skip_blanks(LineEnds::significant);
    if (cursor_.at_body_end()) break;
    const std::string name = folded(scanner_.name_ahead());
    const bool divides = name == "else" && body == &branch.then_body;
    closed = name == "endif";
    if (closed || divides) scanner_.advance(name.size());
    if (divides) body = &branch.else_body;
    if (!closed && !divides) statements_.parse_statement(*body);
  }
  --cursor_.depth().o_lines;
  cursor_.set_line_ends(LineEnds::significant);
  if (closed) return finish_macro_line();
  reporter_.error("E2013", opened, "`IF ... THEN` is not closed", "`ENDIF` is missing");
  return false;
}

MaybeStatement MacroLineParser::parse_while() {
  const Span span = scanner_.here(static_cast<std::uint32_t>(scanner_.name_ahead().size()));
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  scanner_.skip_blanks(LineEnds::significant);
  if (keyword_ahead() != "do") {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`DO` after the condition");
    return std::nullopt;
  }
  return parse_loop(std::move(condition), span);
}

// DO m ... END m
MaybeStatement MacroLineParser::parse_loop(MaybeExpression condition, const Span& opened) {
  const auto number = take_loop_number("do");
  if (!number) return std::nullopt;
  While loop{std::move(*condition), {}, std::string(macro_loop_label) + *number};
  // On Haas the first statement of the loop may stand on its line.
  const bool may_go_on = cursor_.source().rules().is_haas();
  if (!may_go_on && !finish_macro_line()) return std::nullopt;
  if (!parse_loop_body(loop, opened)) return std::nullopt;
  return statement_of(std::move(loop));
}

// The number behind DO or END, without leading zeros.
std::optional<std::string> MacroLineParser::take_loop_number(std::string_view keyword) {
  take_word(keyword);
  scanner_.skip_blanks(LineEnds::significant);
  std::string digits;
  while (is_digit(scanner_.character())) {
    if (!digits.empty() || scanner_.character() != '0') digits += scanner_.character();
    scanner_.advance(1);
  }
  if (!digits.empty()) return digits;
  cursor_.report_unexpected(scanner_.peek(LineEnds::significant),
                            "a number behind `" + std::string(keyword) + "`");
  return std::nullopt;
}

bool MacroLineParser::parse_loop_body(While& loop, const Span& opened) {
  const std::string number = loop.label.substr(macro_loop_label.size());
  if (cursor_.depth().braces + cursor_.depth().o_lines >= limits::nesting) {
    reporter_.error("E2030", opened, "more than 64 nested loops and braces", "too deep");
    return false;
  }
  if (std::ranges::find(open_loops_, number) != open_loops_.end()) {
    reporter_
        .error("E2013", opened, "`DO" + number + "` inside `DO" + number + "`",
               "it is not clear which one `END" + number + "` closes")
        .help.emplace_back("give each nested loop its own number");
    return false;
  }
  open_loops_.push_back(number);
  ++cursor_.depth().o_lines;
  std::optional<std::string> end;
  while (!end) {
    if (!scanner_.at_line_end()) scanner_.skip_blanks(LineEnds::significant);
    if (cursor_.at_body_end()) break;
    if (scanner_.at_line_start()) end = take_end(loop.body);
    if (!end) statements_.parse_statement(loop.body);
  }
  --cursor_.depth().o_lines;
  open_loops_.pop_back();
  cursor_.set_line_ends(LineEnds::significant);
  if (end == number) return finish_macro_line();
  reporter_.error("E2013", opened, "`DO" + number + "` is not closed",
                  end ? "`END" + *end + "` comes before `END" + number + "`"
                      : "`END" + number + "` is missing");
  return false;
}

// How many characters the block number before the words of this line has.
std::size_t MacroLineParser::behind_block_number() const {
  std::size_t at = 0;
  if (upper_case(scanner_.character()) != 'N' || !is_digit(scanner_.character(1))) return 0;
  for (++at; is_digit(scanner_.character(at)) || scanner_.character(at) == '.';) ++at;
  while (is_blank(scanner_.character(at))) ++at;
  return at;
}

// The number of the END that stands on this line, read; nothing where there is none. A jump to its
// block number ends the pass, as an empty statement does.
std::optional<std::string> MacroLineParser::take_end(StatementList& body) {
  const std::size_t before = behind_block_number();
  constexpr std::string_view word = "end";
  std::size_t at = before;
  std::string letters;
  while (is_name_start(scanner_.character(at))) letters += lower_case(scanner_.character(at++));
  if (macro_keyword(letters, cursor_.source().rules()) != word) return std::nullopt;
  while (is_blank(scanner_.character(at))) ++at;
  if (!is_digit(scanner_.character(at))) return std::nullopt;
  if (before != 0) {
    Statement last = statement_of(Compound{});
    const std::string_view rest = cursor_.source().text().substr(scanner_.offset(), before);
    last.span = scanner_.here(1);
    last.number = block_number(rest).value_or(-1);
    body.push_back(std::move(last));
  }
  scanner_.advance(before);
  return take_loop_number(word);
}

// GOTO 10, GOTO#1, GOTO[#1+10]
MaybeStatement MacroLineParser::parse_goto() {
  take_word(goto_word);
  scanner_.skip_blanks(LineEnds::significant);
  auto target = brackets_.parse_value();
  if (!target || !finish_macro_line()) return std::nullopt;
  return statement_of(JumpLine{std::move(*target)});
}

// POPEN and PCLOS: what DPRNT prints goes into the log and the file of printed lines, which are
// open always.
MaybeStatement MacroLineParser::parse_printer_switch() {
  scanner_.advance(scanner_.name_ahead().size());
  if (!finish_macro_line()) return std::nullopt;
  return statement_of(Compound{});
}

// DPRNT[X#100[53]*TEXT]: the text with the values of variables, [53] is 5 digits before and 3
// behind the point; * is a blank. By "printed" in front of it the readers of the log know the line.
MaybeStatement MacroLineParser::parse_print() {
  const Span span = scanner_.here(5);
  scanner_.advance(scanner_.name_ahead().size());
  scanner_.skip_blanks(LineEnds::significant);
  Expression line = string_expression({}, span);
  std::string text = "printed ";
  for (scanner_.advance(1); scanner_.character() != ']';) {
    if (scanner_.at_line_end()) {
      reporter_.error("E2001", span, "`DPRNT[` is not closed", "`]` is missing on this line");
      return std::nullopt;
    }
    if (scanner_.offset() - span.offset > limits::block_bytes) {
      reporter_.error("E1007", span, "the block is longer than 4096 bytes", "too long");
      return std::nullopt;
    }
    if (scanner_.character() != '#') {
      text += scanner_.character() == '*' ? ' ' : scanner_.character();
      scanner_.advance(1);
      continue;
    }
    auto value = parse_printed_value();
    if (!value) return std::nullopt;
    line = concatenated(std::move(line), string_expression(std::exchange(text, {}), span));
    line = concatenated(std::move(line), std::move(*value));
  }
  scanner_.advance(1);
  if (!finish_macro_line()) return std::nullopt;
  IsoBlock block;
  block.comments.push_back(
      {Message::Kind::log, concatenated(std::move(line), string_expression(text, span))});
  return statement_of(std::move(block));
}

// #100[53]
MaybeExpression MacroLineParser::parse_printed_value() {
  auto value = brackets_.parse_parameter_reference();
  if (!value) return std::nullopt;
  const bool formatted = scanner_.character() == '[' && is_digit(scanner_.character(1)) &&
                         is_digit(scanner_.character(2)) && scanner_.character(3) == ']';
  if (!formatted) {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant),
                              "the digits before and after the point, as in `[53]`");
    return std::nullopt;
  }
  const int decimals = scanner_.character(2) - '0';
  scanner_.advance(4);
  return as_text(std::move(*value), decimals);
}

// Comments may follow, nothing else.
bool MacroLineParser::finish_macro_line() {
  scanner_.skip_blanks(LineEnds::significant);
  while (scanner_.character() == '(') {
    if (!scanner_.read_parenthesis_comment()) return false;
    scanner_.skip_blanks(LineEnds::significant);
  }
  if (scanner_.character() == ';' && cursor_.inside_braces()) scanner_.advance(1);
  if (scanner_.character() == ';' && !cursor_.skip_remark()) return false;
  scanner_.skip_blanks(LineEnds::significant);
  if (cursor_.at_statement_end()) return true;
  cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "the end of the line")
      .help.emplace_back("put what follows on a line of its own");
  return false;
}

}  // namespace stanok::lang
