// Whose meaning a text has where the controls that part programs are written for contradict each
// other. What has one meaning everywhere is the same in all dialects.
#pragma once

#include <cstdint>

namespace stanok::lang {

// Names as in the machine file and in `(dialect fanuc A)`.
// `haas` is `fanuc` but for the variables that Haas numbers otherwise.
enum class Dialect : std::uint8_t { stanok, linuxcnc, fanuc, haas };

// The code systems of Fanuc lathes; B has the numbers of docs/reference/language.md.
enum class CodeSystem : std::uint8_t { a, b, c };

struct TextRules {
  Dialect dialect = Dialect::stanok;
  CodeSystem code_system = CodeSystem::b;

  // Fanuc, or Haas, whose language is the same.
  [[nodiscard]] constexpr bool is_fanuc() const {
    return dialect == Dialect::fanuc || dialect == Dialect::haas;
  }
  [[nodiscard]] constexpr bool is_linuxcnc() const { return dialect == Dialect::linuxcnc; }
  [[nodiscard]] constexpr bool is_haas() const { return dialect == Dialect::haas; }
  friend bool operator==(const TextRules&, const TextRules&) = default;
};

}  // namespace stanok::lang
