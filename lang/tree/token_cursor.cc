#include "lang/tree/token_cursor.h"

#include <string>

#include "lang/text/limits.h"

namespace stanok::lang {

bool TokenCursor::at_statement_end() const {
  return scanner_.at_line_end() || (scanner_.character() == '}' && inside_braces());
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
  report_unexpected(token, wanted);
  return false;
}

void TokenCursor::report_unexpected(const Token& token, std::string_view expected) {
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

bool TokenCursor::Nesting::allowed() {
  if (cursor_.nesting_ - 1 <= limits::nesting) return true;
  cursor_.reporter_.error("E2030", cursor_.scanner_.here(), "an expression nested too deep",
                          "more than 64 levels");
  return false;
}

bool TokenCursor::count_operator(const Span& span) {
  if (++operator_count_ <= limits::operators) return true;
  reporter_.error("E2031", span, "an expression with more than 1000 operators", "one too many");
  return false;
}

}  // namespace stanok::lang
