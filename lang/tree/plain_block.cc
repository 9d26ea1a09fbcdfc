#include "lang/tree/plain_block.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/block/block_check.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"
#include "lang/text/source.h"
#include "lang/words/code_system.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {
namespace {

// Largest code, in tenths: M999.9 and what a CodeNumber holds.
constexpr double code_number_max = 9999.0;

bool is_plain_byte(char c) {
  return (static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7F) ||
         c == '\t';
}

// Goes to the line end; false when a byte on the way needs a closer look.
bool skip_to_line_end(const char*& at, const char* end) {
  while (at != end && !is_line_end(*at)) {
    if (!is_plain_byte(*at)) return false;
    ++at;
  }
  return true;
}

bool is_blank_line(const char* at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  return at == end || is_line_end(*at);
}

// Comments of the form (WORD,...) may have an effect.
bool may_be_active(const char* at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  const char* const first = at;
  while (at != end && is_letter(*at)) ++at;
  const char* const last = at;
  while (at != end && is_blank(*at)) ++at;
  return last != first && at != end && *at == ',';
}

bool skip_parentheses(const char*& at, const char* end) {
  ++at;
  if (may_be_active(at, end)) return false;
  for (; at != end && *at != ')'; ++at) {
    if (!is_plain_byte(*at) || *at == '(') return false;
  }
  if (at == end) return false;
  ++at;
  return true;
}

bool add_code(CodeList& list, double number) {
  const double tenths = number * 10.0;
  if (!is_integer(tenths) || tenths < 0.0 || tenths > code_number_max) return false;
  if (list.count == CodeList::capacity) return false;
  list.add(static_cast<CodeNumber>(std::lround(tenths)));
  return true;
}

// A value as it is written.
struct WrittenNumber {
  double value = 0.0;
  bool whole = false;  // without a decimal point
};

bool add_word(BlockWords& words, char letter, WrittenNumber number) {
  const auto [value, whole] = number;
  if (letter == 'G') return add_code(words.g, value);
  if (letter == 'M') return add_code(words.m, value);
  const LetterSet bit = letter_bit(letter);
  if ((words.letters & bit) != 0 || letter == 'N' || letter == 'O') return false;
  words.letters |= bit;
  if (whole) words.whole |= bit;
  words.values[letter] = value;
  return true;
}

bool skip_block_number(const char*& at, const char* end) {
  const char* cursor = at + 1;
  const char* const first = cursor;
  while (cursor != end && (is_digit(*cursor) || *cursor == '.')) ++cursor;
  if (cursor == first || !is_digit(*first)) return false;
  if (std::count(first, cursor, '.') > 1) return false;
  at = cursor;
  return true;
}

// A value behind its address that is no plain number; not inlined, for the sake of the lines that
// have none. A function beside the address has its bracket at once: `Xsin [30]` is no word.
[[gnu::noinline]] bool read_computed_word(const char*& at, const char* end, char letter,
                                          BlockWords& words, TextValues& values) {
  if (at == end || letter == 'G' || letter == 'M') return false;
  if (is_letter(*at) && !is_blank(at[-1])) {
    const char* behind = at;
    while (behind != end && is_name_part(*behind)) ++behind;
    if (behind == end || *behind != '[') return false;
  }
  const auto value = values.read(at);
  if (value && std::isnan(*value) && values.are_known()) {
    words.left_out |= letter_bit(letter);
    return true;
  }
  return value && add_word(words, letter, {*value, words.rules.is_fanuc()});
}

// Address and value; `at` is left behind them.
bool read_word(const char*& at, const char* end, BlockWords& words, TextValues& values) {
  const char letter = upper_case(*at++);
  while (at != end && is_blank(*at)) ++at;
  double value = 0.0;
  bool whole = false;
  const bool good = read_number(at, end, value, whole)
                        ? add_word(words, letter, {value, whole})
                        : read_computed_word(at, end, letter, words, values);
  return good && (at == end || (*at != '.' && *at != '='));
}

// `,C2` and `,R[#1]`; `at` is left behind.
[[gnu::noinline]] bool read_corner_word(const char*& at, const char* end, BlockWords& words,
                                        TextValues& values) {
  const char letter = ++at == end ? '\0' : upper_case(*at);
  const std::string name{',', letter};
  if (!is_corner_word(name)) return false;
  if (std::ranges::any_of(words.named, [&](const NamedWord& word) { return word.name == name; }))
    return false;
  ++at;
  while (at != end && is_blank(*at)) ++at;
  double value = 0.0;
  bool whole = false;
  if (!read_number(at, end, value, whole)) {
    const auto computed = at == end ? std::nullopt : values.read(at);
    if (!computed) return false;
    if (std::isnan(*computed)) return values.are_known();  // a vacant parameter
    value = *computed;
  }
  words.named.push_back({name, value});
  return at == end || (*at != '.' && *at != '=');
}

// The end of a line from its semicolon on; `rules`: null when no word is before it.
bool ends_at_semicolon(const char*& at, const char* end, Surroundings surroundings,
                       const TextRules* rules) {
  if (rules != nullptr && surroundings == Surroundings::braces) return false;
  if (rules != nullptr && rules->is_fanuc() && !is_blank_line(at + 1, end)) return false;
  return skip_to_line_end(at, end);
}

// A line by its angle, with which a block may begin: `,A30`.
bool is_line_angle(const char* at, const char* end) {
  return end - at > 1 && *at == ',' && upper_case(at[1]) == 'A';
}

// What does not begin with a letter, within a line: corner, parentheses or setting.
bool read_other_word(const char*& at, const char* end, BlockWords& words, TextValues& values,
                     bool& any) {
  any = any || is_line_angle(at, end);
  if (*at == ',') return any && read_corner_word(at, end, words, values);
  if (*at == '(') return skip_parentheses(at, end);
  any = true;
  return *at == '#' && values.read_setting(at) && (at == end || *at != '.');
}

// The words of a line up to its end; `at` is left there.
bool read_words(const char*& at, const char* end, Surroundings surroundings, BlockWords& words,
                TextValues& values) {
  bool any = false;
  while (at != end) {
    const char c = *at;
    if (is_blank(c)) {
      ++at;
    } else if (is_letter(c)) {
      if (!read_word(at, end, words, values)) return false;
      any = true;
    } else if (is_line_end(c)) {
      return true;
    } else if (c == ';') {
      return ends_at_semicolon(at, end, surroundings, any ? &words.rules : nullptr);
    } else if (c == '/') {
      return at + 1 != end && at[1] == '/' && skip_to_line_end(at, end);
    } else if (!read_other_word(at, end, words, values, any)) {
      return false;
    }
  }
  return true;
}

void skip_line_end(const char*& at, const char* end) {
  if (at == end) return;
  const bool pair = *at == '\r' && at + 1 != end && at[1] == '\n';
  at += pair ? 2 : 1;
}

}  // namespace

