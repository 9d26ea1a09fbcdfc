#include "lang/program/control_compiler.h"

#include <set>
#include <utility>

#include "lang/text/number.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {

void ControlCompiler::compile(const Compound& compound) {
  bodies_.compile_body(compound.body);
}

void ControlCompiler::compile(const If& statement) {
  expressions_.compile_condition(statement.condition);
  const std::size_t otherwise = code_.emit(Op::jump_if_false, statement.condition.span);
  bodies_.compile_body(statement.then_body);
  if (statement.else_body.empty()) return code_.patch(otherwise);
  const std::size_t end = code_.emit(Op::jump, code_.statement_span());
  code_.patch(otherwise);
  bodies_.compile_body(statement.else_body);
  code_.patch(end);
}

void ControlCompiler::compile(const While& loop) {
  const std::uint32_t start = code_.position();
  expressions_.compile_condition(loop.condition);
  const std::size_t end = code_.emit(Op::jump_if_false, loop.condition.span);
  begin_loop(loop.label);
  bodies_.compile_body(loop.body);
  code_.patch_all_to(loops_.back().continues, start);
  code_.emit(Op::jump, loop.condition.span, start);
  code_.patch(end);
  end_loop();
}

void ControlCompiler::compile(const DoWhile& loop) {
  const std::uint32_t start = code_.position();
  begin_loop(loop.label);
  bodies_.compile_body(loop.body);
  code_.patch_all(loops_.back().continues);
  expressions_.compile_condition(loop.condition);
  const std::size_t end = code_.emit(Op::jump_if_false, loop.condition.span);
  code_.emit(Op::jump, loop.condition.span, start);
  code_.patch(end);
  end_loop();
}

void ControlCompiler::compile(const For& loop) {
  symbols_.open_scope();
  bodies_.compile_list(loop.start);
  const std::uint32_t start = code_.position();
  std::optional<std::size_t> end;
  if (loop.condition) {
    expressions_.compile_condition(*loop.condition);
    end = code_.emit(Op::jump_if_false, loop.condition->span);
  }
  begin_loop({});
  bodies_.compile_body(loop.body);
  code_.patch_all(loops_.back().continues);
  bodies_.compile_list(loop.step);
  code_.emit(Op::jump, code_.statement_span(), start);
  if (end) code_.patch(*end);
  end_loop();
  symbols_.close_scope();
}

// The value is kept in a slot of its own and compared case by case.
void ControlCompiler::compile(const Switch& statement) {
  check_cases(statement);
  const ValueType type = expressions_.compile_expression(statement.value);
  if (!type.known()) return;
  if (!type.is(Type::number) && !type.is(Type::string)) {
    reporter_.error("E3004", statement.value.span, "`switch` takes a num or a string",
                    "this is a " + std::string(type_name(type.type)));
    return;
  }
  const Symbol symbol = symbols_.unnamed(type);
  symbols_.store(symbol, statement.value.span);
  std::vector<std::size_t> ends;
  const SwitchCase* otherwise = nullptr;
  for (const SwitchCase& one : statement.cases) {
    if (one.values.empty()) {
      otherwise = &one;
      continue;
    }
    if (!compile_case(one, symbol, ends)) return;
  }
  if (otherwise != nullptr) bodies_.compile_body(otherwise->body);
  code_.patch_all(ends);
}

// Jumps behind the body to what comes next unless a value hits; false after an error.
bool ControlCompiler::compile_case(const SwitchCase& one, const Symbol& symbol,
                                   std::vector<std::size_t>& ends) {
  std::vector<std::size_t> hits;
  for (const Expression& value : one.values) {
    symbols_.load(symbol, value.span);
    if (!expressions_.require(value, symbol.type.type, "the case")) return false;
    if (symbol.type.is(Type::string)) {
      code_.emit(Op::texts_equal, value.span);
    } else {
      code_.emit(Op::compute, value.span, 0, 0, static_cast<std::uint16_t>(Operation::equal));
    }
    const std::size_t next = code_.emit(Op::jump_if_false, value.span);
    hits.push_back(code_.emit(Op::jump, value.span));
    code_.patch(next);
  }
  const std::size_t next_case = code_.emit(Op::jump, one.span);
  code_.patch_all(hits);
  bodies_.compile_body(one.body);
  ends.push_back(code_.emit(Op::jump, one.span));
  code_.patch(next_case);
  return true;
}

