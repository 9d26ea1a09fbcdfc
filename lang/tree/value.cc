#include "lang/tree/value.h"

#include <cmath>
#include <cstdint>

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

// The bits of a whole number as the controls hold them; nothing for others.
std::optional<std::int32_t> bits_of(double number) {
  const double whole = std::round(number);
  const bool fits = std::abs(whole) < 2147483648.0 && std::abs(number - whole) <= 1e-9;
  return fits ? std::optional(static_cast<std::int32_t>(whole)) : std::nullopt;
}

double bitwise_result(Operation operation, double left, double right) {
  const auto a = bits_of(left);
  const auto b = bits_of(right);
  if (!a || !b) return std::nan("");
  if (operation == Operation::macro_and) return *a & *b;
  return operation == Operation::macro_or ? *a | *b : *a ^ *b;
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
    case Operation::macro_modulo:
      return std::fmod(left, right);
    case Operation::macro_and:
    case Operation::macro_or:
    case Operation::macro_xor:
      return bitwise_result(operation, left, right);
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
                       operation == Operation::bracket_modulo ||
                       operation == Operation::macro_modulo;
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

std::optional<double> computed_with_vacant(Operation operation, double left, double right,
                                           ArithmeticFault& fault) {
  const bool both = std::isnan(left) && std::isnan(right);
  const bool one = std::isnan(left) || std::isnan(right);
  if (one && operation == Operation::bracket_equal) return truth(both);
  if (one && operation == Operation::bracket_not_equal) return truth(!both);
  return computed(operation, value_or_zero(left), value_or_zero(right), fault);
}

}  // namespace stanok::lang
