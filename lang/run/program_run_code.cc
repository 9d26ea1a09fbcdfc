// The machine: one instruction at a time.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "lang/run/program_run.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

std::uint32_t jump_target(const Instruction& instruction) {
  return instruction.operand;
}

bool is_unary(Operation operation) {
  return operation == Operation::negate || operation == Operation::identity ||
         operation == Operation::logical_not;
}

}  // namespace

Value ProgramRun::pop() {
  STANOK_ASSERT(!stack_.empty());
  Value value = std::move(stack_.back());
  stack_.pop_back();
  return value;
}

double ProgramRun::pop_number() {
  STANOK_ASSERT(!stack_.empty());
  const double number = stack_.back().number;
  stack_.pop_back();
  return number;
}

std::optional<int> ProgramRun::pop_integer(std::string_view what) {
  const double number = pop_number();
  if (is_integer(number)) return static_cast<int>(std::lround(number));
  fail("E3010", std::string(what) + " must be a whole number", "not a whole number");
  return std::nullopt;
}

void ProgramRun::step() {
  Frame& frame = frames_.back();
  const CompiledFile& current = file();
  const Instruction instruction = current.code[frame.position++];
  execute_instruction(instruction);
}

void ProgramRun::execute_instruction(const Instruction& instruction) {
  if (execute_memory(instruction) || execute_jump(instruction) || execute_array(instruction)) {
    return;
  }
  switch (instruction.op) {
    case Op::compute:
      return compute(instruction);
    case Op::join_texts: {
      const Value right = pop();
      std::string text = text_of(stack_.back()) + text_of(right);
      if (text.size() > limits::string_bytes) {
        return fail("E3009", "a string is longer than 4096 bytes", "too long");
      }
      stack_.back() = value_of(std::move(text));
      return;
    }
    case Op::texts_equal: {
      const Value right = pop();
      stack_.back() = value_of(text_of(stack_.back()) == text_of(right));
      return;
    }
    case Op::builtin:
      return call_builtin(instruction);
    case Op::system_value:
      return push_system_value(instruction);
    case Op::parameter:
    case Op::named_parameter:
    case Op::named_parameter_exists:
    case Op::predefined_parameter:
    case Op::r_parameter:
      return load_parameter(instruction);
    case Op::settings:
      return take_settings(file().settings[instruction.operand]);
    default:
      return execute_effect(instruction);
  }
}

// Constants and variables.
bool ProgramRun::execute_memory(const Instruction& instruction) {
  const CompiledFile& current = file();
  const Frame& frame = frames_.back();
  const std::size_t local = frame.slots + instruction.operand;
  const std::size_t of_file = file_slots_[frame.file] + instruction.operand;
  switch (instruction.op) {
    case Op::push_number:
      push(value_of(current.numbers[instruction.operand]));
      return true;
    case Op::push_text:
      push(value_of(current.texts[instruction.operand]));
      return true;
    case Op::push_axis: {
      const int axis = channel_words_.axis_called(current.texts[instruction.operand]);
      if (axis < 0) {
        fail("E4010", "this channel has no axis `" + current.texts[instruction.operand] + "`");
      } else {
        push(value_of(static_cast<double>(axis)));
      }
      return true;
    }
    case Op::pop:
      stack_.pop_back();
      return true;
    case Op::duplicate: {
      const std::size_t first = stack_.size() - instruction.count;
      for (std::size_t i = 0; i < instruction.count; ++i) push(Value(stack_[first + i]));
      return true;
    }
    case Op::load_local:
      push(slots_[local]);
      return true;
    case Op::store_local:
      slots_[local] = pop();
      return true;
    case Op::load_file:
      push(slots_[of_file]);
      return true;
    case Op::store_file:
      slots_[of_file] = pop();
      return true;
    case Op::load_reference:
      push(*referred(slots_[local]));
      return true;
    case Op::store_reference:
      store_reference(slots_[local], pop());
      return true;
    case Op::reference_local:
      push(value_of(static_cast<double>(local)));
      return true;
    case Op::reference_file:
      push(value_of(static_cast<double>(of_file)));
      return true;
    default:
      return false;
  }
}

bool ProgramRun::execute_jump(const Instruction& instruction) {
  Frame& frame = frames_.back();
  switch (instruction.op) {
    case Op::jump:
      frame.position = jump_target(instruction);
      return true;
    case Op::jump_if_false:
      if (pop_number() == 0.0) frame.position = jump_target(instruction);
      return true;
    case Op::jump_if_false_keep:
    case Op::jump_if_true_keep: {
      const bool wanted = instruction.op == Op::jump_if_true_keep;
      if ((stack_.back().number != 0.0) == wanted) {
        frame.position = jump_target(instruction);
      } else {
        stack_.pop_back();
      }
      return true;
    }
    case Op::jump_if_skipped:
      if ((block_skip_ >> instruction.count & 1U) != 0) frame.position = jump_target(instruction);
      return true;
    case Op::call:
      call_function(file().callees[instruction.operand]);
      return true;
    case Op::return_value:
      return_from_function(true);
      return true;
    case Op::return_nothing:
      return_from_function(false);
      return true;
    case Op::call_o_sub:
      call_o_subprogram(instruction);
      return true;
    case Op::return_from_o_sub:
      return_from_o_subprogram(instruction.count != 0);
      return true;
    default:
      return false;
  }
}

