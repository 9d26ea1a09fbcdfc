// High-level statements: bodies, conditions, loops, assignments and calls.
//
// Owner: Parser. Owns only what ends the simple statement that is read.
#pragma once

#include <optional>
#include <string_view>

#include "lang/tree/body_parser.h"
#include "lang/tree/declaration_parser.h"
#include "lang/tree/expression_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

class StatementParser {
 public:
  // All must outlive this.
  StatementParser(TokenCursor& cursor, ExpressionParser& expressions, BodyParser& bodies,
                  DeclarationParser& declarations)
      : cursor_(cursor),
        expressions_(expressions),
        bodies_(bodies),
        declarations_(declarations),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeStatement parse_keyword(std::string_view keyword);
  MaybeStatement parse_compound();
  // An assignment or a call.
  MaybeStatement parse_simple();

 private:
  [[nodiscard]] bool refuses_remark_in_braces();
  MaybeStatement parse_if();
  MaybeStatement parse_while();
  MaybeStatement parse_do();
  MaybeStatement parse_for();
  MaybeStatement parse_switch();
  std::optional<SwitchCase> parse_case();
  MaybeStatement parse_return();
  MaybeStatement parse_jump(std::string_view keyword);
  MaybeExpression parse_condition();

  TokenCursor& cursor_;
  ExpressionParser& expressions_;
  BodyParser& bodies_;
  DeclarationParser& declarations_;
  Reporter& reporter_;
  Scanner& scanner_;
  std::string_view closing_ = ";";  // what ends the simple statement
};

}  // namespace stanok::lang
