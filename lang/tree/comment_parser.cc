#include "lang/tree/comment_parser.h"

#include <utility>

#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// #5 or #<name> at the beginning of `text`; the length taken, 0 if there is none.
std::size_t read_comment_parameter(std::string_view text, const Span& span, Expression& parameter) {
  parameter = {};
  parameter.span = span;
  if (text.size() > 1 && text[1] == '<') {
    const std::size_t close = text.find('>');
    if (close == std::string_view::npos) return 0;
    parameter.node = Node::named_parameter;
    for (const char c : text.substr(2, close - 2)) {
      if (!is_blank(c)) parameter.text += lower_case(c);
    }
    return parameter.text.empty() ? 0 : close + 1;
  }
  std::size_t length = 1;
  Expression number;
  for (; length < text.size() && is_digit(text[length]); ++length) {
    number.number = number.number * 10.0 + (text[length] - '0');
  }
  number.span = span;
  parameter.node = Node::parameter;
  parameter.children.push_back(std::move(number));
  return length == 1 ? 0 : length;
}

// %d, %.2f at the beginning of `text`: sets `decimals`; the length taken, 0 if there is none.
std::size_t read_format(std::string_view text, int& decimals) {
  if (text.starts_with("%d")) {
    decimals = 0;
    return 2;
  }
  if (text.starts_with("%f")) {
    decimals = 6;
    return 2;
  }
  if (text.size() < 4 || text[1] != '.' || !is_digit(text[2]) || lower_case(text[3]) != 'f') {
    return 0;
  }
  decimals = text[2] - '0';
  return 4;
}

// The text of (DEBUG,...) and (PRINT,...) with its parameters put in.
Expression comment_text(std::string_view text, const Span& span) {
  Expression whole = string_expression("", span);
  std::string literal;
  int decimals = 6;
  for (std::size_t at = 0; at < text.size();) {
    Expression parameter;
    std::size_t length = 0;
    if (text[at] == '#') length = read_comment_parameter(text.substr(at), span, parameter);
    if (length != 0) {
      whole = concatenated(std::move(whole), string_expression(literal, span));
      whole = concatenated(std::move(whole), as_text(std::move(parameter), decimals));
      literal.clear();
    } else if (text[at] == '%') {
      length = read_format(text.substr(at), decimals);
    }
    if (length == 0) literal += text[at++];
    at += length;
  }
  return concatenated(std::move(whole), string_expression(literal, span));
}

}  // namespace

Expression string_expression(std::string text, const Span& span) {
  Expression expression;
  expression.node = Node::string;
  expression.span = span;
  expression.text = std::move(text);
  return expression;
}

Expression concatenated(Expression left, Expression right) {
  Expression sum;
  sum.node = Node::binary;
  sum.operation = Operation::add;
  sum.span = left.span;
  sum.children.push_back(std::move(left));
  sum.children.push_back(std::move(right));
  return sum;
}

Expression as_text(Expression value, int decimals) {
  Expression count;
  count.number = decimals;
  count.span = value.span;
  Expression call;
  call.node = Node::call;
  call.span = value.span;
  call.text = "str";
  call.children.push_back(std::move(value));
  call.children.push_back(std::move(count));
  return call;
}

bool parse_comment(TokenCursor& cursor, IsoBlock& block) {
  const Span span = cursor.scanner().here();
  const auto comment = cursor.scanner().read_parenthesis_comment();
  if (!comment) return false;
  block.remark = trimmed(*comment);
  const std::size_t comma = comment->find(',');
  if (comma == std::string_view::npos) return true;
  if (comment->size() > limits::block_bytes) {
    cursor.reporter().error("E1007", span, "a comment with a comma is longer than 4096 bytes",
                            "too long");
    return false;
  }
  const std::string word = folded(trimmed(comment->substr(0, comma)));
  const std::string_view text = comment->substr(comma + 1);
  // (LOGOPEN,file), (LOGAPPEND,file) and (LOGCLOSE) say nothing: the log is open always.
  if (word == "msg") {
    block.comments.push_back(
        {Message::Kind::message, string_expression(std::string(trimmed(text)), span)});
  } else if (word == "debug" || word == "print" || word == "log") {
    const auto kind = word == "debug" ? Message::Kind::message : Message::Kind::log;
    block.comments.push_back({kind, comment_text(trimmed(text), span)});
  } else if (word == "abort" && !cursor.source().rules().is_fanuc()) {
    block.comments.push_back({Message::Kind::message, comment_text(trimmed(text), span), true});
  }
  return true;
}

}  // namespace stanok::lang
