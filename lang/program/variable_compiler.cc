#include "lang/program/variable_compiler.h"

#include <utility>

#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

constexpr double shared_elements_max = 65536.0;

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

void VariableCompiler::compile(const Declaration& declaration) {
  for (const DeclaredItem& item : declaration.items) {
    if (declaration.shared) {
      compile_shared(item, declaration.type);
    } else {
      compile_item(declaration, item);
    }
  }
}

void VariableCompiler::compile_item(const Declaration& declaration, const DeclaredItem& item) {
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
  if (declaration.constant && item.initial) symbol.constant = symbols_.constant_of(*item.initial);
  const Symbol* const declared = symbols_.declare(item.name, item.span, std::move(symbol));
  if (declared != nullptr) symbols_.store(*declared, item.span);
}

void VariableCompiler::compile_initial(const DeclaredItem& item, Type type) {
  if (item.has_list) {
    reporter_.error("E3004", item.span, "a list is a value for arrays only", "not an array");
  } else if (item.initial) {
    expressions_.require(*item.initial, type, "the initial value");
  } else if (type == Type::string) {
    code_.push_text("", item.span);
  } else {
    code_.push_number(0.0, item.span);
  }
}

void VariableCompiler::compile_array(const DeclaredItem& item, Type type) {
  if (item.dimension_from_list && !item.has_list) {
    reporter_.error("E3017", item.span, "an array without a size needs a list of values", "");
    return;
  }
  if (item.dimension_from_list) {
    code_.push_number(static_cast<double>(item.initial_list.size()), item.span);
  }
  double size = 1.0;
  for (const Expression& dimension : item.dimensions) {
    if (!expressions_.require(dimension, Type::number, "the size")) return;
    const auto constant = symbols_.constant_of(dimension);
    if (!constant) continue;
    size *= constant->number;
    if (is_integer(constant->number) && constant->number >= 1.0 &&
        size <= static_cast<double>(limits::array_elements)) {
      continue;
    }
    reporter_.error("E3017", dimension.span,
                    "the size of an array must be a whole number from 1 to 1000000", "not a size");
    return;
  }
  const auto dimensions =
      static_cast<std::uint8_t>(item.dimension_from_list ? 1 : item.dimensions.size());
  code_.emit(Op::new_array, item.span, type == Type::string ? 1 : 0, dimensions);
  if (item.initial) {
    reporter_.error("E3004", item.initial->span, "an array takes a list of values", "not a list")
        .help.push_back("write `{...}`");
    return;
  }
  for (const Expression& value : item.initial_list) {
    if (!expressions_.require(value, type, "the element")) return;
  }
  if (item.has_list) {
    code_.emit(Op::fill_array, item.span, static_cast<std::uint32_t>(item.initial_list.size()));
  }
}

void VariableCompiler::compile(const Assignment& assignment) {
  const Expression& target = assignment.target;
  const auto symbol = assignable(target);
  if (!symbol) return;
  const ValueType type =
      target.node == Node::element ? expressions_.compile_element_address(target) : symbol->type;
  if (!type.known()) return;
  if (type.dimensions != 0) {
    reporter_.error("E3004", target.span, "an array cannot be assigned as a whole",
                    "name an element");
    return;
  }
  if (assignment.combined && symbol->shared >= 0)
    return combine_shared(assignment, *symbol, type.type);
  if (assignment.combined) load_target(target, *symbol);
  if (!expressions_.require(assignment.value, type.type, "the value")) return;
  if (assignment.combined && !combine(assignment, *assignment.combined, type.type)) return;
  store_target(target, *symbol);
}

