// Code of expressions, with their types.
//
// Owner: Compiler. A type that is not known was reported; no code that follows it is used.
#pragma once

#include <string_view>

#include "lang/program/call_compiler.h"
#include "lang/program/code_builder.h"
#include "lang/program/compiler_context.h"
#include "lang/program/symbol_table.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

class ExpressionCompiler {
 public:
  // All must outlive this. `channel` nullptr: any axis may exist.
  ExpressionCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
                     const ChannelWords* channel)
      : context_(context),
        reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        channel_(channel),
        calls_(context, code, symbols, *this) {}
  ExpressionCompiler(const ExpressionCompiler&) = delete;
  ExpressionCompiler& operator=(const ExpressionCompiler&) = delete;

  ValueType compile_expression(const Expression& expression);
  // An expression that must be a scalar of `type`.
  bool require(const Expression& expression, Type type, std::string_view what);
  void compile_condition(const Expression& condition);
  // Array and indices on the stack; the element's type, unknown after an error.
  ValueType compile_element_address(const Expression& element);
  // Notes that the text uses a parameter which is another thing on controls of Fanuc.
  void note_use(const Expression& parameter, ParameterAccess access);
  [[nodiscard]] CallCompiler& calls() { return calls_; }

 private:
  ValueType compile_name(const Expression& name);
  ValueType compile_element(const Expression& element);
  ValueType compile_unary(const Expression& unary);
  ValueType compile_binary(const Expression& binary);
  ValueType compile_logical(const Expression& binary);
  ValueType compile_conditional(const Expression& conditional);
  ValueType compile_parameter(const Expression& parameter);
  ValueType compile_system_variable(const Expression& variable);
  ValueType compile_axis(const Expression& axis);

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  const ChannelWords* channel_;
  CallCompiler calls_;
};

}  // namespace stanok::lang
