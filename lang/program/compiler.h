// Compiles the tree of one program file: names, types, and the code.
//
// Text below a reported error gets no code; reading goes on so that all errors of a file are found.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/program/code.h"
#include "lang/program/program.h"
#include "lang/text/compile_watch.h"
#include "lang/text/reporter.h"
#include "lang/tree/builtin.h"
#include "lang/tree/tree.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

struct Constant {
  Type type = Type::number;
  double number = 0.0;
  std::string text;
};

// What a file offers to the files that include it. Names are folded.
struct FileNames {
  std::map<std::string, std::uint32_t> functions;      // index in CompiledFile::functions
  std::map<std::string, std::uint32_t> o_subprograms;  // the same, by label
  std::map<std::string, Constant> constants;
};

struct CompilerContext {
  Program& program;
  std::uint16_t file = 0;
  const ChannelDescription* channel = nullptr;  // nullptr: no channel-dependent checks
  const ChannelDialect& dialect;
  std::vector<FileNames>& names;  // of all files, by index
  Reporter& reporter;
  const CompileWatch& watch;
};

class Compiler {
 public:
  explicit Compiler(CompilerContext context);

  // First for all files: the functions and constants that others may use.
  void declare_names(const StatementList& tree);
  // Then the code.
  void compile(const StatementList& tree);

 private:
  struct ValueType {
    Type type = Type::unknown;
    int dimensions = 0;

    [[nodiscard]] bool is(Type scalar) const { return type == scalar && dimensions == 0; }
    [[nodiscard]] bool known() const { return type != Type::unknown; }
  };
  struct Symbol {
    ValueType type;
    std::uint32_t slot = 0;
    bool file_level = true;
    bool reference = false;
    bool read_only = false;
    int shared = -1;  // number among the shared variables of the file
    std::optional<Constant> constant;
    Span span;
  };
  struct Loop {
    std::string label;                // of O-lines
    std::vector<std::size_t> breaks;  // jumps to patch
    std::vector<std::size_t> continues;
  };

  // compiler.cc: names and statements
  void declare_constants(const Declaration& declaration);
  void declare_function(const FunctionDefinition& function);
  void fold_default_values(FunctionSignature& signature);
  void compile_list(const StatementList& list);
  void compile_statement(const Statement& statement);
  void compile_body(const StatementList& list);  // with its own scope
  void drop_code_from(std::size_t start);
  void compile_kind(const PlainLines& lines);
  void compile_kind(const IncludeDirective&);
  void compile_kind(const KinematicsDirective& directive);
  void compile_kind(const WorkpieceDirective& directive);
  void compile_kind(const ToolOverhangDirective& directive);
  void compile_kind(const FeedLawDirective& directive);
  void compile_kind(const AdaptiveDirective& directive);
  void compile_kind(const NumberedProgram& start);
  void compile_kind(const CallStatement& statement);
  void compile_kind(const FaultyText& text);

  // compiler_control.cc: control flow and functions
  void compile_kind(const Compound& compound);
  void compile_kind(const If& statement);
  void compile_kind(const While& loop);
  void compile_kind(const DoWhile& loop);
  void compile_kind(const For& loop);
  void compile_kind(const Switch& statement);
  void compile_kind(const Break& leave);
  void compile_kind(const Continue& next);
  Loop* find_loop(const std::string& label, std::string_view keyword);
  void compile_kind(const Return& statement);
  void compile_kind(const FunctionDefinition&);
  void compile_condition(const Expression& condition);
  void compile_function(const FunctionDefinition& function, std::uint32_t index);
  void begin_routine(std::uint32_t index);
  void end_routine(std::uint32_t index);
  void check_cases(const Switch& statement);

  // compiler_variable.cc: declarations and assignments
  void compile_kind(const Declaration& declaration);
  void compile_kind(const Assignment& assignment);
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
  Symbol* declare(std::string_view name, const Span& span, Symbol symbol);
  const Symbol* find(std::string_view name) const;
  std::optional<Constant> find_constant(std::string_view name) const;
  void load(const Symbol& symbol, const Span& span);
  void store(const Symbol& symbol, const Span& span);
  // Reports a name of two included files that this file has not itself.
  using NameTest = bool (*)(const FileNames& names, const std::string& folded_name);
  bool refuse_ambiguous(std::string_view name, const Span& span, NameTest defines);
  void report_unknown(std::string_view name, const Span& span, std::string_view what);
  std::vector<std::string_view> known_names() const;

