#include "lang/tree/text_value.h"

#include <array>
#include <cmath>
#include <utility>

#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/tree/bracket_operator.h"
#include "lang/tree/builtin.h"
#include "lang/tree/value.h"

namespace stanok::lang {
namespace {

// The longest names of operators (mod, xor) and functions (exists), one behind the other.
constexpr std::size_t name_length_max = 9;

// A name of few letters, folded.
class ShortName {
 public:
  explicit ShortName(std::string_view name) {
    if (name.size() > letters_.size()) return;
    for (const char c : name) letters_[size_++] = lower_case(c);
  }
  [[nodiscard]] std::string_view text() const { return {letters_.data(), size_}; }

 private:
  std::array<char, name_length_max> letters_{};
  std::size_t size_ = 0;
};

// The rows that compute what the rows of a table name; nullptr: no number from numbers.
template <std::size_t Size>
std::array<const Builtin*, Size> builtins_of(const std::array<BracketFunction, Size>& table) {
  std::array<const Builtin*, Size> rows{};
  for (std::size_t i = 0; i < Size; ++i) rows[i] = find_builtin(table[i].function);
  return rows;
}

const Builtin* builtin_of(const BracketFunction* function) {
  static const auto usual = builtins_of(bracket_functions);
  static const auto macro = builtins_of(macro_functions);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    if (function == &bracket_functions[i]) return usual[i];
  }
  for (std::size_t i = 0; i < macro.size(); ++i) {
    if (function == &macro_functions[i]) return macro[i];
  }
  return nullptr;
}

// In degrees, from 0 on.
double wrapped_degrees(const Value& angle) {
  static const Builtin* const wrap = find_builtin("wrap360");
  Value result;
  return wrap->evaluate({&angle, 1}, result) ? result.number : angle.number;
}

constexpr const BracketOperator* plus_row = find_bracket_operator("+");
constexpr const BracketOperator* minus_row = find_bracket_operator("-");
constexpr const BracketOperator* times_row = find_bracket_operator("*");
constexpr const BracketOperator* divided_row = find_bracket_operator("/");
constexpr const BracketOperator* power_row = find_bracket_operator("**");

// The operator at the beginning of `text`. Nothing for the end of the expression and for what only
// begins like an operator: `//`, `/*`, `+=`, `--`.
const BracketOperator* operator_of(std::string_view text, const TextRules& rules) {
  const char next = text.size() > 1 ? text[1] : '\0';
  switch (text.empty() ? '\0' : text[0]) {
    case '+':
      return next == '+' || next == '=' ? nullptr : plus_row;
    case '-':
      return next == '-' || next == '=' ? nullptr : minus_row;
    case '*':
      if (next == '=') return nullptr;
      return next == '*' ? power_row : times_row;
    case '/':
      return next == '/' || next == '*' || next == '=' ? nullptr : divided_row;
    default:
      break;
  }
  std::size_t length = 0;
  while (length < text.size() && is_name_start(text[length])) ++length;
  return length == 0 ? nullptr
                     : find_leading_operator(ShortName(text.substr(0, length)).text(), rules);
}

}  // namespace

void TextValues::skip_blanks() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
}

std::string_view TextValues::name_ahead() const {
  const char* last = at_;
  while (last != end_ && is_name_part(*last)) ++last;
  return {at_, last};
}

TextValues::MaybeValue TextValues::fail(const char* first, ValueFault fault) {
  fault_ = std::move(fault);
  fault_text_ = {first, at_};
  return std::nullopt;
}

TextValues::MaybeValue TextValues::read(const char*& at) {
  at_ = at;
  depth_ = 0;
  operators_ = 0;
  in_word_ = true;
  const MaybeValue result = value();
  in_word_ = false;
  if (result) at = at_;
  return result;
}

bool TextValues::read_setting(const char*& at) {
  at_ = at + 1;
  depth_ = 1;
  operators_ = 0;
  TextSetting setting;
  if (character() == '<') {
    if (!read_parameter_name()) return false;
    setting.slot = parameters_.slot_to_set(name_);
    if (!setting.slot) return false;
  } else {
    const MaybeValue number = unsigned_value();
    if (!number) return false;
    setting.number = *number;
    if (!parameters_.is_at_hand(*number)) return false;
  }
  setting.text = {at, at_};
  skip_blanks();
  if (character() != '=') return false;
  ++at_;
  skip_blanks();
  depth_ = 0;
  const MaybeValue result = binary(0);
  if (!result) return false;
  setting.value = *result;
  settings_.push_back(setting);
  at = at_;
  return true;
}

// [+|-] unsigned value
TextValues::MaybeValue TextValues::value() {
  if (depth_++ > limits::nesting) return std::nullopt;
  const char sign = character();
  MaybeValue result;
  if (sign == '+' || sign == '-') {
    ++at_;
    skip_blanks();
    result = value();
    if (result && sign == '-') *result = without_sign_of_zero(-*result);
  } else {
    result = unsigned_value();
  }
  --depth_;
  return result;
}

