#include "lang/contract/active_codes.h"

#include <algorithm>

namespace stanok::lang {

ActiveCodes default_codes(ChannelKind kind) {
  const bool lathe = kind == ChannelKind::lathe;
  ActiveCodes codes{};
  const auto set = [&codes](Group group, CodeNumber number) { codes[group] = number; };
  set(Group::motion, g(0));
  set(Group::plane, lathe || kind == ChannelKind::grind ? g(18) : g(17));
  set(Group::distance, g(90));
  set(Group::arc_distance, g(91, 1));
  set(Group::feed_mode, lathe ? g(95) : g(94));
  set(Group::units, g(21));
  set(Group::radius_compensation, g(40));
  set(Group::length, g(49));
  set(Group::transformation, g(13, 1));
  set(Group::return_level, g(98));
  set(Group::scaling, g(50));
  set(Group::mirror, g(50, 1));
  set(Group::work_offset, g(54));
  set(Group::path_mode, g(64));
  set(Group::spindle_mode, g(97));
  set(Group::diameter, lathe ? g(7) : g(8));
  set(Group::rotation, g(69));
  set(Group::polar, g(15));
  set(Group::spindle, m(5));
  set(Group::mist, m(9));
  set(Group::flood, m(9));
  set(Group::override_control, m(48));
  return codes;
}

std::vector<std::string> names_of(const ActiveCodes& codes, char letter) {
  std::vector<std::string> names;
  for (const Group group : all_groups) {
    const bool is_shown = letter_of(group) == letter && (letter == 'G' || codes[group] != 0);
    if (!is_shown) continue;
    std::string name = code_text(letter, codes[group]);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  }
  const auto coolant = std::find(names.begin(), names.end(), "M9");
  const bool has_coolant = std::find(names.begin(), names.end(), "M7") != names.end() ||
                           std::find(names.begin(), names.end(), "M8") != names.end();
  if (coolant != names.end() && has_coolant) names.erase(coolant);
  return names;
}

}  // namespace stanok::lang
