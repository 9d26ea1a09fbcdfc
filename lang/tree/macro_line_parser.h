// Macro lines of Fanuc and Haas: IF, WHILE, DO, END and GOTO.
//
//   IF [..] GOTO n   IF [..] THEN block   IF [..] THEN / ELSE / ENDIF   GOTO n
//   IF [..] block   of Haas, where THEN may be left out
//   WHILE [..] DO m ... END m             DO m ... END m
//   POPEN   DPRNT[text#1[53]]   BPRNT[..]   PCLOS
//
// Blanks between keyword and number are optional. What they enclose becomes the same tree as
// high-level text. Source: Fanuc operator's manual B-63944EN, 16.5. Owner: Parser.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/tree/bracket_parser.h"
#include "lang/tree/iso_parser.h"
#include "lang/tree/token_cursor.h"

namespace stanok::lang {

// How the label of a loop of macro lines begins; no O-line has a blank in it.
inline constexpr std::string_view macro_loop_label = "end ";

// The keyword that a folded name is short for in the dialects of Fanuc, else the name itself.
[[nodiscard]] std::string_view macro_keyword(std::string_view folded_name, const TextRules& rules);

class MacroLineParser {
 public:
  // All must outlive this.
  MacroLineParser(TokenCursor& cursor, BracketParser& brackets, IsoParser& iso,
                  StatementReader& statements)
      : cursor_(cursor),
        brackets_(brackets),
        iso_(iso),
        statements_(statements),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeStatement parse_macro_line();
  // [..] M99 P10 of Haas.
  MaybeStatement parse_conditional_return();

 private:
  MaybeStatement parse_if();
  MaybeStatement parse_then(If& branch);
  bool parse_branches(If& branch, const Span& opened);
  MaybeStatement parse_while();
  MaybeStatement parse_loop(MaybeExpression condition, const Span& opened);
  MaybeStatement parse_goto();
  MaybeStatement parse_printer_switch();
  MaybeStatement parse_print();
  MaybeExpression parse_printed_value();
  bool parse_loop_body(While& loop, const Span& opened);
  [[nodiscard]] std::string letters_ahead() const;
  [[nodiscard]] std::string keyword_ahead() const;
  [[nodiscard]] std::size_t behind_block_number() const;
  std::optional<std::string> take_end(StatementList& body);
  bool take_word(std::string_view word);
  std::optional<std::string> take_loop_number(std::string_view keyword);
  MaybeExpression parse_condition();
  bool finish_macro_line();

  TokenCursor& cursor_;
  BracketParser& brackets_;
  IsoParser& iso_;
  StatementReader& statements_;
  Reporter& reporter_;
  Scanner& scanner_;
  std::vector<std::string> open_loops_;  // numbers of the DO around what is read, outermost first
};

}  // namespace stanok::lang
