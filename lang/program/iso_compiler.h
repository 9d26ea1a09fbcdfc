// Code of ISO blocks that are not plain: their constants in a template, the rest computed.
//
// Owner: Compiler.
#pragma once

#include <optional>
#include <vector>

#include "lang/program/expression_compiler.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

class IsoCompiler {
 public:
  // All must outlive this. `channel` nullptr: checks that depend on it are left out.
  IsoCompiler(const CompilerContext& context, CodeBuilder& code, SymbolTable& symbols,
              ExpressionCompiler& expressions, const ChannelWords* channel)
      : context_(context),
        reporter_(context.reporter),
        file_(context.compiled()),
        code_(code),
        symbols_(symbols),
        expressions_(expressions),
        channel_(channel) {}

  void compile(const IsoBlock& block);

 private:
  void compile_words(const IsoBlock& block, BlockTemplate& made);
  void add_constant_word(const IsoWord& word, double value, BlockTemplate& made);
  void add_computed_word(const IsoWord& word, BlockTemplate& made);
  void compile_spindle(const IsoBlock& block, BlockTemplate& made);
  bool compile_stop_variable(const IsoBlock& block);
  void compile_settings(const std::vector<ParameterSetting>& settings);
  std::optional<SettingTarget> compile_setting(const ParameterSetting& setting);
  void check_template(const BlockTemplate& made);

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  SymbolTable& symbols_;
  ExpressionCompiler& expressions_;
  const ChannelWords* channel_;
};

}  // namespace stanok::lang
