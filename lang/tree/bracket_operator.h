// Operators and functions of bracket expressions, for both readers of them: the parser and the
// computation from text.
//
// The Fanuc dialect follows the operator's manual B-63944EN, 16.2 and 16.4: AND binds like *, OR
// and XOR like +, all three work on bits; FIX goes towards zero and FUP away from it; ASIN and ATAN
// of two values are never negative (parameter NAT 0).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "lang/contract/dialect.h"
#include "lang/tree/tree.h"

namespace stanok::lang {

struct BracketOperator {
  std::string_view name;
  int level;  // 0 binds weakest; all of one level from left to right
  Operation operation;
};

inline constexpr int comparison_level = 1;

// AND, OR and XOR of Haas take the whole part of a number (mill operator's manual, "Logical
// operators"); on Fanuc controls a fraction is an error.
[[nodiscard]] constexpr bool takes_whole_part(Operation operation, const TextRules& rules) {
  return rules.is_haas() && (operation == Operation::macro_and ||
                             operation == Operation::macro_or || operation == Operation::macro_xor);
}

inline constexpr auto bracket_operators = std::to_array<BracketOperator>({
    {"and", 0, Operation::bracket_and},
    {"or", 0, Operation::bracket_or},
    {"xor", 0, Operation::bracket_xor},
    {"eq", comparison_level, Operation::bracket_equal},
    {"ne", comparison_level, Operation::bracket_not_equal},
    {"gt", comparison_level, Operation::bracket_greater},
    {"ge", comparison_level, Operation::bracket_greater_equal},
    {"lt", comparison_level, Operation::bracket_less},
    {"le", comparison_level, Operation::bracket_less_equal},
    {"+", 2, Operation::add},
    {"-", 2, Operation::subtract},
    {"*", 3, Operation::multiply},
    {"/", 3, Operation::divide},
    {"mod", 3, Operation::bracket_modulo},
    {"**", 4, Operation::power},
});
inline constexpr int bracket_levels = 5;

// What the Fanuc dialect has instead.
inline constexpr auto macro_operators = std::to_array<BracketOperator>({
    {"and", 3, Operation::macro_and},
    {"or", 2, Operation::macro_or},
    {"xor", 2, Operation::macro_xor},
    {"mod", 3, Operation::macro_modulo},
    {"an", 3, Operation::macro_and},
    {"xo", 2, Operation::macro_xor},
});

// The row of an operator by its folded name, or nullptr.
[[nodiscard]] constexpr const BracketOperator* find_bracket_operator(std::string_view name,
                                                                     const TextRules& rules = {}) {
  if (rules.is_fanuc()) {
    for (const BracketOperator& row : macro_operators) {
      if (row.name == name) return &row;
    }
  }
  for (const BracketOperator& row : bracket_operators) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

// A function in brackets and the function of high-level text that computes the same.
struct BracketFunction {
  std::string_view name;
  std::string_view function;
  bool wraps = false;  // the result is brought to 0 to 360 deg
};

inline constexpr auto bracket_functions = std::to_array<BracketFunction>({{"abs", "abs"},
                                                                          {"acos", "acos"},
                                                                          {"asin", "asin"},
                                                                          {"atan", "atan2"},
                                                                          {"cos", "cos"},
                                                                          {"exists", "exists"},
                                                                          {"exp", "exp"},
                                                                          {"fix", "floor"},
                                                                          {"fup", "ceil"},
                                                                          {"ln", "ln"},
                                                                          {"round", "round"},
                                                                          {"sin", "sin"},
                                                                          {"sqrt", "sqrt"},
                                                                          {"tan", "tan"}});

// What the Fanuc dialect has instead and besides, with the abbreviations of B-63944EN, 16.8. ATAN
// of one value is "atan". POW[a,b] and ATAN[a,b]: B-64304EN, 16.3.
inline constexpr auto macro_functions = std::to_array<BracketFunction>(
    {{"pow", "pow"},      {"asin", "asin", true}, {"atan", "atan2", true}, {"bcd", "to_bcd"},
     {"bin", "from_bcd"}, {"fix", "trunc"},       {"fup", "round_away"},   {"sqr", "sqrt"},
     {"ab", "abs"},       {"ac", "acos"},         {"as", "asin", true},    {"at", "atan2", true},
     {"bc", "to_bcd"},    {"bi", "from_bcd"},     {"co", "cos"},           {"ex", "exp"},
     {"fi", "trunc"},     {"fu", "round_away"},   {"ro", "round"},         {"si", "sin"},
     {"sq", "sqrt"},      {"ta", "tan"}});

// The row of a function by its folded name, or nullptr.
[[nodiscard]] constexpr const BracketFunction* find_bracket_function(std::string_view name,
                                                                     const TextRules& rules = {}) {
  if (rules.is_fanuc()) {
    for (const BracketFunction& row : macro_functions) {
      if (row.name == name) return &row;
    }
  }
  for (const BracketFunction& row : bracket_functions) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

// The row of the operator with which a folded name begins: it is the name, or a function follows
// without a blank, as in `#1LEABS[#2]`. Or nullptr.
[[nodiscard]] constexpr const BracketOperator* find_leading_operator(std::string_view name,
                                                                     const TextRules& rules = {}) {
  if (const BracketOperator* const whole = find_bracket_operator(name, rules)) return whole;
  for (const BracketOperator& row : bracket_operators) {
    if (!name.starts_with(row.name)) continue;
    const std::string_view behind = name.substr(row.name.size());
    if (find_bracket_function(behind, rules) != nullptr)
      return find_bracket_operator(row.name, rules);
  }
  return nullptr;
}

}  // namespace stanok::lang
