// Reads a program text piece by piece: blanks, comments, tokens of high-level text.
//
// Where a piece ends depends on what it stands in (an ISO block ends with its line, ( is a comment
// or a group), so the parser drives the scanner and says what it expects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/reporter.h"
#include "lang/text/source.h"

namespace stanok::lang {

enum class TokenKind : std::uint8_t { end, number, string, name, symbol };

struct Token {
  TokenKind kind = TokenKind::end;  // end: of the text, or of the line in line mode
  Span span;
  std::string_view text;  // as written
  double number = 0.0;
  std::string string;  // the value of a string token, escapes resolved

  [[nodiscard]] bool is(std::string_view symbol) const {
    return kind == TokenKind::symbol && text == symbol;
  }
};

// In high-level text a line end is a blank; in blocks and directives it ends the statement.
enum class LineEnds : std::uint8_t { blank, significant };

class Scanner {
 public:
  Scanner(const Source& source, Reporter& reporter);

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::uint32_t line() const { return line_; }
  [[nodiscard]] bool at_end() const { return offset_ >= source_.end(); }
  // The character `ahead` of here; NUL behind the end.
  [[nodiscard]] char character(std::size_t ahead = 0) const;
  [[nodiscard]] bool at_line_end() const { return at_end() || is_line_end(character()); }
  // Nothing but blanks between the beginning of the line and here.
  [[nodiscard]] bool at_line_start() const;
  // The span from `start` (on `line`) to here.
  [[nodiscard]] Span span_from(std::size_t start, std::uint32_t line) const;
  // A span of `length` characters from here.
  [[nodiscard]] Span here(std::uint32_t length = 1) const;

  void advance(std::size_t characters);
  // Goes to an offset further on that lies on `line`.
  void move_to(std::size_t offset, std::uint32_t line);
  // Blanks and // and /* */ comments; the last may span lines. In line mode line ends stop it.
  void skip_blanks(LineEnds line_ends);
  void skip_to_line_end();
  // A comment that goes to the line end.
  void skip_line_comment();
  // Over the line end (LF, CRLF or CR) at which the scanner stands.
  void skip_line_end();
  // A ( ) comment from its opening parenthesis; its text, or nothing when it does not close.
  std::optional<std::string_view> read_parenthesis_comment();

  // The next token, consumed or only looked at.
  Token take(LineEnds line_ends);
  Token peek(LineEnds line_ends);

  // Letters, digits and _ from here; empty if no name begins here.
  [[nodiscard]] std::string_view name_ahead() const;

 private:
  bool skip_block_comment();
  // Of the text from `start` to the end of what was read; `line` is that of `start`.
  void check_comment(std::size_t start, std::uint32_t line);
  Token read_token(LineEnds line_ends);
  Token read_number_token();
  Token read_string_token();
  Token read_symbol_token();

  const Source& source_;
  Reporter& reporter_;
  std::string_view text_;  // up to the end of what is read
  std::size_t offset_ = 0;
  std::uint32_t line_ = 1;

  // The token looked at last, its start, and where it ends.
  std::optional<Token> peeked_;
  std::size_t peeked_from_ = 0;
  LineEnds peeked_mode_ = LineEnds::blank;
  std::size_t peeked_end_ = 0;
  std::uint32_t peeked_end_line_ = 1;
};

}  // namespace stanok::lang
