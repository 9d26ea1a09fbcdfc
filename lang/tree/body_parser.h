// Bodies in braces, of control statements and functions.
#pragma once

#include <optional>
#include <string_view>

#include "lang/tree/token_cursor.h"

namespace stanok::lang {

class BodyParser {
 public:
  // Both must outlive this.
  BodyParser(TokenCursor& cursor, StatementReader& statements)
      : cursor_(cursor),
        statements_(statements),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  // { statements } of what is called `of`.
  std::optional<StatementList> parse_body(std::string_view of);

 private:
  TokenCursor& cursor_;
  StatementReader& statements_;
  Reporter& reporter_;
  Scanner& scanner_;
};

}  // namespace stanok::lang
