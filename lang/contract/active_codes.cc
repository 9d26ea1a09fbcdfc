#include "lang/contract/active_codes.h"

#include <algorithm>
#include <utility>

namespace stanok::lang {

ActiveCodes default_codes(ChannelKind kind) {
  const bool lathe = kind == ChannelKind::lathe;
  ActiveCodes codes{};
  const auto set = [&codes](Group group, CodeNumber number) {
    codes[static_cast<std::size_t>(group)] = number;
  };
  set(Group::motion, 0);
  set(Group::plane, lathe || kind == ChannelKind::grind ? 180 : 170);
  set(Group::distance, 900);
  set(Group::arc_distance, 911);
  set(Group::feed_mode, lathe ? 950 : 940);
  set(Group::units, 210);
  set(Group::radius_compensation, 400);
  set(Group::length, 490);
  set(Group::transformation, 131);
  set(Group::return_level, 980);
  set(Group::scaling, 500);
  set(Group::mirror, 501);
  set(Group::work_offset, 540);
  set(Group::path_mode, 640);
  set(Group::spindle_mode, 970);
  set(Group::diameter, lathe ? 70 : 80);
  set(Group::rotation, 690);
  set(Group::polar, 150);
  set(Group::spindle, 50);
  set(Group::mist, 90);
  set(Group::flood, 90);
  set(Group::override_control, 480);
  return codes;
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
