// Arrays and references while a program runs.
#include <cmath>
#include <utility>

#include "lang/run/program_run.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {
bool ProgramRun::execute_array(const Instruction& instruction) {
  std::shared_ptr<Object> array;
  std::size_t element = 0;
  switch (instruction.op) {
    case Op::element:
      if (pop_element(instruction.count, array, element)) push(array->elements[element]);
      return true;
    case Op::store_element: {
      Value value = pop();
      if (pop_element(instruction.count, array, element)) {
        put_element(*array, element, std::move(value));
      }
      return true;
    }
    case Op::element_reference:
      if (pop_element(instruction.count, array, element)) {
        push({static_cast<double>(element), std::move(array)});
      }
      return true;
    case Op::new_array:
      make_array(instruction);
      return true;
    case Op::fill_array:
      fill_array(instruction.operand);
      return true;
    default:
      return false;
  }
}

void ProgramRun::make_array(const Instruction& instruction) {
  double sizes[2] = {1.0, 1.0};
  for (std::size_t i = instruction.count; i-- > 0;) sizes[i] = pop_number();
  const double count = sizes[0] * sizes[1];
  const bool whole = is_integer(sizes[0]) && is_integer(sizes[1]);
  if (!whole || sizes[0] < 0.5 || sizes[1] < 0.5 ||
      count > static_cast<double>(limits::array_elements)) {
    return fail("E3017", "the size of an array is a whole number from 1 to 1000000", "not a size");
  }
  const auto elements = static_cast<std::size_t>(std::llround(count));
  Value array;
  array.object = std::make_shared<Object>();
  array.object->ledger = array_ledger_;
  if (!enter_in_ledger(*array.object, elements * sizeof(Value))) return;
  array.object->elements.resize(elements);
  if (instruction.count == 2) {
    array.object->columns = static_cast<std::size_t>(std::lround(sizes[1]));
  }
  push(std::move(array));
}

void ProgramRun::fill_array(std::size_t count) {
  Object& array = *stack_[stack_.size() - count - 1].object;
  if (count > array.elements.size()) {
    return fail("E3017",
                "the list has " + std::to_string(count) + " values, the array " +
                    std::to_string(array.elements.size()),
                "too many values");
  }
  for (std::size_t i = count; i-- > 0;) put_element(array, i, pop());
}

// What the array needs more than before; false when all arrays together then need too much.
bool ProgramRun::enter_in_ledger(Object& array, std::size_t bytes) {
  if (*array_ledger_ + bytes > limits::run_array_bytes) {
    fail("E8002", "the arrays of the program need more than 64 MiB", "one too many");
    return false;
  }
  *array_ledger_ += bytes;
  array.bytes += bytes;
  return true;
}

void ProgramRun::put_element(Object& array, std::size_t element, Value value) {
  Value& place = array.elements[element];
  const std::size_t before = place.object ? place.object->text.size() : 0;
  const std::size_t after = value.object ? value.object->text.size() : 0;
  *array_ledger_ -= before;
  array.bytes -= before;
  if (after == 0 || enter_in_ledger(array, after)) {
    place = std::move(value);
  } else {
    place = {};
  }
}

void ProgramRun::store_reference(const Value& reference, Value value) {
  const auto index = static_cast<std::size_t>(reference.number);
  if (reference.object) return put_element(*reference.object, index, std::move(value));
  slots_[index] = std::move(value);
}

bool ProgramRun::pop_element(std::size_t indices, std::shared_ptr<Object>& array,
                             std::size_t& element) {
  double index[2] = {0.0, 0.0};
  for (std::size_t i = indices; i-- > 0;) index[i] = pop_number();
  array = pop().object;
  const bool plane = array->columns != 0;
  if (plane != (indices == 2)) {
    fail("E3004", plane ? "the array has two dimensions" : "the array has one dimension",
         "wrong number of indices");
    return false;
  }
  const std::size_t columns = plane ? array->columns : 1;
  const std::size_t row_count = array->elements.size() / columns;
  const auto rows = static_cast<double>(row_count);
  const double limits[2] = {rows, plane ? static_cast<double>(columns) : 1.0};
  for (std::size_t i = 0; i < indices; ++i) {
    if (is_integer(index[i]) && index[i] > -0.5 && index[i] < limits[i] - 0.5) continue;
    char text[64];
    std::snprintf(text, sizeof text, "index %.12g, valid are 0 to %.0f", index[i], limits[i] - 1.0);
    fail("E3011", "index outside the array", text);
    return false;
  }
  const auto row = static_cast<std::size_t>(std::lround(index[0]));
  const auto column = static_cast<std::size_t>(std::lround(index[1]));
  element = row * columns + (plane ? column : 0);
  return true;
}

Value* ProgramRun::referred(const Value& reference) {
  const auto index = static_cast<std::size_t>(reference.number);
  return reference.object ? &reference.object->elements[index] : &slots_[index];
}

}  // namespace stanok::lang
