#include "lang/tree/keywords.h"

#include <array>

namespace stanok::lang {
namespace {

constexpr auto keywords = std::to_array<std::string_view>(
    {"if",     "else", "while", "for",    "do",   "switch", "case",  "default", "break", "continue",
     "return", "num",  "bool",  "string", "axis", "void",   "const", "shared",  "true",  "false"});

constexpr auto reserved_words = std::to_array<std::string_view>(
    {"repeat", "until", "goto", "extern", "struct", "enum", "import", "export", "persist"});

}  // namespace

bool is_keyword(std::string_view folded_name) {
  for (const std::string_view word : keywords) {
    if (word == folded_name) return true;
  }
  return false;
}

bool is_reserved_word(std::string_view folded_name) {
  for (const std::string_view word : reserved_words) {
    if (word == folded_name) return true;
  }
  return false;
}

std::optional<Type> type_of_keyword(std::string_view folded_name) {
  if (folded_name == "num") return Type::number;
  if (folded_name == "bool") return Type::boolean;
  if (folded_name == "string") return Type::string;
  if (folded_name == "axis") return Type::axis;
  if (folded_name == "void") return Type::none;
  return std::nullopt;
}

}  // namespace stanok::lang