bool read_plain_line(const char*& at, const char* end, const LineRules& rules, BlockWords& words,
                     TextValues& values) {
  words.clear();
  words.rules = rules.text;
  values.begin_line(end, rules.text);
  const char* cursor = at;
  while (cursor != end && is_blank(*cursor)) ++cursor;
  if (cursor != end && (*cursor == 'N' || *cursor == 'n') && !skip_block_number(cursor, end)) {
    return false;
  }
  if (!read_words(cursor, end, rules.surroundings, words, values) ||
      cursor - at > static_cast<std::ptrdiff_t>(limits::block_bytes))
    return false;
  skip_line_end(cursor, end);
  if (rules.text.code_system != CodeSystem::b && !translate_codes(words.g, rules.text.code_system))
    return false;
  at = cursor;
  return true;
}

bool is_plain_block(const BlockWords& words, const ChannelWords* channel,
                    const ChannelDialect& dialect) {
  if (macro_of(words, dialect) || (words.letters & dialect.alias_letters()) != 0) return false;
  for (const CodeNumber number : words.g) {
    const Code* const code = find_code('G', number);
    if (code == nullptr || code->action == CodeAction::unsupported) return false;
  }
  for (const CodeNumber number : words.m) {
    const Code* const code = find_code('M', number);
    if (code == nullptr || code->action == CodeAction::unsupported || changes_program_flow(*code))
      return false;
  }
  return !dwells_suspiciously_long(words) && !check_block(words, channel, dialect);
}

}  // namespace stanok::lang
