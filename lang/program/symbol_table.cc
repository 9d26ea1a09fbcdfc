#include "lang/program/symbol_table.h"

#include <utility>

#include "lang/tree/builtin.h"

namespace stanok::lang {
SymbolTable::SymbolTable(const CompilerContext& context, CodeBuilder& code)
    : context_(context), reporter_(context.reporter), file_(context.compiled()), code_(code) {
  open_scope();
}

void SymbolTable::begin_routine() {
  routine_slots_ = 0;
  open_scope();
}

std::uint32_t SymbolTable::end_routine() {
  close_scope();
  return *std::exchange(routine_slots_, std::nullopt);
}

Symbol SymbolTable::unnamed(ValueType type) {
  Symbol symbol;
  symbol.type = type;
  symbol.slot = new_slot();
  symbol.file_level = !routine_slots_.has_value();
  return symbol;
}

std::string_view type_name(Type type) {
  switch (type) {
    case Type::none:
      return "void";
    case Type::number:
      return "num";
    case Type::boolean:
      return "bool";
    case Type::string:
      return "string";
    case Type::axis:
      return "axis";
    case Type::unknown:
      return "unknown";
  }
  return "";
}

const Symbol* SymbolTable::find(std::string_view name) const {
  const std::string wanted = folded(name);
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const auto found = scope->find(wanted);
    if (found != scope->end()) return &found->second;
  }
  return nullptr;
}

// Constants that have no symbol here: built in, of this file (before it is compiled), of includes.
std::optional<Constant> SymbolTable::find_constant(std::string_view name) const {
  const std::string wanted = folded(name);
  if (const auto number = find_builtin_constant(wanted)) return Constant{Type::number, *number, {}};
  const auto look_in = [&](std::uint16_t file) -> std::optional<Constant> {
    const auto& constants = context_.names[file].constants;
    const auto found = constants.find(wanted);
    if (found == constants.end()) return std::nullopt;
    return found->second;
  };
  if (auto own = look_in(context_.file)) return own;
  std::optional<Constant> hit;
  std::uint16_t hit_file = 0;
  for (const std::uint16_t file : file_.includes) {
    auto included = look_in(file);
    if (!included) continue;
    if (hit && hit_file != file) return std::nullopt;  // refuse_ambiguous() says so
    hit = std::move(included);
    hit_file = file;
  }
  return hit;
}

bool SymbolTable::refuse_ambiguous(std::string_view name, const Span& span, NameTest defines) {
  const std::string wanted = folded(name);
  if (defines(context_.names[context_.file], wanted)) return false;
  std::optional<std::uint16_t> hit;
  for (const std::uint16_t file : file_.includes) {
    if (file == hit || !defines(context_.names[file], wanted)) continue;
    if (hit) {
      const auto& files = context_.program.files;
      reporter_
          .error("E7006", span, "`" + std::string(name) + "` is in two included files",
                 "it is not clear which one is meant")
          .notes.push_back(
              {"in " + files[*hit]->source.name() + " and " + files[file]->source.name(), {}});
      return true;
    }
    hit = file;
  }
  return false;
}

Symbol* SymbolTable::declare(std::string_view name, const Span& span, Symbol symbol) {
  const std::string wanted = folded(name);
  const Symbol* const outer = find(name);
  const bool function = context_.names[context_.file].functions.contains(wanted);
  if (outer != nullptr || function) {
    Diagnostic& diagnostic =
        reporter_.error("E3002", span, "`" + std::string(name) + "` is already declared",
                        "same name as an earlier one");
    if (outer != nullptr) {
      diagnostic.notes.push_back({"declared here first", file_.source.place(outer->span)});
    }
    return nullptr;
  }
  symbol.slot = new_slot();
  symbol.file_level = !routine_slots_.has_value();
  symbol.span = span;
  return &scopes_.back().emplace(wanted, std::move(symbol)).first->second;
}

