#include "lang/tree/scanner.h"

#include <fast_float/fast_float.h>

#include <array>
#include <cmath>

#include "base/utf8.h"

namespace stanok::lang {
Scanner::Scanner(const Source& source, Reporter& reporter)
    : source_(source),
      reporter_(reporter),
      text_(source.text().substr(0, source.end())),
      offset_(source.begin()),
      line_(source.begin_line()) {}

char Scanner::character(std::size_t ahead) const {
  return offset_ + ahead < text_.size() ? text_[offset_ + ahead] : '\0';
}

bool Scanner::at_line_start() const {
  std::size_t at = offset_;
  while (at > source_.begin() && is_blank(text_[at - 1])) --at;
  return at == source_.begin() || is_line_end(text_[at - 1]);
}

Span Scanner::span_from(std::size_t start, std::uint32_t line) const {
  return {start, static_cast<std::uint32_t>(offset_ - start), line};
}

Span Scanner::here(std::uint32_t length) const {
  return {offset_, length, line_};
}

void Scanner::advance(std::size_t characters) {
  offset_ += characters;
}

void Scanner::move_to(std::size_t offset, std::uint32_t line) {
  offset_ = offset;
  line_ = line;
}

void Scanner::skip_line_end() {
  const bool pair = character() == '\r' && character(1) == '\n';
  offset_ += pair ? 2 : 1;
  ++line_;
}

void Scanner::skip_to_line_end() {
  while (!at_line_end()) ++offset_;
}

void Scanner::skip_line_comment() {
  const std::size_t start = offset_;
  skip_to_line_end();
  check_comment(start, line_);
}

void Scanner::skip_blanks(LineEnds line_ends) {
  while (!at_end()) {
    const char c = character();
    if (is_blank(c)) {
      ++offset_;
    } else if (is_line_end(c)) {
      if (line_ends == LineEnds::significant) return;
      skip_line_end();
    } else if (c == '/' && character(1) == '/') {
      skip_line_comment();
    } else if (c == '/' && character(1) == '*') {
      if (!skip_block_comment()) return;
    } else {
      return;
    }
  }
}

bool Scanner::skip_block_comment() {
  const Span opening = here(2);
  const std::size_t start = offset_;
  const std::uint32_t line = line_;
  const std::size_t close = text_.find("*/", offset_ + 2);
  if (close == std::string_view::npos) {
    reporter_.error("E1006", opening, "the comment is not closed", "`*/` is missing");
    offset_ = text_.size();
    return false;
  }
  while (offset_ < close) {
    if (is_line_end(character())) {
      skip_line_end();
    } else {
      ++offset_;
    }
  }
  offset_ = close + 2;
  check_comment(start, line);
  return true;
}

void Scanner::check_comment(std::size_t start, std::uint32_t line) {
  if (!source_.is_repaired()) return;
  const std::size_t at = text_.substr(0, offset_).find(replacement_character, start);
  if (at == std::string_view::npos) return;
  const auto ends = [&](std::size_t k) { return is_line_end(text_[k]); };
  for (std::size_t k = start; k < at; k += ends(k) && text_.substr(k, 2) == "\r\n" ? 2 : 1)
    line += ends(k) ? 1 : 0;
  const auto length = static_cast<std::uint32_t>(replacement_character.size());
  reporter_.warning("W110", {at, length, line}, "the text is not valid UTF-8", "shown as U+FFFD");
}

// In the dialects of Fanuc a comment goes on to the parenthesis that closes the first one.
std::optional<std::string_view> Scanner::read_parenthesis_comment() {
  const Span opening = here();
  const std::size_t start = ++offset_;
  for (int inner = 0; !at_line_end() && (character() != ')' || inner > 0); ++offset_) {
    if (character() == ')') --inner;
    if (character() != '(') continue;
    ++inner;
    if (source_.rules().is_fanuc()) continue;
    reporter_.error("E1008", here(), "a comment in parentheses cannot contain `(`",
                    "nested comment");
    return std::nullopt;
  }
  if (at_line_end()) {
    reporter_.error("E1006", opening, "the comment is not closed", "`)` is missing on this line");
    return std::nullopt;
  }
  const std::string_view comment = text_.substr(start, offset_ - start);
  check_comment(start, line_);
  ++offset_;
  return comment;
}

std::string_view Scanner::name_ahead() const {
  std::size_t length = 0;
  if (is_name_start(character())) {
    while (is_name_part(character(length))) ++length;
  }
  return text_.substr(std::min(offset_, text_.size()), length);
}

Token Scanner::take(LineEnds line_ends) {
  Token token = peek(line_ends);
  move_to(peeked_end_, peeked_end_line_);
  peeked_.reset();
  return token;
}

Token Scanner::peek(LineEnds line_ends) {
  if (peeked_ && peeked_from_ == offset_ && peeked_mode_ == line_ends) return *peeked_;
  const std::size_t from = offset_;
  const std::uint32_t line = line_;
  Token token = read_token(line_ends);
  peeked_from_ = from;
  peeked_mode_ = line_ends;
  peeked_end_ = offset_;
  peeked_end_line_ = line_;
  move_to(from, line);
  peeked_ = token;
  return token;
}

Token Scanner::read_token(LineEnds line_ends) {
  skip_blanks(line_ends);
  const char c = character();
  Token token;
  token.span = here(0);
  if (at_line_end()) return token;
  if (is_digit(c) || (c == '.' && is_digit(character(1)))) return read_number_token();
  if (c == '"') return read_string_token();
  if (is_name_start(c)) {
    token.kind = TokenKind::name;
    token.text = name_ahead();
    token.span.length = static_cast<std::uint32_t>(token.text.size());
    offset_ += token.text.size();
    return token;
  }
  return read_symbol_token();
}

Token Scanner::read_number_token() {
  Token token;
  token.kind = TokenKind::number;
  const std::size_t start = offset_;
  while (is_digit(character())) ++offset_;
  if (character() == '.') ++offset_;
  while (is_digit(character())) ++offset_;
  if (upper_case(character()) == 'E') {
    const std::size_t sign = character(1) == '+' || character(1) == '-' ? 1 : 0;
    if (is_digit(character(1 + sign))) {
      offset_ += 1 + sign;
      while (is_digit(character())) ++offset_;
    }
  }
  token.span = span_from(start, line_);
  token.text = text_.substr(start, offset_ - start);
  fast_float::from_chars(token.text.data(), token.text.data() + token.text.size(), token.number);
  if (std::isinf(token.number)) {
    reporter_.error("E1002", token.span, "the number is too large", "beyond 1.8e308");
  }
  if (character() == '.' || is_name_part(character())) {
    reporter_.error("E1002", here(), "a number is followed directly by other characters",
                    "not part of a number");
  }
  return token;
}

Token Scanner::read_string_token() {
  Token token;
  token.kind = TokenKind::string;
  const std::size_t start = offset_++;
  while (!at_line_end() && character() != '"') {
    char c = character();
    if (c == '\\') {
      const char escaped = character(1);
      c = escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
      if (escaped != 'n' && escaped != 't' && escaped != '"' && escaped != '\\') {
        reporter_.error("E1005", here(2), "the escape in the string is unknown", "not an escape")
            .help.push_back(R"(use \" \\ \n or \t)");
      }
      ++offset_;
    }
    token.string += c;
    if (!at_line_end()) ++offset_;
  }
  if (at_line_end()) {
    reporter_.error("E1004", span_from(start, line_), "the string is not closed",
                    "`\"` is missing on this line");
  } else {
    ++offset_;
  }
  check_comment(start, line_);
  token.span = span_from(start, line_);
  token.text = text_.substr(start, offset_ - start);
  return token;
}

Token Scanner::read_symbol_token() {
  static constexpr auto pairs = std::to_array<std::string_view>(
      {"**", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "++", "--"});
  Token token;
  token.kind = TokenKind::symbol;
  const std::string_view ahead = text_.substr(offset_, 2);
  std::size_t length = 1;
  for (const std::string_view pair : pairs) {
    if (ahead == pair) length = 2;
  }
  if (length == 1 && static_cast<unsigned char>(ahead[0]) >= 0x80) {
    length = std::max<std::size_t>(character_length(text_, offset_), 1);
  }
  token.text = text_.substr(offset_, length);
  token.span = here(static_cast<std::uint32_t>(length));
  offset_ += length;
  return token;
}

}  // namespace stanok::lang
