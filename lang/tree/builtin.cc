#include "lang/tree/builtin.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>

#include "base/angle.h"
#include "base/utf8.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/text/source.h"

namespace stanok::lang {
namespace {

using Arguments = std::span<const Value>;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double near_tolerance = 1e-6;

bool set(Value& result, double number) {
  result = value_of(without_sign_of_zero(number));
  return std::isfinite(number);
}

bool set_text(Value& result, std::string text) {
  if (text.size() > limits::string_bytes) return false;
  result = value_of(std::move(text));
  return true;
}

template <double (*Function)(double)>
bool unary(Arguments a, Value& result) {
  return set(result, Function(a[0].number));
}

double tangent(double x) {
  const double cosine = cosine_of_degrees(x);
  return cosine == 0.0 ? HUGE_VAL : sine_of_degrees(x) / cosine;
}
// Of the rational sines only 0, a half and 1 belong to rational angles (I. Niven, "Irrational
// Numbers", 1956): 0 and 1 come out exactly by themselves.
double arc_sine(double x) {
  constexpr double of_a_half = 30.0;
  return std::abs(x) == 0.5 ? std::copysign(of_a_half, x) : std::asin(x) / degree;
}
double arc_cosine(double x) {
  constexpr double of_a_half = 60.0;
  if (std::abs(x) == 0.5) return x > 0.0 ? of_a_half : 180.0 - of_a_half;
  return std::acos(x) / degree;
}
double arc_tangent(double x) {
  return std::atan(x) / degree;
}
double square_root(double x) {
  return std::sqrt(x);
}
double magnitude(double x) {
  return std::abs(x);
}
double sign_of(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}
double round_down(double x) {
  return std::floor(x);
}
double round_up(double x) {
  return std::ceil(x);
}
double round_half_away(double x) {
  return std::round(x);
}
double cut_off(double x) {
  return std::trunc(x);
}
double round_away(double x) {
  return x < 0.0 ? std::floor(x) : std::ceil(x);
}
// Decimal digits of four bits each, and back; NaN beyond 8 digits.
constexpr double bcd_end = 1e8;
double to_bcd(double x) {
  if (!is_integer(x) || x < 0.0 || x >= bcd_end) return std::nan("");
  auto rest = static_cast<std::uint32_t>(whole_number(x));
  std::uint32_t digits = 0;
  for (unsigned shift = 0; rest != 0; shift += 4, rest /= 10) digits |= (rest % 10) << shift;
  return digits;
}
double from_bcd(double x) {
  if (x < 0.0 || x > 4294967295.0 || x != std::floor(x)) return std::nan("");
  auto rest = static_cast<std::uint32_t>(x);
  double number = 0.0;
  for (double unit = 1.0; rest != 0; unit *= 10.0, rest >>= 4U) {
    if ((rest & 15U) > 9) return std::nan("");
    number += unit * (rest & 15U);
  }
  return number;
}
double exponential(double x) {
  return std::exp(x);
}
double natural_logarithm(double x) {
  return std::log(x);
}
double decimal_logarithm(double x) {
  return std::log10(x);
}
double wrapped(double x) {
  const double rest = std::fmod(x, 360.0);
  const double turn = rest < 0.0 ? rest + 360.0 : rest;
  return turn < 360.0 ? turn : 0.0;  // the sum may have been rounded up
}

bool arc_tangent_of_two(Arguments a, Value& result) {
  return set(result, std::atan2(a[0].number, a[1].number) / degree);
}
bool smallest(Arguments a, Value& result) {
  double least = a[0].number;
  for (const Value& value : a) least = std::min(least, value.number);
  return set(result, least);
}
bool largest(Arguments a, Value& result) {
  double most = a[0].number;
  for (const Value& value : a) most = std::max(most, value.number);
  return set(result, most);
}
template <Operation Which>
bool arithmetic(Arguments a, Value& result) {
  ArithmeticFault fault{};
  const auto number = computed(Which, a[0].number, a[1].number, fault);
  return number && set(result, *number);
}
bool hypotenuse(Arguments a, Value& result) {
  return set(result, std::hypot(a[0].number, a[1].number));
}
bool is_near(Arguments a, Value& result) {
  const double tolerance = a.size() > 2 ? a[2].number : near_tolerance;
  result = value_of(std::abs(a[0].number - a[1].number) <= tolerance);
  return true;
}
bool clamped(Arguments a, Value& result) {
  if (a[1].number > a[2].number) return false;
  return set(result, std::clamp(a[0].number, a[1].number, a[2].number));
}

// Bits of whole numbers from 0 to 2^32 - 1.
template <class Combine>
bool combine_bits(Arguments a, Value& result, Combine combine) {
  for (const Value& value : a) {
    const bool whole = std::abs(value.number - std::round(value.number)) <= 1e-9;
    if (!whole || value.number < -0.5 || value.number > 4294967295.0) return false;
  }
  const auto left = static_cast<std::uint32_t>(std::llround(a[0].number));
  const auto right = static_cast<std::uint32_t>(std::llround(a[1].number));
  return set(result, static_cast<double>(combine(left, right)));
}
bool bits_and(Arguments a, Value& result) {
  return combine_bits(a, result, [](std::uint32_t x, std::uint32_t y) { return x & y; });
}
bool bits_or(Arguments a, Value& result) {
  return combine_bits(a, result, [](std::uint32_t x, std::uint32_t y) { return x | y; });
}
bool bits_xor(Arguments a, Value& result) {
  return combine_bits(a, result, [](std::uint32_t x, std::uint32_t y) { return x ^ y; });
}

bool length_of_text(Arguments a, Value& result) {
  return set(result, static_cast<double>(character_count(text_of(a[0]))));
}
bool part_of_text(Arguments a, Value& result) {
  const std::string& text = text_of(a[0]);
  if (!is_integer(a[1].number) || a[1].number < 0.0) return false;
  const std::size_t first = whole_number(a[1].number);
  if (first > character_count(text)) return false;
  std::size_t count = std::string::npos;
  if (a.size() > 2) {
    if (!is_integer(a[2].number) || a[2].number < 0.0) return false;
    count = whole_number(a[2].number);
  }
  const std::string_view rest = std::string_view(text).substr(offset_of_character(text, first));
  return set_text(result, std::string(rest.substr(0, offset_of_character(rest, count))));
}
bool place_of_match(Arguments a, Value& result) {
  const std::string_view text = text_of(a[0]);
  const std::size_t at = text.find(text_of(a[1]));
  if (at == std::string::npos) return set(result, -1.0);
  return set(result, static_cast<double>(character_count(text.substr(0, at))));
}
bool in_lower_case(Arguments a, Value& result) {
  return set_text(result, folded(text_of(a[0])));
}
bool in_upper_case(Arguments a, Value& result) {
  std::string text = text_of(a[0]);
  std::transform(text.begin(), text.end(), text.begin(), upper_case);
  return set_text(result, std::move(text));
}
// The shortest text that reads back as the same number; with an exponent only where figures would
// be counted otherwise.
std::string shortest_text(double number) {
  char text[64];
  int digits = 0;
  do {
    std::snprintf(text, sizeof text, "%.*e", digits++, number);
  } while (digits < 17 && std::strtod(text, nullptr) != number);
  const auto exponent = static_cast<int>(std::strtol(std::strchr(text, 'e') + 1, nullptr, 10));
  if (exponent < -5 || exponent > 15) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
  } else {
    std::snprintf(text, sizeof text, "%.*f", std::max(digits - 1 - exponent, 0), number);
  }
  return text;
}

bool number_as_text(Arguments a, Value& result) {
  if (a.size() < 2) return set_text(result, shortest_text(a[0].number));
  if (!is_integer(a[1].number) || a[1].number < 0.0 || a[1].number > 17.0) return false;
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", static_cast<int>(std::lround(a[1].number)), a[0].number);
  const bool rounded_to_zero = std::strpbrk(text, "123456789") == nullptr;
  return set_text(result, rounded_to_zero && text[0] == '-' ? text + 1 : text);
}
bool as_number(Arguments a, Value& result) {
  std::string_view text = text_of(a[0]);
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && set(result, number);
}

constexpr Builtin pure(std::string_view name, Type result, std::string_view arguments,
                       int optional_arguments, Evaluation evaluate) {
  Builtin row;
  row.name = name;
  row.result = result;
  row.arguments = arguments;
  row.optional_arguments = optional_arguments;
  row.evaluate = evaluate;
  return row;
}

constexpr Builtin number(std::string_view name, std::string_view arguments, Evaluation evaluate) {
  return pure(name, Type::number, arguments, 0, evaluate);
}

constexpr Builtin channel(std::string_view name, Type result, std::string_view arguments,
                          RequestKind request, std::string_view failure_code) {
  Builtin row;
  row.name = name;
  row.result = result;
  row.arguments = arguments;
  row.optional_arguments = request == RequestKind::channel_wait ? 1 : 0;
  row.effect = Effect::request;
  row.request = request;
  row.failure_code = failure_code;
  row.takes_channel = true;
  row.refuses_own_channel =
      request != RequestKind::channel_state && request != RequestKind::mark_state;
  return row;
}

constexpr Builtin effect(std::string_view name, Type result, std::string_view arguments,
                         Effect what, Message::Kind message = Message::Kind::message) {
  Builtin row;
  row.name = name;
  row.result = result;
  row.arguments = arguments;
  row.effect = what;
  row.message = message;
  return row;
}

constexpr Builtin machine_value(std::string_view name) {
  Builtin row;
  row.name = name;
  row.effect = Effect::request;
  row.request = RequestKind::machine_value;
  row.request_text = name;
  return row;
}

constexpr Builtin mark(std::string_view name, std::string_view arguments, MarkCommand::Kind kind) {
  Builtin row;
  row.name = name;
  row.result = Type::none;
  row.arguments = arguments;
  row.effect = Effect::mark;
  row.mark = kind;
  return row;
}

constexpr Builtin table(std::string_view name, Type result, std::string_view arguments,
                        RequestKind request) {
  Builtin row;
  row.name = name;
  row.result = result;
  row.arguments = arguments;
  row.effect = Effect::table;
  row.request = request;
  if (result == Type::boolean) row.failure_code = "E5020";
  return row;
}

constexpr auto builtin_rows = std::to_array<Builtin>({
    number("sin", "n", unary<sine_of_degrees>),
    number("cos", "n", unary<cosine_of_degrees>),
    number("tan", "n", unary<tangent>),
    number("asin", "n", unary<arc_sine>),
    number("acos", "n", unary<arc_cosine>),
    number("atan", "n", unary<arc_tangent>),
    number("atan2", "nn", arc_tangent_of_two),
    number("sqrt", "n", unary<square_root>),
    number("abs", "n", unary<magnitude>),
    number("sign", "n", unary<sign_of>),
    number("min", "nn*", smallest),
    number("max", "nn*", largest),
    number("floor", "n", unary<round_down>),
    number("ceil", "n", unary<round_up>),
    number("round", "n", unary<round_half_away>),
    number("trunc", "n", unary<cut_off>),
    number("round_away", "n", unary<round_away>),
    number("to_bcd", "n", unary<to_bcd>),
    number("from_bcd", "n", unary<from_bcd>),
    number("exp", "n", unary<exponential>),
    number("ln", "n", unary<natural_logarithm>),
    number("log10", "n", unary<decimal_logarithm>),
    number("pow", "nn", arithmetic<Operation::power>),
    number("hypot", "nn", hypotenuse),
    number("mod", "nn", arithmetic<Operation::modulo>),
    pure("near", Type::boolean, "nnn", 1, is_near),
    number("clamp", "nnn", clamped),
    number("wrap360", "n", unary<wrapped>),
    number("bit_and", "nn", bits_and),
    number("bit_or", "nn", bits_or),
    number("bit_xor", "nn", bits_xor),
    number("len", "s", length_of_text),
    pure("substr", Type::string, "snn", 1, part_of_text),
    number("find", "ss", place_of_match),
    pure("upper", Type::string, "s", 0, in_upper_case),
    pure("lower", Type::string, "s", 0, in_lower_case),
    pure("str", Type::string, "nn", 1, number_as_text),
    number("to_num", "s", as_number),
    effect("msg", Type::none, "s", Effect::message, Message::Kind::message),
    effect("warn", Type::none, "s", Effect::message, Message::Kind::warning),
    effect("log", Type::none, "s", Effect::message, Message::Kind::log),
    effect("sync", Type::none, "", Effect::request),
    effect("terminate", Type::none, "ns", Effect::terminate),
    effect("call", Type::none, "s", Effect::call_file),
    effect("channel_error", Type::string, "", Effect::channel_error),
    effect("arg", Type::number, "s", Effect::argument),
    effect("has_arg", Type::boolean, "s", Effect::has_argument),
    effect("save_gvector", Type::string, "n", Effect::save_state),
    effect("restore_gvector", Type::boolean, "s", Effect::restore_state),
    machine_value("clock"),
    channel("channel_load", Type::boolean, "ns", RequestKind::channel_load, "E6011"),
    channel("channel_start", Type::boolean, "n", RequestKind::channel_start, "E6012"),
    channel("channel_run", Type::boolean, "ns", RequestKind::channel_run, "E6013"),
    channel("channel_wait", Type::boolean, "nn", RequestKind::channel_wait, "E6010"),
    channel("channel_stop", Type::boolean, "n", RequestKind::channel_stop, "E6014"),
    channel("channel_reset", Type::boolean, "n", RequestKind::channel_reset, "E6015"),
    channel("channel_state", Type::number, "n", RequestKind::channel_state, ""),
    effect("mark_wait", Type::none, "nn*", Effect::mark_wait),
    mark("mark_wait_soft", "nn*", MarkCommand::Kind::wait_soft),
    mark("mark_set", "n", MarkCommand::Kind::set),
    mark("mark_clear", "n", MarkCommand::Kind::clear),
    table("settable_zs", Type::boolean, "nnxn", RequestKind::offset_table_write),
    table("settable_tool", Type::boolean, "nnpn", RequestKind::tool_table_write),
    table("gettable_zs", Type::number, "nnx", RequestKind::offset_table_read),
    table("gettable_tool", Type::number, "nnp", RequestKind::tool_table_read),
    channel("mark_is_set", Type::boolean, "nn", RequestKind::mark_state, ""),
});

}  // namespace

const Builtin* find_builtin(std::string_view folded_name) {
  const auto row = std::find_if(builtin_rows.begin(), builtin_rows.end(),
                                [&](const Builtin& one) { return one.name == folded_name; });
  return row == builtin_rows.end() ? nullptr : &*row;
}

std::span<const Builtin> builtins() {
  return builtin_rows;
}

}  // namespace stanok::lang
