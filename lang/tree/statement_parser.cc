// High-level statements: bodies, conditions, loops, assignments and calls.
#include <array>
#include <utility>

#include "lang/text/limits.h"
#include "lang/tree/parser.h"

namespace stanok::lang {
namespace {

constexpr auto keywords = std::to_array<std::string_view>(
    {"if",     "else", "while", "for",    "do",   "switch", "case",  "default", "break", "continue",
     "return", "num",  "bool",  "string", "axis", "void",   "const", "shared",  "true",  "false"});

constexpr auto reserved_words = std::to_array<std::string_view>(
    {"repeat", "until", "goto", "extern", "struct", "enum", "import", "export", "persist"});

std::optional<Operation> combined_operation(const Token& token) {
  if (token.is("+=") || token.is("++")) return Operation::add;
  if (token.is("-=") || token.is("--")) return Operation::subtract;
  if (token.is("*=")) return Operation::multiply;
  if (token.is("/=")) return Operation::divide;
  return std::nullopt;
}

}  // namespace

bool is_keyword(std::string_view folded_name) {
  for (const std::string_view word : keywords) {
    if (word == folded_name) return true;
  }
  return false;
}

bool is_reserved_word(std::string_view folded_name) {
  for (const std::string_view word : reserved_words) {
    if (word == folded_name) return true;
  }
  return false;
}

std::optional<Type> type_of_keyword(std::string_view folded_name) {
  if (folded_name == "num") return Type::number;
  if (folded_name == "bool") return Type::boolean;
  if (folded_name == "string") return Type::string;
  if (folded_name == "axis") return Type::axis;
  if (folded_name == "void") return Type::none;
  return std::nullopt;
}

Parser::MaybeStatement Parser::parse_keyword(std::string_view keyword) {
  line_ends_ = LineEnds::blank;
  if (keyword == "if") return parse_if();
  if (keyword == "while") return parse_while();
  if (keyword == "do") return parse_do();
  if (keyword == "for") return parse_for();
  if (keyword == "switch") return parse_switch();
  if (keyword == "return") return parse_return();
  if (keyword == "break" || keyword == "continue") return parse_jump(keyword);
  report_unexpected(scanner_.peek(LineEnds::blank), "a statement");
  return std::nullopt;
}

// { statements }
std::optional<StatementList> Parser::parse_body(std::string_view of) {
  line_ends_ = LineEnds::blank;
  const Token open = scanner_.peek(LineEnds::blank);
  if (!open.is("{")) {
    reporter_
        .error("E2020", open.span, "the body of `" + std::string(of) + "` needs braces",
               "expected `{`")
        .help.push_back("write `" + std::string(of) + " ... { ... }`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  if (brace_depth_ + o_depth_ >= limits::nesting) {
    reporter_.error("E2030", open.span, "more than 64 nested braces", "too deep");
    return std::nullopt;
  }
  StatementList body;
  ++brace_depth_;
  scanner_.skip_blanks(LineEnds::significant);
  while (!scanner_.at_end() && scanner_.character() != '}') {
    parse_statement(body);
    if (!scanner_.at_line_end()) scanner_.skip_blanks(LineEnds::significant);
  }
  --brace_depth_;
  line_ends_ = LineEnds::blank;
  if (scanner_.at_end()) {
    reporter_.error("E2003", open.span, "`{` is not closed", "`}` is missing");
    return std::nullopt;
  }
  scanner_.advance(1);
  return body;
}

Parser::MaybeStatement Parser::parse_compound() {
  auto body = parse_body("compound");
  if (!body) return std::nullopt;
  return statement_of(Compound{std::move(*body)});
}

// ( condition )
Parser::MaybeExpression Parser::parse_condition() {
  line_ends_ = LineEnds::blank;
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  if (!expect("(", "the keyword")) return std::nullopt;
  auto condition = parse_expression(LineEnds::blank);
  if (!condition || !expect(")", "the condition")) return std::nullopt;
  if (!check_length(start, line)) return std::nullopt;
  return condition;
}

Parser::MaybeStatement Parser::parse_if() {
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  auto then_body = parse_body("if");
  if (!then_body) return std::nullopt;
  If statement{std::move(*condition), std::move(*then_body), {}};
  const Token token = scanner_.peek(LineEnds::blank);
  if (token.kind != TokenKind::name || folded(token.text) != "else") {
    return statement_of(std::move(statement));
  }
  scanner_.take(LineEnds::blank);
  const Token next = scanner_.peek(LineEnds::blank);
  if (next.kind == TokenKind::name && folded(next.text) == "if") {
    if (else_if_depth_ >= limits::else_ifs) {
      reporter_.error("E2031", next.span, "more than 1000 `else if` in a row", "one too many");
      return std::nullopt;
    }
    ++else_if_depth_;
    auto other = parse_if();
    --else_if_depth_;
    if (!other) return std::nullopt;
    other->span = next.span;
    statement.else_body.push_back(std::move(*other));
  } else {
    auto else_body = parse_body("else");
    if (!else_body) return std::nullopt;
    statement.else_body = std::move(*else_body);
  }
  return statement_of(std::move(statement));
}

Parser::MaybeStatement Parser::parse_while() {
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition) return std::nullopt;
  auto body = parse_body("while");
  if (!body) return std::nullopt;
  return statement_of(While{std::move(*condition), std::move(*body), {}});
}

Parser::MaybeStatement Parser::parse_do() {
  scanner_.take(LineEnds::blank);
  auto body = parse_body("do");
  if (!body) return std::nullopt;
  const Token token = scanner_.peek(LineEnds::blank);
  if (token.kind != TokenKind::name || folded(token.text) != "while") {
    report_unexpected(token, "`while` after the body of `do`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  auto condition = parse_condition();
  if (!condition || !expect(";", "the condition of `do`")) return std::nullopt;
  return statement_of(DoWhile{std::move(*body), std::move(*condition), {}});
}

Parser::MaybeStatement Parser::parse_for() {
  const std::size_t begin = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.take(LineEnds::blank);
  if (!expect("(", "`for`")) return std::nullopt;
  For loop;
  if (!accept(";")) {
    const Token first = scanner_.peek(LineEnds::blank);
    scanner_.skip_blanks(LineEnds::blank);
    const bool declares = type_of_keyword(folded(first.text)).has_value();
    auto start = declares ? parse_declaration_or_function() : parse_simple();
    if (!start) return std::nullopt;
    start->span = first.span;
    loop.start.push_back(std::move(*start));
  }
  if (!accept(";")) {
    loop.condition = parse_expression(LineEnds::blank);
    if (!loop.condition || !expect(";", "the condition of `for`")) return std::nullopt;
  }
  if (!accept(")")) {
    const Span span = scanner_.peek(LineEnds::blank).span;
    // A simple statement without its `;`: the parenthesis ends it.
    closing_ = ")";
    auto step = parse_simple();
    closing_ = ";";
    if (!step) return std::nullopt;
    step->span = span;
    loop.step.push_back(std::move(*step));
  }
  if (!check_length(begin, line)) return std::nullopt;
  auto body = parse_body("for");
  if (!body) return std::nullopt;
  loop.body = std::move(*body);
  return statement_of(std::move(loop));
}

Parser::MaybeStatement Parser::parse_switch() {
  scanner_.take(LineEnds::blank);
  auto value = parse_condition();
  if (!value || !expect("{", "`switch ( )`")) return std::nullopt;
  Switch statement{std::move(*value), {}};
  while (!accept("}")) {
    auto next = parse_case();
    if (!next) return std::nullopt;
    statement.cases.push_back(std::move(*next));
  }
  return statement_of(std::move(statement));
}

// case 1, 2: { }   default: { }
std::optional<SwitchCase> Parser::parse_case() {
  const Token token = scanner_.peek(LineEnds::blank);
  const std::string word = folded(token.text);
  SwitchCase one;
  one.span = token.span;
  if (word != "case" && word != "default") {
    report_unexpected(token, "`case`, `default` or `}`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  if (word == "case") {
    if (!parse_list(":", one.values)) return std::nullopt;
    if (one.values.empty()) {
      reporter_.error("E2001", token.span, "`case` needs a value", "no value");
      return std::nullopt;
    }
  } else if (!expect(":", "`default`")) {
    return std::nullopt;
  }
  auto body = parse_body(word);
  if (!body) return std::nullopt;
  one.body = std::move(*body);
  return one;
}

Parser::MaybeStatement Parser::parse_return() {
  scanner_.take(LineEnds::blank);
  Return statement;
  if (accept(";")) return statement_of(std::move(statement));
  statement.value = parse_expression(LineEnds::blank);
  if (!statement.value || !expect(";", "the value of `return`")) return std::nullopt;
  return statement_of(std::move(statement));
}

Parser::MaybeStatement Parser::parse_jump(std::string_view keyword) {
  scanner_.take(LineEnds::blank);
  if (!expect(";", "`" + std::string(keyword) + "`")) return std::nullopt;
  return keyword == "break" ? statement_of(Break{}) : statement_of(Continue{});
}

// An assignment or a call.
Parser::MaybeStatement Parser::parse_simple() {
  line_ends_ = LineEnds::blank;
  const Token name = scanner_.peek(LineEnds::blank);
  if (name.kind != TokenKind::name) {
    report_unexpected(name, "an assignment or a call");
    return std::nullopt;
  }
  auto target = parse_name();
  if (!target) return std::nullopt;
  if (target->node == Node::call) {
    if (!expect(closing_, "the call")) return std::nullopt;
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
    auto value = parse_expression(LineEnds::blank);
    if (!value) return std::nullopt;
    assignment.value = std::move(*value);
  } else {
    report_unexpected(token, "`=` or `(` after `" + assignment.target.text + "`");
    return std::nullopt;
  }
  if (!expect(closing_, "the assignment")) return std::nullopt;
  return statement_of(std::move(assignment));
}

}  // namespace stanok::lang
