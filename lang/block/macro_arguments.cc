#include "lang/block/macro_arguments.h"

#include <array>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

// By letter from A; 0: none.
constexpr std::array<int, 26> parameter_of_letter = {
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

}  // namespace

int parameter_of_argument(char letter) {
  return parameter_of_letter[static_cast<std::size_t>(letter_index(letter))];
}

std::optional<BlockFault> check_macro_block(const BlockWords& words, const MacroCode& macro) {
  const std::string name = code_text(macro.letter, macro.number);
  const bool call = macro.user_code == nullptr;
  const int m_codes = words.m.count - (macro.letter == 'M' ? 1 : 0);
  const int g_codes = words.g.count - (macro.letter == 'G' ? 1 : 0);
  if (g_codes > 0 || m_codes > (call ? 1 : 0)) {
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
  if (call && !words.has('P')) {
    return BlockFault{"E4007", {'G', g(65), {}}, "`G65` needs the number of a program", "no P", {},
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
    arguments.values[static_cast<std::size_t>(letter_index('M'))] = words.m.numbers[0] / 10.0;
  }
  arguments.g.count = 0;
  arguments.m.count = 0;
  return arguments;
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
