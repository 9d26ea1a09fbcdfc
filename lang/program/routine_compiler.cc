// Code of subprograms, calls and counted loops of O-lines.
#include <utility>

#include "lang/program/compiler.h"

namespace stanok::lang {

void Compiler::declare_o_subprogram(const OSubprogram& subprogram) {
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

// Where it stands it does nothing; its code lies behind that of the file.
void Compiler::compile_kind(const OSubprogram&) {}

void Compiler::compile_o_subprogram(const OSubprogram& subprogram, std::uint32_t index) {
  routine_ = Routine::o_subprogram;
  begin_routine(index);
  compile_body(subprogram.body);
  statement_span_ = subprogram.label.span;
  compile_kind(OReturn{subprogram.value});
  end_routine(index);
}

void Compiler::compile_kind(const OReturn& statement) {
  if (routine_ != Routine::o_subprogram) {
    reporter_.error("E3016", statement_span_, "`O... return` outside a subprogram",
                    "no `O... sub` to leave");
    return;
  }
  if (statement.value && !require(*statement.value, Type::number, "the result")) return;
  emit(Op::return_from_o_sub, statement_span_, 0, statement.value ? 1 : 0);
}

void Compiler::compile_kind(const OCall& call) {
  for (const Expression& argument : call.arguments) {
    if (!require(argument, Type::number, "the argument")) return;
  }
  OCallCode code;
  code.computed = call.label.computed.has_value();
  if (code.computed) {
    if (!require(*call.label.computed, Type::number, "the number of the subprogram")) return;
  } else if (const auto callee = find_o_subprogram(call.label)) {
    code.callee = *callee;
  } else {
    return;
  }
  file_.o_calls.push_back(code);
  emit(Op::call_o_sub, statement_span_, static_cast<std::uint32_t>(file_.o_calls.size() - 1),
       static_cast<std::uint8_t>(call.arguments.size()));
}

// In this file, then in the included ones (once), then in the file of that name.
std::optional<Callee> Compiler::find_o_subprogram(const OLabel& label) {
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
          .error("E7006", label.span, "O" + label.name + " stands in two included files",
                 "which one is meant?")
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

// The count is read once and rounded; the counter is a variable of its own.
void Compiler::compile_kind(const ORepeat& loop) {
  if (!require(loop.count, Type::number, "the count")) return;
  const Span& span = loop.count.span;
  Symbol counter;
  counter.type = {Type::number, 0};
  counter.slot = new_slot();
  counter.file_level = routine_ == Routine::none;
  const auto* const round = find_builtin("round");
  emit(Op::builtin, span, static_cast<std::uint32_t>(round - builtins().data()), 1);
  store(counter, span);
  const std::uint32_t start = position();
  const auto compute = [&](Operation operation) {
    push_number(1.0, span);
    emit(Op::compute, span, 0, 0, static_cast<std::uint16_t>(operation));
  };
  load(counter, span);
  compute(Operation::greater_equal);
  const std::size_t end = emit(Op::jump_if_false, span);
  loops_.push_back({loop.label, {}, {}});
  compile_body(loop.body);
  patch_all(loops_.back().continues);
  load(counter, span);
  compute(Operation::subtract);
  store(counter, span);
  emit(Op::jump, span, start);
  patch(end);
  patch_all(loops_.back().breaks);
  loops_.pop_back();
}

}  // namespace stanok::lang
