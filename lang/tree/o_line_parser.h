// O-lines: subprograms and flow of RS274/NGC, and numbered programs.
//
// What O-lines enclose becomes the same tree as high-level text; only their subprograms, calls and
// counted loops have nodes of their own. Owner: Parser.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/tree/bracket_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

// O, or the colon that stands for it in ISO code of Fanuc controls. Source: operator's manual
// B-63944EN, 13.1.
[[nodiscard]] bool is_program_letter(char c, const TextRules& rules);

class OLineParser {
 public:
  // All must outlive this.
  OLineParser(TokenCursor& cursor, BracketParser& brackets, StatementReader& statements)
      : cursor_(cursor),
        brackets_(brackets),
        statements_(statements),
        source_(cursor.source()),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  // `skip_level` of the block skip before it, 0: none.
  MaybeStatement parse_o_line(int skip_level);

 private:
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
    int skip_level = 0;

    [[nodiscard]] std::string text() const { return "O" + label + " " + keyword; }
  };
  bool read_label(std::size_t& at, OLineAhead& line) const;
  std::optional<OLineAhead> o_line_ahead(int skip_level = 0) const;
  void check_skipped_body(const OpenOLine& open, const StatementList& body);
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
  void take_second_word(OLineAhead& line) const;
  MaybeExpression parse_o_bracket(std::string_view keyword);
  MaybeExpression parse_o_condition(std::string_view keyword);
  bool parse_optional_bracket(MaybeExpression& value);
  bool finish_o_line();

  TokenCursor& cursor_;
  BracketParser& brackets_;
  StatementReader& statements_;
  const Source& source_;
  Reporter& reporter_;
  Scanner& scanner_;
};

}  // namespace stanok::lang
