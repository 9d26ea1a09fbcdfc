#include "lang/tree/o_line_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

constexpr std::size_t program_digits_max = 8;

// Keywords that end or divide what another O-line opened; `while` does so behind `do` only.
constexpr auto closing_words =
    std::to_array<std::string_view>({"endsub", "elseif", "else", "endif", "endwhile", "endrepeat"});

constexpr auto o_keywords = std::to_array<std::string_view>(
    {"sub", "endsub", "call", "return", "if", "elseif", "else", "endif", "while", "endwhile", "do",
     "repeat", "endrepeat", "break", "continue"});

bool is_closing(std::string_view keyword) {
  return std::find(closing_words.begin(), closing_words.end(), keyword) != closing_words.end();
}

// "100" of "0100".
std::string without_leading_zeros(const std::string& digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return digits.substr(first);
}

// A capital O before which there are comments and frame marks only: `O<name>` alone is the title of
// a program, as in LinuxCNC.
bool is_title_of_text(const Source& source, std::size_t offset) {
  if (source.text()[offset] != 'O') return false;
  std::string_view before = source.text().substr(source.begin(), offset - source.begin());
  while (!before.empty()) {
    const std::size_t end = std::min(before.find_first_of("\r\n"), before.size());
    const std::size_t first = before.substr(0, end).find_first_not_of(" \t");
    if (first != std::string_view::npos && first < end) {
      if (std::string_view("(;%").find(before[first]) == std::string_view::npos) return false;
    }
    before.remove_prefix(std::min(end + 1, before.size()));
  }
  return true;
}

}  // namespace

bool is_program_letter(char c, const TextRules& rules) {
  return upper_case(c) == 'O' || (c == ':' && rules.is_fanuc());
}

// The label of a line, from `at` on, which is left behind it.
bool OLineParser::read_label(std::size_t& at, OLineAhead& line) const {
  const auto character = [&] { return scanner_.character(at); };
  if (character() == '<') {
    for (++at; character() != '>'; ++at) {
      if (character() == '\0' || is_line_end(character())) return false;
      if (!is_blank(character())) line.written += character();
    }
    ++at;
    line.label = folded(line.written);
    return !line.label.empty();
  }
  for (; is_digit(character()); ++at) line.written += character();
  if (line.written.empty()) return false;
  line.numbered = true;
  line.label = without_leading_zeros(line.written);
  return !line.label.empty();
}

// The O-line that begins here, without reading it; nothing when it has a computed label, or not the
// block skip before it.
std::optional<OLineParser::OLineAhead> OLineParser::o_line_ahead(int skip_level) const {
  std::size_t at = 0;
  const auto character = [&] { return scanner_.character(at); };
  const auto skip_blanks = [&] {
    while (is_blank(character())) ++at;
  };
  if (skip_level != 0) {
    if (character() != '/') return std::nullopt;
    ++at;
    const int level = is_digit(character()) && character() != '0' ? character() - '0' : 1;
    if (level != skip_level) return std::nullopt;
    if (is_digit(character())) ++at;
    skip_blanks();
  }
  if (upper_case(character()) == 'N' && is_digit(scanner_.character(at + 1))) {
    for (++at; is_digit(character()) || character() == '.';) ++at;
    skip_blanks();
  }
  if (!is_program_letter(character(), cursor_.source().rules())) return std::nullopt;
  ++at;
  skip_blanks();
  OLineAhead line;
  if (!read_label(at, line)) return std::nullopt;
  line.label_length = at;
  skip_blanks();
  for (; is_name_part(character()); ++at) line.keyword += lower_case(character());
  line.length = at;
  if (line.keyword == "end" || line.keyword == "else") take_second_word(line);
  return line;
}

// `end sub` is `endsub`, `else if` is `elseif`.
void OLineParser::take_second_word(OLineAhead& line) const {
  std::size_t at = line.length;
  while (is_blank(scanner_.character(at))) ++at;
  std::string whole = line.keyword;
  for (; is_name_part(scanner_.character(at)); ++at) whole += lower_case(scanner_.character(at));
  if (std::ranges::find(o_keywords, whole) == o_keywords.end() || whole == line.keyword) return;
  line.keyword = std::move(whole);
  line.length = at;
}

