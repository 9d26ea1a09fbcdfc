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

// Brought to 0 to 360 deg.
Expression wrapped_angle(Expression angle) {
  const Span span = angle.span;
  return call_of("wrap360", span, std::move(angle));
}

Expression binary(Operation operation, Expression left, Expression right) {
  Expression made;
  made.node = Node::binary;
  made.operation = operation;
  made.span = joined(left.span, right.span);
  made.children.push_back(std::move(left));
  made.children.push_back(std::move(right));
  return made;
}

Expression whole_part(Expression number) {
  const Span span = number.span;
  return call_of("trunc", span, std::move(number));
}

// Words whose values are whole numbers.
constexpr std::string_view counted_words = "DGHLMNOPST";
constexpr std::string_view angle_words = "ABC";

// Folded, without the number that may follow directly: `#1EQ0`.
std::string operator_name(const Token& token) {
  std::string name = folded(token.text);
  // Brackets have no `++` and `--`: the second sign is that of the operand.
  if (name == "++" || name == "--") name.pop_back();
  if (token.kind != TokenKind::name) return name;
  return name.substr(0, name.find_first_of("0123456789"));
}

}  // namespace

bool is_bracket_function(std::string_view folded_name) {
  constexpr TextRules fanuc{Dialect::fanuc, CodeSystem::b};
  return find_bracket_function(folded_name, fanuc) != nullptr;
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
  if (c == '#') {
    auto parameter = parse_parameter_reference();
    const bool stays_vacant = parameter && source_.rules().is_fanuc();
    if (stays_vacant && parameter->node == Node::parameter)
      parameter->node = Node::vacant_parameter;
    return parameter;
  }
  if (c == '[') return parse_bracket();
  if (is_letter(c)) {
    const std::string_view name = scanner_.name_ahead();
    if (find_bracket_function(folded(name), source_.rules()) != nullptr)
      return parse_bracket_function(name);
  }
  const char* const first = source_.text().data() + scanner_.offset();
  const char* const end = source_.text().data() + source_.end();
  const char* at = first;
  Expression number;
  bool whole = false;
  if (static_cast<unsigned char>(c) >= 0x80) {
    report_illegal_character(cursor_);
    return std::nullopt;
  }
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

// #5, #<name>, ##5, #[...]; blanks behind the sign say nothing, as between all words.
MaybeExpression BracketParser::parse_parameter_reference() {
  TokenCursor::Nesting nesting(cursor_);
  if (!nesting.allowed()) return std::nullopt;
  const std::size_t start = scanner_.offset();
  const std::uint32_t line = scanner_.line();
  scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
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
  auto inner = parse_inside();
  if (!inner || !close_bracket()) return std::nullopt;
  inner->span = scanner_.span_from(start, line);
  return inner;
}

// An expression in brackets. Comments between its words say nothing; behind the value of a
// parameter they may be a message: `#3000=1 (NO TOOL)`.
MaybeExpression BracketParser::parse_inside() {
  scanner_.advance(1);
  ++open_;
  auto inner = parse_bracket_binary(0);
  if (inner && !skip_comments()) inner.reset();
  --open_;
  return inner;
}

// False, with a report: one is at fault.
bool BracketParser::skip_comments() {
  scanner_.skip_blanks(LineEnds::significant);
  while (open_ > 0 && scanner_.character() == '(') {
    if (!scanner_.read_parenthesis_comment()) return false;
    scanner_.skip_blanks(LineEnds::significant);
  }
  return true;
}

bool BracketParser::close_bracket() {
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() != ']') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "an operator or `]`");
    return false;
  }
  scanner_.advance(1);
  return true;
}

MaybeExpression BracketParser::parse_bracket_binary(int level) {
  if (!skip_comments()) return std::nullopt;
  if (level == bracket_levels) return parse_value();
  auto left = parse_bracket_binary(level + 1);
  for (bool compared = false; left; compared = level == comparison_level) {
    if (!skip_comments()) return std::nullopt;
    const Token token = scanner_.peek(LineEnds::significant);
    const BracketOperator* const found =
        find_leading_operator(operator_name(token), source_.rules());
    if (found == nullptr || found->level != level) break;
    if (compared && source_.rules().is_fanuc() && refuse_chain(token)) return std::nullopt;
    if (!cursor_.count_operator(token.span)) return std::nullopt;
    scanner_.advance(found->name.size());
    auto right = parse_bracket_binary(level + 1);
    if (!right) return std::nullopt;
    if (takes_whole_part(found->operation, source_.rules())) {
      left = whole_part(std::move(*left));
      right = whole_part(std::move(*right));
    }
    left = binary(found->operation, std::move(*left), std::move(*right));
  }
  return left;
}

// AND binds stronger than EQ there: `[#1 EQ 0 AND #2 EQ 1]` is not what it looks like.
bool BracketParser::refuse_chain(const Token& comparison) {
  reporter_.error("E2008", comparison.span, "comparisons do not chain", "second comparison")
      .help.emplace_back("put each comparison in brackets: `[[#1 EQ 0] AND [#2 EQ 1]]`");
  return true;
}

