#include "lang/run/vm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/text/reporter.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {
namespace {

// The calls that led to the innermost frame, the last one first.
std::vector<std::string> call_stack(const Program& program, const std::vector<CallFrame>& frames) {
  std::vector<std::string> lines;
  for (std::size_t i = frames.size(); i-- > 1;) {
    const CallFrame& frame = frames[i];
    const CallFrame& caller = frames[i - 1];
    const CompiledFile& calling = *program.files[caller.file];
    const Place place = calling.source.place(calling.spans[caller.position - 1]);
    std::string name = program.files[frame.file]->source.name();
    if (frame.program_number != 0) name = "O" + std::to_string(frame.program_number);
    if (frame.function != nullptr) {
      name = frame.function->signature.name + (frame.function->o_subprogram ? "" : "()");
    }
    lines.push_back("in " + name + ", called at " + place.file + ":" + std::to_string(place.line) +
                    ":" + std::to_string(place.column));
  }
  return lines;
}

}  // namespace

LineRules rules_of(const CompiledFile& file, const PlainLines& lines) {
  return {lines.surroundings, file.source.rules()};
}

void Vm::begin(std::shared_ptr<const Program> program) {
  program_ = std::move(program);
  plain_ = {};
  stack_.clear();
  slots_.clear();
  file_slots_.clear();
  frames_.clear();
  for (const auto& one : program_->files) {
    file_slots_.push_back(slots_.size());
    slots_.resize(slots_.size() + one->file_slots);
  }
  frames_.emplace_back();
  frames_.back().slots = slots_.size();
}

void Vm::begin_again() {
  plain_ = {};
  stack_.clear();
  frames_.back().position = 0;
}

const Instruction* Vm::step() {
  CallFrame& frame = frames_.back();
  const Instruction& instruction = file().code[frame.position++];
  return execute(instruction) ? nullptr : &instruction;
}

bool Vm::execute(const Instruction& instruction) {
  if (execute_constant(instruction) || execute_variable(instruction)) return true;
  if (execute_jump(instruction)) return true;
  if (ArrayInstructions::takes(instruction.op)) {
    ValueFault fault;
    if (!arrays_.execute(instruction, fault)) fail(fault);
    return true;
  }
  switch (instruction.op) {
    case Op::compute:
      compute(instruction);
      return true;
    case Op::builtin:
      call_builtin(instruction);
      return true;
    case Op::plain_lines: {
      const PlainLines& lines = file().plain_lines[instruction.operand];
      const char* const text = file().source.text().data();
      plain_ = {text + lines.begin, text + lines.end, lines.first_line, rules_of(file(), lines)};
      return true;
    }
    case Op::raise: {
      const Fault& fault = file().faults[instruction.operand];
      fail_at(fault.span, fault.code, fault.message, fault.label);
      return true;
    }
    default:
      return execute_texts(instruction);
  }
}

bool Vm::execute_constant(const Instruction& instruction) {
  const CompiledFile& current = file();
  switch (instruction.op) {
    case Op::push_number:
      stack_.push(value_of(current.numbers[instruction.operand]));
      return true;
    case Op::push_text:
      stack_.push(value_of(current.texts[instruction.operand]));
      return true;
    case Op::push_axis:
      push_axis(instruction);
      return true;
    case Op::pop:
      stack_.drop();
      return true;
    case Op::duplicate:
      for (std::size_t i = 0; i < instruction.count; ++i) {
        stack_.push(Value(stack_.top(instruction.count).front()));
      }
      return true;
    default:
      return false;
  }
}

bool Vm::execute_variable(const Instruction& instruction) {
  const std::size_t local = frames_.back().slots + instruction.operand;
  const std::size_t of_file = file_slots_[frames_.back().file] + instruction.operand;
  switch (instruction.op) {
    case Op::load_local:
      stack_.push(slots_[local]);
      return true;
    case Op::store_local:
      slots_[local] = stack_.pop();
      return true;
    case Op::load_file:
      stack_.push(slots_[of_file]);
      return true;
    case Op::store_file:
      slots_[of_file] = stack_.pop();
      return true;
    case Op::load_reference:
      stack_.push(referred(slots_[local]));
      return true;
    case Op::store_reference:
      store_reference(slots_[local], stack_.pop());
      return true;
    case Op::reference_local:
      stack_.push(value_of(static_cast<double>(local)));
      return true;
    case Op::reference_file:
      stack_.push(value_of(static_cast<double>(of_file)));
      return true;
    default:
      return false;
  }
}

void Vm::push_axis(const Instruction& instruction) {
  const std::string& name = file().texts[instruction.operand];
  const int axis = words_.axis_called(name).number();
  if (axis < 0) return fail("E4010", "this channel has no axis `" + name + "`");
  stack_.push(value_of(static_cast<double>(axis)));
}

