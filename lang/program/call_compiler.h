// Code of calls: built-in functions and functions of the program.
//
// Owner: ExpressionCompiler, which compiles the arguments.
#pragma once

#include <optional>
#include <string_view>

#include "lang/program/code_builder.h"
#include "lang/program/compiler_context.h"
#include "lang/program/symbol_table.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {

class ExpressionCompiler;

class CallCompiler {
 public:
  enum class Form { expression, statement };

  // All must outlive this.
  CallCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
               ExpressionCompiler& expressions)
      : context_(context),
        reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions) {}

  void compile(const CallStatement& statement);
  ValueType compile_call(const Expression& call, Form form);
  // The channel of a call when it is constant: it must exist. Nothing when it is not constant or at
  // fault.
  std::optional<int> constant_channel(const Expression& argument, OwnChannel own,
                                      std::string_view function);

 private:
  // What the arguments of a builtin came to.
  enum class Arguments { faulty, plain, entry_by_number };

  bool check_argument_count(const Builtin& builtin, const Expression& call);
  Arguments compile_arguments(const Builtin& builtin, const Expression& call);
  ValueType compile_builtin(const Builtin& builtin, const Expression& call, Form form);
  void emit_builtin(const Builtin& builtin, const Expression& call, Form form, Arguments arguments);
  ValueType compile_user_call(const Callee& callee, const Expression& call, Form form);
  bool compile_argument(const FunctionParameter& parameter, const Expression& argument);
  bool compile_reference(const FunctionParameter& parameter, const Expression& argument);
  std::optional<Type> compile_entry_name(const Expression& argument, char letter);
  void check_mark_call(const Expression& call);
  void check_channel_call(const Builtin& builtin, const Expression& call);

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
};

}  // namespace stanok::lang