MaybeStatement OLineParser::parse_o_line(int skip_level) {
  cursor_.set_line_ends(LineEnds::significant);
  cursor_.begin_operators();
  const auto ahead = o_line_ahead();
  const Span label_span =
      scanner_.here(static_cast<std::uint32_t>(ahead ? ahead->label_length : 1));
  if (!ahead) return parse_computed_call();
  const Span line_span = scanner_.here(static_cast<std::uint32_t>(ahead->length));
  if (ahead->keyword.empty()) return parse_program_number(*ahead, label_span);
  scanner_.advance(ahead->length);
  const OpenOLine open{ahead->label, ahead->keyword, line_span, skip_level};
  const std::string_view keyword = open.keyword;
  if (keyword == "call") return parse_o_call({ahead->label, ahead->written, {}, label_span});
  if (keyword == "sub") return parse_o_sub(open, {ahead->label, ahead->written, {}, label_span});
  if (keyword == "if") return parse_o_if(open);
  if (keyword == "while") return parse_o_while(open);
  if (keyword == "do") return parse_o_do(open);
  if (keyword == "repeat") return parse_o_repeat(open);
  if (keyword == "return") return parse_o_return();
  if (keyword == "break" || keyword == "continue") {
    if (!finish_o_line()) return std::nullopt;
    return keyword == "break" ? statement_of(Break{open.label})
                              : statement_of(Continue{open.label});
  }
  if (is_closing(keyword)) {
    reporter_.error("E2013", line_span, "`" + open.text() + "` has nothing to close",
                    "no O-line opened this");
    return std::nullopt;
  }
  Diagnostic& diagnostic =
      reporter_.error("E2001", line_span, "unknown keyword `" + open.keyword + "` on an O-line",
                      "not a keyword of O-lines");
  const std::string_view nearest = nearest_name(keyword, {o_keywords.begin(), o_keywords.end()});
  if (!nearest.empty()) diagnostic.help.push_back("did you mean `" + std::string(nearest) + "`?");
  return std::nullopt;
}

// O100 alone, or O100 (title): a program of that number begins.
MaybeStatement OLineParser::parse_program_number(const OLineAhead& line, const Span& span) {
  scanner_.advance(line.length);
  const bool is_title = is_title_of_text(cursor_.source(), span.offset);
  if (!finish_o_line()) return std::nullopt;
  if (!line.numbered && is_title) return statement_of(Compound{});
  if (!line.numbered) {
    reporter_.error("E2001", span, "an O-line with a name needs a keyword", "no keyword")
        .help.push_back("write e.g. `O<name> sub` or `O<name> call`");
    return std::nullopt;
  }
  const bool inside = !cursor_.at_file_level();
  if (inside || line.label.size() > program_digits_max) {
    reporter_.error("E2012", span,
                    inside ? "a numbered program is inside braces or O-lines"
                           : "a program number has at most 8 digits",
                    "");
    return std::nullopt;
  }
  return statement_of(NumberedProgram{std::stoi(line.label)});
}

// O[...] call, O#1 call
MaybeStatement OLineParser::parse_computed_call() {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
  auto number = brackets_.parse_value();
  if (!number) return std::nullopt;
  OLabel label;
  label.span = scanner_.span_from(start, line);
  label.computed = std::move(*number);
  scanner_.skip_blanks(LineEnds::significant);
  const std::string keyword = folded(scanner_.name_ahead());
  if (keyword != "call") {
    reporter_.error("E2001", scanner_.peek(LineEnds::significant).span,
                    "an O-line with a computed number can only be a call", "expected `call`");
    return std::nullopt;
  }
  scanner_.advance(keyword.size());
  return parse_o_call(std::move(label));
}

