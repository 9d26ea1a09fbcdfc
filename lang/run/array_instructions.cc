#include "lang/run/array_instructions.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {

bool ArrayInstructions::execute(const Instruction& instruction, ValueFault& fault) {
  Element element;
  switch (instruction.op) {
    case Op::element:
      if (!pop_element(instruction.count, element, fault)) return false;
      stack_.push(element.array->elements[element.index]);
      return true;
    case Op::store_element: {
      Value value = stack_.pop();
      return pop_element(instruction.count, element, fault) &&
             put_element(*element.array, element.index, std::move(value), fault);
    }
    case Op::element_reference:
      if (!pop_element(instruction.count, element, fault)) return false;
      stack_.push({static_cast<double>(element.index), std::move(element.array)});
      return true;
    case Op::new_array:
      return make(instruction, fault);
    case Op::fill_array:
      return fill(instruction.operand, fault);
    default:
      STANOK_ASSERT(false);
  }
  return false;
}

bool ArrayInstructions::make(const Instruction& instruction, ValueFault& fault) {
  double sizes[2] = {1.0, 1.0};
  for (std::size_t i = instruction.count; i-- > 0;) sizes[i] = stack_.pop_number();
  const double count = sizes[0] * sizes[1];
  const bool whole = is_integer(sizes[0]) && is_integer(sizes[1]);
  if (!whole || sizes[0] < 0.5 || sizes[1] < 0.5 ||
      count > static_cast<double>(limits::array_elements)) {
    fault = {"E3017", "the size of an array must be a whole number from 1 to 1000000",
             "not a size"};
    return false;
  }
  const std::size_t elements = whole_number(count);
  Value array;
  array.object = std::make_shared<Object>();
  array.object->ledger = ledger_;
  if (!enter_in_ledger(*array.object, elements * sizeof(Value), fault)) return false;
  array.object->elements.resize(elements);
  if (instruction.count == 2) array.object->columns = whole_number(sizes[1]);
  stack_.push(std::move(array));
  return true;
}

bool ArrayInstructions::fill(std::size_t count, ValueFault& fault) {
  Object& array = *stack_.top(count + 1).front().object;
  if (count > array.elements.size()) {
    fault = {"E3017",
             "the list has " + std::to_string(count) + " values, the array " +
                 std::to_string(array.elements.size()),
             "too many values"};
    return false;
  }
  bool good = true;
  for (std::size_t i = count; i-- > 0;) {
    good = put_element(array, i, stack_.pop(), fault) && good;
  }
  return good;
}

bool ArrayInstructions::enter_in_ledger(Object& array, std::size_t bytes, ValueFault& fault) {
  if (*ledger_ + bytes > limits::run_array_bytes) {
    fault = {"E8002", "the arrays of the program need more than 64 MiB", "one too many"};
    return false;
  }
  *ledger_ += bytes;
  array.bytes += bytes;
  return true;
}

bool ArrayInstructions::put_element(Object& array, std::size_t element, Value value,
                                    ValueFault& fault) {
  Value& place = array.elements[element];
  const std::size_t before = place.object ? place.object->text.size() : 0;
  const std::size_t after = value.object ? value.object->text.size() : 0;
  *ledger_ -= before;
  array.bytes -= before;
  const bool fits = after == 0 || enter_in_ledger(array, after, fault);
  place = fits ? std::move(value) : Value{};
  return fits;
}

bool ArrayInstructions::pop_element(std::size_t indices, Element& element, ValueFault& fault) {
  double index[2] = {0.0, 0.0};
  for (std::size_t i = indices; i-- > 0;) index[i] = stack_.pop_number();
  element.array = stack_.pop().object;
  const Object& array = *element.array;
  const bool plane = array.columns != 0;
  if (plane != (indices == 2)) {
    fault = {"E3004", plane ? "the array has two dimensions" : "the array has one dimension",
             "wrong number of indices"};
    return false;
  }
  const std::size_t columns = plane ? array.columns : 1;
  const std::size_t rows = array.elements.size() / columns;
  const double limits[2] = {static_cast<double>(rows), plane ? static_cast<double>(columns) : 1.0};
  for (std::size_t i = 0; i < indices; ++i) {
    if (is_integer(index[i]) && index[i] > -0.5 && index[i] < limits[i] - 0.5) continue;
    char text[64];
    std::snprintf(text, sizeof text, "index %.12g; valid indices are 0 to %.0f", index[i],
                  limits[i] - 1.0);
    fault = {"E3011", "index outside the array", text};
    return false;
  }
  const std::size_t row = whole_number(index[0]);
  const std::size_t column = whole_number(index[1]);
  element.index = row * columns + (plane ? column : 0);
  return true;
}

}  // namespace stanok::lang