  // compiler_expression.cc
  ValueType compile_expression(const Expression& expression);
  ValueType compile_name(const Expression& name);
  ValueType compile_element(const Expression& element);
  // Array and indices on the stack; the element's type, unknown after an error.
  ValueType compile_element_address(const Expression& element);
  ValueType compile_unary(const Expression& unary);
  ValueType compile_binary(const Expression& binary);
  ValueType compile_logical(const Expression& binary);
  ValueType compile_conditional(const Expression& conditional);
  ValueType compile_parameter(const Expression& parameter);
  ValueType compile_system_variable(const Expression& variable);
  ValueType compile_axis(const Expression& axis);
  bool require(const Expression& expression, Type type, std::string_view what);
  std::optional<Constant> constant_of(const Expression& expression) const;

  // compiler_call.cc
  enum class CallForm { expression, statement };
  ValueType compile_call(const Expression& call, CallForm form);
  bool check_argument_count(const Builtin& builtin, const Expression& call);
  bool compile_arguments(const Builtin& builtin, const Expression& call, bool& number_names_entry);
  ValueType compile_builtin(const Builtin& builtin, const Expression& call, CallForm form);
  ValueType compile_user_call(const Callee& callee, const Expression& call, CallForm form);
  bool compile_argument(const FunctionParameter& parameter, const Expression& argument);
  bool compile_reference(const FunctionParameter& parameter, const Expression& argument);
  std::optional<Callee> find_function(std::string_view name) const;
  std::optional<Type> compile_entry_name(const Expression& argument, char letter);
  void check_mark_call(const Expression& call);
  void check_channel_call(const Builtin& builtin, const Expression& call);
  std::optional<int> constant_channel(const Expression& argument, bool refuse_own,
                                      std::string_view function);

  // compiler_o_line.cc
  void declare_o_subprogram(const OSubprogram& subprogram);
  void compile_o_subprogram(const OSubprogram& subprogram, std::uint32_t index);
  void compile_kind(const OSubprogram&);
  void compile_kind(const OCall& call);
  void compile_kind(const OReturn& statement);
  void compile_kind(const ORepeat& loop);
  std::optional<Callee> find_o_subprogram(const OLabel& label);

  // compiler_iso.cc
  void compile_kind(const IsoBlock& block);
  void compile_words(const IsoBlock& block, BlockTemplate& made);
  void add_constant_word(const IsoWord& word, double value, BlockTemplate& made);
  void add_computed_word(const IsoWord& word, BlockTemplate& made);
  void compile_spindle(const IsoBlock& block, BlockTemplate& made);
  void compile_settings(const std::vector<ParameterSetting>& settings);
  std::optional<SettingTarget> compile_setting(const ParameterSetting& setting);
  void check_template(const BlockTemplate& made);
  std::uint32_t named_parameter_slot(const std::string& name);

  // code
  std::size_t emit(Op op, const Span& span, std::uint32_t operand = 0, std::uint8_t count = 0,
                   std::uint16_t extra = 0);
  void push_number(double number, const Span& span);
  void push_text(std::string text, const Span& span);
  void push_constant(const Constant& constant, const Span& span);
  [[nodiscard]] std::uint32_t position() const;
  void patch(std::size_t jump);  // to here
  void patch_all(const std::vector<std::size_t>& jumps);
  std::uint32_t new_slot();

  CompilerContext context_;
  std::optional<ChannelWords> channel_words_;  // nothing: see CompilerContext::channel
  Reporter& reporter_;
  CompiledFile& file_;
  std::vector<std::map<std::string, Symbol>> scopes_;
  std::vector<Loop> loops_;
  std::map<const FunctionDefinition*, std::uint32_t> function_index_;
  std::map<const OSubprogram*, std::uint32_t> o_subprogram_index_;
  enum class Routine { none, function, o_subprogram };
  Routine routine_ = Routine::none;               // what is compiled; none: text of the file
  const FunctionDefinition* function_ = nullptr;  // of Routine::function
  std::uint32_t routine_slots_ = 0;
  Span statement_span_;
};

}  // namespace stanok::lang
