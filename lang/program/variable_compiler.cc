// Code of declarations and assignments; scopes and names.
#include <utility>

#include "lang/program/compiler.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

// Of +=, -=, *= and /=.
Combination combination_of(Operation operation) {
  switch (operation) {
    case Operation::subtract:
      return Combination::subtract;
    case Operation::multiply:
      return Combination::multiply;
    case Operation::divide:
      return Combination::divide;
    default:
      return Combination::add;
  }
}

}  // namespace

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

const Compiler::Symbol* Compiler::find(std::string_view name) const {
  const std::string wanted = folded(name);
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const auto found = scope->find(wanted);
    if (found != scope->end()) return &found->second;
  }
  return nullptr;
}

// Constants that have no symbol here: built in, of this file (before it is compiled), of includes.
std::optional<Constant> Compiler::find_constant(std::string_view name) const {
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

bool Compiler::refuse_ambiguous(std::string_view name, const Span& span, NameTest defines) {
  const std::string wanted = folded(name);
  if (defines(context_.names[context_.file], wanted)) return false;
  std::optional<std::uint16_t> hit;
  for (const std::uint16_t file : file_.includes) {
    if (file == hit || !defines(context_.names[file], wanted)) continue;
    if (hit) {
      const auto& files = context_.program.files;
      reporter_
          .error("E7006", span, "`" + std::string(name) + "` stands in two included files",
                 "which one is meant?")
          .notes.push_back(
              {"in " + files[*hit]->source.name() + " and " + files[file]->source.name(), {}});
      return true;
    }
    hit = file;
  }
  return false;
}

Compiler::Symbol* Compiler::declare(std::string_view name, const Span& span, Symbol symbol) {
  const std::string wanted = folded(name);
  const Symbol* const outer = find(name);
  const bool function = context_.names[context_.file].functions.contains(wanted);
  if (outer != nullptr || function) {
    Diagnostic& diagnostic =
        reporter_.error("E3002", span, "`" + std::string(name) + "` is declared already",
                        "same name as an earlier one");
    if (outer != nullptr) {
      diagnostic.notes.push_back({"declared here first", file_.source.place(outer->span)});
    }
    return nullptr;
  }
  symbol.slot = new_slot();
  symbol.file_level = routine_ == Routine::none;
  symbol.span = span;
  return &scopes_.back().emplace(wanted, std::move(symbol)).first->second;
}

// Of a shared array there is nothing to load: its elements are asked for one by one.
void Compiler::load(const Symbol& symbol, const Span& span) {
  if (symbol.shared >= 0) {
    if (symbol.type.dimensions == 0)
      emit(Op::read_shared, span, static_cast<std::uint32_t>(symbol.shared));
    return;
  }
  const Op op = symbol.file_level  ? Op::load_file
                : symbol.reference ? Op::load_reference
                                   : Op::load_local;
  emit(op, span, symbol.slot);
}

void Compiler::store(const Symbol& symbol, const Span& span) {
  if (symbol.shared >= 0) {
    emit(Op::write_shared, span, static_cast<std::uint32_t>(symbol.shared));
    return;
  }
  const Op op = symbol.file_level  ? Op::store_file
                : symbol.reference ? Op::store_reference
                                   : Op::store_local;
  emit(op, span, symbol.slot);
}

std::vector<std::string_view> Compiler::known_names() const {
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

void Compiler::report_unknown(std::string_view name, const Span& span, std::string_view what) {
  if (reporter_.is_spoilt(name)) return;
  Diagnostic& diagnostic = reporter_.error(
      "E3001", span, "unknown " + std::string(what) + " `" + std::string(name) + "`",
      "not declared here");
  if (!reporter_.is_kept(diagnostic)) return;
  const std::string_view nearest = nearest_name(name, known_names());
  if (!nearest.empty()) diagnostic.help.push_back("did you mean `" + std::string(nearest) + "`?");
}

void Compiler::compile_kind(const Declaration& declaration) {
  for (const DeclaredItem& item : declaration.items) {
    if (declaration.shared) {
      compile_shared(item, declaration.type);
    } else {
      compile_item(declaration, item);
    }
  }
}

void Compiler::compile_item(const Declaration& declaration, const DeclaredItem& item) {
  const bool array = !item.dimensions.empty() || item.dimension_from_list;
  if (declaration.constant && !item.initial && !item.has_list) {
    reporter_.error("E3007", item.span, "a constant needs a value", "no value");
    return;
  }
  if (declaration.type == Type::axis && !item.initial) {
    reporter_.error("E3007", item.span, "an axis variable needs an axis", "no value");
    return;
  }
  if (array) {
    compile_array(item, declaration.type);
  } else {
    compile_initial(item, declaration.type);
  }
  Symbol symbol;
  symbol.type.type = declaration.type;
  symbol.type.dimensions = array ? static_cast<int>(item.dimensions.size()) : 0;
  if (item.dimension_from_list) symbol.type.dimensions = 1;
  symbol.read_only = declaration.constant;
  if (declaration.constant && item.initial) symbol.constant = constant_of(*item.initial);
  const Symbol* const declared = declare(item.name, item.span, std::move(symbol));
  if (declared != nullptr) store(*declared, item.span);
}

void Compiler::compile_initial(const DeclaredItem& item, Type type) {
  if (item.has_list) {
    reporter_.error("E3004", item.span, "a list is a value for arrays only", "not an array");
  } else if (item.initial) {
    require(*item.initial, type, "the initial value");
  } else if (type == Type::string) {
    push_text("", item.span);
  } else {
    push_number(0.0, item.span);
  }
}

void Compiler::compile_array(const DeclaredItem& item, Type type) {
  if (item.dimension_from_list && !item.has_list) {
    reporter_.error("E3017", item.span, "an array without a size needs a list of values", "");
    return;
  }
  if (item.dimension_from_list) {
    push_number(static_cast<double>(item.initial_list.size()), item.span);
  }
  double size = 1.0;
  for (const Expression& dimension : item.dimensions) {
    if (!require(dimension, Type::number, "the size")) return;
    const auto constant = constant_of(dimension);
    if (!constant) continue;
    size *= constant->number;
    if (is_integer(constant->number) && constant->number >= 1.0 &&
        size <= static_cast<double>(limits::array_elements)) {
      continue;
    }
    reporter_.error("E3017", dimension.span,
                    "the size of an array is a whole number from 1 to 1000000", "not a size");
    return;
  }
  const auto dimensions =
      static_cast<std::uint8_t>(item.dimension_from_list ? 1 : item.dimensions.size());
  emit(Op::new_array, item.span, type == Type::string ? 1 : 0, dimensions);
  if (item.initial) {
    reporter_.error("E3004", item.initial->span, "an array takes a list of values", "not a list")
        .help.push_back("write `{...}`");
    return;
  }
  for (const Expression& value : item.initial_list) {
    if (!require(value, type, "the element")) return;
  }
  if (item.has_list) {
    emit(Op::fill_array, item.span, static_cast<std::uint32_t>(item.initial_list.size()));
  }
}

void Compiler::compile_kind(const Assignment& assignment) {
  const Expression& target = assignment.target;
  const auto symbol = assignable(target);
  if (!symbol) return;
  const ValueType type =
      target.node == Node::element ? compile_element_address(target) : symbol->type;
  if (!type.known()) return;
  if (type.dimensions != 0) {
    reporter_.error("E3004", target.span, "an array cannot be assigned as a whole",
                    "name an element");
    return;
  }
  if (assignment.combined && symbol->shared >= 0)
    return combine_shared(assignment, *symbol, type.type);
  if (assignment.combined) load_target(target, *symbol);
  if (!require(assignment.value, type.type, "the value")) return;
  if (assignment.combined && !combine(assignment, *assignment.combined, type.type)) return;
  store_target(target, *symbol);
}

// The variable that `target` names, unless it cannot be changed.
std::optional<Compiler::Symbol> Compiler::assignable(const Expression& target) {
  const Symbol* const found = find(target.text);
  if (found == nullptr && !find_constant(target.text)) {
    report_unknown(target.text, target.span, "variable");
    return std::nullopt;
  }
  if (found != nullptr && !found->read_only) return *found;
  Diagnostic& diagnostic = reporter_.error(
      "E3013", target.span, "`" + target.text + "` is a constant", "cannot be changed");
  if (found != nullptr && reporter_.is_kept(diagnostic))
    diagnostic.notes.push_back({"declared here", file_.source.place(found->span)});
  return std::nullopt;
}

// The value that an operator like += begins with; the address of an element stays on the stack.
void Compiler::load_target(const Expression& target, const Symbol& symbol) {
  if (target.node != Node::element) return load(symbol, target.span);
  const auto indices = static_cast<std::uint8_t>(target.children.size());
  emit(Op::duplicate, target.span, 0, static_cast<std::uint8_t>(indices + 1));
  emit(Op::element, target.span, 0, indices);
}

// The machine reads, computes and writes at once.
void Compiler::combine_shared(const Assignment& assignment, const Symbol& symbol, Type type) {
  if (!require(assignment.value, type, "the value")) return;
  const Operation operation = *assignment.combined;
  if (type != Type::number && (type != Type::string || operation != Operation::add)) {
    refuse_combination(assignment, type);
    return;
  }
  const Expression& target = assignment.target;
  const std::size_t indices = target.node == Node::element ? target.children.size() : 0;
  emit(Op::combine_shared, statement_span_, static_cast<std::uint32_t>(symbol.shared),
       static_cast<std::uint8_t>(indices), static_cast<std::uint16_t>(combination_of(operation)));
}

void Compiler::refuse_combination(const Assignment& assignment, Type type) {
  reporter_.error("E3004", assignment.target.span,
                  "this operator does not work on a " + std::string(type_name(type)), "");
}

bool Compiler::combine(const Assignment& assignment, Operation operation, Type type) {
  if (type == Type::string && operation == Operation::add) {
    emit(Op::join_texts, assignment.value.span);
    return true;
  }
  if (type == Type::number) {
    emit(Op::compute, statement_span_, 0, 0, static_cast<std::uint16_t>(operation));
    return true;
  }
  refuse_combination(assignment, type);
  return false;
}

void Compiler::store_target(const Expression& target, const Symbol& symbol) {
  if (target.node != Node::element) return store(symbol, target.span);
  const bool shared = symbol.shared >= 0;
  emit(shared ? Op::write_shared : Op::store_element, target.span,
       shared ? static_cast<std::uint32_t>(symbol.shared) : 0,
       static_cast<std::uint8_t>(target.children.size()));
}

}  // namespace stanok::lang
