#include "lang/block/feed_law_rules.h"

#include <utility>

#include "lang/feed_law/feed_law_words.h"
#include "lang/words/law_address.h"

namespace stanok::lang {
namespace {

bool takes_feed_law(const Code& code) {
  const bool straight = code.action == CodeAction::move_straight && code.number == g(1);
  return straight || code.action == CodeAction::move_in_arc ||
         code.action == CodeAction::move_in_cubic || code.action == CodeAction::move_in_quadratic;
}

}  // namespace

WordName first_law_word(const BlockWords& words) {
  for (const NamedWord& word : words.named) {
    if (is_law_address(word.name)) return {0, -1, word.name};
  }
  return {};
}

BlockFault law_without_path(const BlockWords& words, const std::string& where, std::string label) {
  BlockFault fault = fault_at("E4333", first_law_word(words), "a feed law is not possible " + where,
                              std::move(label));
  fault.help.emplace_back(
      "program it with G1, G2, G3, G5 or G5.1, or earlier in a block without axis words");
  return fault;
}

std::optional<BlockFault> check_feed_law(const BlockWords& words, const BlockCodes& codes,
                                         AxisWordCount count) {
  if (words.named.empty()) return std::nullopt;
  const LawWords law = law_words_of(words);
  if (law.empty()) return std::nullopt;
  if (auto form = form_of(law); !form) return std::move(form).error();
  const Code* const user = codes.axis_user;
  if (count == AxisWordCount::none || user == nullptr || takes_feed_law(*user)) return std::nullopt;
  const std::string name = "`" + code_text(user->letter, user->number) + "`";
  return law_without_path(words, "in a block of " + name, name + " takes no feed law");
}

bool has_feed_law(const BlockWords& words) {
  return !words.named.empty() && !law_words_of(words).empty();
}

}  // namespace stanok::lang
