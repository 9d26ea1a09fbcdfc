#include "lang/program/compiler.h"

#include <utility>

namespace stanok::lang {

Compiler::Compiler(CompilerContext context)
    : context_(std::move(context)),
      reporter_(context_.reporter),
      file_(*context_.program.files[context_.file]) {
  if (context_.channel != nullptr) channel_words_.emplace(*context_.channel);
}

void Compiler::declare_names(const StatementList& tree) {
  for (const Statement& statement : tree) {
    if (const auto* const declaration = std::get_if<Declaration>(&statement.kind)) {
      declare_constants(*declaration);
    }
  }
  for (const Statement& statement : tree) {
    if (const auto* const function = std::get_if<FunctionDefinition>(&statement.kind)) {
      declare_function(*function);
    }
    if (const auto* const subprogram = std::get_if<OSubprogram>(&statement.kind)) {
      declare_o_subprogram(*subprogram);
    }
  }
}

void Compiler::declare_constants(const Declaration& declaration) {
  if (!declaration.constant) return;
  for (const DeclaredItem& item : declaration.items) {
    if (!item.initial) continue;
    auto constant = constant_of(*item.initial);
    if (constant && constant->type == declaration.type) {
      context_.names[context_.file].constants.emplace(folded(item.name), std::move(*constant));
    }
  }
}

void Compiler::declare_function(const FunctionDefinition& function) {
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
void Compiler::fold_default_values(FunctionSignature& signature) {
  bool has_default = false;
  for (FunctionParameter& parameter : signature.parameters) {
    if (has_default && !parameter.initial) {
      reporter_.error("E3007", parameter.span, "parameters with default values come last",
                      "no default value");
      return;
    }
    if (!parameter.initial) continue;
    has_default = true;
    const auto value = constant_of(*parameter.initial);
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

void Compiler::compile(const StatementList& tree) {
  scopes_.emplace_back();
  for (const Statement& statement : tree) {
    file_.entries.push_back(position());
    compile_statement(statement);
  }
  emit(Op::end_of_text, {file_.source.end(), 0, file_.source.line_number(file_.source.end())});
  for (const Statement& statement : tree) {
    if (const auto* const function = std::get_if<FunctionDefinition>(&statement.kind)) {
      const auto index = function_index_.find(function);
      if (index != function_index_.end()) compile_function(*function, index->second);
    }
    if (const auto* const subprogram = std::get_if<OSubprogram>(&statement.kind)) {
      const auto index = o_subprogram_index_.find(subprogram);
      if (index != o_subprogram_index_.end()) compile_o_subprogram(*subprogram, index->second);
    }
  }
}

void Compiler::compile_list(const StatementList& list) {
  for (const Statement& statement : list) compile_statement(statement);
}

void Compiler::compile_body(const StatementList& list) {
  scopes_.emplace_back();
  compile_list(list);
  scopes_.pop_back();
}

void Compiler::compile_statement(const Statement& statement) {
  context_.watch.pass();
  statement_span_ = statement.span;
  const std::size_t errors = reporter_.error_count();
  const std::size_t start = file_.code.size();
  std::optional<std::size_t> skip;
  if (statement.skip_level != 0) {
    skip = emit(Op::jump_if_skipped, statement.span, 0,
                static_cast<std::uint8_t>(statement.skip_level));
  }
  std::visit([this](const auto& kind) { compile_kind(kind); }, statement.kind);
  if (reporter_.error_count() != errors && reporter_.is_soft(statement.span.offset)) {
    drop_code_from(start);
    compile_kind(FaultyText{reporter_.last_error()});
    return;
  }
  if (skip) patch(*skip);
}

void Compiler::drop_code_from(std::size_t start) {
  file_.code.resize(start);
  file_.spans.resize(start);
  const auto dropped = [start](std::size_t jump) { return jump >= start; };
  for (Loop& loop : loops_) {
    std::erase_if(loop.breaks, dropped);
    std::erase_if(loop.continues, dropped);
  }
}

void Compiler::compile_kind(const PlainLines& lines) {
  file_.plain_lines.push_back(lines);
  emit(Op::plain_lines, statement_span_, static_cast<std::uint32_t>(file_.plain_lines.size() - 1));
}

void Compiler::compile_kind(const IncludeDirective&) {}

void Compiler::compile_kind(const NumberedProgram& start) {
  if (!file_.numbered_programs.emplace(start.number, position()).second) {
    reporter_.error("E3002", statement_span_,
                    "program O" + std::to_string(start.number) + " stands twice in this file",
                    "second program of this number");
  }
}

void Compiler::compile_kind(const WorkpieceDirective& directive) {
  for (const Expression& argument : directive.arguments) {
    if (!require(argument, Type::number, "the argument")) return;
  }
  emit(Op::workpiece, statement_span_, 0, static_cast<std::uint8_t>(directive.arguments.size()),
       directive.position ? 1 : 0);
}

void Compiler::compile_kind(const ToolOverhangDirective& directive) {
  const auto& arguments = directive.arguments;
  if (!arguments.empty() && !require(arguments[0], Type::number, "the overhang")) return;
  if (arguments.size() == 2 && !require(arguments[1], Type::axis, "the radial axis")) return;
  emit(Op::tool_overhang, statement_span_, 0, static_cast<std::uint8_t>(arguments.size()));
}

void Compiler::compile_kind(const AdaptiveDirective& directive) {
  for (const Expression& argument : directive.arguments) {
    if (!require(argument, Type::number, "a value of force control")) return;
  }
  emit(Op::adaptive, statement_span_, 0, static_cast<std::uint8_t>(directive.arguments.size()),
       static_cast<std::uint16_t>(directive.kind));
}

void Compiler::compile_kind(const FeedLawDirective& directive) {
  for (const Expression& array : directive.arguments) {
    const ValueType type = compile_expression(array);
    if (!type.known()) return;
    if (type.type == Type::number && type.dimensions != 0) continue;
    reporter_.error("E3004", array.span, "a curve takes arrays of num", "not such an array");
    return;
  }
  emit(Op::feed_law, statement_span_, 0, static_cast<std::uint8_t>(directive.arguments.size()));
}

void Compiler::compile_kind(const KinematicsDirective& directive) {
  const Expression& scheme = directive.arguments[0];
  const Expression& channel = directive.arguments[1];
  const bool good =
      require(scheme, Type::number, "the scheme") && require(channel, Type::number, "the channel");
  if (!good) return;
  emit(Op::kinematics, statement_span_);
  const auto target = constant_channel(channel, false, "#kinematics");
  const auto number = constant_of(scheme);
  if (!target || !number) return;
  ConstantDispatch dispatch;
  dispatch.kind = RequestKind::kinematics;
  dispatch.channel = *target;
  dispatch.scheme = static_cast<int>(number->number);
  dispatch.place = file_.source.place(statement_span_);
  context_.program.dispatches.push_back(dispatch);
  if (context_.channel == nullptr || number->number == 0.0) return;
  std::string known;
  for (const auto& [of, id] : context_.channel->schemes) {
    if (of != *target) continue;
    if (id == number->number) return;
    known += (known.empty() ? "" : ", ") + std::to_string(id);
  }
  Diagnostic& diagnostic =
      reporter_.error("E5201", scheme.span,
                      "channel " + std::to_string(*target) + " has no kinematic scheme " +
                          std::string(file_.source.text(scheme.span)),
                      "unknown scheme");
  if (!known.empty()) diagnostic.notes.push_back({"schemes of this channel: " + known, {}});
}

void Compiler::compile_kind(const CallStatement& statement) {
  const ValueType type = compile_call(statement.call, CallForm::statement);
  if (type.known() && type.type != Type::none) emit(Op::pop, statement.call.span);
}

void Compiler::compile_kind(const FaultyText& text) {
  file_.faults.push_back(text.fault);
  emit(Op::raise, statement_span_, static_cast<std::uint32_t>(file_.faults.size() - 1));
}

std::size_t Compiler::emit(Op op, const Span& span, std::uint32_t operand, std::uint8_t count,
                           std::uint16_t extra) {
  file_.code.push_back({op, count, extra, operand});
  file_.spans.push_back(span);
  return file_.code.size() - 1;
}

void Compiler::push_number(double number, const Span& span) {
  file_.numbers.push_back(number);
  emit(Op::push_number, span, static_cast<std::uint32_t>(file_.numbers.size() - 1));
}

void Compiler::push_text(std::string text, const Span& span) {
  file_.texts.push_back(std::move(text));
  emit(Op::push_text, span, static_cast<std::uint32_t>(file_.texts.size() - 1));
}

void Compiler::push_constant(const Constant& constant, const Span& span) {
  if (constant.type == Type::string) {
    push_text(constant.text, span);
  } else {
    push_number(constant.number, span);
  }
}

std::uint32_t Compiler::position() const {
  return static_cast<std::uint32_t>(file_.code.size());
}

void Compiler::patch(std::size_t jump) {
  file_.code[jump].operand = position();
}

void Compiler::patch_all(const std::vector<std::size_t>& jumps) {
  for (const std::size_t jump : jumps) patch(jump);
}

std::uint32_t Compiler::new_slot() {
  return routine_ != Routine::none ? routine_slots_++ : file_.file_slots++;
}

}  // namespace stanok::lang
