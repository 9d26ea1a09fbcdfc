#include "lang/program/routine_compiler.h"

#include <utility>

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

void RoutineCompiler::declare(const FunctionDefinition& function) {
  const auto index = static_cast<std::uint32_t>(file_.functions.size());
  FileNames& names = context_.names[context_.file];
  if (!names.functions.emplace(folded(function.name), index).second) {
    reporter_.error("E3002", function.name_span,
                    "the function `" + function.name + "` is defined twice", "second definition");
    return;
  }
  FunctionCode code;
  code.signature = {function.result, function.name, function.name_span, function.parameters};
  fold_default_values(code.signature);
  file_.functions.push_back(std::move(code));
  file_.function_by_name.emplace(folded(function.name), index);
  function_index_[&function] = index;
}

// Default values become literals, so that every file that calls the function can use them.
void RoutineCompiler::fold_default_values(FunctionSignature& signature) {
  bool has_default = false;
  for (FunctionParameter& parameter : signature.parameters) {
    if (has_default && !parameter.initial) {
      reporter_.error("E3007", parameter.span, "parameters with default values must come last",
                      "no default value");
      return;
    }
    if (!parameter.initial) continue;
    has_default = true;
    const auto value = symbols_.constant_of(*parameter.initial);
    if (!value || value->type != parameter.type || parameter.reference || parameter.array) {
      reporter_.error("E3007", parameter.initial->span,
                      "a default value is a constant " + std::string(type_name(parameter.type)) +
                          " for a parameter by value",
                      "not such a constant");
      return;
    }
    parameter.initial->node = value->type == Type::string    ? Node::string
                              : value->type == Type::boolean ? Node::boolean
                                                             : Node::number;
    parameter.initial->number = value->number;
    parameter.initial->text = value->text;
    parameter.initial->children.clear();
  }
}

void RoutineCompiler::compile(const Return& statement) {
  if (routine_ != Routine::function) {
    reporter_
        .error("E3016", code_.statement_span(), "`return` outside a function",
               "no function to leave")
        .help.push_back(
            "a program file ends with M30, a subprogram with M99, `O... sub` with "
            "`O... return`");
    return;
  }
  const Type result = function_->result;
  if (statement.value && result == Type::none) {
    reporter_.error("E3004", statement.value->span, "a `void` function returns no value",
                    "unnecessary value");
    return;
  }
  if (!statement.value && result != Type::none) {
    reporter_.error("E3004", code_.statement_span(),
                    "`" + function_->name + "` must return a " + std::string(type_name(result)),
                    "no value");
    return;
  }
  if (statement.value && !expressions_.require(*statement.value, result, "the result")) return;
  code_.emit(statement.value ? Op::return_value : Op::return_nothing, code_.statement_span());
}

void RoutineCompiler::compile_routine(const FunctionDefinition& function) {
  const auto found = function_index_.find(&function);
  if (found == function_index_.end()) return;
  const std::uint32_t index = found->second;
  function_ = &function;
  begin_routine(Routine::function, index);
  for (const FunctionParameter& parameter : function.parameters) {
    Symbol symbol;
    symbol.type = {parameter.type, parameter.array ? -1 : 0};
    symbol.reference = parameter.reference && !parameter.array;
    symbols_.declare(parameter.name, parameter.span, symbol);
  }
  bodies_.compile_body(function.body);
  if (function.result != Type::none && !returns_always(function.body)) {
    reporter_.error("E3012", function.name_span,
                    "`" + function.name + "` does not return a value on every path",
                    "a path ends without `return`");
  }
  code_.emit(Op::return_nothing, function.name_span);
  end_routine(index);
  function_ = nullptr;
}

void RoutineCompiler::begin_routine(Routine routine, std::uint32_t index) {
  routine_ = routine;
  file_.functions[index].entry = code_.position();
  symbols_.begin_routine();
}

void RoutineCompiler::end_routine(std::uint32_t index) {
  file_.functions[index].slots = symbols_.end_routine();
  routine_ = Routine::none;
}

