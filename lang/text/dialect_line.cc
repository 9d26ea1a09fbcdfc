#include "lang/text/dialect_line.h"

#include <array>
#include <utility>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr auto dialects =
    std::to_array<std::pair<std::string_view, Dialect>>({{"stanok", Dialect::stanok},
                                                         {"linuxcnc", Dialect::linuxcnc},
                                                         {"fanuc", Dialect::fanuc},
                                                         {"haas", Dialect::haas}});

// The next word of `text`, which is left behind it.
std::string next_word(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  std::size_t length = 0;
  while (length < text.size() && !is_blank(text[length])) ++length;
  std::string word = folded(text.substr(0, length));
  text.remove_prefix(length);
  return word;
}

}  // namespace

std::optional<Dialect> dialect_called(std::string_view folded_name) {
  for (const auto& [name, dialect] : dialects) {
    if (name == folded_name) return dialect;
  }
  return std::nullopt;
}

std::optional<CodeSystem> code_system_called(std::string_view folded_name) {
  if (folded_name == "a") return CodeSystem::a;
  if (folded_name == "b") return CodeSystem::b;
  if (folded_name == "c") return CodeSystem::c;
  return std::nullopt;
}

std::string_view name_of(Dialect dialect) {
  for (const auto& [name, known] : dialects) {
    if (known == dialect) return name;
  }
  return {};
}

DialectLine dialect_line(std::string_view line, const TextRules& usual) {
  DialectLine result;
  if (!line.starts_with('(')) return result;
  std::string_view rest = line.substr(1, line.find(')', 1) - 1);
  if (next_word(rest) != "dialect") return result;
  TextRules rules = usual;
  const std::string name = next_word(rest);
  const std::string system = next_word(rest);
  const auto dialect = dialect_called(name);
  const auto code_system = code_system_called(system);
  const bool has_systems = dialect == Dialect::fanuc || dialect == Dialect::haas;
  if (!dialect) {
    result.problem = "there is no dialect `" + name + "`; write stanok, linuxcnc, fanuc or haas";
  } else if (!system.empty() && (!code_system || !has_systems)) {
    result.problem = "`" + system + "` is not a code system; write A, B or C after fanuc or haas";
  } else if (!next_word(rest).empty()) {
    result.problem = "there is extra text after the dialect; write e.g. `(dialect fanuc A)`";
  } else {
    rules.dialect = *dialect;
    if (code_system) rules.code_system = *code_system;
    if (!has_systems) rules.code_system = CodeSystem::b;
    result.rules = rules;
  }
  return result;
}

}  // namespace stanok::lang
