#include "lang/tree/expression_parser.h"

#include <array>
#include <utility>

#include "lang/text/limits.h"
#include "lang/tree/builtin.h"
#include "lang/tree/keywords.h"

namespace stanok::lang {
namespace {

struct BinaryOperator {
  std::string_view symbol;
  int level;  // 0 binds weakest
  Operation operation;
};

constexpr auto binary_operators = std::to_array<BinaryOperator>({
    {"||", 0, Operation::logical_or},
    {"&&", 1, Operation::logical_and},
    {"==", 2, Operation::equal},
    {"!=", 2, Operation::not_equal},
    {"<", 3, Operation::less},
    {"<=", 3, Operation::less_equal},
    {">", 3, Operation::greater},
    {">=", 3, Operation::greater_equal},
    {"+", 4, Operation::add},
    {"-", 4, Operation::subtract},
    {"*", 5, Operation::multiply},
    {"/", 5, Operation::divide},
    {"%", 5, Operation::modulo},
});
constexpr int level_count = 6;

const BinaryOperator* operator_at(const Token& token, int level) {
  if (token.kind != TokenKind::symbol) return nullptr;
  for (const BinaryOperator& candidate : binary_operators) {
    if (candidate.level == level && candidate.symbol == token.text) return &candidate;
  }
  return nullptr;
}

bool is_level_of_comparison(int level) {
  return level == 2 || level == 3;
}

Expression unary_of(Operation operation, const Span& span, Expression operand) {
  Expression unary;
  unary.node = Node::unary;
  unary.operation = operation;
  unary.span = joined(span, operand.span);
  unary.children.push_back(std::move(operand));
  return unary;
}

Expression binary_of(Operation operation, Expression left, Expression right) {
  Expression binary;
  binary.node = Node::binary;
  binary.operation = operation;
  binary.span = joined(left.span, right.span);
  binary.children.push_back(std::move(left));
  binary.children.push_back(std::move(right));
  return binary;
}

// X, X2, R5: one letter and digits.
bool is_letter_with_index(std::string_view name) {
  for (const char c : name.substr(1)) {
    if (!is_digit(c)) return false;
  }
  return is_letter(name[0]);
}

}  // namespace

MaybeExpression ExpressionParser::parse_expression(LineEnds line_ends) {
  const LineEnds outer = cursor_.line_ends();
  cursor_.set_line_ends(line_ends);
  if (cursor_.nesting() == 0) cursor_.begin_operators();
  auto expression = parse_conditional();
  cursor_.set_line_ends(outer);
  return expression;
}

MaybeExpression ExpressionParser::parse_conditional() {
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  auto condition = parse_binary(0);
  if (!condition || !cursor_.accept("?")) return condition;
  auto first = parse_conditional();
  if (!first || !cursor_.expect(":", "the first value of `?`")) return std::nullopt;
  auto second = parse_conditional();
  if (!second) return std::nullopt;
  Expression conditional;
  conditional.node = Node::conditional;
  conditional.span = joined(condition->span, second->span);
  conditional.children.push_back(std::move(*condition));
  conditional.children.push_back(std::move(*first));
  conditional.children.push_back(std::move(*second));
  return conditional;
}

MaybeExpression ExpressionParser::parse_binary(int level) {
  if (level == level_count) return parse_unary();
  auto left = parse_binary(level + 1);
  for (int count = 0; left; ++count) {
    const Token token = scanner_.peek(cursor_.line_ends());
    const BinaryOperator* const found = operator_at(token, level);
    if (found == nullptr) break;
    if (count > 0 && is_level_of_comparison(level)) {
      reporter_.error("E2008", token.span, "comparisons do not chain", "second comparison")
          .help.push_back("join them with `&&`, e.g. `aa < bb && bb < cc`");
      return std::nullopt;
    }
    if (!cursor_.count_operator(token.span)) return std::nullopt;
    scanner_.take(cursor_.line_ends());
    auto right = parse_binary(level + 1);
    if (!right) return std::nullopt;
    left = binary_of(found->operation, std::move(*left), std::move(*right));
  }
  return left;
}

MaybeExpression ExpressionParser::parse_unary() {
  const Token token = scanner_.peek(cursor_.line_ends());
  const bool minus = token.is("-");
  if (!minus && !token.is("+") && !token.is("!")) return parse_power();
  scanner_.take(cursor_.line_ends());
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  auto operand = parse_unary();
  if (!operand) return std::nullopt;
  const Operation operation = minus           ? Operation::negate
                              : token.is("+") ? Operation::identity
                                              : Operation::logical_not;
  return unary_of(operation, token.span, std::move(*operand));
}

// a ** b, from right to left; binds stronger than a sign before it.
MaybeExpression ExpressionParser::parse_power() {
  auto base = parse_primary();
  if (!base || !cursor_.accept("**")) return base;
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  auto exponent = parse_unary();
  if (!exponent) return std::nullopt;
  return binary_of(Operation::power, std::move(*base), std::move(*exponent));
}

MaybeExpression ExpressionParser::parse_primary() {
  scanner_.skip_blanks(cursor_.line_ends());
  const char c = scanner_.character();
  if (c == '#') return brackets_.parse_parameter_reference();
  if (c == '$') return parse_system_variable();
  if (c == '(') return parse_group();
  const Token token = scanner_.peek(cursor_.line_ends());
  if (token.kind == TokenKind::name) return parse_name();
  Expression literal;
  literal.span = token.span;
  if (token.kind == TokenKind::number) {
    literal.number = token.number;
  } else if (token.kind == TokenKind::string) {
    literal.node = Node::string;
    literal.text = token.string;
  } else {
    cursor_.report_unexpected(token, "a value");
    return std::nullopt;
  }
  scanner_.take(cursor_.line_ends());
  return literal;
}

MaybeExpression ExpressionParser::parse_group() {
  scanner_.take(cursor_.line_ends());
  auto inner = parse_conditional();
  if (!inner || !cursor_.expect(")", "the expression")) return std::nullopt;
  return inner;
}

// Where an operator may stand, ( is a comment unless a function name stands before it.
bool ExpressionParser::is_call(const Token& name) {
  if (!scanner_.peek(cursor_.line_ends()).is("(")) return false;
  if (cursor_.line_ends() == LineEnds::blank) return true;
  const std::string wanted = folded(name.text);
  return find_builtin(wanted) != nullptr || functions_.contains(wanted);
}

MaybeExpression ExpressionParser::parse_name() {
  const Token name = scanner_.take(cursor_.line_ends());
  const std::string wanted = folded(name.text);
  Expression expression;
  expression.span = name.span;
  expression.text = name.text;
  if (wanted == "true" || wanted == "false") {
    expression.node = Node::boolean;
    expression.number = wanted == "true" ? 1.0 : 0.0;
    return expression;
  }
  if (is_keyword(wanted)) {
    cursor_.report_unexpected(name, "a value");
    return std::nullopt;
  }
  if (is_letter_with_index(name.text)) {
    const bool r_parameter = wanted[0] == 'r' && wanted.size() > 1;
    expression.node = r_parameter ? Node::r_parameter : Node::axis;
    for (const char digit : wanted.substr(1)) {
      expression.number = expression.number * 10.0 + (digit - '0');
    }
    return expression;
  }
  if (is_call(name)) {
    scanner_.take(cursor_.line_ends());
    expression.node = Node::call;
    if (!parse_list(")", expression.children)) return std::nullopt;
    return expression;
  }
  expression.node = Node::name;
  if (!scanner_.peek(cursor_.line_ends()).is("[")) return expression;
  expression.node = Node::element;
  while (cursor_.accept("[")) {
    auto index = parse_conditional();
    if (!index || !cursor_.expect("]", "the index")) return std::nullopt;
    expression.children.push_back(std::move(*index));
  }
  return expression;
}

// $name or $name[index]
MaybeExpression ExpressionParser::parse_system_variable() {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.advance(1);
  const std::string_view name = scanner_.name_ahead();
  if (name.empty()) {
    cursor_.report_unexpected(scanner_.peek(cursor_.line_ends()),
                              "the name of a system variable after `$`");
    return std::nullopt;
  }
  scanner_.advance(name.size());
  Expression variable;
  variable.node = Node::system_variable;
  variable.text = folded(name);
  variable.span = scanner_.span_from(start, line);
  if (cursor_.accept("[")) {
    auto index = parse_conditional();
    if (!index || !cursor_.expect("]", "the index")) return std::nullopt;
    variable.children.push_back(std::move(*index));
  }
  return variable;
}

// expressions separated by commas, up to and with `close`
bool ExpressionParser::parse_list(std::string_view close, std::vector<Expression>& list) {
  if (cursor_.accept(close)) return true;
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  bool good = true;
  do {
    auto element = parse_conditional();
    good = element.has_value() && cursor_.check_length(start, line);
    if (good) list.push_back(std::move(*element));
  } while (good && cursor_.accept(","));
  return good && cursor_.expect(close, "the last value");
}

}  // namespace stanok::lang
