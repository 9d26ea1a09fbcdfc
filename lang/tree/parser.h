// Makes the tree of a program text; every error is reported, and reading goes on behind it.
//
// The kind of a statement follows from its first characters (docs/reference/language.md,
// "Statements"). Functions that return nothing have reported why; the statement they belong to is
// then skipped.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lang/contract/environment.h"
#include "lang/text/compile_watch.h"
#include "lang/text/reporter.h"
#include "lang/tree/named_parameter.h"
#include "lang/tree/scanner.h"
#include "lang/tree/tree.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

// Names (folded) of the functions that a text defines, found without reading it in full.
[[nodiscard]] std::set<std::string> defined_functions(const Source& source);

// What the parser asks of the compilation: the functions an included file defines.
using IncludedFunctions = std::function<std::set<std::string>(std::string_view file)>;

struct ParserContext {
  const ChannelDescription* channel = nullptr;  // nullptr: channel-dependent checks are left out
  const ChannelDialect* dialect = nullptr;      // nullptr: nothing added
  IncludedFunctions included_functions;
  std::set<std::string> functions;              // folded names that can be called besides
  NamedParameters* named_parameters = nullptr;  // nullptr: blocks that use them are not plain
  CompileWatch* watch = nullptr;                // nullptr: nothing ends the reading
};

class Parser {
 public:
  Parser(const Source& source, Reporter& reporter, ParserContext context);

  [[nodiscard]] StatementList parse_program();
  // Reads the ISO block at `span` alone, to find the places of its words.
  [[nodiscard]] static std::optional<IsoBlock> parse_block(const Source& source, const Span& span);

 private:
  using MaybeExpression = std::optional<Expression>;
  using MaybeStatement = std::optional<Statement>;

  // parser.cc: statements and their kinds
  void parse_statement(StatementList& list);
  bool take_plain_lines(StatementList& list);
  MaybeStatement parse_kind();
  MaybeStatement parse_named_start();
  MaybeStatement refuse_type(const std::string& name);
  int take_block_skip();
  void take_block_number();
  void recover(std::size_t start);
  void recover_from_header(std::size_t start);
  void close_headless();
  [[nodiscard]] MaybeStatement spoilt(const Declaration& declaration);
  void keep_faulty(StatementList& list, std::size_t start, std::uint32_t line);
  bool inside_braces() const { return brace_depth_ > 0; }
  bool expect(std::string_view symbol, std::string_view after);
  bool accept(std::string_view symbol);
  void report_unexpected(const Token& token, std::string_view expected);
  // Ends a statement that ends with its line.
  bool finish_line();
  // Whether the statement (or its head) from `start` to here is short enough; reports it else.
  bool check_length(std::size_t start, std::uint32_t line);

  // parser_statement.cc: high-level statements
  MaybeStatement parse_keyword(std::string_view keyword);
  std::optional<StatementList> parse_body(std::string_view of);
  MaybeStatement parse_compound();
  MaybeStatement parse_if();
  MaybeStatement parse_while();
  MaybeStatement parse_do();
  MaybeStatement parse_for();
  MaybeStatement parse_switch();
  std::optional<SwitchCase> parse_case();
  MaybeStatement parse_return();
  MaybeStatement parse_simple();
  MaybeStatement parse_jump(std::string_view keyword);
  MaybeExpression parse_condition();

  // parser_declaration.cc: variables and functions
  MaybeStatement parse_declaration_or_function();
  MaybeStatement parse_items(Declaration declaration);
  bool parse_dimensions(DeclaredItem& item);
  bool parse_initial(DeclaredItem& item);
  MaybeStatement parse_function(Type result, const Token& name);
  std::optional<FunctionParameter> parse_parameter();
  bool check_declared_name(const Token& name);

  // parser_iso.cc: ISO blocks
  MaybeStatement parse_iso();
  bool parse_iso_part(IsoBlock& block);
  bool parse_word(IsoBlock& block);
  bool parse_long_word(IsoBlock& block, std::string_view name);
  bool parse_plain_value(IsoWord& word);
  bool apply_aliases(IsoBlock& block);
  bool parse_parameter_setting(IsoBlock& block);
  bool add_word(IsoBlock& block, IsoWord word);
  bool end_iso_in_braces();
  bool is_named_address(std::string_view name) const;

  // parser_comment.cc: comments in ISO blocks
  bool parse_comment(IsoBlock& block);
  Expression comment_text(std::string_view text, const Span& span);

  // parser_bracket.cc: values and expressions of the RS274 kind
  MaybeExpression parse_value();
  MaybeExpression parse_unsigned_value();
  MaybeExpression parse_bracket();
  MaybeExpression parse_bracket_binary(int level);
  MaybeExpression parse_bracket_function(std::string_view name);
  MaybeExpression parse_parameter_reference();

