#include "lang/tree/bracket_parser.h"

#include <utility>

#include "lang/text/number.h"
#include "lang/tree/bracket_operator.h"

namespace stanok::lang {
namespace {

Expression call_of(std::string_view function, const Span& span, Expression argument) {
  Expression call;
  call.node = Node::call;
  call.span = span;
  call.text = function;
  call.children.push_back(std::move(argument));
  return call;
}

}  // namespace

std::optional<std::string_view> bracket_function(std::string_view folded_name) {
  for (const auto& [name, function] : bracket_functions) {
    if (name == folded_name) return function;
  }
  return std::nullopt;
}

// [+|-] unsigned value
MaybeExpression BracketParser::parse_value() {
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  const char sign = scanner_.character();
  if (sign != '+' && sign != '-') return parse_unsigned_value();
  const Span span = scanner_.here();
  scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
  auto operand = parse_value();
  if (!operand) return std::nullopt;
  Expression unary;
  unary.node = Node::unary;
  unary.operation = sign == '-' ? Operation::negate : Operation::identity;
  unary.span = joined(span, operand->span);
  unary.children.push_back(std::move(*operand));
  return unary;
}

MaybeExpression BracketParser::parse_unsigned_value() {
  const char c = scanner_.character();
  if (c == '#') return parse_parameter_reference();
  if (c == '[') return parse_bracket();
  if (is_letter(c)) {
    const std::string_view name = scanner_.name_ahead();
    if (bracket_function(folded(name))) return parse_bracket_function(name);
  }
  const char* const first = source_.text().data() + scanner_.offset();
  const char* const end = source_.text().data() + source_.end();
  const char* at = first;
  Expression number;
  bool whole = false;
  if (!is_digit(c) && c != '.') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "a number");
    return std::nullopt;
  }
  if (!read_number(at, end, number.number, whole)) {
    const bool large = is_digit(c) || is_digit(scanner_.character(1));
    reporter_.error("E1002", scanner_.here(),
                    large ? "the number is too large" : "a number needs a digit",
                    large ? "beyond 1.8e308" : "no digit");
    return std::nullopt;
  }
  number.span = scanner_.here(static_cast<std::uint32_t>(at - first));
  scanner_.advance(static_cast<std::size_t>(at - first));
  return number;
}

// #5, #<name>, ##5, #[...]
MaybeExpression BracketParser::parse_parameter_reference() {
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.advance(1);
  Expression parameter;
  if (scanner_.character() == '<') {
    scanner_.advance(1);
    while (!scanner_.at_line_end() && scanner_.character() != '>') {
      if (!is_blank(scanner_.character())) parameter.text += lower_case(scanner_.character());
      scanner_.advance(1);
    }
    if (scanner_.at_line_end() || parameter.text.empty()) {
      reporter_.error("E2001", scanner_.span_from(start, line), "a parameter name is `#<name>`",
                      "incomplete");
      return std::nullopt;
    }
    scanner_.advance(1);
    parameter.node = Node::named_parameter;
  } else {
    auto number = parse_unsigned_value();
    if (!number) return std::nullopt;
    parameter.node = Node::parameter;
    parameter.children.push_back(std::move(*number));
  }
  parameter.span = scanner_.span_from(start, line);
  return parameter;
}

MaybeExpression BracketParser::parse_bracket() {
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.advance(1);
  auto inner = parse_bracket_binary(0);
  if (!inner) return std::nullopt;
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() != ']') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "an operator or `]`");
    return std::nullopt;
  }
  scanner_.advance(1);
  inner->span = scanner_.span_from(start, line);
  return inner;
}

MaybeExpression BracketParser::parse_bracket_binary(int level) {
  scanner_.skip_blanks(LineEnds::significant);
  if (level == bracket_levels) return parse_value();
  auto left = parse_bracket_binary(level + 1);
  while (left) {
    scanner_.skip_blanks(LineEnds::significant);
    const Token token = scanner_.peek(LineEnds::significant);
    const BracketOperator* const found = find_bracket_operator(folded(token.text));
    if (found == nullptr || found->level != level) break;
    if (!cursor_.count_operator(token.span)) return std::nullopt;
    scanner_.take(LineEnds::significant);
    auto right = parse_bracket_binary(level + 1);
    if (!right) return std::nullopt;
    Expression binary;
    binary.node = Node::binary;
    binary.operation = found->operation;
    binary.span = joined(left->span, right->span);
    binary.children.push_back(std::move(*left));
    binary.children.push_back(std::move(*right));
    left = std::move(binary);
  }
  return left;
}

MaybeExpression BracketParser::parse_bracket_function(std::string_view name) {
  const Span name_span = scanner_.here(static_cast<std::uint32_t>(name.size()));
  const std::string_view function = bracket_function(folded(name)).value_or("");
  scanner_.advance(name.size());
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() != '[') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`[` after the function");
    return std::nullopt;
  }
  auto argument = parse_bracket();
  if (!argument) return std::nullopt;
  Expression call = call_of(function, joined(name_span, argument->span), std::move(*argument));
  if (function == "exists") {
    call.node = Node::exists;
    if (call.children[0].node == Node::named_parameter) return call;
    reporter_.error("E2001", call.span, "EXISTS takes a named parameter", "write EXISTS[#<name>]");
    return std::nullopt;
  }
  if (function != "atan2") return call;
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() == '/') {
    scanner_.advance(1);
    scanner_.skip_blanks(LineEnds::significant);
  }
  if (scanner_.character() != '[') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`/[` after ATAN[...]");
    return std::nullopt;
  }
  auto second = parse_bracket();
  if (!second) return std::nullopt;
  call.span = joined(call.span, second->span);
  call.children.push_back(std::move(*second));
  return call;
}

}  // namespace stanok::lang
