#include "lang/program/expression_compiler.h"

#include <cmath>
#include <utility>

#include "lang/block/other_controls.h"
#include "lang/block/predefined_parameter.h"
#include "lang/text/number.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {
namespace {

bool is_equality(Operation operation) {
  return operation == Operation::equal || operation == Operation::not_equal;
}

bool is_logical(Operation operation) {
  return operation == Operation::logical_and || operation == Operation::logical_or;
}

}  // namespace

bool ExpressionCompiler::require(const Expression& expression, Type type, std::string_view what) {
  const ValueType found = compile_expression(expression);
  if (!found.known()) return false;
  if (found.is(type)) return true;
  const std::string found_name =
      found.dimensions != 0 ? "an array" : "a " + std::string(type_name(found.type));
  Diagnostic& diagnostic = reporter_.error(
      "E3004", expression.span,
      std::string(what) + " must be a " + std::string(type_name(type)) + ", not " + found_name,
      "this is " + found_name);
  if (type == Type::string && found.is(Type::number)) {
    diagnostic.help.push_back("convert it: `str (" +
                              std::string(file_.source.text(expression.span)) + ")`");
  }
  return false;
}

ValueType ExpressionCompiler::compile_expression(const Expression& expression) {
  switch (expression.node) {
    case Node::number:
      code_.push_number(expression.number, expression.span);
      return {Type::number, 0};
    case Node::boolean:
      code_.push_number(expression.number, expression.span);
      return {Type::boolean, 0};
    case Node::string:
      code_.push_text(expression.text, expression.span);
      return {Type::string, 0};
    case Node::name:
      return compile_name(expression);
    case Node::element:
      return compile_element(expression);
    case Node::call:
      return calls_.compile_call(expression, CallCompiler::Form::expression);
    case Node::unary:
      return compile_unary(expression);
    case Node::binary:
      return compile_binary(expression);
    case Node::conditional:
      return compile_conditional(expression);
    case Node::parameter:
    case Node::vacant_parameter:
    case Node::named_parameter:
    case Node::r_parameter:
    case Node::exists:
      return compile_parameter(expression);
    case Node::axis:
      return compile_axis(expression);
    case Node::system_variable:
      return compile_system_variable(expression);
  }
  return {};
}

ValueType ExpressionCompiler::compile_name(const Expression& name) {
  if (const Symbol* const symbol = symbols_.find(name.text)) {
    if (symbol->shared >= 0 && symbol->type.dimensions != 0) {
      reporter_.error("E3004", name.span, "a shared array cannot be used as a whole",
                      "name an element");
      return {};
    }
    if (symbol->constant) {
      code_.push_constant(*symbol->constant, name.span);
    } else {
      symbols_.load(*symbol, name.span);
    }
    return symbol->type;
  }
  if (const auto constant = symbols_.find_constant(name.text)) {
    code_.push_constant(*constant, name.span);
    return {constant->type, 0};
  }
  const SymbolTable::NameTest defines = [](const FileNames& names, const std::string& wanted) {
    return names.constants.contains(wanted);
  };
  if (!symbols_.refuse_ambiguous(name.text, name.span, defines)) {
    symbols_.report_unknown(name.text, name.span, "variable");
  }
  return {};
}

ValueType ExpressionCompiler::compile_element_address(const Expression& element) {
  const Symbol* const symbol = symbols_.find(element.text);
  if (symbol == nullptr) {
    symbols_.report_unknown(element.text, element.span, "array");
    return {};
  }
  const int dimensions = symbol->type.dimensions;
  const auto given = static_cast<int>(element.children.size());
  if (dimensions == 0 || given > 2 || (dimensions > 0 && given != dimensions)) {
    reporter_.error("E3004", element.span,
                    dimensions == 0 ? "`" + element.text + "` is not an array"
                                    : "`" + element.text + "` has " + std::to_string(dimensions) +
                                          (dimensions == 1 ? " dimension" : " dimensions"),
                    "wrong number of indices");
    return {};
  }
  const ValueType type{symbol->type.type, 0};
  symbols_.load(*symbol, element.span);
  for (const Expression& index : element.children) {
    if (!require(index, Type::number, "the index")) return {};
  }
  return type;
}

