// Instructions on arrays: making, filling, and reaching their elements.
//
// Owner: Vm. Owns the ledger of what all arrays of the runs need together. Invariant: the ledger
// never passes limits::run_array_bytes; an array that dies takes its bytes out of it.
#pragma once

#include <cstddef>
#include <memory>

#include "lang/program/code.h"
#include "lang/run/value_stack.h"
#include "lang/tree/text_value.h"
#include "lang/tree/value.h"

namespace stanok::lang {

class ArrayInstructions {
 public:
  // `stack` must outlive this.
  explicit ArrayInstructions(ValueStack& stack) : stack_(stack) {}

  [[nodiscard]] static bool takes(Op op) {
    return op == Op::element || op == Op::store_element || op == Op::element_reference ||
           op == Op::new_array || op == Op::fill_array;
  }
  // Executes one of these; false, and why, when it has no result.
  [[nodiscard]] bool execute(const Instruction& instruction, ValueFault& fault);
  // Stores a value in an element; false, and why, when all arrays together then need too much.
  [[nodiscard]] bool put_element(Object& array, std::size_t element, Value value,
                                 ValueFault& fault);

  // Bytes that all arrays need at this moment.
  [[nodiscard]] std::size_t bytes() const { return *ledger_; }

 private:
  struct Element {
    std::shared_ptr<Object> array;
    std::size_t index = 0;
  };
  bool make(const Instruction& instruction, ValueFault& fault);
  bool fill(std::size_t count, ValueFault& fault);
  bool enter_in_ledger(Object& array, std::size_t bytes, ValueFault& fault);
  bool pop_element(std::size_t indices, Element& element, ValueFault& fault);

  ValueStack& stack_;
  ArrayLedger ledger_ = std::make_shared<std::size_t>(0);
};

}  // namespace stanok::lang
