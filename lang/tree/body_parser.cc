#include "lang/tree/body_parser.h"

#include "lang/text/limits.h"

namespace stanok::lang {

// { statements }
std::optional<StatementList> BodyParser::parse_body(std::string_view of) {
  cursor_.set_line_ends(LineEnds::blank);
  const Token open = scanner_.peek(LineEnds::blank);
  if (!open.is("{")) {
    reporter_
        .error("E2020", open.span, "the body of `" + std::string(of) + "` needs braces",
               "expected `{`")
        .help.push_back("write `" + std::string(of) + " ... { ... }`");
    return std::nullopt;
  }
  scanner_.take(LineEnds::blank);
  if (cursor_.depth().braces + cursor_.depth().o_lines >= limits::nesting) {
    reporter_.error("E2030", open.span, "more than 64 nested braces", "too deep");
    return std::nullopt;
  }
  StatementList body;
  ++cursor_.depth().braces;
  scanner_.skip_blanks(LineEnds::significant);
  while (!scanner_.at_end() && scanner_.character() != '}') {
    statements_.parse_statement(body);
    if (!scanner_.at_line_end()) scanner_.skip_blanks(LineEnds::significant);
  }
  --cursor_.depth().braces;
  cursor_.set_line_ends(LineEnds::blank);
  if (scanner_.at_end()) {
    reporter_.error("E2003", open.span, "`{` is not closed", "`}` is missing");
    return std::nullopt;
  }
  scanner_.advance(1);
  return body;
}

}  // namespace stanok::lang
