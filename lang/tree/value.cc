#include "lang/tree/value.h"

#include <cmath>

namespace stanok::lang {
namespace {

// EQ and NE compare with this tolerance; LT, LE, GT and GE are exact (LinuxCNC).
constexpr double bracket_tolerance = 1e-6;

bool near(double a, double b) {
  return std::abs(a - b) <= bracket_tolerance;
}

// Remainder with the sign of the divisor.
double floored_remainder(double left, double right) {
  const double rest = std::fmod(left, right);
  return rest != 0.0 && (rest < 0.0) != (right < 0.0) ? rest + right : rest;
}

// Remainder that is never negative.
double positive_remainder(double left, double right) {
  const double rest = std::fmod(left, right);
  return rest < 0.0 ? rest + std::abs(right) : rest;
}

double raw_result(Operation operation, double left, double right) {
  switch (operation) {
    case Operation::add:
      return left + right;
    case Operation::subtract:
      return left - right;
    case Operation::multiply:
      return left * right;
    case Operation::divide:
      return left / right;
    case Operation::modulo:
      return floored_remainder(left, right);
    case Operation::bracket_modulo:
      return positive_remainder(left, right);
    case Operation::power:
      return std::pow(left, right);
    case Operation::less:
      return truth(left < right);
    case Operation::less_equal:
      return truth(left <= right);
    case Operation::greater:
      return truth(left > right);
    case Operation::greater_equal:
      return truth(left >= right);
    case Operation::equal:
      return truth(left == right);
    case Operation::not_equal:
      return truth(left != right);
    case Operation::logical_and:
    case Operation::bracket_and:
      return truth(left != 0.0 && right != 0.0);
    case Operation::logical_or:
    case Operation::bracket_or:
      return truth(left != 0.0 || right != 0.0);
    case Operation::bracket_xor:
      return truth((left != 0.0) != (right != 0.0));
    case Operation::negate:
      return 0.0 - left;
    case Operation::identity:
      return left;
    case Operation::logical_not:
      return truth(left == 0.0);
    case Operation::bracket_equal:
      return truth(near(left, right));
    case Operation::bracket_not_equal:
      return truth(!near(left, right));
    case Operation::bracket_greater:
      return truth(left > right);
    case Operation::bracket_greater_equal:
      return truth(left >= right);
    case Operation::bracket_less:
      return truth(left < right);
    case Operation::bracket_less_equal:
      return truth(left <= right);
  }
  return 0.0;
}

}  // namespace

Value value_of(std::string text) {
  Value value;
  value.object = std::make_shared<Object>();
  value.object->text = std::move(text);
  return value;
}

std::optional<double> computed(Operation operation, double left, double right,
                               ArithmeticFault& fault) {
  const bool divides = operation == Operation::divide || operation == Operation::modulo ||
                       operation == Operation::bracket_modulo;
  if (divides && right == 0.0) {
    fault = {"E3008", "a number is divided by zero"};
    return std::nullopt;
  }
  const double result = raw_result(operation, left, right);
  if (std::isfinite(result)) return without_sign_of_zero(result);
  fault = std::isnan(result) ? ArithmeticFault{"E3009", "no real result"}
                             : ArithmeticFault{"E3009", "the result is too large"};
  return std::nullopt;
}

}  // namespace stanok::lang
