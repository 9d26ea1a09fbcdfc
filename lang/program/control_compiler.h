// Code of control flow: branches, loops of high-level text and of O-lines, and the way out of them.
//
// Owner: Compiler. Owns the loops that are open. Invariant: a loop is open while its body is
// compiled, the innermost last.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lang/program/expression_compiler.h"

namespace stanok::lang {

class ControlCompiler {
 public:
  // All must outlive this.
  ControlCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
                  ExpressionCompiler& expressions, BodyCompiler& bodies)
      : reporter_(context.reporter),
        program_(context.program),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions),
        bodies_(bodies) {}

  void compile(const Compound& compound);
  void compile(const If& statement);
  void compile(const While& loop);
  void compile(const DoWhile& loop);
  void compile(const For& loop);
  void compile(const Switch& statement);
  void compile(const Break& leave);
  void compile(const Continue& next);
  void compile(const ORepeat& loop);
  void compile(const JumpLine& jump);

  // The code from there on is dropped.
  void forget_jumps_from(std::size_t start);

 private:
  struct Loop {
    std::string label;                // of O-lines
    std::uint32_t begin = 0;          // its first instruction
    std::vector<std::size_t> breaks;  // jumps to patch
    std::vector<std::size_t> continues;
  };
  Loop* find_loop(const std::string& label, std::string_view keyword);
  // At the beginning of a body.
  void begin_loop(const std::string& label) { loops_.push_back({label, code_.position(), {}, {}}); }
  void end_loop();
  void check_cases(const Switch& statement);
  bool compile_case(const SwitchCase& one, const Symbol& symbol, std::vector<std::size_t>& ends);

  Reporter& reporter_;
  Program& program_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
  BodyCompiler& bodies_;
  std::vector<Loop> loops_;
};

}  // namespace stanok::lang