MaybeExpression BracketParser::parse_condition() {
  auto number = parse_bracket();
  return number ? MaybeExpression(truth_of(std::move(*number))) : std::nullopt;
}

Expression truth_of(Expression number) {
  const Span span = number.span;
  return binary(Operation::not_equal, std::move(number), number_expression(0.0, span));
}

MaybeExpression BracketParser::parse_word_value(char letter) {
  word_ = letter;
  auto value = parse_value();
  word_ = 0;
  return value;
}

// round (argument * scale) / scale; a length has ten times as many increments in an inch as in a
// millimetre.
Expression BracketParser::rounded_to_increment(Expression argument, const Span& span) const {
  constexpr double per_mm = 1000.0;
  constexpr double more_per_inch = 9000.0;
  Expression scale = number_expression(per_mm, span);
  if (angle_words.find(word_) == std::string_view::npos) {
    Expression in_inches;
    in_inches.node = Node::named_parameter;
    in_inches.text = "_imperial";
    in_inches.span = span;
    scale = binary(
        Operation::add, std::move(scale),
        binary(Operation::multiply, std::move(in_inches), number_expression(more_per_inch, span)));
  }
  Expression counted = binary(Operation::multiply, std::move(argument), scale);
  return binary(Operation::divide, call_of("round", span, std::move(counted)), std::move(scale));
}

MaybeExpression BracketParser::parse_bracket_function(std::string_view name) {
  const Span name_span = scanner_.here(static_cast<std::uint32_t>(name.size()));
  const BracketFunction& row = *find_bracket_function(folded(name), source_.rules());
  const std::string_view function = row.function;
  scanner_.advance(name.size());
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() != '[') {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`[` after the function");
    return std::nullopt;
  }
  const bool may_have_two = function == "atan2" || function == "pow";
  if (may_have_two && source_.rules().is_fanuc()) return parse_function_of_two(row, name_span);
  auto argument = parse_bracket();
  if (!argument) return std::nullopt;
  const bool to_increment = function == "round" && word_ != 0 && source_.rules().is_fanuc() &&
                            counted_words.find(word_) == std::string_view::npos;
  if (to_increment) {
    const Span whole = joined(name_span, argument->span);
    return rounded_to_increment(std::move(*argument), whole);
  }
  Expression call = call_of(function, joined(name_span, argument->span), std::move(*argument));
  if (function == "exists") {
    call.node = Node::exists;
    if (call.children[0].node == Node::named_parameter) return call;
    if (call.children[0].node == Node::parameter) {
      // As far as their numbers go, all of them do.
      constexpr double last = 5602.0;
      const Expression& n = call.children[0].children[0];
      return binary(Operation::bracket_and,
                    binary(Operation::bracket_greater_equal, n, number_expression(1.0, call.span)),
                    binary(Operation::bracket_less_equal, n, number_expression(last, call.span)));
    }
    reporter_.error("E2001", call.span, "EXISTS takes a named parameter", "write EXISTS[#<name>]");
    return std::nullopt;
  }
  if (function == "atan2") return parse_arc_tangent(std::move(call));
  return row.wraps ? wrapped_angle(std::move(call)) : std::move(call);
}

// POW[a,b], ATAN[a,b], and ATAN[a] with or without /[b].
MaybeExpression BracketParser::parse_function_of_two(const BracketFunction& row,
                                                     const Span& name_span) {
  auto first = parse_inside();
  if (!first) return std::nullopt;
  Expression call = call_of(row.function, joined(name_span, first->span), std::move(*first));
  scanner_.skip_blanks(LineEnds::significant);
  const bool has_two = scanner_.character() == ',';
  if (!has_two && row.function == "pow") {
    cursor_.report_unexpected(scanner_.peek(LineEnds::significant), "`,` and the exponent");
    return std::nullopt;
  }
  if (has_two) {
    auto second = parse_inside();
    if (!second) return std::nullopt;
    call.span = joined(call.span, second->span);
    call.children.push_back(std::move(*second));
  }
  if (!close_bracket()) return std::nullopt;
  MaybeExpression made = has_two ? std::move(call) : parse_arc_tangent(std::move(call));
  return made && row.wraps && made->text != "atan" ? wrapped_angle(std::move(*made))
                                                   : std::move(made);
}

// ATAN[a]/[b]; in the Fanuc dialect also of one value.
MaybeExpression BracketParser::parse_arc_tangent(Expression call) {
  scanner_.skip_blanks(LineEnds::significant);
  std::size_t behind = 1;
  while (is_blank(scanner_.character(behind))) ++behind;
  const bool divided = scanner_.character() == '/' && scanner_.character(behind) == '[';
  if (source_.rules().is_fanuc() && !divided && scanner_.character() != '[') {
    call.text = "atan";
    return call;
  }
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