bool Vm::execute_jump(const Instruction& instruction) {
  std::uint32_t& position = frame().position;
  switch (instruction.op) {
    case Op::jump:
      position = instruction.operand;
      return true;
    case Op::jump_if_false:
      if (stack_.pop_number() == 0.0) position = instruction.operand;
      return true;
    case Op::jump_if_false_keep:
    case Op::jump_if_true_keep: {
      const bool wanted = instruction.op == Op::jump_if_true_keep;
      if ((stack_.top().number != 0.0) == wanted) {
        position = instruction.operand;
      } else {
        stack_.drop();
      }
      return true;
    }
    case Op::jump_if_skipped:
      if ((block_skip_ >> instruction.count & 1U) != 0) position = instruction.operand;
      return true;
    default:
      return false;
  }
}

bool Vm::execute_texts(const Instruction& instruction) {
  if (instruction.op != Op::join_texts && instruction.op != Op::texts_equal) return false;
  const Value right = stack_.pop();
  if (instruction.op == Op::texts_equal) {
    stack_.top() = value_of(text_of(stack_.top()) == text_of(right));
    return true;
  }
  std::string text = text_of(stack_.top()) + text_of(right);
  if (text.size() > limits::string_bytes) {
    fail("E3009", "a string is longer than 4096 bytes", "too long");
  } else {
    stack_.top() = value_of(std::move(text));
  }
  return true;
}

void Vm::store_reference(const Value& reference, Value value) {
  const auto index = static_cast<std::size_t>(reference.number);
  ValueFault fault;
  if (!reference.object) {
    slots_[index] = std::move(value);
  } else if (!arrays_.put_element(*reference.object, index, std::move(value), fault)) {
    fail(fault);
  }
}

const Value& Vm::referred(const Value& reference) const {
  const auto index = static_cast<std::size_t>(reference.number);
  return reference.object ? reference.object->elements[index] : slots_[index];
}

const Span& Vm::span() const {
  const CompiledFile& current = file();
  const std::uint32_t next = frames_.back().position;
  const std::size_t index = next == 0 ? 0 : next - 1;
  return current.spans[std::min(index, current.spans.size() - 1)];
}

Span Vm::next_span() const {
  const std::vector<Span>& spans = file().spans;
  if (!plain_.at_end()) return file().source.words_of_line(plain_.line);
  return spans[std::min<std::size_t>(frames_.back().position, spans.size() - 1)];
}

WhereItRuns Vm::where() const {
  const int level = static_cast<int>(frames_.size()) - 1;
  const bool runs = !frames_.empty() && program_;
  return {origin(), level, runs ? file().source.rules() : TextRules{}};
}

Origin Vm::origin() const {
  if (frames_.empty() || !program_) return {};
  if (!plain_.at_end()) return {frames_.back().file, plain_.line};
  return instruction_origin();
}

bool Vm::check_call_depth() {
  if (frames_.size() <= limits::call_depth) return true;
  fail("E8001", "more than 64 nested calls", "one call too many");
  return false;
}

CallFrame Vm::frame_at_top(std::uint16_t of_file) const {
  CallFrame frame;
  frame.file = of_file;
  frame.slots = slots_.size();
  frame.stack = stack_.height();
  return frame;
}

void Vm::add_slots(const FunctionCode& function) {
  slots_.resize(slots_.size() + function.slots);
}

void Vm::renew_file_variables(CallFrame& frame) {
  frame.context->file_slots_before = file_slots_[frame.file];
  file_slots_[frame.file] = slots_.size();
  slots_.resize(slots_.size() + program_->files[frame.file]->file_slots);
}

void Vm::take_arguments(const CallFrame& frame) {
  for (std::size_t i = frame.function->signature.parameters.size(); i-- > 0;) {
    slots_[frame.slots + i] = stack_.pop();
  }
}

void Vm::leave() {
  const CallFrame& frame = frames_.back();
  slots_.resize(frame.slots);
  stack_.cut_to(frame.stack);
  if (frame.context && frame.context->file_slots_before) {
    file_slots_[frame.file] = *frame.context->file_slots_before;
  }
  if (frame.context && frame.context->modal_call) plain_ = frame.context->plain_of_caller;
  frames_.pop_back();
}

std::optional<int> Vm::pop_integer(std::string_view what) {
  const double number = stack_.pop_number();
  if (is_integer(number)) return static_cast<int>(std::lround(number));
  fail("E3010", std::string(what) + " must be a whole number", "not a whole number");
  return std::nullopt;
}

void Vm::fail(std::string_view code, std::string message, std::string label) {
  fail_with(diagnostic(code, std::move(message), std::move(label)));
}

void Vm::fail_at(const Span& at, std::string_view code, std::string message, std::string label) {
  fail_with(diagnostic_at(file().source, code, at, std::move(message), std::move(label)));
}

void Vm::fail_with(Diagnostic diagnostic) {
  if (diagnostic.stack.empty()) diagnostic.stack = call_stack(*program_, frames_);
  run_.fail(std::move(diagnostic));
}

Diagnostic Vm::diagnostic(std::string_view code, std::string message, std::string label) const {
  Diagnostic diagnostic =
      diagnostic_at(file().source, code, span(), std::move(message), std::move(label));
  diagnostic.stack = call_stack(*program_, frames_);
  return diagnostic;
}

}  // namespace stanok::lang