// Of a shared array there is nothing to load: its elements are asked for one by one.
void SymbolTable::load(const Symbol& symbol, const Span& span) {
  if (symbol.shared >= 0) {
    if (symbol.type.dimensions == 0)
      code_.emit(Op::read_shared, span, static_cast<std::uint32_t>(symbol.shared));
    return;
  }
  const Op op = symbol.file_level  ? Op::load_file
                : symbol.reference ? Op::load_reference
                                   : Op::load_local;
  code_.emit(op, span, symbol.slot);
}

void SymbolTable::store(const Symbol& symbol, const Span& span) {
  if (symbol.shared >= 0) {
    code_.emit(Op::write_shared, span, static_cast<std::uint32_t>(symbol.shared));
    return;
  }
  const Op op = symbol.file_level  ? Op::store_file
                : symbol.reference ? Op::store_reference
                                   : Op::store_local;
  code_.emit(op, span, symbol.slot);
}

std::vector<std::string_view> SymbolTable::known_names() const {
  std::vector<std::string_view> names;
  for (const auto& scope : scopes_) {
    for (const auto& [name, symbol] : scope) names.push_back(name);
  }
  for (const auto& [name, index] : context_.names[context_.file].functions) names.push_back(name);
  for (const std::uint16_t file : file_.includes) {
    for (const auto& [name, index] : context_.names[file].functions) names.push_back(name);
    for (const auto& [name, constant] : context_.names[file].constants) names.push_back(name);
  }
  for (const Builtin& builtin : builtins()) names.push_back(builtin.name);
  return names;
}

void SymbolTable::report_unknown(std::string_view name, const Span& span, std::string_view what) {
  if (reporter_.is_spoilt(name)) return;
  Diagnostic& diagnostic = reporter_.error(
      "E3001", span, "unknown " + std::string(what) + " `" + std::string(name) + "`",
      "not declared here");
  if (!reporter_.is_kept(diagnostic)) return;
  const std::string_view nearest = nearest_name(name, known_names());
  if (!nearest.empty()) diagnostic.help.push_back("did you mean `" + std::string(nearest) + "`?");
}

std::optional<Callee> SymbolTable::find_function(std::string_view name) const {
  const std::string wanted = folded(name);
  const auto look_in = [&](std::uint16_t file) -> std::optional<Callee> {
    const auto& functions = context_.names[file].functions;
    const auto found = functions.find(wanted);
    if (found == functions.end()) return std::nullopt;
    return Callee{file, found->second};
  };
  if (auto own = look_in(context_.file)) return own;
  for (const std::uint16_t file : file_.includes) {
    if (auto included = look_in(file)) return included;
  }
  return std::nullopt;
}

std::optional<Constant> SymbolTable::constant_of(const Expression& expression) const {
  switch (expression.node) {
    case Node::number:
      return Constant{Type::number, expression.number, {}};
    case Node::boolean:
      return Constant{Type::boolean, expression.number, {}};
    case Node::string:
      return Constant{Type::string, 0.0, expression.text};
    case Node::name:
      if (const Symbol* const symbol = find(expression.text)) return symbol->constant;
      return find_constant(expression.text);
    case Node::unary: {
      const auto operand = constant_of(expression.children[0]);
      const bool logical = expression.operation == Operation::logical_not;
      if (!operand || operand->type != (logical ? Type::boolean : Type::number)) break;
      ArithmeticFault fault{};
      const auto result = computed(expression.operation, operand->number, 0.0, fault);
      if (!result) break;
      return Constant{operand->type, *result, {}};
    }
    case Node::binary: {
      const auto left = constant_of(expression.children[0]);
      const auto right = left ? constant_of(expression.children[1]) : std::nullopt;
      if (!right || left->type != Type::number || right->type != Type::number) break;
      ArithmeticFault fault{};
      const auto result = computed(expression.operation, left->number, right->number, fault);
      if (!result) break;
      return Constant{
          is_comparison(expression.operation) ? Type::boolean : Type::number, *result, {}};
    }
    default:
      break;
  }
  return std::nullopt;
}

std::uint32_t SymbolTable::named_parameter_slot(const std::string& name) {
  return context_.program.named_parameters.add(folded(name));
}

std::uint32_t SymbolTable::new_slot() {
  return routine_slots_ ? (*routine_slots_)++ : file_.file_slots++;
}

}  // namespace stanok::lang
