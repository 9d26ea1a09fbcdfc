#include "lang/tree/token_cursor.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/text/limits.h"

namespace stanok::lang {

bool TokenCursor::at_statement_end() const {
  return scanner_.at_line_end() || (scanner_.character() == '}' && inside_braces());
}

bool TokenCursor::at_body_end() const {
  return scanner_.at_end() || (scanner_.character() == '}' && inside_braces());
}

bool TokenCursor::accept(std::string_view symbol) {
  if (!scanner_.peek(line_ends_).is(symbol)) return false;
  scanner_.take(line_ends_);
  return true;
}

bool TokenCursor::expect(std::string_view symbol, std::string_view after) {
  if (accept(symbol)) return true;
  const Token token = scanner_.peek(line_ends_);
  const std::string wanted = "`" + std::string(symbol) + "` after " + std::string(after);
  if (symbol == ";" && token.span.line != scanner_.line() && scanner_.offset() > 0) {
    const Span end{scanner_.offset() - 1, 1, scanner_.line()};
    reporter_.error("E2001", end, "expected " + wanted + ", found the end of the line",
                    "`;` is missing after this");
    return false;
  }
  report_unexpected(token, wanted);
  return false;
}

Diagnostic& TokenCursor::report_unexpected(const Token& token, std::string_view expected) {
  const std::string found =
      token.kind == TokenKind::end
          ? (scanner_.at_end() ? "the end of the text" : "the end of the line")
          : "`" + std::string(token.text) + "`";
  Span span = token.span;
  if (span.length == 0) span.length = 1;
  Diagnostic& diagnostic =
      reporter_.error("E2001", span, "expected " + std::string(expected) + ", found " + found,
                      "expected " + std::string(expected));
  if (token.is("=")) diagnostic.help.push_back("to compare, write `==`");
  return diagnostic;
}

bool TokenCursor::check_length(std::size_t start, std::uint32_t line) {
  if (scanner_.offset() - start <= limits::statement_bytes) return true;
  reporter_.error("E1007", {start, 1, line}, "the statement is longer than 64 KiB", "too long");
  return false;
}

bool TokenCursor::finish_line() {
  scanner_.skip_blanks(LineEnds::significant);
  if (scanner_.character() == ';') scanner_.advance(1);
  scanner_.skip_blanks(LineEnds::significant);
  if (at_statement_end()) return true;
  report_unexpected(scanner_.peek(LineEnds::significant), "the end of the line");
  return false;
}

namespace {

// Whether a text begins as blocks do: X1, G0, #5=1, GOTO 5.
bool begins_block(std::string_view text) {
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < text.size() && is_blank(text[at])) ++at;
  };
  const auto character = [&] { return at < text.size() ? text[at] : '\0'; };
  skip_blanks();
  if (character() == '#') return true;
  if (!is_letter(character())) return false;
  ++at;
  if (is_name_start(character())) {
    const std::string word = folded(text.substr(at - 1, 4));
    return word.starts_with("if") || word == "goto" || word == "whil";
  }
  skip_blanks();
  const char c = character();
  return is_digit(c) || c == '-' || c == '+' || c == '.' || c == '#' || c == '[';
}

}  // namespace

bool TokenCursor::skip_remark() {
  const std::size_t behind = scanner_.offset() + 1;
  const std::string_view line = source_.text().substr(behind, source_.end() - behind);
  const std::string_view rest = line.substr(0, line.find_first_of("\r\n"));
  if (source_.rules().is_fanuc() && begins_block(rest)) {
    reporter_
        .error("E2004", scanner_.here(), "a block after `;` on the same line",
               "`;` ends a block in the dialect fanuc")
        .help.emplace_back("put each block on its own line; write comments in ( )");
    return false;
  }
  scanner_.skip_line_comment();
  return true;
}

bool TokenCursor::Nesting::allowed() {
  if (cursor_.nesting_ - 1 <= limits::nesting) return true;
  cursor_.reporter_.error("E2030", cursor_.scanner_.here(), "an expression nested too deep",
                          "more than 64 levels");
  return false;
}

void report_illegal_character(TokenCursor& cursor) {
  const Token token = cursor.scanner().peek(LineEnds::significant);
  Diagnostic& diagnostic = cursor.reporter().error("E1001", token.span, "illegal character",
                                                   "only comments and strings may contain it");
  // Hyphens, dashes and the minus of Unicode.
  constexpr auto dashes =
      std::to_array<std::string_view>({"\xE2\x80\x90", "\xE2\x80\x91", "\xE2\x80\x92",
                                       "\xE2\x80\x93", "\xE2\x80\x94", "\xE2\x88\x92"});
  if (std::ranges::find(dashes, token.text) != dashes.end())
    diagnostic.help.emplace_back(
        "this is a typographic dash; use the minus sign of the keyboard, `-`");
}

bool TokenCursor::count_operator(const Span& span) {
  if (++operator_count_ <= limits::operators) return true;
  reporter_.error("E2031", span, "an expression with more than 1000 operators", "one too many");
  return false;
}

}  // namespace stanok::lang