void ProgramRun::compute(const Instruction& instruction) {
  const auto operation = static_cast<Operation>(instruction.extra);
  double right = 0.0;
  if (!is_unary(operation)) right = pop_number();
  Value& left = stack_.back();
  ArithmeticFault fault{};
  const auto result = computed(operation, left.number, right, fault);
  if (!result) return fail(fault.code, fault.message);
  left.number = *result;
}

void ProgramRun::call_builtin(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::span<const Value> arguments(stack_.data() + stack_.size() - instruction.count,
                                         instruction.count);
  Value result;
  const bool good = builtin.evaluate(arguments, result);
  stack_.resize(stack_.size() - instruction.count);
  if (good) return push(std::move(result));
  fail("E3009", "invalid argument of `" + std::string(builtin.name) + "`", "no result");
}

void ProgramRun::execute_effect(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::plain_lines: {
      const PlainLines& lines = file().plain_lines[instruction.operand];
      const char* const text = file().source.text().data();
      plain_ = {text + lines.begin, text + lines.end, lines.first_line, lines.surroundings};
      return;
    }
    case Op::block:
      return run_block(instruction);
    case Op::message:
      return send_message(instruction);
    case Op::request:
      return ask_builtin(instruction);
    case Op::request_value:
      return ask_value(instruction);
    case Op::kinematics:
      return ask_kinematics();
    case Op::terminate:
      return terminate();
    case Op::call_file:
      return call_file();
    case Op::tool_overhang:
      return ask_overhang(instruction);
    case Op::feed_law:
      return take_feed_law_directive(instruction);
    case Op::adaptive:
      return order_force_control(instruction);
    case Op::workpiece:
      return announce_workpiece(instruction);
    case Op::table:
      return ask_table(instruction);
    case Op::read_shared:
      return read_shared(instruction);
    case Op::write_shared:
      return write_shared(instruction);
    case Op::combine_shared:
      return combine_shared(instruction);
    case Op::mark:
      return take_mark(instruction);
    case Op::argument:
      return push_argument(instruction.count != 0);
    case Op::save_gvector:
      return save_gvector();
    case Op::restore_gvector:
      return restore_gvector(instruction.count != 0);
    case Op::channel_error:
      return push(value_of(channel_error_));
    case Op::raise: {
      const Fault& fault = file().faults[instruction.operand];
      return fail_at(fault.span, fault.code, fault.message, fault.label);
    }
    case Op::end_of_text:
      queue_.set_origin({frames_.back().file, span().line}, block_);
      if (frames_.size() > 1) return leave_subprogram();
      if (modal_.curve.open())
        return fail("E4312", "the text ends inside a NURBS curve", "no G5.3");
      return end_program(ProgramEndKind::end_of_text);
    default:
      STANOK_ASSERT(false);
  }
}

void ProgramRun::send_message(const Instruction& instruction) {
  queue_.set_origin({frames_.back().file, span().line}, block_);
  const Value text = pop();
  queue_.emit(Message{text_of(text), static_cast<Message::Kind>(instruction.extra)});
}

// Puts the computed values into a copy of the block's constants and executes it.
void ProgramRun::run_block(const Instruction& instruction) {
  const BlockTemplate& block = file().blocks[instruction.operand];
  words_ = block.words;
  for (auto word = block.computed.rbegin(); word != block.computed.rend(); ++word) {
    const double value = pop_number();
    switch (word->kind) {
      case ComputedWord::Kind::letter:
        words_.values[static_cast<std::size_t>(letter_index(word->letter))] = value;
        break;
      case ComputedWord::Kind::named:
        words_.named[word->index].value = value;
        break;
      case ComputedWord::Kind::spindle:
        if (!is_integer(value)) return fail("E3010", "a spindle is a whole number");
        words_.spindle = static_cast<int>(std::lround(value));
        break;
      case ComputedWord::Kind::g_code:
      case ComputedWord::Kind::m_code: {
        if (!is_integer(value * 10.0) || value < 0.0 || value > 3276.0) {
          return fail("E4004", "the computed value is no code", "unknown code");
        }
        CodeList& list = word->kind == ComputedWord::Kind::g_code ? words_.g : words_.m;
        list.numbers[word->index] = static_cast<CodeNumber>(std::lround(value * 10.0));
        break;
      }
    }
  }
  ++block_;
  execute(block.span, &block.places);
}

}  // namespace stanok::lang
