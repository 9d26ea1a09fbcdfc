// Values and expressions of the RS274 kind: 5, -#5, #<name>, [#1 * 2], SIN[30].
//
// Owner: Parser. Knows no names but those of its functions: what #<name> stands for is found when
// the tree is compiled.
#pragma once

#include <optional>
#include <string_view>

#include "lang/tree/bracket_operator.h"
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
  // Behind the address of a word. In the Fanuc dialect ROUND works there on the least input
  // increment of the address (B-63944EN, 16.2): 0.001 mm or deg, 0.0001 inch.
  MaybeExpression parse_word_value(char letter);
  // Behind `=` of a parameter: a value, or an expression without brackets around it.
  MaybeExpression parse_right_side() { return parse_bracket_binary(0); }
  // From `[`, a number that is true when it is not 0.
  MaybeExpression parse_condition();
  // From its `[`.
  MaybeExpression parse_bracket();
  // From its `#`.
  MaybeExpression parse_parameter_reference();

 private:
  MaybeExpression parse_unsigned_value();
  MaybeExpression parse_bracket_binary(int level);
  MaybeExpression parse_bracket_function(std::string_view name);
  MaybeExpression parse_arc_tangent(Expression call);
  MaybeExpression parse_function_of_two(const BracketFunction& row, const Span& name_span);
  MaybeExpression parse_inside();
  [[nodiscard]] bool skip_comments();
  [[nodiscard]] bool close_bracket();
  bool refuse_chain(const Token& comparison);
  [[nodiscard]] Expression rounded_to_increment(Expression argument, const Span& span) const;

  TokenCursor& cursor_;
  const Source& source_;
  Reporter& reporter_;
  Scanner& scanner_;
  int open_ = 0;   // brackets in which this is
  char word_ = 0;  // address of the word whose value is read; 0: none
};

// A number as a condition: true when it is not 0.
[[nodiscard]] Expression truth_of(Expression number);

// Whether brackets know a function of this name in any dialect: ABS, ACOS, ...
[[nodiscard]] bool is_bracket_function(std::string_view folded_name);

}  // namespace stanok::lang