ValueType ExpressionCompiler::compile_element(const Expression& element) {
  const ValueType type = compile_element_address(element);
  if (!type.known()) return {};
  const int shared = symbols_.find(element.text)->shared;
  code_.emit(shared >= 0 ? Op::read_shared : Op::element, element.span,
             shared >= 0 ? static_cast<std::uint32_t>(shared) : 0,
             static_cast<std::uint8_t>(element.children.size()));
  return type;
}

ValueType ExpressionCompiler::compile_unary(const Expression& unary) {
  const bool logical = unary.operation == Operation::logical_not;
  const Type type = logical ? Type::boolean : Type::number;
  if (const auto constant = symbols_.constant_of(unary)) {
    code_.push_constant(*constant, unary.span);
    return {constant->type, 0};
  }
  if (!require(unary.children[0], type, "the operand")) return {};
  code_.emit(Op::compute, unary.span, 0, 1, static_cast<std::uint16_t>(unary.operation));
  return {type, 0};
}

ValueType ExpressionCompiler::compile_binary(const Expression& binary) {
  if (is_logical(binary.operation)) return compile_logical(binary);
  if (const auto constant = symbols_.constant_of(binary)) {
    code_.push_constant(*constant, binary.span);
    return {constant->type, 0};
  }
  const Expression& left_operand = binary.children[0];
  const Expression& right_operand = binary.children[1];
  const ValueType left = compile_expression(left_operand);
  if (!left.known()) return {};
  const bool joins = binary.operation == Operation::add && left.is(Type::string);
  const bool scalar = left.dimensions == 0;
  const bool equality = is_equality(binary.operation) && scalar;
  if (!joins && !equality && !left.is(Type::number)) {
    reporter_.error("E3004", left_operand.span,
                    "this operator does not work on " +
                        (scalar ? "a " + std::string(type_name(left.type)) : "an array"),
                    "not a num");
    return {};
  }
  if (!require(right_operand, left.type, "the right operand")) return {};
  if (joins) {
    code_.emit(Op::join_texts, binary.span);
    return {Type::string, 0};
  }
  if (left.is(Type::string)) {
    code_.emit(Op::texts_equal, binary.span);
    if (binary.operation == Operation::not_equal) {
      code_.emit(Op::compute, binary.span, 0, 1,
                 static_cast<std::uint16_t>(Operation::logical_not));
    }
    return {Type::boolean, 0};
  }
  const auto left_value = symbols_.constant_of(left_operand);
  const auto right_value = symbols_.constant_of(right_operand);
  ArithmeticFault fault{};
  if (left_value && right_value &&
      !computed(binary.operation, left_value->number, right_value->number, fault)) {
    reporter_.error(fault.code, binary.span, fault.message, "");
    return {};
  }
  code_.emit(Op::compute, binary.span, 0, 0, static_cast<std::uint16_t>(binary.operation));
  return {is_comparison(binary.operation) ? Type::boolean : Type::number, 0};
}

// && and || compute the right operand only when it decides.
ValueType ExpressionCompiler::compile_logical(const Expression& binary) {
  if (!require(binary.children[0], Type::boolean, "the left operand")) return {};
  const bool conjunction = binary.operation == Operation::logical_and;
  const std::size_t end =
      code_.emit(conjunction ? Op::jump_if_false_keep : Op::jump_if_true_keep, binary.span);
  if (!require(binary.children[1], Type::boolean, "the right operand")) return {};
  code_.patch(end);
  return {Type::boolean, 0};
}

ValueType ExpressionCompiler::compile_conditional(const Expression& conditional) {
  compile_condition(conditional.children[0]);
  const std::size_t otherwise = code_.emit(Op::jump_if_false, conditional.span);
  const ValueType type = compile_expression(conditional.children[1]);
  const std::size_t end = code_.emit(Op::jump, conditional.span);
  code_.patch(otherwise);
  if (!type.known() || !require(conditional.children[2], type.type, "the second value")) return {};
  code_.patch(end);
  return type;
}

