// Values and expressions of the RS274 kind: 5, -#5, #<name>, [#1 * 2], SIN[30].
//
// Owner: Parser. Knows no names but those of its functions: what #<name> stands for is found when
// the tree is compiled.
#pragma once

#include <optional>
#include <string_view>

#include "lang/tree/token_cursor.h"

namespace stanok::lang {

class BracketParser {
 public:
  // `cursor` must outlive this.
  explicit BracketParser(TokenCursor& cursor)
      : cursor_(cursor),
        source_(cursor.source()),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeExpression parse_value();
  // From its `[`.
  MaybeExpression parse_bracket();
  // From its `#`.
  MaybeExpression parse_parameter_reference();

 private:
  MaybeExpression parse_unsigned_value();
  MaybeExpression parse_bracket_binary(int level);
  MaybeExpression parse_bracket_function(std::string_view name);

  TokenCursor& cursor_;
  const Source& source_;
  Reporter& reporter_;
  Scanner& scanner_;
};

// Functions in brackets: ABS, ACOS, ... with the name of the function that computes them.
[[nodiscard]] std::optional<std::string_view> bracket_function(std::string_view folded_name);

}  // namespace stanok::lang
