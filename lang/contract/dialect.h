// Whose meaning a text has where the controls that part programs are written for contradict each
// other. What has one meaning everywhere is the same in all dialects.
#pragma once

#include <cstdint>

namespace stanok::lang {

// Names as in the machine file and in `(dialect fanuc A)`.
enum class Dialect : std::uint8_t { stanok, linuxcnc, fanuc };

// The code systems of Fanuc lathes; B has the numbers of docs/reference/language.md.
enum class CodeSystem : std::uint8_t { a, b, c };

struct TextRules {
  Dialect dialect = Dialect::stanok;
  CodeSystem code_system = CodeSystem::b;

  [[nodiscard]] constexpr bool is_fanuc() const { return dialect == Dialect::fanuc; }
  friend bool operator==(const TextRules&, const TextRules&) = default;
};

}  // namespace stanok::lang
