// The names of one file: scopes of variables, constants, functions of included files.
//
// Owner: Compiler. Owns the scopes and counts the slots of variables. Invariants: the innermost
// scope is the last; slots of a routine are counted from its beginning, others from that of the
// file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/program/code_builder.h"
#include "lang/program/compiler_context.h"

namespace stanok::lang {

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

class SymbolTable {
 public:
  // Both must outlive this. Begins with the scope of the file.
  SymbolTable(const CompilerContext& context, CodeBuilder& code);

  void open_scope() { scopes_.emplace_back(); }
  void close_scope() { scopes_.pop_back(); }
  [[nodiscard]] bool at_file_level() const { return scopes_.size() == 1; }
  // A function or subprogram, with the scope of its parameters; end_routine() returns its slots.
  void begin_routine();
  std::uint32_t end_routine();

  // Reports a name that is declared already; nullptr then.
  Symbol* declare(std::string_view name, const Span& span, Symbol symbol);
  // A variable without a name.
  [[nodiscard]] Symbol unnamed(ValueType type);
  [[nodiscard]] const Symbol* find(std::string_view name) const;
  // Code that reads or stores the value of a variable.
  void load(const Symbol& symbol, const Span& span);
  void store(const Symbol& symbol, const Span& span);

  [[nodiscard]] std::optional<Constant> find_constant(std::string_view name) const;
  // The value of an expression of constants, if it has one; reports nothing.
  [[nodiscard]] std::optional<Constant> constant_of(const Expression& expression) const;
  [[nodiscard]] std::optional<Callee> find_function(std::string_view name) const;
  // The slot of #<name>.
  [[nodiscard]] std::uint32_t named_parameter_slot(const std::string& name);

  // Reports a name of two included files that this file has not itself.
  using NameTest = bool (*)(const FileNames& names, const std::string& folded_name);
  bool refuse_ambiguous(std::string_view name, const Span& span, NameTest defines);
  void report_unknown(std::string_view name, const Span& span, std::string_view what);

 private:
  std::uint32_t new_slot();
  [[nodiscard]] std::vector<std::string_view> known_names() const;

  const CompilerContext& context_;
  Reporter& reporter_;
  CompiledFile& file_;
  CodeBuilder& code_;
  std::vector<std::map<std::string, Symbol>> scopes_;
  std::optional<std::uint32_t> routine_slots_;  // nothing: text of the file
};

}  // namespace stanok::lang