ValueType ExpressionCompiler::compile_parameter(const Expression& parameter) {
  switch (parameter.node) {
    case Node::parameter:
    case Node::vacant_parameter:
      if (!require(parameter.children[0], Type::number, "the parameter number")) return {};
      note_use(parameter, ParameterAccess::read);
      code_.emit(Op::parameter, parameter.span, 0, 0,
                 parameter.node == Node::vacant_parameter ? 1 : 0);
      return {Type::number, 0};
    case Node::named_parameter:
      if (const PredefinedParameter* const row = find_predefined_parameter(parameter.text)) {
        code_.emit(Op::predefined_parameter, parameter.span,
                   static_cast<std::uint32_t>(row - predefined_parameters().data()));
      } else {
        code_.emit(Op::named_parameter, parameter.span,
                   symbols_.named_parameter_slot(parameter.text));
      }
      return {Type::number, 0};
    case Node::exists:
      if (find_predefined_parameter(parameter.children[0].text) != nullptr) {
        code_.push_number(1.0, parameter.span);
      } else {
        code_.emit(Op::named_parameter_exists, parameter.span,
                   symbols_.named_parameter_slot(parameter.children[0].text));
      }
      return {Type::number, 0};
    default:
      break;
  }
  if (parameter.number > 999.0) {
    reporter_.error("E3015", parameter.span, "there is no R-parameter of this number",
                    "R0 to R999 exist");
    return {};
  }
  code_.emit(Op::r_parameter, parameter.span, static_cast<std::uint32_t>(parameter.number));
  return {Type::number, 0};
}

void ExpressionCompiler::note_use(const Expression& parameter, ParameterAccess access) {
  const Expression& number = parameter.children[0];
  constexpr double number_max = 9999.0;
  const bool known = number.node == Node::number && is_integer(number.number) &&
                     number.number >= 0.0 && number.number <= number_max;
  if (!known || file_.source.rules().is_fanuc()) return;
  const auto constant = static_cast<int>(std::lround(number.number));
  if (meaning_on_fanuc(constant).empty()) return;
  file_.parameter_uses.push_back({constant, access, parameter.span});
}

ValueType ExpressionCompiler::compile_axis(const Expression& axis) {
  if (channel_ != nullptr && !channel_->axis_called(axis.text).exists()) {
    reporter_.error("E4010", axis.span, "this channel has no axis `" + axis.text + "`",
                    "not an axis of channel " + std::to_string(context_.channel->id));
    return {};
  }
  file_.texts.push_back(axis.text);
  code_.emit(Op::push_axis, axis.span, static_cast<std::uint32_t>(file_.texts.size() - 1));
  return {Type::axis, 0};
}

ValueType ExpressionCompiler::compile_system_variable(const Expression& variable) {
  const SystemVariable* const row = find_system_variable(variable.text);
  if (row == nullptr) {
    std::vector<std::string_view> names;
    for (const SystemVariable& known : system_variables()) names.push_back(known.name);
    Diagnostic& diagnostic = reporter_.error(
        "E3001", variable.span, "unknown system variable `$" + variable.text + "`", "");
    const std::string_view nearest = nearest_name(variable.text, names);
    if (!nearest.empty()) {
      diagnostic.help.push_back("did you mean `$" + std::string(nearest) + "`?");
    }
    return {};
  }
  const bool has_index = !variable.children.empty();
  if (has_index != (row->index != Type::none) && !(has_index && row->name == "speed")) {
    reporter_.error("E3005", variable.span,
                    "`$" + variable.text + "` " + (has_index ? "takes no index" : "needs an index"),
                    "");
    return {};
  }
  const Type index_type = row->index == Type::none ? Type::number : row->index;
  if (has_index && !require(variable.children[0], index_type, "the index")) return {};
  const auto index = static_cast<std::uint32_t>(row - system_variables().data());
  code_.emit(row->of_machine ? Op::request_value : Op::system_value, variable.span, index,
             has_index ? 1 : 0);
  return {row->result, 0};
}

void ExpressionCompiler::compile_condition(const Expression& condition) {
  const ValueType type = compile_expression(condition);
  if (!type.known() || type.is(Type::boolean)) return;
  Diagnostic& diagnostic = reporter_.error("E3006", condition.span, "a condition must be a bool",
                                           "this is a " + std::string(type_name(type.type)));
  if (!type.is(Type::number)) return;
  diagnostic.help.push_back("write `" + std::string(file_.source.text(condition.span)) + " != 0`");
}

}  // namespace stanok::lang
