// Code of control flow and functions.
#include <set>
#include <utility>

#include "lang/program/compiler.h"

namespace stanok::lang {
namespace {

bool returns_always(const StatementList& list);

bool returns(const Statement& statement) {
  if (std::holds_alternative<Return>(statement.kind)) return true;
  if (const auto* compound = std::get_if<Compound>(&statement.kind)) {
    return returns_always(compound->body);
  }
  if (const auto* branch = std::get_if<If>(&statement.kind)) {
    return returns_always(branch->then_body) && returns_always(branch->else_body);
  }
  if (const auto* call = std::get_if<CallStatement>(&statement.kind)) {
    return folded(call->call.text) == "terminate";
  }
  if (const auto* choice = std::get_if<Switch>(&statement.kind)) {
    bool has_default = false;
    for (const SwitchCase& one : choice->cases) {
      if (!returns_always(one.body)) return false;
      has_default = has_default || one.values.empty();
    }
    return has_default;
  }
  return false;
}

bool returns_always(const StatementList& list) {
  return !list.empty() && returns(list.back());
}

}  // namespace

void Compiler::compile_kind(const Compound& compound) {
  compile_body(compound.body);
}

void Compiler::compile_condition(const Expression& condition) {
  const ValueType type = compile_expression(condition);
  if (!type.known() || type.is(Type::boolean)) return;
  Diagnostic& diagnostic = reporter_.error("E3006", condition.span, "a condition must be a bool",
                                           "this is a " + std::string(type_name(type.type)));
  if (!type.is(Type::number)) return;
  diagnostic.help.push_back("write `" + std::string(file_.source.text(condition.span)) + " != 0`");
}

void Compiler::compile_kind(const If& statement) {
  compile_condition(statement.condition);
  const std::size_t otherwise = emit(Op::jump_if_false, statement.condition.span);
  compile_body(statement.then_body);
  if (statement.else_body.empty()) return patch(otherwise);
  const std::size_t end = emit(Op::jump, statement_span_);
  patch(otherwise);
  compile_body(statement.else_body);
  patch(end);
}

void Compiler::compile_kind(const While& loop) {
  const std::uint32_t start = position();
  compile_condition(loop.condition);
  const std::size_t end = emit(Op::jump_if_false, loop.condition.span);
  loops_.push_back({loop.label, {}, {}});
  compile_body(loop.body);
  for (const std::size_t jump : loops_.back().continues) file_.code[jump].operand = start;
  emit(Op::jump, loop.condition.span, start);
  patch(end);
  patch_all(loops_.back().breaks);
  loops_.pop_back();
}

void Compiler::compile_kind(const DoWhile& loop) {
  const std::uint32_t start = position();
  loops_.push_back({loop.label, {}, {}});
  compile_body(loop.body);
  patch_all(loops_.back().continues);
  compile_condition(loop.condition);
  const std::size_t end = emit(Op::jump_if_false, loop.condition.span);
  emit(Op::jump, loop.condition.span, start);
  patch(end);
  patch_all(loops_.back().breaks);
  loops_.pop_back();
}

void Compiler::compile_kind(const For& loop) {
  scopes_.emplace_back();
  compile_list(loop.start);
  const std::uint32_t start = position();
  std::optional<std::size_t> end;
  if (loop.condition) {
    compile_condition(*loop.condition);
    end = emit(Op::jump_if_false, loop.condition->span);
  }
  loops_.emplace_back();
  compile_body(loop.body);
  patch_all(loops_.back().continues);
  compile_list(loop.step);
  emit(Op::jump, statement_span_, start);
  if (end) patch(*end);
  patch_all(loops_.back().breaks);
  loops_.pop_back();
  scopes_.pop_back();
}

// The value is kept in a slot of its own and compared case by case.
void Compiler::compile_kind(const Switch& statement) {
  check_cases(statement);
  const ValueType type = compile_expression(statement.value);
  if (!type.known()) return;
  if (!type.is(Type::number) && !type.is(Type::string)) {
    reporter_.error("E3004", statement.value.span, "`switch` takes a num or a string",
                    "this is a " + std::string(type_name(type.type)));
    return;
  }
  Symbol symbol;
  symbol.type = type;
  symbol.slot = new_slot();
  symbol.file_level = routine_ == Routine::none;
  store(symbol, statement.value.span);
  std::vector<std::size_t> ends;
  const SwitchCase* otherwise = nullptr;
  for (const SwitchCase& one : statement.cases) {
    if (one.values.empty()) {
      otherwise = &one;
      continue;
    }
    std::vector<std::size_t> hits;
    for (const Expression& value : one.values) {
      load(symbol, value.span);
      if (!require(value, type.type, "the case")) return;
      if (type.is(Type::string)) {
        emit(Op::texts_equal, value.span);
      } else {
        emit(Op::compute, value.span, 0, 0, static_cast<std::uint16_t>(Operation::equal));
      }
      const std::size_t next = emit(Op::jump_if_false, value.span);
      hits.push_back(emit(Op::jump, value.span));
      patch(next);
    }
    const std::size_t next_case = emit(Op::jump, one.span);
    patch_all(hits);
    compile_body(one.body);
    ends.push_back(emit(Op::jump, one.span));
    patch(next_case);
  }
  if (otherwise != nullptr) compile_body(otherwise->body);
  patch_all(ends);
}

void Compiler::check_cases(const Switch& statement) {
  std::set<std::pair<double, std::string>> seen;
  bool has_default = false;
  for (const SwitchCase& one : statement.cases) {
    if (one.values.empty() && std::exchange(has_default, true)) {
      reporter_.error("E3018", one.span, "a `switch` has one `default`", "second `default`");
    }
    for (const Expression& value : one.values) {
      const auto constant = constant_of(value);
      if (!constant) {
        reporter_.error("E3007", value.span, "a case must be constant", "not a constant");
        continue;
      }
      if (!seen.emplace(constant->number, constant->text).second)
        reporter_.error("E3018", value.span, "this case stands twice", "same value as before");
    }
  }
}

// The innermost loop, or the one of that label.
Compiler::Loop* Compiler::find_loop(const std::string& label, std::string_view keyword) {
  for (auto loop = loops_.rbegin(); loop != loops_.rend(); ++loop) {
    if (label.empty() || loop->label == label) return &*loop;
  }
  reporter_.error("E3016", statement_span_,
                  label.empty() ? "`" + std::string(keyword) + "` outside a loop"
                                : "`" + std::string(keyword) + "` outside the loop O" + label,
                  "no loop that is meant");
  return nullptr;
}

void Compiler::compile_kind(const Break& leave) {
  Loop* const loop = find_loop(leave.label, "break");
  if (loop != nullptr) loop->breaks.push_back(emit(Op::jump, statement_span_));
}

void Compiler::compile_kind(const Continue& next) {
  Loop* const loop = find_loop(next.label, "continue");
  if (loop != nullptr) loop->continues.push_back(emit(Op::jump, statement_span_));
}

void Compiler::compile_kind(const Return& statement) {
  if (routine_ != Routine::function) {
    reporter_.error("E3016", statement_span_, "`return` outside a function", "no function to leave")
        .help.push_back(
            "a program file ends with M30, a subprogram with M99, `O... sub` with "
            "`O... return`");
    return;
  }
  const Type result = function_->result;
  if (statement.value && result == Type::none) {
    reporter_.error("E3004", statement.value->span, "a `void` function returns no value",
                    "superfluous value");
    return;
  }
  if (!statement.value && result != Type::none) {
    reporter_.error("E3004", statement_span_,
                    "`" + function_->name + "` must return a " + std::string(type_name(result)),
                    "no value");
    return;
  }
  if (statement.value && !require(*statement.value, result, "the result")) return;
  emit(statement.value ? Op::return_value : Op::return_nothing, statement_span_);
}

void Compiler::compile_kind(const FunctionDefinition&) {}

void Compiler::compile_function(const FunctionDefinition& function, std::uint32_t index) {
  function_ = &function;
  routine_ = Routine::function;
  begin_routine(index);
  for (const FunctionParameter& parameter : function.parameters) {
    Symbol symbol;
    symbol.type = {parameter.type, parameter.array ? -1 : 0};
    symbol.reference = parameter.reference && !parameter.array;
    declare(parameter.name, parameter.span, symbol);
  }
  compile_body(function.body);
  if (function.result != Type::none && !returns_always(function.body)) {
    reporter_.error("E3012", function.name_span,
                    "`" + function.name + "` does not return a value on every path",
                    "a path ends without `return`");
  }
  emit(Op::return_nothing, function.name_span);
  end_routine(index);
  function_ = nullptr;
}

void Compiler::begin_routine(std::uint32_t index) {
  routine_slots_ = 0;
  loops_.clear();
  file_.functions[index].entry = position();
  scopes_.emplace_back();
}

void Compiler::end_routine(std::uint32_t index) {
  scopes_.pop_back();
  file_.functions[index].slots = routine_slots_;
  routine_ = Routine::none;
}

}  // namespace stanok::lang