void ControlCompiler::check_cases(const Switch& statement) {
  std::set<std::pair<double, std::string>> seen;
  bool has_default = false;
  for (const SwitchCase& one : statement.cases) {
    if (one.values.empty() && std::exchange(has_default, true)) {
      reporter_.error("E3018", one.span, "a `switch` has one `default`", "second `default`");
    }
    for (const Expression& value : one.values) {
      const auto constant = symbols_.constant_of(value);
      if (!constant) {
        reporter_.error("E3007", value.span, "a case must be constant", "not a constant");
        continue;
      }
      if (!seen.emplace(constant->number, constant->text).second)
        reporter_.error("E3018", value.span, "this case appears twice",
                        "same value as an earlier case");
    }
  }
}

// The innermost loop, or the one of that label.
ControlCompiler::Loop* ControlCompiler::find_loop(const std::string& label,
                                                  std::string_view keyword) {
  for (auto loop = loops_.rbegin(); loop != loops_.rend(); ++loop) {
    if (label.empty() || loop->label == label) return &*loop;
  }
  reporter_.error("E3016", code_.statement_span(),
                  label.empty() ? "`" + std::string(keyword) + "` outside a loop"
                                : "`" + std::string(keyword) + "` outside the loop O" + label,
                  "no such loop");
  return nullptr;
}

void ControlCompiler::compile(const Break& leave) {
  Loop* const loop = find_loop(leave.label, "break");
  if (loop != nullptr) loop->breaks.push_back(code_.emit(Op::jump, code_.statement_span()));
}

void ControlCompiler::compile(const Continue& next) {
  Loop* const loop = find_loop(next.label, "continue");
  if (loop != nullptr) loop->continues.push_back(code_.emit(Op::jump, code_.statement_span()));
}

// The count is read once and rounded; the counter is a variable of its own.
void ControlCompiler::compile(const ORepeat& loop) {
  if (!expressions_.require(loop.count, Type::number, "the count")) return;
  const Span& span = loop.count.span;
  const Symbol counter = symbols_.unnamed({Type::number, 0});
  const auto* const round = find_builtin("round");
  code_.emit(Op::builtin, span, static_cast<std::uint32_t>(round - builtins().data()), 1);
  symbols_.store(counter, span);
  const std::uint32_t start = code_.position();
  const auto compute = [&](Operation operation) {
    code_.push_number(1.0, span);
    code_.emit(Op::compute, span, 0, 0, static_cast<std::uint16_t>(operation));
  };
  symbols_.load(counter, span);
  compute(Operation::greater_equal);
  const std::size_t end = code_.emit(Op::jump_if_false, span);
  begin_loop(loop.label);
  bodies_.compile_body(loop.body);
  code_.patch_all(loops_.back().continues);
  symbols_.load(counter, span);
  compute(Operation::subtract);
  symbols_.store(counter, span);
  code_.emit(Op::jump, span, start);
  code_.patch(end);
  end_loop();
}

// A constant number is looked for when the file is compiled, see Loader.
void ControlCompiler::compile(const JumpLine& jump) {
  program_.jumps = true;
  if (!expressions_.require(jump.target, Type::number, "the number of a block")) return;
  const auto number = symbols_.constant_of(jump.target);
  if (number && is_integer(number->number)) {
    file_.jumps.push_back({static_cast<int>(number->number), code_.position(), jump.target.span});
  }
  code_.emit(Op::go_to, jump.target.span);
}

void ControlCompiler::end_loop() {
  file_.loops.push_back({loops_.back().begin, code_.position()});
  code_.patch_all(loops_.back().breaks);
  loops_.pop_back();
}

void ControlCompiler::forget_jumps_from(std::size_t start) {
  const auto dropped = [start](std::size_t jump) { return jump >= start; };
  const auto dropped_code = [start](const auto& place) { return place.position >= start; };
  std::erase_if(file_.jumps, dropped_code);
  std::erase_if(file_.numbered_statements, dropped_code);
  for (Loop& loop : loops_) {
    std::erase_if(loop.breaks, dropped);
    std::erase_if(loop.continues, dropped);
  }
}

}  // namespace stanok::lang
