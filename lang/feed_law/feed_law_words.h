// The addresses of feed laws, and which of them make a law together.
//
// Every law has its forms (law_type.h): the addresses it must have and those it may have. What fits
// no row is answered with the address that is missing or too many. Source of the laws and their
// addresses: docs/programmer/feed-laws.md; how programs state them:
// docs/reference/language.md#feed-laws.
#pragma once

#include <string>
#include <string_view>

#include "base/expected.h"
#include "lang/feed_law/law_types.h"
#include "lang/words/block_fault.h"
#include "lang/words/block_words.h"
#include "lang/words/law_address.h"

namespace stanok::lang {

// The words of a law in a block, with their values as programmed; a value that is computed later is
// not a number.
struct LawWords {
  LawAddressSet set = 0;
  LawAddressArray<double> values{};

  [[nodiscard]] bool empty() const { return set == 0; }
  [[nodiscard]] bool has(LawAddress address) const {
    return (set >> static_cast<unsigned>(address) & 1U) != 0;
  }
  [[nodiscard]] double value(LawAddress address) const { return values[address]; }
};
[[nodiscard]] LawWords law_words_of(const BlockWords& words);

// "`S_n dS dl` or `S_n S_k dS`": the forms of the law.
[[nodiscard]] std::string forms_text(std::string_view law);

// The form that the words fill, or why they fill none.
[[nodiscard]] Expected<const LawForm*, BlockFault> form_of(const LawWords& words);

// "`S_n` = 60", or the name alone when the value is not known.
[[nodiscard]] std::string word_text(const LawWords& words, LawAddress address);
[[nodiscard]] WordName word_name(LawAddress address);
// A number as messages show it.
[[nodiscard]] std::string law_number_text(double number);

}  // namespace stanok::lang
