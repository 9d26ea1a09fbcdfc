// Code of functions and subprograms of O-lines, of calls of the latter, and of the way out of both.
//
// Owner: Compiler. Owns which routines the file has and which is compiled. What a routine does
// where it stands is nothing; its code lies behind that of the file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "lang/program/expression_compiler.h"

namespace stanok::lang {

class RoutineCompiler {
 public:
  // All must outlive this.
  RoutineCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
                  ExpressionCompiler& expressions, BodyCompiler& bodies)
      : context_(context),
        reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions),
        bodies_(bodies) {}

  // First: the names that others may use.
  void declare(const FunctionDefinition& function);
  void declare(const OSubprogram& subprogram);

  // Where they stand.
  void compile(const FunctionDefinition&) {}
  void compile(const OSubprogram&) {}
  void compile(const Return& statement);
  void compile(const OReturn& statement);
  void compile(const OCall& call);

  // Behind the code of the file; a routine that was not declared is left out.
  void compile_routine(const FunctionDefinition& function);
  void compile_routine(const OSubprogram& subprogram);

 private:
  enum class Routine : std::uint8_t { none, function, o_subprogram };

  void fold_default_values(FunctionSignature& signature);
  void begin_routine(Routine routine, std::uint32_t index);
  void end_routine(std::uint32_t index);
  std::optional<Callee> find_o_subprogram(const OLabel& label);

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
  BodyCompiler& bodies_;
  std::map<const FunctionDefinition*, std::uint32_t> function_index_;
  std::map<const OSubprogram*, std::uint32_t> o_subprogram_index_;
  Routine routine_ = Routine::none;               // what is compiled; none: text of the file
  const FunctionDefinition* function_ = nullptr;  // of Routine::function
};

}  // namespace stanok::lang
