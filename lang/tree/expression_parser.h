// Expressions of high-level text, by descent over the levels of precedence.
//
// Owner: Parser. Owns nothing; which names are functions decides only whether ( begins arguments or
// a comment.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/tree/bracket_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

class ExpressionParser {
 public:
  // All must outlive this; `functions` are folded names and may grow.
  ExpressionParser(TokenCursor& cursor, BracketParser& brackets,
                   const std::set<std::string>& functions)
      : cursor_(cursor),
        brackets_(brackets),
        functions_(functions),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeExpression parse_expression(LineEnds line_ends);
  // Variable, element or call.
  MaybeExpression parse_name();
  // Expressions separated by commas, up to and with `close`.
  bool parse_list(std::string_view close, std::vector<Expression>& list);

 private:
  MaybeExpression parse_conditional();
  MaybeExpression parse_binary(int level);
  MaybeExpression parse_unary();
  MaybeExpression parse_power();
  MaybeExpression parse_primary();
  MaybeExpression parse_system_variable();
  MaybeExpression parse_group();
  [[nodiscard]] bool is_call(const Token& name);

  TokenCursor& cursor_;
  BracketParser& brackets_;
  const std::set<std::string>& functions_;
  Reporter& reporter_;
  Scanner& scanner_;
};

}  // namespace stanok::lang