TextValues::MaybeValue TextValues::unsigned_value() {
  const char c = character();
  if (c == '#') return parameter();
  if (c == '[') return bracket();
  if (is_letter(c)) return function();
  return is_digit(c) || c == '.' ? number() : std::nullopt;
}

TextValues::MaybeValue TextValues::number() {
  double result = 0.0;
  bool whole = false;
  if (!read_number(at_, end_, result, whole) || !std::isfinite(result)) return std::nullopt;
  return result;
}

// <name> into name_, blanks left out.
bool TextValues::read_parameter_name() {
  name_.clear();
  for (++at_; at_ != end_ && *at_ != '>'; ++at_) {
    if (is_line_end(*at_)) return false;
    if (!is_blank(*at_)) name_ += lower_case(*at_);
  }
  if (at_ == end_ || name_.empty()) return false;
  ++at_;
  return true;
}

// #5, #<name>, ##5, #[...]
TextValues::MaybeValue TextValues::parameter() {
  if (depth_++ > limits::nesting) return std::nullopt;
  const char* const first = at_++;
  MaybeValue result;
  if (character() == '<') {
    if (!read_parameter_name()) return std::nullopt;
    result = parameters_.named(name_, fault_);
  } else {
    const MaybeValue number = unsigned_value();
    if (!number || !parameters_.is_at_hand(*number)) return std::nullopt;
    result = parameters_.numbered(*number, fault_);
  }
  --depth_;
  if (!result) fault_text_ = {first, at_};
  const bool vacant = result && std::isnan(*result) && parameters_.are_known();
  return vacant && !rules_.is_fanuc() ? 0.0 : result;
}

TextValues::MaybeValue TextValues::bracket() {
  ++at_;
  const MaybeValue result = binary(0);
  if (!result) return std::nullopt;
  skip_blanks();
  if (character() != ']') return std::nullopt;
  ++at_;
  return result;
}

// An expression whose operators bind at least as strongly as `level`.
TextValues::MaybeValue TextValues::binary(int level) {
  skip_blanks();
  const char* const first = at_;
  MaybeValue left = value();
  for (bool compared = false; left;) {
    const char* const last = at_;
    skip_blanks();
    const BracketOperator* const found = operator_of({at_, end_}, rules_);
    if (found == nullptr || found->level < level) {
      at_ = last;
      return left;
    }
    if (compared && rules_.is_fanuc()) return std::nullopt;
    compared = found->level == comparison_level;
    if (++operators_ > limits::operators) return std::nullopt;
    at_ += found->name.size();
    const MaybeValue right = binary(found->level + 1);
    if (!right) return std::nullopt;
    if (takes_whole_part(found->operation, rules_)) return std::nullopt;  // left to the parser
    const bool unknown = std::isnan(*left) || std::isnan(*right);
    ArithmeticFault fault{};
    if (unknown && parameters_.are_known()) {
      left = computed_with_vacant(found->operation, *left, *right, fault);
    } else {
      left = computed(found->operation, *left, *right, fault);
      if (unknown) left = std::nan("");
    }
    if (!left) return fail(first, {fault.code, fault.message, {}});
  }
  return std::nullopt;
}

// SIN[...], ATAN[...]/[...]
TextValues::MaybeValue TextValues::function() {
  const char* const first = at_;
  const std::string_view name = name_ahead();
  const BracketFunction* const function = find_bracket_function(ShortName(name).text(), rules_);
  const Builtin* const row = function == nullptr ? nullptr : builtin_of(function);
  if (row == nullptr) return std::nullopt;
  // ROUND of a word goes by the increment of its address there: left to the parser.
  if (in_word_ && rules_.is_fanuc() && function->name == "round") return std::nullopt;
  if (function->name == "pow") return std::nullopt;  // of two values in one pair of brackets
  at_ += name.size();
  std::array<Value, 2> arguments;
  const std::size_t count = row->arguments.size();
  for (std::size_t i = 0; i < count; ++i) {
    skip_blanks();
    if (i != 0 && character() == '/') {
      ++at_;
      skip_blanks();
    }
    if (character() != '[') return std::nullopt;
    const MaybeValue argument = bracket();
    if (!argument) return std::nullopt;
    const bool vacant = std::isnan(*argument) && parameters_.are_known();
    arguments[i].number = vacant ? 0.0 : *argument;
  }
  Value result;
  if (std::isnan(arguments[0].number) || std::isnan(arguments[1].number)) return std::nan("");
  if (row->evaluate({arguments.data(), count}, result))
    return function->wraps ? wrapped_degrees(result) : result.number;
  return fail(first,
              {"E3009", "invalid argument of `" + std::string(row->name) + "`", "no result"});
}

}  // namespace stanok::lang