MaybeStatement OLineParser::parse_o_call(OLabel label) {
  OCall call{std::move(label), {}};
  while (true) {
    scanner_.skip_blanks(LineEnds::significant);
    if (scanner_.character() == '(') {
      if (!scanner_.read_parenthesis_comment()) return std::nullopt;
      continue;
    }
    if (scanner_.character() != '[') break;
    auto argument = brackets_.parse_bracket();
    if (!argument) return std::nullopt;
    call.arguments.push_back(std::move(*argument));
  }
  if (call.arguments.size() > limits::o_call_arguments) {
    reporter_.error("E3005", call.arguments[limits::o_call_arguments].span,
                    "an O-line call takes at most 30 arguments", "one too many");
    return std::nullopt;
  }
  if (!finish_o_line()) return std::nullopt;
  return statement_of(std::move(call));
}

MaybeStatement OLineParser::parse_o_sub(const OpenOLine& open, OLabel label) {
  if (!cursor_.at_file_level()) {
    reporter_.error("E2012", open.span, "`" + open.text() + "` inside braces or other O-lines",
                    "subprograms belong at file level");
    return std::nullopt;
  }
  if (!finish_o_line()) return std::nullopt;
  OSubprogram subprogram{std::move(label), {}, {}};
  if (!parse_o_body(open, {"endsub"}, subprogram.body)) return std::nullopt;
  if (!parse_optional_bracket(subprogram.value)) return std::nullopt;
  return statement_of(std::move(subprogram));
}

MaybeStatement OLineParser::parse_o_return() {
  OReturn result;
  if (!parse_optional_bracket(result.value)) return std::nullopt;
  return statement_of(std::move(result));
}

MaybeStatement OLineParser::parse_o_if(const OpenOLine& open) {
  auto condition = parse_o_condition(open.keyword);
  If statement;
  auto end = parse_o_body(open, {"elseif", "else", "endif"}, statement.then_body);
  if (!end) return std::nullopt;
  if (*end == "else") {
    if (!finish_o_line()) return std::nullopt;
    end = parse_o_body(open, {"endif"}, statement.else_body);
  } else if (*end == "elseif") {
    if (cursor_.depth().else_ifs >= limits::else_ifs) {
      reporter_.error("E2031", open.span, "more than 1000 `elseif` in a row", "one too many");
      return std::nullopt;
    }
    ++cursor_.depth().else_ifs;
    auto other = parse_o_if({open.label, *end, open.span, open.skip_level});
    --cursor_.depth().else_ifs;
    if (!other) return std::nullopt;
    other->span = open.span;
    statement.else_body.push_back(std::move(*other));
  }
  const bool closed = end == "elseif" || (end && finish_o_line());
  if (!closed || !condition) return std::nullopt;
  statement.condition = std::move(*condition);
  return statement_of(std::move(statement));
}

MaybeStatement OLineParser::parse_o_while(const OpenOLine& open) {
  auto condition = parse_o_condition(open.keyword);
  While loop{{}, {}, open.label};
  if (!parse_o_body(open, {"endwhile"}, loop.body) || !finish_o_line()) return std::nullopt;
  if (!condition) return std::nullopt;
  loop.condition = std::move(*condition);
  return statement_of(std::move(loop));
}

MaybeStatement OLineParser::parse_o_do(const OpenOLine& open) {
  if (!finish_o_line()) return std::nullopt;
  StatementList body;
  if (!parse_o_body(open, {"while"}, body)) return std::nullopt;
  auto condition = parse_o_condition("while");
  if (!condition) return std::nullopt;
  return statement_of(DoWhile{std::move(body), std::move(*condition), open.label});
}

MaybeStatement OLineParser::parse_o_repeat(const OpenOLine& open) {
  auto count = parse_o_bracket(open.keyword);
  ORepeat loop{{}, {}, open.label};
  if (!parse_o_body(open, {"endrepeat"}, loop.body) || !finish_o_line()) return std::nullopt;
  if (!count) return std::nullopt;
  loop.count = std::move(*count);
  return statement_of(std::move(loop));
}

