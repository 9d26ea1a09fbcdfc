// Code of directives: #kinematics, #workpiece, #tool_overhang, #feedlaw, #adaptive,
// #orientation.
//
// Owner: Compiler.
#pragma once

#include "lang/program/expression_compiler.h"

namespace stanok::lang {

class DirectiveCompiler {
 public:
  // All must outlive this.
  DirectiveCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
                    ExpressionCompiler& expressions)
      : context_(context),
        reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions) {}

  void compile(const IncludeDirective&) {}
  void compile(const KinematicsDirective& directive);
  void compile(const WorkpieceDirective& directive);
  void compile(const ToolOverhangDirective& directive);
  void compile(const FeedLawDirective& directive);
  void compile(const AdaptiveDirective& directive);
  void compile(const OrientationDirective& directive);

 private:
  void note_dispatch(int channel, const Expression& scheme);

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
};

}  // namespace stanok::lang
