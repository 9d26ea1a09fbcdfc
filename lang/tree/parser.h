// Makes the tree of a program text; every error is reported, and reading goes on behind it.
//
// The kind of a statement follows from its first characters (docs/reference/language.md,
// "Statements"); each kind has its parser over one TokenCursor. Functions that return nothing have
// reported why; the statement they belong to is then skipped.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "lang/contract/environment.h"
#include "lang/text/compile_watch.h"
#include "lang/text/reporter.h"
#include "lang/tree/body_parser.h"
#include "lang/tree/bracket_parser.h"
#include "lang/tree/declaration_parser.h"
#include "lang/tree/directive_parser.h"
#include "lang/tree/expression_parser.h"
#include "lang/tree/iso_parser.h"
#include "lang/tree/macro_line_parser.h"
#include "lang/tree/o_line_parser.h"
#include "lang/tree/statement_parser.h"
#include "lang/tree/token_cursor.h"
#include "lang/tree/tree.h"
#include "lang/words/channel_words.h"
#include "lang/words/named_parameter.h"

namespace stanok::lang {

struct ParserContext {
  const ChannelDescription* channel = nullptr;  // nullptr: channel-dependent checks are left out
  const ChannelDialect* dialect = nullptr;      // nullptr: nothing added
  IncludedFunctions included_functions;
  std::set<std::string> functions;              // folded names that can be called besides
  NamedParameters* named_parameters = nullptr;  // nullptr: blocks that use them are not plain
  CompileWatch* watch = nullptr;                // nullptr: nothing ends the reading
};

class Parser final : private StatementReader {
 public:
  Parser(const Source& source, Reporter& reporter, ParserContext context);

  [[nodiscard]] StatementList parse_program();
  // Reads the ISO block at `span` alone, to find the places of its words.
  [[nodiscard]] static std::optional<IsoBlock> parse_block(const Source& source, const Span& span);

 private:
  void parse_statement(StatementList& list) override;
  bool take_plain_lines(StatementList& list);
  bool pass_separator();
  MaybeStatement parse_kind(int skip_level);
  MaybeStatement parse_named_start();
  MaybeStatement refuse_type(const std::string& name);
  int take_block_skip();
  int take_block_number();
  void recover(std::size_t start);
  void recover_from_header(std::size_t start);
  [[nodiscard]] bool opens_braces(std::size_t start) const;
  void close_headless();
  void keep_faulty(StatementList& list, std::size_t start, std::uint32_t line);
  [[nodiscard]] Scanner& scanner() { return cursor_.scanner(); }
  [[nodiscard]] Reporter& reporter() { return cursor_.reporter(); }

  ParserContext context_;
  const ChannelDialect& dialect_;
  std::optional<ChannelWords> channel_words_;  // nothing: see ParserContext::channel
  TokenCursor cursor_;
  std::set<std::string> functions_;  // folded names that can be called
  BracketParser brackets_;
  ExpressionParser expressions_;
  IsoParser iso_;
  BodyParser bodies_;
  DeclarationParser declarations_;
  StatementParser statements_;
  OLineParser o_lines_;
  MacroLineParser macro_lines_;
  DirectiveParser directives_;
  int headless_braces_ = 0;  // open ones of statements whose header is at fault
};

}  // namespace stanok::lang