void RoutineCompiler::declare(const OSubprogram& subprogram) {
  const auto index = static_cast<std::uint32_t>(file_.functions.size());
  const OLabel& label = subprogram.label;
  if (!context_.names[context_.file].o_subprograms.emplace(label.name, index).second) {
    reporter_.error("E3002", label.span, "the subprogram O" + label.name + " is defined twice",
                    "second definition");
    return;
  }
  FunctionCode code;
  code.signature = {Type::none, "O" + label.name, label.span, {}};
  code.o_subprogram = true;
  file_.functions.push_back(std::move(code));
  file_.o_subprograms.emplace(label.name, index);
  o_subprogram_index_[&subprogram] = index;
}

void RoutineCompiler::compile_routine(const OSubprogram& subprogram) {
  const auto found = o_subprogram_index_.find(&subprogram);
  if (found == o_subprogram_index_.end()) return;
  const std::uint32_t index = found->second;
  begin_routine(Routine::o_subprogram, index);
  bodies_.compile_body(subprogram.body);
  code_.set_statement_span(subprogram.label.span);
  compile(OReturn{subprogram.value});
  end_routine(index);
}

void RoutineCompiler::compile(const OReturn& statement) {
  if (routine_ != Routine::o_subprogram) {
    reporter_.error("E3016", code_.statement_span(), "`O... return` outside a subprogram",
                    "no `O... sub` to leave");
    return;
  }
  if (statement.value && !expressions_.require(*statement.value, Type::number, "the result"))
    return;
  code_.emit(Op::return_from_o_sub, code_.statement_span(), 0, statement.value ? 1 : 0);
}

void RoutineCompiler::compile(const OCall& call) {
  for (const Expression& argument : call.arguments) {
    if (!expressions_.require(argument, Type::number, "the argument")) return;
  }
  OCallCode code;
  code.computed = call.label.computed.has_value();
  if (code.computed) {
    if (!expressions_.require(*call.label.computed, Type::number, "the number of the subprogram"))
      return;
  } else if (const auto callee = find_o_subprogram(call.label)) {
    code.callee = *callee;
  } else {
    return;
  }
  file_.o_calls.push_back(code);
  code_.emit(Op::call_o_sub, code_.statement_span(),
             static_cast<std::uint32_t>(file_.o_calls.size() - 1),
             static_cast<std::uint8_t>(call.arguments.size()));
}

// In this file, then in the included ones (once), then in the file of that name.
std::optional<Callee> RoutineCompiler::find_o_subprogram(const OLabel& label) {
  const auto look_in = [&](std::uint16_t file) -> std::optional<Callee> {
    const auto& known = context_.names[file].o_subprograms;
    const auto found = known.find(label.name);
    if (found == known.end()) return std::nullopt;
    return Callee{file, found->second};
  };
  if (auto own = look_in(context_.file)) return own;
  std::optional<Callee> hit;
  for (const std::uint16_t file : file_.includes) {
    const auto found = look_in(file);
    if (!found || (hit && hit->file == file)) continue;
    if (hit) {
      const auto& files = context_.program.files;
      reporter_
          .error("E7006", label.span, "O" + label.name + " is in two included files",
                 "it is not clear which one is meant")
          .notes.push_back(
              {"in " + files[hit->file]->source.name() + " and in " + files[file]->source.name(),
               {}});
      return std::nullopt;
    }
    hit = found;
  }
  if (hit) return hit;
  const auto file = context_.program.file_by_label.find({context_.file, label.name});
  if (file != context_.program.file_by_label.end()) {
    if (auto found = look_in(file->second)) return found;
  }
  reporter_
      .error("E7005", label.span, "there is no subprogram O" + label.name,
             file == context_.program.file_by_label.end()
                 ? "not in this file, nor in an included one, nor a file of that name"
                 : "the file of that name does not hold it")
      .help.push_back("begin it with `O" + label.name + " sub`");
  return std::nullopt;
}

}  // namespace stanok::lang
