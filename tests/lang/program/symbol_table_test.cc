// What the compilers of the constructs share: code, names, scopes; without a Compiler.
#include "lang/program/symbol_table.h"

#include <gtest/gtest.h>

#include "lang/program/control_compiler.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

Program three_files() {
  Program program;
  for (const char* const name : {"main.nc", "one.nc", "two.nc"}) {
    program.files.push_back(std::make_unique<CompiledFile>(source_of(name, "text\n")));
  }
  return program;
}

class SymbolTableTest : public ::testing::Test {
 protected:
  Symbol number() {
    Symbol symbol;
    symbol.type = {Type::number, 0};
    return symbol;
  }
  CompiledFile& file() { return *program.files.front(); }
  std::string first_code() {
    const Diagnostics all = reporter.take();
    return all.empty() ? "" : all.front().code;
  }

  Program program = three_files();
  std::vector<FileNames> names{3};
  const ChannelDialect dialect{nullptr};
  Source source = source_of("main.nc", "text\n");
  Reporter reporter{source};
  const Interruption interrupted;
  const CompileWatch watch{interrupted};
  CompilerContext context{program, 0, nullptr, dialect, names, reporter, watch};
  CodeBuilder code{context.compiled()};
  SymbolTable symbols{context, code};
};

TEST_F(SymbolTableTest, CodeAndSpansStandParallelAndJumpsArePatched) {
  const std::size_t jump = code.emit(Op::jump, {0, 4, 1});
  code.push_number(2.5, {0, 4, 1});
  code.patch(jump);
  EXPECT_EQ(file().code[jump].operand, 2u);
  EXPECT_EQ(file().numbers.at(0), 2.5);
  code.patch_all_to({jump}, 1);
  EXPECT_EQ(file().code[jump].operand, 1u);
  EXPECT_EQ(file().spans.size(), file().code.size());
  code.drop_from(1);
  EXPECT_EQ(code.position(), 1u);
  EXPECT_EQ(file().spans.size(), 1u);
}

TEST_F(SymbolTableTest, ANameIsKnownInItsScopeOnlyWhateverItsCase) {
  symbols.open_scope();
  EXPECT_FALSE(symbols.at_file_level());
  ASSERT_NE(symbols.declare("Depth", {}, number()), nullptr);
  EXPECT_NE(symbols.find("dEPTH"), nullptr);
  symbols.close_scope();
  EXPECT_EQ(symbols.find("depth"), nullptr);
  EXPECT_TRUE(symbols.at_file_level());
}

TEST_F(SymbolTableTest, ANameIsDeclaredOnceOuterScopesAndFunctionsIncluded) {
  symbols.declare("depth", {}, number());
  symbols.open_scope();
  EXPECT_EQ(symbols.declare("depth", {}, number()), nullptr);
  EXPECT_EQ(first_code(), "E3002");
  names[0].functions["half"] = 0;
  EXPECT_EQ(symbols.declare("half", {}, number()), nullptr);
}

TEST_F(SymbolTableTest, RoutinesCountSlotsOfTheirOwn) {
  symbols.declare("first", {}, number());
  EXPECT_EQ(file().file_slots, 1u);
  symbols.begin_routine();
  const Symbol* const parameter = symbols.declare("value", {}, number());
  ASSERT_NE(parameter, nullptr);
  EXPECT_FALSE(parameter->file_level);
  EXPECT_EQ(parameter->slot, 0u);
  EXPECT_EQ(symbols.unnamed({Type::number, 0}).slot, 1u);
  EXPECT_EQ(symbols.end_routine(), 2u);
  EXPECT_EQ(file().file_slots, 1u);
}

TEST_F(SymbolTableTest, TheKindOfAVariableDecidesHowItIsRead) {
  Symbol symbol = number();
  symbols.load(symbol, {});
  symbol.file_level = false;
  symbols.load(symbol, {});
  symbol.reference = true;
  symbols.store(symbol, {});
  symbol.shared = 3;
  symbols.store(symbol, {});
  EXPECT_EQ(file().code[0].op, Op::load_file);
  EXPECT_EQ(file().code[1].op, Op::load_local);
  EXPECT_EQ(file().code[2].op, Op::store_reference);
  EXPECT_EQ(file().code[3].op, Op::write_shared);
  EXPECT_EQ(file().code[3].operand, 3u);
}

TEST_F(SymbolTableTest, AConstantOfTwoIncludedFilesIsAmbiguous) {
  file().includes = {1, 2};
  names[1].constants["limit"] = {Type::number, 1.0, {}};
  EXPECT_EQ(symbols.find_constant("Limit")->number, 1.0);
  names[2].constants["limit"] = {Type::number, 2.0, {}};
  EXPECT_FALSE(symbols.find_constant("Limit").has_value());
  const SymbolTable::NameTest defines = [](const FileNames& of, const std::string& name) {
    return of.constants.contains(name);
  };
  EXPECT_TRUE(symbols.refuse_ambiguous("limit", {}, defines));
  EXPECT_EQ(first_code(), "E7006");
}

TEST_F(SymbolTableTest, ConstantsAreComputedWhereTheyCan) {
  Expression two;
  two.number = 2.0;
  Expression sum;
  sum.node = Node::binary;
  sum.operation = Operation::add;
  sum.children = {two, two};
  EXPECT_EQ(symbols.constant_of(sum)->number, 4.0);
  sum.operation = Operation::divide;
  sum.children[1].number = 0.0;
  EXPECT_FALSE(symbols.constant_of(sum).has_value());
}

// Bodies without statements.
struct EmptyBodies : BodyCompiler {
  void compile_list(const StatementList&) override {}
  void compile_body(const StatementList&) override {}
};

TEST_F(SymbolTableTest, ControlFlowIsCompiledByItself) {
  ExpressionCompiler expressions(context, code, symbols, nullptr);
  EmptyBodies bodies;
  ControlCompiler control(context, code, symbols, expressions, bodies);
  While loop;
  loop.condition.node = Node::boolean;
  loop.condition.number = 1.0;
  control.compile(loop);
  ASSERT_EQ(code.position(), 3u);
  EXPECT_EQ(file().code[1].op, Op::jump_if_false);
  EXPECT_EQ(file().code[1].operand, 3u);
  EXPECT_EQ(file().code[2].op, Op::jump);
  EXPECT_EQ(file().code[2].operand, 0u);
  control.compile(Break{});
  EXPECT_EQ(first_code(), "E3016");
}

}  // namespace
}  // namespace stanok::lang::testing
