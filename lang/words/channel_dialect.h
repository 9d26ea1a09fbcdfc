// What the machine file adds to the language of a channel: codes of its own and letters for named
// addresses. It holds for every text the channel executes, included files too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "lang/contract/environment.h"
#include "lang/words/code_table.h"

namespace stanok::lang {

class ChannelDialect {
 public:
  // `channel` nullptr: nothing is added.
  explicit ChannelDialect(const ChannelDescription* channel);

  // The macro that a code calls, or nullptr.
  [[nodiscard]] const UserCode* macro(char letter, int number) const;
  // The row of an M code that is an output of the machine, or nullptr.
  [[nodiscard]] const Code* output(char letter, int number) const;
  // The machine file's M code of this number, if it is an output.
  [[nodiscard]] const UserCode* output_code(int number) const;
  // The named address for which a letter stands; empty if none.
  [[nodiscard]] std::string_view alias(char letter) const;
  [[nodiscard]] LetterSet alias_letters() const { return alias_letters_; }

 private:
  std::vector<UserCode> macros_;
  std::vector<UserCode> outputs_;
  std::vector<Code> output_rows_;  // parallel
  std::vector<AddressAlias> aliases_;
  LetterSet alias_letters_ = 0;
};

// The code that takes every other word of its block as an argument: G65 and its like, or a user
// code.
struct MacroCode {
  char letter = 'G';
  int number = g(65);
  const UserCode* user_code = nullptr;  // nullptr: G65, G66, G66.1
};
[[nodiscard]] std::optional<MacroCode> macro_of(const BlockWords& words,
                                                const ChannelDialect& dialect);

// One entry of the machine file: `code` is "G200", "M6", "M120"; `meaning` is a program file,
// "file.nc:function", or for M100 to M899 "before", "after" or "with_motion" (when the output
// stands to the motion of its block), "wait" behind it. The error says what is wrong.
[[nodiscard]] Expected<UserCode, std::string> read_user_code(std::string_view code,
                                                             std::string_view meaning);

// One letter of the machine file for a named address: "E" and "dS", or an axis word of more than
// one character. The error says what is wrong. `axis_words`: how programs of the channel call its
// axes.
[[nodiscard]] Expected<AddressAlias, std::string> read_address_alias(
    std::string_view letter, std::string_view address, ChannelKind kind,
    std::span<const std::string> axis_words);

}  // namespace stanok::lang
