#include "lang/feed_law/feed_law_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stanok::lang {
namespace {

LawAddressSet must_of(const LawForm& form) {
  LawAddressSet set = 0;
  for (const LawAddress address : form.must()) set |= address_bit(address);
  return set;
}

// What lies between the words and a form.
struct Difference {
  LawAddressSet missing = 0;
  LawAddressSet excess = 0;

  [[nodiscard]] int count(LawAddressSet set) const {
    int bits = 0;
    for (; set != 0; set = static_cast<LawAddressSet>(set & (set - 1))) ++bits;
    return bits;
  }
  [[nodiscard]] bool none() const { return missing == 0 && excess == 0; }
  // Of two forms as far away the one that lacks something is meant rather than one in which
  // something is too many.
  [[nodiscard]] int distance() const { return 8 * count(missing) + 9 * count(excess); }
};

Difference difference(const LawForm& form, LawAddressSet set) {
  const LawAddressSet must = must_of(form);
  return {static_cast<LawAddressSet>(must & ~set),
          static_cast<LawAddressSet>(set & ~(must | form.may))};
}

LawAddress first_of(LawAddressSet set) {
  unsigned address = 0;
  while ((set >> address & 1U) == 0) ++address;
  return static_cast<LawAddress>(address);
}

// The law that `address` makes one think of: the first that has it in a form.
const LawForm& form_with(LawAddress address) {
  return *std::ranges::find_if(law_forms(), [address](const LawForm& form) {
    return ((must_of(form) | form.may) & address_bit(address)) != 0;
  });
}

bool takes_address(std::string_view law, LawAddress address) {
  return std::ranges::any_of(law_forms(), [&](const LawForm& form) {
    return form.law == law && ((must_of(form) | form.may) & address_bit(address)) != 0;
  });
}

std::string law_title(std::string_view law) {
  return "the " + std::string(law) + " law";
}

std::string remedy(std::string_view law) {
  return law_title(law) + " is written " + forms_text(law);
}

// The first of the words that are there and right names the law, with its value.
BlockFault missing_address(const LawForm& form, const LawWords& words, LawAddress missing) {
  const LawAddress present = first_of(static_cast<LawAddressSet>(
      (words.set & must_of(form)) != 0 ? words.set & must_of(form) : words.set));
  const std::string name = "`" + std::string(name_of(missing)) + "`";
  BlockFault fault = fault_at(
      "E4330", word_name(present),
      law_title(form.law) + " with " + word_text(words, present) + " needs " + name + ", too",
      "no " + name);
  fault.help.push_back(remedy(form.law));
  return fault;
}

BlockFault excess_address(const LawForm& form, const LawWords& words, LawAddress excess) {
  if (takes_address(form.law, excess)) {
    BlockFault fault = fault_at(
        "E4331", word_name(excess),
        word_text(words, excess) + " is one too many for " + law_title(form.law), "leave out");
    fault.help.push_back(remedy(form.law));
    return fault;
  }
  const std::string_view other = form_with(excess).law;
  BlockFault fault = fault_at("E4332", word_name(excess),
                              word_text(words, excess) + " belongs to " + law_title(other) +
                                  ", the other words to " + law_title(form.law),
                              "of another law");
  fault.help.push_back(remedy(form.law));
  fault.help.push_back(remedy(other));
  return fault;
}

}  // namespace

LawWords law_words_of(const BlockWords& words) {
  LawWords law;
  for (const NamedWord& word : words.named) {
    const auto address = find_law_address(word.name);
    if (!address) continue;
    law.set |= address_bit(*address);
    law.values[*address] = word.value;
  }
  return law;
}

std::string forms_text(std::string_view law) {
  std::string text;
  for (const LawForm& form : law_forms()) {
    if (form.law != law) continue;
    text += text.empty() ? "`" : " or `";
    for (const LawAddress address : form.must()) {
      text += std::string(name_of(address)) + (address == form.must().back() ? "`" : " ");
    }
  }
  return text;
}

Expected<const LawForm*, BlockFault> form_of(const LawWords& words) {
  const auto distance = [&](const LawForm& form) { return difference(form, words.set).distance(); };
  const LawForm& nearest = *std::ranges::min_element(
      law_forms(), [&](const LawForm& a, const LawForm& b) { return distance(a) < distance(b); });
  const Difference gap = difference(nearest, words.set);
  if (gap.none()) return &nearest;
  if (gap.excess != 0) {
    return Unexpected<BlockFault>(excess_address(nearest, words, first_of(gap.excess)));
  }
  return Unexpected<BlockFault>(missing_address(nearest, words, first_of(gap.missing)));
}

WordName word_name(LawAddress address) {
  return {0, -1, std::string(name_of(address))};
}

std::string law_number_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

std::string word_text(const LawWords& words, LawAddress address) {
  std::string text = "`" + std::string(name_of(address)) + "`";
  const double value = words.value(address);
  if (words.has(address) && !std::isnan(value)) text += " = " + law_number_text(value);
  return text;
}

}  // namespace stanok::lang
