// Directives: #include, #kinematics, #feedlaw, ...
//
// Owner: Parser. Adds the functions of included files to those that can be called.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/tree/expression_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

// What the parser asks of the compilation: the functions an included file defines.
using IncludedFunctions = std::function<std::set<std::string>(std::string_view file)>;

class DirectiveParser {
 public:
  // All must outlive this; an empty `included_functions` adds nothing.
  DirectiveParser(TokenCursor& cursor, ExpressionParser& expressions,
                  std::set<std::string>& functions, const IncludedFunctions& included_functions)
      : cursor_(cursor),
        expressions_(expressions),
        functions_(functions),
        included_functions_(included_functions),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  // From its `#`.
  MaybeStatement parse_directive();

 private:
  // The two directives about the workpiece.
  enum class WorkpieceForm : std::uint8_t { announcement, position };

  MaybeStatement parse_include();
  MaybeStatement parse_kinematics();
  MaybeStatement parse_workpiece(WorkpieceForm form, const Span& name);
  MaybeStatement parse_tool_overhang(const Span& name);
  MaybeStatement parse_adaptive(const Span& name);
  MaybeStatement parse_orientation();
  MaybeStatement parse_plane(const Span& name);
  bool parse_vibration_switch(AdaptiveDirective& directive);

  // directive_parser_feed_law.cc
  MaybeStatement parse_feed_law(const Span& name);
  MaybeStatement feed_law_statement(const Span& name, const Token& law,
                                    std::vector<Expression> arguments);
  MaybeStatement refuse_law_arguments(const Span& name, std::size_t given,
                                      const std::string& signature);

  TokenCursor& cursor_;
  ExpressionParser& expressions_;
  std::set<std::string>& functions_;
  const IncludedFunctions& included_functions_;
  Reporter& reporter_;
  Scanner& scanner_;
};

}  // namespace stanok::lang
