// The cursor that the parsers of the constructs share, and small parsers over it alone.
#include "lang/tree/token_cursor.h"

#include <gtest/gtest.h>

#include "lang/tree/body_parser.h"
#include "lang/tree/bracket_parser.h"
#include "lang/tree/expression_parser.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

// A text and the cursor at its beginning.
struct Reading {
  explicit Reading(std::string_view text) : source(source_of("main.nc", text)) {}

  std::string first_code() {
    const Diagnostics all = reporter.take();
    return all.empty() ? "" : all.front().code;
  }

  Source source;
  Reporter reporter{source};
  TokenCursor cursor{source, reporter};
};

TEST(TokenCursor, AcceptsWhatStandsThereAndReportsWhatIsMissing) {
  Reading reading("( 5");
  EXPECT_FALSE(reading.cursor.accept("["));
  EXPECT_TRUE(reading.cursor.accept("("));
  EXPECT_FALSE(reading.cursor.expect(")", "the value"));
  const Diagnostics all = reading.reporter.take();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].message, "expected `)` after the value, found `5`");
}

TEST(TokenCursor, ALineEndIsABlankOrTheEndAsItIsSet) {
  Reading reading("\n;");
  reading.cursor.set_line_ends(LineEnds::significant);
  EXPECT_FALSE(reading.cursor.accept(";"));
  reading.cursor.set_line_ends(LineEnds::blank);
  EXPECT_TRUE(reading.cursor.accept(";"));
}

TEST(TokenCursor, ABraceEndsAStatementOnlyInsideBraces) {
  Reading reading("}");
  EXPECT_TRUE(reading.cursor.at_file_level());
  EXPECT_FALSE(reading.cursor.at_statement_end());
  ++reading.cursor.depth().braces;
  EXPECT_TRUE(reading.cursor.at_statement_end());
  EXPECT_TRUE(reading.cursor.finish_line());
  EXPECT_FALSE(reading.cursor.at_file_level());
}

TEST(TokenCursor, NestingIsLimitedAndGivenBack) {
  Reading reading("x");
  std::vector<std::unique_ptr<TokenCursor::Nesting>> levels;
  for (int level = 0; level < 65; ++level) {
    levels.push_back(std::make_unique<TokenCursor::Nesting>(reading.cursor));
    ASSERT_TRUE(levels.back()->allowed()) << level;
  }
  {
    TokenCursor::Nesting one_more(reading.cursor);
    EXPECT_FALSE(one_more.allowed());
  }
  EXPECT_EQ(reading.first_code(), "E2030");
  levels.clear();
  EXPECT_EQ(reading.cursor.nesting(), 0);
}

TEST(TokenCursor, OperatorsAreCountedFromTheBeginningOfAnExpression) {
  Reading reading("x");
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(reading.cursor.count_operator({}));
  reading.cursor.begin_operators();
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(reading.cursor.count_operator({}));
  EXPECT_FALSE(reading.cursor.count_operator({0, 1, 1}));
  EXPECT_EQ(reading.first_code(), "E2031");
}

TEST(BracketParser, ReadsValuesOfTheRs274Kind) {
  Reading reading("-[#1 + SIN[30]] X");
  BracketParser brackets(reading.cursor);
  const auto value = brackets.parse_value();
  ASSERT_TRUE(value.has_value());
  EXPECT_EQ(value->operation, Operation::negate);
  EXPECT_EQ(value->children[0].operation, Operation::add);
  EXPECT_EQ(value->children[0].children[1].text, "sin");
  EXPECT_EQ(reading.source.text(value->span), "-[#1 + SIN[30]]");
}

TEST(ExpressionParser, AnExpressionLeavesTheLineEndsAsTheyWere) {
  Reading reading("2 + 3 * 4 ** 2\n");
  BracketParser brackets(reading.cursor);
  const std::set<std::string> functions;
  ExpressionParser expressions(reading.cursor, brackets, functions);
  reading.cursor.set_line_ends(LineEnds::significant);
  const auto sum = expressions.parse_expression(LineEnds::blank);
  ASSERT_TRUE(sum.has_value());
  EXPECT_EQ(sum->operation, Operation::add);
  EXPECT_EQ(sum->children[1].operation, Operation::multiply);
  EXPECT_EQ(sum->children[1].children[1].operation, Operation::power);
  EXPECT_EQ(reading.cursor.line_ends(), LineEnds::significant);
}

// Reads each character as an empty statement.
struct CharacterReader : StatementReader {
  explicit CharacterReader(TokenCursor& of) : cursor(of) {}
  void parse_statement(StatementList& list) override {
    cursor.scanner().advance(1);
    list.push_back(statement_of(Compound{}));
  }
  TokenCursor& cursor;
};

TEST(BodyParser, ReadsStatementsUpToItsBraceAndCountsTheLevel) {
  Reading reading("{ a b }rest");
  CharacterReader statements(reading.cursor);
  BodyParser bodies(reading.cursor, statements);
  const auto body = bodies.parse_body("while");
  ASSERT_TRUE(body.has_value());
  EXPECT_EQ(body->size(), 2u);
  EXPECT_TRUE(reading.cursor.at_file_level());
  EXPECT_EQ(reading.cursor.scanner().character(), 'r');
  Reading open("{ a");
  CharacterReader others(open.cursor);
  EXPECT_FALSE(BodyParser(open.cursor, others).parse_body("while").has_value());
  EXPECT_EQ(open.first_code(), "E2003");
}

}  // namespace
}  // namespace stanok::lang::testing
