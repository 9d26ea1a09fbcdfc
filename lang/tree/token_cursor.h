// Where the reading of a text stands, shared by those who read its constructs.
//
// Owns the scanner, what a line end means in what is read now, and how deep it is nested. Owner:
// Parser; one thread. Invariants: depths count what is open around here and are the same before and
// after a construct; functions that return nothing or false have reported why.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lang/text/reporter.h"
#include "lang/tree/scanner.h"
#include "lang/tree/tree.h"

namespace stanok::lang {

// Nothing: it is at fault, which was reported.
using MaybeExpression = std::optional<Expression>;
using MaybeStatement = std::optional<Statement>;

class TokenCursor {
 public:
  // What is open around a statement.
  struct Depth {
    int braces = 0;
    int o_lines = 0;
    int else_ifs = 0;
  };

  // Both must outlive this.
  TokenCursor(const Source& source, Reporter& reporter)
      : source_(source), reporter_(reporter), scanner_(source, reporter) {}
  TokenCursor(const TokenCursor&) = delete;
  TokenCursor& operator=(const TokenCursor&) = delete;

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] Reporter& reporter() { return reporter_; }
  [[nodiscard]] Scanner& scanner() { return scanner_; }

  // Of the expression or statement read now.
  [[nodiscard]] LineEnds line_ends() const { return line_ends_; }
  void set_line_ends(LineEnds line_ends) { line_ends_ = line_ends; }

  [[nodiscard]] Depth& depth() { return depth_; }
  [[nodiscard]] bool inside_braces() const { return depth_.braces > 0; }
  [[nodiscard]] bool at_file_level() const { return depth_.braces == 0 && depth_.o_lines == 0; }
  // The end of the line, or the brace that closes what it stands in.
  [[nodiscard]] bool at_statement_end() const;
  // The end of the text, or the brace that closes what it stands in: no statement begins there.
  [[nodiscard]] bool at_body_end() const;

  bool accept(std::string_view symbol);
  bool expect(std::string_view symbol, std::string_view after);
  Diagnostic& report_unexpected(const Token& token, std::string_view expected);
  // Ends a statement that ends with its line.
  bool finish_line();
  // Whether the statement (or its head) from `start` to here is short enough; reports it else.
  bool check_length(std::size_t start, std::uint32_t line);

  // One level of nesting in an expression, for as long as it lives.
  class Nesting {
   public:
    explicit Nesting(TokenCursor& cursor) : cursor_(cursor) { ++cursor_.nesting_; }
    ~Nesting() { --cursor_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    // False, with a report, when the limit is exceeded.
    [[nodiscard]] bool allowed();

   private:
    TokenCursor& cursor_;
  };
  [[nodiscard]] int nesting() const { return nesting_; }
  // Operators are counted from here on; chains of them become deep trees.
  void begin_operators() { operator_count_ = 0; }
  bool count_operator(const Span& span);
  // At a `;` behind the words of a block: passes over the remark behind it. False, with a report,
  // for a second block: `;` ends blocks on Fanuc controls.
  bool skip_remark();

 private:
  const Source& source_;
  Reporter& reporter_;
  Scanner scanner_;
  LineEnds line_ends_ = LineEnds::blank;
  Depth depth_;
  int nesting_ = 0;         // of the expression, itself counted
  int operator_count_ = 0;  // in it
};

// E1001 for the character that stands here.
void report_illegal_character(TokenCursor& cursor);

// Who reads the statements in a body.
class StatementReader {
 public:
  StatementReader() = default;
  StatementReader(const StatementReader&) = delete;
  StatementReader& operator=(const StatementReader&) = delete;
  virtual ~StatementReader() = default;

  // The statement that stands here, or nothing but blanks, is added to `list`.
  virtual void parse_statement(StatementList& list) = 0;
};

}  // namespace stanok::lang
