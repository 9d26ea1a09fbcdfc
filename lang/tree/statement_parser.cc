#include "lang/tree/statement_parser.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "lang/text/limits.h"
#include "lang/tree/keywords.h"

namespace stanok::lang {
namespace {

std::optional<Operation> combined_operation(const Token& token) {
  if (token.is("+=") || token.is("++")) return Operation::add;
  if (token.is("-=") || token.is("--")) return Operation::subtract;
  if (token.is("*=")) return Operation::multiply;
  if (token.is("/=")) return Operation::divide;
  return std::nullopt;
}

// What somebody may mean by a name that begins a line and is no variable or function. Empty: not
// known.
std::string help_for_word(std::string_view name) {
  std::string digits(name);
  std::replace_if(
      digits.begin() + 1, digits.end(), [](char c) { return upper_case(c) == 'O'; }, '0');
  const bool is_word = digits != name && std::all_of(digits.begin() + 1, digits.end(), is_digit);
  if (is_word) return "did you mean `" + digits + "`? This has the letter O";
  if (folded(name) == "setvn")
    return "variables have no names of `SETVN` here: write their numbers, or `#<name>` in the "
           "dialects stanok and linuxcnc";
  return {};
}

}  // namespace

MaybeStatement StatementParser::parse_keyword(std::string_view keyword) {
  cursor_.set_line_ends(LineEnds::blank);
  if (keyword == "if") return parse_if();
  if (keyword == "while") return parse_while();
  if (keyword == "do") return parse_do();
  if (keyword == "for") return parse_for();
  if (keyword == "switch") return parse_switch();
  if (keyword == "return") return parse_return();
  if (keyword == "break" || keyword == "continue") return parse_jump(keyword);
  cursor_.report_unexpected(scanner_.peek(LineEnds::blank), "a statement");
  return std::nullopt;
}

// `{ roughing }`: other controls write comments so. Words on one line, the first of two letters and
// more and no keyword.
bool StatementParser::refuses_remark_in_braces() {
  std::size_t length = 1;
  const auto character = [&] { return scanner_.character(length); };
  const auto skip_blanks = [&] {
    while (is_blank(character())) ++length;
  };
  skip_blanks();
  bool any = false;
  for (; character() != '}' || !any; skip_blanks()) {
    std::string word;
    for (; is_letter(character()); ++length) word += lower_case(character());
    if (word.size() < (any ? 1U : 2U) || (!any && is_keyword(word))) return false;
    while (is_name_part(character()) || character() == '.' || character() == ',') ++length;
    any = true;
  }
  ++length;
  reporter_
      .error("E2001", scanner_.here(static_cast<std::uint32_t>(length)),
             "braces contain statements, not a comment", "a text")
      .help.push_back("write a comment in parentheses, `(text)`, or after `;`");
  scanner_.advance(length);
  return true;
}

MaybeStatement StatementParser::parse_compound() {
  if (refuses_remark_in_braces()) return std::nullopt;
  auto body = bodies_.parse_body("compound");
  if (!body) return std::nullopt;
  return statement_of(Compound{std::move(*body)});
}

// ( condition )
MaybeExpression StatementParser::parse_condition() {
  cursor_.set_line_ends(LineEnds::blank);
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  if (!cursor_.expect("(", "the keyword")) return std::nullopt;
  auto condition = expressions_.parse_expression(LineEnds::blank);
  if (!condition || !cursor_.expect(")", "the condition")) return std::nullopt;
  if (!cursor_.check_length(start, line)) return std::nullopt;
  return condition;
}

MaybeStatement StatementParser::parse_if() {
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  auto then_body = bodies_.parse_body("if");
  if (!then_body) return std::nullopt;
  If statement{std::move(*condition), std::move(*then_body), {}};
  const Token token = scanner_.peek(LineEnds::blank);
  if (token.kind != TokenKind::name || folded(token.text) != "else") {
    return statement_of(std::move(statement));
  }
  scanner_.take(LineEnds::blank);
  const Token next = scanner_.peek(LineEnds::blank);
  if (next.kind == TokenKind::name && folded(next.text) == "if") {
    if (cursor_.depth().else_ifs >= limits::else_ifs) {
      reporter_.error("E2031", next.span, "more than 1000 `else if` in a row", "one too many");
      return std::nullopt;
    }
    ++cursor_.depth().else_ifs;
    auto other = parse_if();
    --cursor_.depth().else_ifs;
    if (!other) return std::nullopt;
    other->span = next.span;
    statement.else_body.push_back(std::move(*other));
  } else {
    auto else_body = bodies_.parse_body("else");
    if (!else_body) return std::nullopt;
    statement.else_body = std::move(*else_body);
  }
  return statement_of(std::move(statement));
}

MaybeStatement StatementParser::parse_while() {
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  auto body = bodies_.parse_body("while");
  if (!body) return std::nullopt;
  return statement_of(While{std::move(*condition), std::move(*body), {}});
}

MaybeStatement StatementParser::parse_do() {
  scanner_.take(LineEnds::blank);
  auto body = bodies_.parse_body("do");
  if (!body) return std::nullopt;
  const Token token = scanner_.peek(LineEnds::blank);
  if (token.kind != TokenKind::name || folded(token.text) != "while") {
    cursor_.report_unexpected(token, "`while` after the body of `do`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition || !cursor_.expect(";", "the condition of `do`")) return std::nullopt;
  return statement_of(DoWhile{std::move(*body), std::move(*condition), {}});
}

MaybeStatement StatementParser::parse_for() {
  const std::size_t begin = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.take(LineEnds::blank);
  if (!cursor_.expect("(", "`for`")) return std::nullopt;
  For loop;
  if (!cursor_.accept(";")) {
    const Token first = scanner_.peek(LineEnds::blank);
    scanner_.skip_blanks(LineEnds::blank);
    const bool declares = type_of_keyword(folded(first.text)).has_value();
    auto start = declares ? declarations_.parse_declaration_or_function() : parse_simple();
    if (!start) return std::nullopt;
    start->span = first.span;
    loop.start.push_back(std::move(*start));
  }
  if (!cursor_.accept(";")) {
    loop.condition = expressions_.parse_expression(LineEnds::blank);
    if (!loop.condition || !cursor_.expect(";", "the condition of `for`")) return std::nullopt;
  }
  if (!cursor_.accept(")")) {
    const Span span = scanner_.peek(LineEnds::blank).span;
    // A simple statement without its `;`: the parenthesis ends it.
    closing_ = ")";
    auto step = parse_simple();
    closing_ = ";";
    if (!step) return std::nullopt;
    step->span = span;
    loop.step.push_back(std::move(*step));
  }
  if (!cursor_.check_length(begin, line)) return std::nullopt;
  auto body = bodies_.parse_body("for");
  if (!body) return std::nullopt;
  loop.body = std::move(*body);
  return statement_of(std::move(loop));
}

MaybeStatement StatementParser::parse_switch() {
  scanner_.take(LineEnds::blank);
  auto value = parse_condition();
  if (!value || !cursor_.expect("{", "`switch ( )`")) return std::nullopt;
  Switch statement{std::move(*value), {}};
  while (!cursor_.accept("}")) {
    auto next = parse_case();
    if (!next) return std::nullopt;
    statement.cases.push_back(std::move(*next));
  }
  return statement_of(std::move(statement));
}

// case 1, 2: { }   default: { }
std::optional<SwitchCase> StatementParser::parse_case() {
  const Token token = scanner_.peek(LineEnds::blank);
  const std::string word = folded(token.text);
  SwitchCase one;
  one.span = token.span;
  if (word != "case" && word != "default") {
    cursor_.report_unexpected(token, "`case`, `default` or `}`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  if (word == "case") {
    if (!expressions_.parse_list(":", one.values)) return std::nullopt;
    if (one.values.empty()) {
      reporter_.error("E2001", token.span, "`case` needs a value", "no value");
      return std::nullopt;
    }
  } else if (!cursor_.expect(":", "`default`")) {
    return std::nullopt;
  }
  auto body = bodies_.parse_body(word);
  if (!body) return std::nullopt;
  one.body = std::move(*body);
  return one;
}

MaybeStatement StatementParser::parse_return() {
  scanner_.take(LineEnds::blank);
  Return statement;
  if (cursor_.accept(";")) return statement_of(std::move(statement));
  statement.value = expressions_.parse_expression(LineEnds::blank);
  if (!statement.value || !cursor_.expect(";", "the value of `return`")) return std::nullopt;
  return statement_of(std::move(statement));
}

MaybeStatement StatementParser::parse_jump(std::string_view keyword) {
  scanner_.take(LineEnds::blank);
  if (!cursor_.expect(";", "`" + std::string(keyword) + "`")) return std::nullopt;
  return keyword == "break" ? statement_of(Break{}) : statement_of(Continue{});
}

// An assignment or a call.
MaybeStatement StatementParser::parse_simple() {
  cursor_.set_line_ends(LineEnds::blank);
  const Token name = scanner_.peek(LineEnds::blank);
  if (name.kind != TokenKind::name) {
    cursor_.report_unexpected(name, "an assignment or a call");
    return std::nullopt;
  }
  auto target = expressions_.parse_name();
  if (!target) return std::nullopt;
  if (target->node == Node::call) {
    if (!cursor_.expect(closing_, "the call")) return std::nullopt;
    return statement_of(CallStatement{std::move(*target)});
  }
  if (target->node != Node::name && target->node != Node::element) {
    if (reporter_.is_spoilt(name.text)) return std::nullopt;
    reporter_.error("E2001", target->span, "expected an assignment or a call",
                    "not a variable or function");
    return std::nullopt;
  }
  const Token token = scanner_.take(LineEnds::blank);
  const auto combined = combined_operation(token);
  Assignment assignment{std::move(*target), combined, {}};
  if (token.is("++") || token.is("--")) {
    assignment.value.number = 1.0;
    assignment.value.span = token.span;
  } else if (token.is("=") || combined) {
    auto value = expressions_.parse_expression(LineEnds::blank);
    if (!value) return std::nullopt;
    assignment.value = std::move(*value);
  } else {
    const std::string wanted = "`=` or `(` after `" + assignment.target.text + "`";
    const bool is_alone = token.span.line != name.span.line;
    Diagnostic& unexpected =
        is_alone ? reporter_.error("E2001", name.span, "expected " + wanted, "the line ends here")
                 : cursor_.report_unexpected(token, wanted);
    const std::string help = help_for_word(name.text);
    if (!help.empty()) unexpected.help.push_back(help);
    return std::nullopt;
  }
  if (!cursor_.expect(closing_, "the assignment")) return std::nullopt;
  return statement_of(std::move(assignment));
}

}  // namespace stanok::lang
