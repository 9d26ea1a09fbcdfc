// Operators and functions of bracket expressions, for both readers of them: the parser and the
// computation from text.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "lang/tree/tree.h"

namespace stanok::lang {

struct BracketOperator {
  std::string_view name;
  int level;  // 0 binds weakest; all of one level from left to right
  Operation operation;
};

inline constexpr auto bracket_operators = std::to_array<BracketOperator>({
    {"and", 0, Operation::bracket_and},
    {"or", 0, Operation::bracket_or},
    {"xor", 0, Operation::bracket_xor},
    {"eq", 1, Operation::bracket_equal},
    {"ne", 1, Operation::bracket_not_equal},
    {"gt", 1, Operation::bracket_greater},
    {"ge", 1, Operation::bracket_greater_equal},
    {"lt", 1, Operation::bracket_less},
    {"le", 1, Operation::bracket_less_equal},
    {"+", 2, Operation::add},
    {"-", 2, Operation::subtract},
    {"*", 3, Operation::multiply},
    {"/", 3, Operation::divide},
    {"mod", 3, Operation::bracket_modulo},
    {"**", 4, Operation::power},
});
inline constexpr int bracket_levels = 5;

// The row of an operator by its folded name, or nullptr.
[[nodiscard]] constexpr const BracketOperator* find_bracket_operator(std::string_view name) {
  for (const BracketOperator& row : bracket_operators) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

// Functions in brackets and the function of high-level text that computes the same.
inline constexpr auto bracket_functions =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"abs", "abs"},
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

}  // namespace stanok::lang
