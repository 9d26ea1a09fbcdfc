// Compiles the tree of one program file: names, types, and the code.
//
// Each construct has its compiler over one CodeBuilder and one SymbolTable; this one decides which
// statement is whose. Text below a reported error gets no code; reading goes on so that all errors
// of a file are found.
#pragma once

#include <optional>

#include "lang/program/code_builder.h"
#include "lang/program/compiler_context.h"
#include "lang/program/control_compiler.h"
#include "lang/program/directive_compiler.h"
#include "lang/program/expression_compiler.h"
#include "lang/program/iso_compiler.h"
#include "lang/program/routine_compiler.h"
#include "lang/program/symbol_table.h"
#include "lang/program/variable_compiler.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

class Compiler final : private BodyCompiler {
 public:
  explicit Compiler(const CompilerContext& context);

  // First for all files: the functions and constants that others may use.
  void declare_names(const StatementList& tree);
  // Then the code.
  void compile(const StatementList& tree);

 private:
  void declare_constants(const Declaration& declaration);
  void compile_list(const StatementList& list) override;
  void compile_body(const StatementList& list) override;
  void compile_statement(const Statement& statement);
  // A statement by who compiles its kind.
  template <class Kind>
  void compile_kind(const Kind& kind);
  void compile_own(const PlainLines& lines);
  void compile_own(const NumberedProgram& start);
  void compile_own(const FaultyText& text);

  CompilerContext context_;
  Reporter& reporter_;
  CompiledFile& file_;
  std::optional<ChannelWords> channel_words_;  // nothing: see CompilerContext::channel
  CodeBuilder code_;
  SymbolTable symbols_;
  ExpressionCompiler expressions_;
  VariableCompiler variables_;
  ControlCompiler control_;
  RoutineCompiler routines_;
  DirectiveCompiler directives_;
  IsoCompiler iso_;
};

}  // namespace stanok::lang