// The statements up to the O-line of the same label whose keyword is one of `ends`; that keyword,
// read.
std::optional<std::string> OLineParser::parse_o_body(const OpenOLine& open,
                                                     const std::vector<std::string_view>& ends,
                                                     StatementList& body) {
  if (cursor_.depth().braces + cursor_.depth().o_lines >= limits::nesting) {
    reporter_.error("E2030", open.span, "more than 64 nested O-lines and braces", "too deep");
    return std::nullopt;
  }
  ++cursor_.depth().o_lines;
  std::optional<std::string> end;
  while (!end) {
    if (!scanner_.at_line_end()) scanner_.skip_blanks(LineEnds::significant);
    if (cursor_.at_body_end()) {
      reporter_.error("E2013", open.span, "`" + open.text() + "` is not closed",
                      "`O" + open.label + " " + std::string(ends.back()) + "` is missing");
      break;
    }
    if (scanner_.at_line_start()) end = take_o_end(open, ends);
    if (!end) statements_.parse_statement(body);
  }
  --cursor_.depth().o_lines;
  cursor_.set_line_ends(LineEnds::significant);
  if (end && open.skip_level != 0) check_skipped_body(open, body);
  return end;
}

// Behind a skipped opening line all lines are skipped.
void OLineParser::check_skipped_body(const OpenOLine& open, const StatementList& body) {
  for (const Statement& statement : body) {
    if (statement.skip_level == open.skip_level) continue;
    reporter_
        .error("E2005", statement.span, "a line without `/` between skipped O-lines",
               "would run without `" + open.text() + "`")
        .help.push_back("put `/` before all lines up to the closing one, or before none");
    return;
  }
}

// The keyword of the O-line that stands here when it ends what is open; a wrong one is reported.
std::optional<std::string> OLineParser::take_o_end(const OpenOLine& open,
                                                   const std::vector<std::string_view>& ends) {
  const auto ahead = o_line_ahead(open.skip_level);
  if (!ahead) return std::nullopt;
  const bool same = ahead->label == open.label;
  const bool ends_this = same && std::find(ends.begin(), ends.end(), ahead->keyword) != ends.end();
  if (!ends_this && !is_closing(ahead->keyword)) return std::nullopt;
  const Span span = scanner_.here(static_cast<std::uint32_t>(ahead->length));
  scanner_.advance(ahead->length);
  if (ends_this) return ahead->keyword;
  reporter_
      .error("E2013", span,
             "`O" + ahead->label + " " + ahead->keyword + "` while `" + open.text() + "` is open",
             "closes something else")
      .notes.push_back({"opened here", source_.place(open.span)});
  scanner_.skip_to_line_end();
  return std::nullopt;
}

// [expression] that must stand behind a keyword, and the end of the line. What the line opened is
// read on when it is faulty.
MaybeExpression OLineParser::parse_o_bracket(std::string_view keyword) {
  scanner_.skip_blanks(LineEnds::significant);
  MaybeExpression value;
  if (scanner_.character() == '[') {
    value = brackets_.parse_bracket();
  } else {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant),
                              "`[` after `" + std::string(keyword) + "`");
  }
  if (value && finish_o_line()) return value;
  scanner_.skip_to_line_end();
  return std::nullopt;
}

// A condition of O-lines is a number: true when it is not 0.
MaybeExpression OLineParser::parse_o_condition(std::string_view keyword) {
  auto number = parse_o_bracket(keyword);
  if (!number) return std::nullopt;
  return truth_of(std::move(*number));
}

// [expression] or nothing, then the end of the line.
bool OLineParser::parse_optional_bracket(MaybeExpression& value) {
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() == '[') {
    value = brackets_.parse_bracket();
    if (!value) return false;
  }
  return finish_o_line();
}

// Comments may follow, nothing else.
bool OLineParser::finish_o_line() {
  scanner_.skip_blanks(LineEnds::significant);
  while (scanner_.character() == '(') {
    if (!scanner_.read_parenthesis_comment()) return false;
    scanner_.skip_blanks(LineEnds::significant);
  }
  if (scanner_.character() == ';' && !cursor_.inside_braces()) scanner_.skip_line_comment();
  if (scanner_.at_line_end() || (scanner_.character() == '}' && cursor_.inside_braces()))
    return true;
  cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "the end of the O-line");
  return false;
}

}  // namespace stanok::lang