// The variable that `target` names, unless it cannot be changed.
std::optional<Symbol> VariableCompiler::assignable(const Expression& target) {
  const Symbol* const found = symbols_.find(target.text);
  if (found == nullptr && !symbols_.find_constant(target.text)) {
    symbols_.report_unknown(target.text, target.span, "variable");
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
void VariableCompiler::load_target(const Expression& target, const Symbol& symbol) {
  if (target.node != Node::element) return symbols_.load(symbol, target.span);
  const auto indices = static_cast<std::uint8_t>(target.children.size());
  code_.emit(Op::duplicate, target.span, 0, static_cast<std::uint8_t>(indices + 1));
  code_.emit(Op::element, target.span, 0, indices);
}

// The machine reads, computes and writes at once.
void VariableCompiler::combine_shared(const Assignment& assignment, const Symbol& symbol,
                                      Type type) {
  if (!expressions_.require(assignment.value, type, "the value")) return;
  const Operation operation = *assignment.combined;
  if (type != Type::number && (type != Type::string || operation != Operation::add)) {
    refuse_combination(assignment, type);
    return;
  }
  const Expression& target = assignment.target;
  const std::size_t indices = target.node == Node::element ? target.children.size() : 0;
  code_.emit(Op::combine_shared, code_.statement_span(), static_cast<std::uint32_t>(symbol.shared),
             static_cast<std::uint8_t>(indices),
             static_cast<std::uint16_t>(combination_of(operation)));
}

void VariableCompiler::refuse_combination(const Assignment& assignment, Type type) {
  reporter_.error("E3004", assignment.target.span,
                  "this operator does not work on a " + std::string(type_name(type)), "");
}

bool VariableCompiler::combine(const Assignment& assignment, Operation operation, Type type) {
  if (type == Type::string && operation == Operation::add) {
    code_.emit(Op::join_texts, assignment.value.span);
    return true;
  }
  if (type == Type::number) {
    code_.emit(Op::compute, code_.statement_span(), 0, 0, static_cast<std::uint16_t>(operation));
    return true;
  }
  refuse_combination(assignment, type);
  return false;
}

void VariableCompiler::store_target(const Expression& target, const Symbol& symbol) {
  if (target.node != Node::element) return symbols_.store(symbol, target.span);
  const bool shared = symbol.shared >= 0;
  code_.emit(shared ? Op::write_shared : Op::store_element, target.span,
             shared ? static_cast<std::uint32_t>(symbol.shared) : 0,
             static_cast<std::uint8_t>(target.children.size()));
}

void VariableCompiler::compile_shared(const DeclaredItem& item, Type type) {
  const auto refuse = [&](std::string message, std::string label) {
    reporter_.error("E3020", item.span, std::move(message), std::move(label));
  };
  if (!symbols_.at_file_level()) {
    return refuse("a shared variable must be declared at file level", "inside braces");
  }
  if (type == Type::axis)
    return refuse("a shared variable must be a num, bool or string", "an axis");
  if (item.initial || item.has_list) {
    return refuse("a shared variable must not have an initial value",
                  "it is 0 when the machine starts");
  }
  SharedVariable variable;
  variable.name = folded(item.name);
  variable.is_text = type == Type::string;
  variable.is_bool = type == Type::boolean;
  variable.is_array = !item.dimensions.empty();
  variable.place = file_.source.place(item.span);
  std::uint32_t sizes[2] = {1, 0};
  for (std::size_t i = 0; i < item.dimensions.size() && i < 2; ++i) {
    const auto size = symbols_.constant_of(item.dimensions[i]);
    const bool good = size && size->type == Type::number && is_integer(size->number) &&
                      size->number >= 1.0 && size->number <= shared_elements_max;
    if (!good) return refuse("the size of a shared array must be a constant from 1 to 65536", "");
    sizes[i] = static_cast<std::uint32_t>(size->number);
  }
  variable.rows = sizes[0];
  variable.columns = sizes[1];
  Symbol symbol;
  symbol.type.type = type;
  symbol.type.dimensions = static_cast<int>(item.dimensions.size());
  symbol.shared = static_cast<int>(file_.shared.size());
  if (symbols_.declare(item.name, item.span, std::move(symbol)) != nullptr)
    file_.shared.push_back(std::move(variable));
}

}  // namespace stanok::lang
