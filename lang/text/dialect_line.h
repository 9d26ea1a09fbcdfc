// The dialect that a program names in its first line: `(dialect fanuc A)`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/contract/dialect.h"

namespace stanok::lang {

// What a first line says about the dialect.
struct DialectLine {
  std::optional<TextRules> rules;  // nothing: it does not speak of it, or is at fault
  std::string problem;             // why it is at fault
};

// `line` without the blanks around it. The code system that it leaves out is the one of `usual`.
[[nodiscard]] DialectLine dialect_line(std::string_view line, const TextRules& usual);

[[nodiscard]] std::optional<Dialect> dialect_called(std::string_view folded_name);
[[nodiscard]] std::optional<CodeSystem> code_system_called(std::string_view folded_name);
[[nodiscard]] std::string_view name_of(Dialect dialect);

}  // namespace stanok::lang