  // parser_directive.cc
  MaybeStatement parse_directive();
  MaybeStatement parse_include();
  MaybeStatement parse_kinematics();
  MaybeStatement parse_workpiece(bool position, const Span& name);
  MaybeStatement parse_tool_overhang(const Span& name);
  MaybeStatement parse_macro_line();

  // parser_adaptive.cc
  MaybeStatement parse_adaptive(const Span& name);
  bool parse_vibration_switch(AdaptiveDirective& directive);

  // parser_feed_law.cc
  MaybeStatement parse_feed_law(const Span& name);
  MaybeStatement feed_law_statement(const Span& name, const Token& law,
                                    std::vector<Expression> arguments);
  MaybeStatement refuse_law_arguments(const Span& name, std::size_t given,
                                      const std::string& signature);

  // parser_o_line.cc
  struct OLineAhead {
    std::string label;  // folded, or digits without leading zeros
    std::string written;
    bool numbered = false;
    std::string keyword;  // folded; empty: a program number
    std::size_t label_length = 0;
    std::size_t length = 0;  // with the keyword
  };
  // An O-line that opened something, until the line that closes it.
  struct OpenOLine {
    std::string label;
    std::string keyword;
    Span span;

    [[nodiscard]] std::string text() const { return "O" + label + " " + keyword; }
  };
  std::optional<OLineAhead> o_line_ahead() const;
  MaybeStatement parse_o_line();
  MaybeStatement parse_program_number(const OLineAhead& line, const Span& span);
  MaybeStatement parse_computed_call();
  MaybeStatement parse_o_call(OLabel label);
  MaybeStatement parse_o_sub(const OpenOLine& open, OLabel label);
  MaybeStatement parse_o_return();
  MaybeStatement parse_o_if(const OpenOLine& open);
  MaybeStatement parse_o_while(const OpenOLine& open);
  MaybeStatement parse_o_do(const OpenOLine& open);
  MaybeStatement parse_o_repeat(const OpenOLine& open);
  std::optional<std::string> parse_o_body(const OpenOLine& open,
                                          const std::vector<std::string_view>& ends,
                                          StatementList& body);
  std::optional<std::string> take_o_end(const OpenOLine& open,
                                        const std::vector<std::string_view>& ends);
  MaybeExpression parse_o_bracket(std::string_view keyword);
  MaybeExpression parse_o_condition(std::string_view keyword);
  bool parse_optional_bracket(MaybeExpression& value);
  bool finish_o_line();

  // parser_expression.cc
  MaybeExpression parse_expression(LineEnds line_ends);
  MaybeExpression parse_conditional();
  MaybeExpression parse_binary(int level);
  MaybeExpression parse_unary();
  MaybeExpression parse_power();
  MaybeExpression parse_primary();
  MaybeExpression parse_name();
  MaybeExpression parse_system_variable();
  MaybeExpression parse_group();
  bool parse_list(std::string_view close, std::vector<Expression>& list);
  [[nodiscard]] bool is_call(const Token& name);

  // One level of nesting in an expression, for as long as it lives.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) { ++parser_.nesting_; }
    ~Nesting() { --parser_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    // False, with a report, when the limit is exceeded.
    [[nodiscard]] bool allowed();

   private:
    Parser& parser_;
  };
  bool count_operator(const Span& span);

  const Source& source_;
  Reporter& reporter_;
  ParserContext context_;
  const ChannelDialect& dialect_;
  std::optional<ChannelWords> channel_words_;  // nothing: see ParserContext::channel
  Scanner scanner_;
  std::set<std::string> functions_;
  LineEnds line_ends_ = LineEnds::blank;  // of the expression at hand
  int brace_depth_ = 0;
  int headless_braces_ = 0;  // open ones of statements whose header is at fault
  int o_depth_ = 0;          // O-lines that are open
  int else_if_depth_ = 0;
  int nesting_ = 0;                 // of the expression at hand, itself counted
  int operator_count_ = 0;          // in it
  std::string_view closing_ = ";";  // what ends the simple statement at hand
};

// Keywords and names that a program may not declare.
[[nodiscard]] bool is_keyword(std::string_view folded_name);
[[nodiscard]] bool is_reserved_word(std::string_view folded_name);
[[nodiscard]] std::optional<Type> type_of_keyword(std::string_view folded_name);
// Functions in brackets: ABS, ACOS, ... with the name of the function that computes them.
[[nodiscard]] std::optional<std::string_view> bracket_function(std::string_view folded_name);

}  // namespace stanok::lang
