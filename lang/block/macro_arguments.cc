#include "lang/block/macro_arguments.h"

#include <algorithm>
#include <array>

#include "lang/text/source.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {
namespace {

// 0: none.
constexpr LetterArray<int> parameter_of_letter = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                  0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

}  // namespace

int parameter_of_argument(char letter) {
  return parameter_of_letter[letter];
}

std::optional<BlockFault> check_macro_block(const BlockWords& words, const MacroCode& macro) {
  const std::string name = code_text(macro.letter, macro.number);
  const bool call = macro.user_code == nullptr;
  const std::size_t g_codes_max = macro.letter == 'G' ? 1 : 0;
  const std::size_t m_codes_max = (macro.letter == 'M' ? 1 : 0) + (call ? 1 : 0);
  if (words.g.count > g_codes_max || words.m.count > m_codes_max) {
    return BlockFault{"E4013",
                      {macro.letter, macro.number, {}},
                      "`" + name + "` and another code in one block",
                      "takes all words of its block as arguments",
                      {},
                      {}};
  }
  if (words.spindle_named) {
    return BlockFault{"E4003",       {}, "nothing in this block uses the spindle after `$`",
                      "unused word", {}, {}};
  }
  const auto corner = std::ranges::find_if(
      words.named, [](const NamedWord& word) { return is_corner_word(word.name); });
  if (corner != words.named.end()) {
    return fault_at("E4003", {0, -1, corner->name}, "a call does not use `" + corner->name + "`",
                    "unused word");
  }
  if (call && !words.has('P')) {
    return BlockFault{"E4007",
                      WordName{macro.letter, macro.number, {}},
                      "`" + name + "` needs P, a program number",
                      "no P",
                      {},
                      {}};
  }
  return std::nullopt;
}

BlockWords arguments_of(const BlockWords& words, const MacroCode& macro) {
  BlockWords arguments = words;
  const bool call = macro.user_code == nullptr;
  if (call) arguments.letters &= ~letters_of("LP");
  if (call && words.m.count == 1) {
    arguments.letters |= letter_bit('M');
    arguments.values['M'] = words.m.numbers[0] / 10.0;
  }
  arguments.g.count = 0;
  arguments.m.count = 0;
  return arguments;
}

int parameter_of_repeated(std::string_view name) {
  const bool repeated = name.size() >= 2 && name[0] >= 'I' && name[0] <= 'K' && is_digit(name[1]);
  if (!repeated) return 0;
  int set = 0;
  for (const char digit : name.substr(1)) set = 10 * set + (is_digit(digit) ? digit - '0' : 0);
  constexpr int first = 4;  // of I, then J and K
  const int number = first + 3 * (set - 1) + (name[0] - 'I');
  return number <= 33 ? number : 0;
}

std::optional<double> find_argument(const BlockWords& arguments, std::string_view name) {
  if (name.size() == 1 && is_letter(name[0])) {
    const char letter = upper_case(name[0]);
    return arguments.has(letter) ? std::optional(arguments.value(letter)) : std::nullopt;
  }
  for (const NamedWord& word : arguments.named) {
    if (folded(word.name) == folded(name)) return word.value;
  }
  return std::nullopt;
}

}  // namespace stanok::lang
