// The instructions that only compute, in one tight loop: what long calculations spend their time
// with. Whatever is rare, fails or has an effect is left to Vm::step.
#include <cmath>
#include <utility>

#include "lang/run/vm.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {
namespace {

// The result of the frequent operations; false for the others and for results that are errors.
bool quick_result(Operation operation, double left, double right, double& result) {
  switch (operation) {
    case Operation::add:
      result = left + right;
      return std::isfinite(result);
    case Operation::subtract:
      result = left - right;
      return std::isfinite(result);
    case Operation::multiply:
      result = without_sign_of_zero(left * right);
      return std::isfinite(result);
    case Operation::divide:
      result = without_sign_of_zero(left / right);
      return right != 0.0 && std::isfinite(result);
    case Operation::less:
      result = truth(left < right);
      return true;
    case Operation::less_equal:
      result = truth(left <= right);
      return true;
    case Operation::greater:
      result = truth(left > right);
      return true;
    case Operation::greater_equal:
      result = truth(left >= right);
      return true;
    case Operation::bracket_less:
      result = truth(left < right);
      return !std::isunordered(left, right);
    case Operation::bracket_less_equal:
      result = truth(left <= right);
      return !std::isunordered(left, right);
    case Operation::bracket_greater:
      result = truth(left > right);
      return !std::isunordered(left, right);
    case Operation::bracket_greater_equal:
      result = truth(left >= right);
      return !std::isunordered(left, right);
    case Operation::equal:
      result = truth(left == right);
      return true;
    case Operation::not_equal:
      result = truth(left != right);
      return !std::isunordered(left, right);
    default:
      return false;
  }
}

bool is_unary(Operation operation) {
  return operation == Operation::negate || operation == Operation::identity ||
         operation == Operation::logical_not;
}

}  // namespace

// Executes up to `bound` instructions and returns how many; stops before the first that is not of
// this kind. Slots and constants do not move meanwhile: only calls and arrays make new slots.
int Vm::compute_ahead(int bound) {
  CallFrame& frame = frames_.back();
  const CompiledFile& text = file();
  const Instruction* const code = text.code.data();
  const double* const numbers = text.numbers.data();
  Value* const locals = slots_.data() + frame.slots;
  Value* const of_file = slots_.data() + file_slots_[frame.file];
  const auto store = [this](Value& slot) {
    slot = std::move(stack_.top());
    stack_.drop();
  };
  std::uint32_t position = frame.position;
  const auto stop_before = [&frame, &position](int done) {
    frame.position = position - 1;
    return done;
  };
  for (int done = 0; done < bound; ++done) {
    const Instruction& instruction = code[position++];
    switch (instruction.op) {
      case Op::push_number:
        stack_.push({numbers[instruction.operand], nullptr});
        break;
      case Op::load_local:
        stack_.push(locals[instruction.operand]);
        break;
      case Op::load_file:
        stack_.push(of_file[instruction.operand]);
        break;
      case Op::store_local:
        store(locals[instruction.operand]);
        break;
      case Op::store_file:
        store(of_file[instruction.operand]);
        break;
      case Op::compute: {
        const auto operation = static_cast<Operation>(instruction.extra);
        Value* const right = &stack_.top();
        double result = 0.0;
        const bool unary = instruction.count != 0;
        if (unary || !quick_result(operation, right[-1].number, right->number, result)) {
          return stop_before(done);
        }
        stack_.drop();
        stack_.top().number = result;
        break;
      }
      case Op::jump:
        position = instruction.operand;
        break;
      case Op::jump_if_false:
        if (stack_.top().number == 0.0) position = instruction.operand;
        stack_.drop();
        break;
      default:
        return stop_before(done);
    }
  }
  frame.position = position;
  return bound;
}

void Vm::compute(const Instruction& instruction) {
  const auto operation = static_cast<Operation>(instruction.extra);
  double right = 0.0;
  if (!is_unary(operation)) right = stack_.pop_number();
  Value& left = stack_.top();
  ArithmeticFault fault{};
  const auto result = computed_with_vacant(operation, left.number, right, fault);
  if (!result) return fail(fault.code, fault.message);
  left.number = *result;
}

void Vm::call_builtin(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  Value result;
  for (Value& argument : stack_.top(instruction.count)) {
    argument.number = value_or_zero(argument.number);
  }
  const bool good = builtin.evaluate(stack_.top(instruction.count), result);
  stack_.cut_to(stack_.height() - instruction.count);
  if (good) return stack_.push(std::move(result));
  fail("E3009", "invalid argument of `" + std::string(builtin.name) + "`", "no result");
}

}  // namespace stanok::lang
