#include "lang/feed_law/feed_law_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stanok::lang {
namespace {

using enum LawAddress;
using Kind = FeedLaw::Kind;
using Speed = FeedLaw::Speed;

constexpr LawAddressSet bit(LawAddress address) {
  return static_cast<LawAddressSet>(1U << static_cast<unsigned>(address));
}

struct Must {
  std::array<LawAddress, 5> addresses{};
  std::size_t count = 0;
};
template <class... Addresses>
constexpr Must must(Addresses... addresses) {
  return {{addresses...}, sizeof...(addresses)};
}

constexpr LawForm form(std::string_view law, std::string_view directive, Kind kind, Speed speed,
                       const Must& must, LawAddressSet may = 0) {
  return {law, directive, kind, speed, must.addresses, must.count, may};
}

// Columns: law, word of #feedlaw, kind, speed, addresses it must have and may have. The forms of a
// law follow each other. With S_k, dl follows from the length of the block; S_k beside dl ends the
// steps.
constexpr auto forms = std::to_array<LawForm>({
    form("linear", "linear", Kind::linear, Speed::unchanged, must(feed_first, feed_step, way_step),
         bit(feed_last)),
    form("linear", "", Kind::linear, Speed::unchanged, must(feed_first, feed_last, feed_step)),
    form("modulated", "modulated", Kind::modulated, Speed::unchanged,
         must(feed_min, feed_step, way_step, steps)),
    form("modulated", "", Kind::modulated, Speed::unchanged,
         must(feed_min, feed_max, feed_step, way_step)),
    form("interrupted", "interrupt", Kind::interrupted, Speed::unchanged, must(stand, cut)),
    form("spindle speed", "speed", Kind::linear, Speed::rev_per_min,
         must(speed_first, speed_step, feed_first, feed_step, way_step)),
    form("spindle speed", "", Kind::linear, Speed::rev_per_min,
         must(speed_first, speed_last, feed_first, feed_last, feed_step), bit(way_step)),
    form("cutting speed", "cutting_speed", Kind::linear, Speed::m_per_min,
         must(cutting_first, cutting_step, feed_first, feed_step, way_step)),
    form("cutting speed", "", Kind::linear, Speed::m_per_min,
         must(cutting_first, cutting_last, feed_first, feed_last, feed_step), bit(way_step)),
});

LawAddressSet must_of(const LawForm& form) {
  LawAddressSet set = 0;
  for (const LawAddress address : form.must()) set |= bit(address);
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
  return *std::find_if(forms.begin(), forms.end(), [address](const LawForm& form) {
    return ((must_of(form) | form.may) & bit(address)) != 0;
  });
}

bool belongs_to(std::string_view law, LawAddress address) {
  return std::any_of(forms.begin(), forms.end(), [&](const LawForm& form) {
    return form.law == law && ((must_of(form) | form.may) & bit(address)) != 0;
  });
}

std::string title(std::string_view law) {
  return "the " + std::string(law) + " law";
}

std::string remedy(std::string_view law) {
  return title(law) + " is written " + forms_text(law);
}

// The first of the words that are there and right names the law, with its value.
BlockFault missing_address(const LawForm& form, const LawWords& words, LawAddress missing) {
  const LawAddress present = first_of(static_cast<LawAddressSet>(
      (words.set & must_of(form)) != 0 ? words.set & must_of(form) : words.set));
  const std::string name = "`" + std::string(name_of(missing)) + "`";
  BlockFault fault =
      fault_at("E4330", word_name(present),
               title(form.law) + " with " + word_text(words, present) + " needs " + name + ", too",
               "no " + name);
  fault.help.push_back(remedy(form.law));
  return fault;
}

BlockFault excess_address(const LawForm& form, const LawWords& words, LawAddress excess) {
  if (belongs_to(form.law, excess)) {
    BlockFault fault =
        fault_at("E4331", word_name(excess),
                 word_text(words, excess) + " is one too many for " + title(form.law), "leave out");
    fault.help.push_back(remedy(form.law));
    return fault;
  }
  const std::string_view other = form_with(excess).law;
  BlockFault fault = fault_at("E4332", word_name(excess),
                              word_text(words, excess) + " belongs to " + title(other) +
                                  ", the other words to " + title(form.law),
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
    law.set |= bit(*address);
    law.values[*address] = word.value;
  }
  return law;
}

std::span<const LawForm> law_forms() {
  return forms;
}

std::string forms_text(std::string_view law) {
  std::string text;
  for (const LawForm& form : forms) {
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
  const LawForm& nearest = *std::min_element(
      forms.begin(), forms.end(),
      [&](const LawForm& a, const LawForm& b) { return distance(a) < distance(b); });
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
