// Code of declarations and assignments, of shared variables too: these live in the machine, a
// program only names them.
//
// Owner: Compiler.
#pragma once

#include <optional>

#include "lang/program/expression_compiler.h"

namespace stanok::lang {

class VariableCompiler {
 public:
  // All must outlive this.
  VariableCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
                   ExpressionCompiler& expressions)
      : reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions) {}

  void compile(const Declaration& declaration);
  void compile(const Assignment& assignment);

 private:
  std::optional<Symbol> assignable(const Expression& target);
  void load_target(const Expression& target, const Symbol& symbol);
  void store_target(const Expression& target, const Symbol& symbol);
  bool combine(const Assignment& assignment, Operation operation, Type type);
  void combine_shared(const Assignment& assignment, const Symbol& symbol, Type type);
  void refuse_combination(const Assignment& assignment, Type type);
  void compile_item(const Declaration& declaration, const DeclaredItem& item);
  void compile_shared(const DeclaredItem& item, Type type);
  void compile_array(const DeclaredItem& item, Type type);
  void compile_initial(const DeclaredItem& item, Type type);

  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
};

}  // namespace stanok::lang
