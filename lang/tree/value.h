// Values of high-level text while a program runs.
//
// Types are known when a program is compiled, so a value carries no tag: numbers, bools (1, 0) and
// axes (their index) are the number, strings and arrays the object. A reference to a variable is
// its slot, to an array element the array and the element's index.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lang/tree/tree.h"

namespace stanok::lang {

// There is one zero: -0 would be shown as such, and be another direction for atan2.
[[nodiscard]] constexpr double without_sign_of_zero(double number) {
  return number + 0.0;
}

struct Object;

struct Value {
  double number = 0.0;
  std::shared_ptr<Object> object;
};

// Bytes that the arrays of a run need at this moment, their strings included; a string in several
// elements counts in each.
using ArrayLedger = std::shared_ptr<std::size_t>;

struct Object {
  Object() = default;
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (ledger) *ledger -= bytes;
  }

  std::string text;             // string
  ArrayLedger ledger;           // array; what it needs is entered there
  std::size_t bytes = 0;        // entered
  std::vector<Value> elements;  // array, row by row
  std::size_t columns = 0;      // array of two dimensions; 0: one dimension
};

[[nodiscard]] inline Value value_of(double number) {
  return {number, nullptr};
}
// A claim as numbers have it.
[[nodiscard]] constexpr double truth(bool claim) {
  return claim ? 1.0 : 0.0;
}
[[nodiscard]] inline Value value_of(bool claim) {
  return {truth(claim), nullptr};
}
[[nodiscard]] Value value_of(std::string text);
[[nodiscard]] inline const std::string& text_of(const Value& value) {
  static const std::string empty;
  return value.object ? value.object->text : empty;
}

// Why a computation has no result.
struct ArithmeticFault {
  const char* code;
  const char* message;
};

// The result of an operation on two numbers (one for unary ones), comparisons as 1 and 0. Nothing,
// with `fault` set, for a division by zero, an invalid argument or an overflow.
[[nodiscard]] std::optional<double> computed(Operation operation, double left, double right,
                                             ArithmeticFault& fault);

// A vacant parameter of the Fanuc dialect is NaN. It counts as 0, but equals only another one.
[[nodiscard]] inline double value_or_zero(double number) {
  return std::isnan(number) ? 0.0 : number;
}
[[nodiscard]] std::optional<double> computed_with_vacant(Operation operation, double left,
                                                         double right, ArithmeticFault& fault);

}  // namespace stanok::lang
