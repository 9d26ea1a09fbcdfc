#include "lang/contract/active_codes.h"

#include <algorithm>
#include <utility>

#include "lang/block/modal_state.h"

namespace stanok::lang {

ActiveCodes default_codes(ChannelKind kind) {
  return default_modal_state(kind).codes;
}

std::vector<std::string> names_of(const ActiveCodes& codes, char letter) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const auto group = static_cast<Group>(k);
    const bool is_shown = letter_of(group) == letter && (letter == 'G' || codes[k] != 0);
    if (!is_shown) continue;
    std::string name = code_text(letter, codes[k]);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  }
  const auto coolant = std::find(names.begin(), names.end(), "M9");
  const bool has_coolant = std::find(names.begin(), names.end(), "M7") != names.end() ||
                           std::find(names.begin(), names.end(), "M8") != names.end();
  if (coolant != names.end() && has_coolant) names.erase(coolant);
  return names;
}

void CodeChanges::note(std::uint64_t block, const ActiveCodes& codes) {
  if (codes == newest_) return;
  newest_ = codes;
  if (!changes_.empty() && changes_.back().block == block) {
    changes_.back().codes = codes;
    return;
  }
  if (changes_.size() == kept_max) changes_.erase(changes_.begin());
  changes_.push_back({block, codes});
}

std::vector<CodeChange> CodeChanges::take() {
  return std::exchange(changes_, {});
}

}  // namespace stanok::lang
