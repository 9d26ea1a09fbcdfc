// Declarations of variables and definitions of functions.
//
// Owner: Parser. Names whose declaration is at fault are spoilt in the reporter: that they are not
// known is not told again.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "lang/tree/body_parser.h"
#include "lang/tree/expression_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

class DeclarationParser {
 public:
  // All must outlive this.
  DeclarationParser(TokenCursor& cursor, ExpressionParser& expressions, BodyParser& bodies)
      : cursor_(cursor),
        expressions_(expressions),
        bodies_(bodies),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeStatement parse_declaration_or_function();

 private:
  MaybeStatement parse_items(Declaration declaration);
  bool parse_dimensions(DeclaredItem& item);
  bool parse_initial(DeclaredItem& item);
  MaybeStatement parse_function(Type result, const Token& name);
  std::optional<FunctionParameter> parse_parameter();
  bool check_declared_name(const Token& name);
  [[nodiscard]] MaybeStatement spoilt(const Declaration& declaration);

  TokenCursor& cursor_;
  ExpressionParser& expressions_;
  BodyParser& bodies_;
  Reporter& reporter_;
  Scanner& scanner_;
};

// Names (folded) of the functions that a text defines, found without reading it in full.
[[nodiscard]] std::set<std::string> defined_functions(const Source& source);

}  // namespace stanok::lang
