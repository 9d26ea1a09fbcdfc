#include "lang/words/code_system.h"

#include <array>
#include <charconv>
#include <span>

namespace stanok::lang {
namespace {

struct OtherCode {
  CodeNumber written = 0;
  CodeNumber here = 0;  // code_missing: the system does not have the code
};
constexpr CodeNumber code_missing = -1;

constexpr auto system_a = std::to_array<OtherCode>({
    {g(50), g(92)},
    {g(50, 3), g(92, 1)},
    {g(77), code_missing},
    {g(78), code_missing},
    {g(79), code_missing},
    {g(90), g(77)},
    {g(91), code_missing},
    {g(92), g(78)},
    {g(93), code_missing},
    {g(94), g(79)},
    {g(95), code_missing},
    {g(98), g(94)},
    {g(99), g(95)},
});

constexpr auto system_c = std::to_array<OtherCode>({
    {g(20), g(77)},
    {g(21), g(78)},
    {g(24), g(79)},
    {g(70), g(20)},
    {g(71), g(21)},
    {g(72), g(70)},
    {g(73), g(71)},
    {g(74), g(72)},
    {g(75), g(73)},
    {g(76), g(74)},
    {g(77), g(75)},
    {g(78), g(76)},
    {g(79), code_missing},
});

std::span<const OtherCode> rows_of(CodeSystem system) {
  if (system == CodeSystem::a) return system_a;
  if (system == CodeSystem::c) return system_c;
  return {};
}

}  // namespace

std::optional<CodeNumber> translated_code(CodeNumber written, CodeSystem system) {
  for (const OtherCode& row : rows_of(system)) {
    if (row.written != written) continue;
    return row.here == code_missing ? std::nullopt : std::optional(row.here);
  }
  return written;
}

CodeNumber code_as_written(CodeNumber code, CodeSystem system) {
  for (const OtherCode& row : rows_of(system)) {
    if (row.here == code) return row.written;
  }
  return code;
}

std::string text_as_written(std::string_view text, CodeSystem system) {
  std::string result;
  const auto is_digit = [&](std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
  };
  const auto is_in_word = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || (c >= '0' && c <= '9');
  };
  for (std::size_t at = 0; at < text.size();) {
    const bool begins =
        text[at] == 'G' && is_digit(at + 1) && (at == 0 || !is_in_word(text[at - 1]));
    if (!begins) {
      result += text[at++];
      continue;
    }
    std::size_t end = at + 1;
    while (is_digit(end)) ++end;
    int whole = 0;
    std::from_chars(text.data() + at + 1, text.data() + end, whole);
    int tenths = 0;
    if (end < text.size() && text[end] == '.' && is_digit(end + 1)) {
      tenths = text[end + 1] - '0';
      end += 2;
    }
    constexpr int whole_max = 999;
    const bool is_code = whole <= whole_max && (end == text.size() || !is_in_word(text[end]));
    const auto here = static_cast<CodeNumber>(is_code ? whole * 10 + tenths : 0);
    const CodeNumber written = is_code ? code_as_written(here, system) : here;
    result += written == here ? std::string(text.substr(at, end - at)) : code_text('G', written);
    at = end;
  }
  return result;
}

void name_codes_as_written(BlockFault& fault, CodeSystem system) {
  if (system == CodeSystem::b) return;
  fault.message = text_as_written(fault.message, system);
  fault.label = text_as_written(fault.label, system);
  for (Note& note : fault.notes) note.text = text_as_written(note.text, system);
  for (std::string& help : fault.help) help = text_as_written(help, system);
}

bool translate_codes(CodeList& codes, CodeSystem system) {
  for (std::size_t i = 0; i < codes.count; ++i) {
    const auto here = translated_code(codes.numbers[i], system);
    if (!here) return false;
    codes.numbers[i] = *here;
  }
  return true;
}

std::string_view instead_of_code(CodeNumber written, CodeSystem system) {
  if (system == CodeSystem::c) return {};
  switch (written) {
    case g(77):
      return "the turning cycle is `G90`";
    case g(78):
      return "the thread cycle is `G92`";
    case g(79):
      return "the facing cycle is `G94`";
    case g(91):
      return "increments are `U` and `W`";
    case g(95):
      return "the feed per revolution is `G99`";
    default:
      return {};
  }
}

}  // namespace stanok::lang
