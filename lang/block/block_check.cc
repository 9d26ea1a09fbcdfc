#include "lang/block/block_check.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/block/feed_law_rules.h"
#include "lang/block/macro_arguments.h"
#include "lang/block/other_controls.h"
#include "lang/words/corner_word.h"
#include "lang/words/law_address.h"
#include "lang/words/named_address.h"

namespace stanok::lang {
namespace {

// All words that a motion code may use, whichever is modally active.
LetterSet words_of_all_motions() {
  static const LetterSet words = [] {
    LetterSet all = 0;
    for (const Code& code : code_table()) {
      if (code.group == Group::motion) all |= code.words;
    }
    return all;
  }();
  return words;
}

// Whether a named word may be one of an axis.
bool any_named_axis(const BlockWords& words) {
  return std::any_of(words.named.begin(), words.named.end(), [](const NamedWord& word) {
    return !is_law_address(word.name) && !is_corner_word(word.name);
  });
}

}  // namespace

char first_letter(LetterSet set) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((set & letter_bit(letter)) != 0) return letter;
  }
  return 0;
}

char dwell_word(const BlockWords& words, const BlockCodes& codes) {
  if (!words.g.has(g(4))) return 0;
  if (words.has('P')) return 'P';
  if (codes.axis_user != nullptr) return 0;
  for (const char letter : {'X', 'U', 'F', 'S'}) {
    if (words.has(letter)) return letter;
  }
  return 0;
}

BlockFault unused_word(LetterSet unused, const ChannelDescription* channel) {
  const char letter = first_letter(unused);
  const std::string name(1, letter);
  if (channel != nullptr && (letter_bit(letter) & customary_axis_letters) != 0) {
    if (channel->kind == ChannelKind::master) {
      return fault_at("E4010", {letter, -1, {}}, "axis word `" + name + "` on a master channel",
                      "a master channel has no axes");
    }
    BlockFault fault =
        fault_at("E4010", {letter, -1, {}}, "this channel has no axis `" + name + "`",
                 "not an axis of channel " + std::to_string(channel->id));
    std::string axes;
    for (const AxisDescription& axis : channel->axes) axes += (axes.empty() ? "" : " ") + axis.word;
    fault.notes.push_back({"axes of the channel: " + axes, {}});
    return fault;
  }
  return fault_at("E4003", {letter, -1, {}}, "nothing in this block uses `" + name + "`",
                  "unused word");
}

std::optional<BlockFault> check_master(const BlockWords& words, const ChannelDescription& channel) {
  if (channel.kind != ChannelKind::master) return std::nullopt;
  for (const char letter : {'S', 'T'}) {
    if (!words.has(letter)) continue;
    return fault_at("E4009", {letter, -1, {}}, std::string("`") + letter + "` on a master channel",
                    "a master channel has no axes and no spindle");
  }
  for (const NamedWord& word : words.named) {
    if (!spindle_of_indexed_speed(word) && !is_law_address(word.name)) continue;
    return fault_at("E4009", {0, -1, word.name}, "`" + word.name + "` on a master channel",
                    "a master channel has no axes and no spindle");
  }
  return std::nullopt;
}

std::optional<BlockFault> missing_axes(const BlockCodes& codes, AxisWordCount count) {
  const Code* const user = codes.axis_user;
  if (user == nullptr || user->axes != AxisWords::required || count == AxisWordCount::some)
    return std::nullopt;
  return fault_at("E4007", {user->letter, user->number, {}},
                  "`" + code_text(user->letter, user->number) + "` needs an axis word", "");
}

LetterSet plain_corners_of(const BlockWords& words, const BlockCodes& codes,
                           const ChannelDescription& channel) {
  const Code* const motion = motion_of(codes);
  const bool may_be_line = motion == nullptr || motion->number == g(1);
  if (channel.kind != ChannelKind::lathe || !may_be_line) return 0;
  if (words.rules.is_linuxcnc()) return rounding_letter_of_linuxcnc;
  // Lathes of Haas have them always (lathe operator's manual, "Corner rounding and chamfering").
  const bool has_them = channel.plain_corners || words.rules.is_haas();
  return has_them && words.rules.is_fanuc() ? plain_corner_letters | square_chamfer_letters : 0;
}

std::optional<BlockFault> check_block(const BlockWords& words, const ChannelWords* channel_words,
                                      const ChannelDialect& dialect) {
  if (const auto macro = macro_of(words, dialect)) return check_macro_block(words, *macro);
  BlockCodes codes;
  const ChannelDescription* const channel = channel_words ? &channel_words->channel() : nullptr;
  const ChannelKind* const kind = channel ? &channel->kind : nullptr;
  if (auto fault = resolve_codes(words, kind, dialect, codes)) return fault;
  // Which words a code uses that is computed at run time cannot be known here.
  const auto later = [](CodeNumber number) { return number == code_computed_later; };
  if (std::any_of(words.g.begin(), words.g.end(), later)) return std::nullopt;
  if (std::any_of(words.m.begin(), words.m.end(), later)) return std::nullopt;
  const char dwell = dwell_word(words, codes);
  const LetterSet dwell_set = dwell == 0 ? 0 : letter_bit(dwell);
  LetterSet axes = customary_axis_letters;
  if (channel != nullptr) {
    if (auto fault = check_master(words, *channel)) return fault;
    axes = channel_words->letters() | channel_words->incremental_letters();
    const bool has_axis_words = (words.letters & axes & ~dwell_set) != 0 || any_named_axis(words);
    if (auto fault = other_meaning({words, codes, channel->kind, has_axis_words})) return fault;
  }
  LetterSet allowed = codes.words | allowed_everywhere(words.rules) | dwell_set | axes;
  if (!codes.has(Group::motion)) allowed |= words_of_all_motions();
  if (words.rules.is_fanuc() && !codes.has(Group::length)) allowed |= letters_of("H");
  if (channel != nullptr) allowed |= plain_corners_of(words, codes, *channel);
  const LetterSet unused = words.letters & ~allowed;
  if (unused != 0) return unused_word(unused, channel);
  const bool any_axis_word =
      (words.letters & axes & ~dwell_set) != 0 || (!words.named.empty() && any_named_axis(words));
  const AxisWordCount count = any_axis_word ? AxisWordCount::some : AxisWordCount::none;
  if (!words.named.empty()) {
    if (auto fault = check_feed_law(words, codes, count)) return fault;
  }
  return missing_axes(codes, count);
}

bool dwells_suspiciously_long(const BlockWords& words) {
  if (words.rules.is_fanuc()) return false;
  const auto looks_like_milliseconds = [&](char letter) {
    return words.has(letter) && words.value(letter) >= 100.0 &&
           (words.whole & letter_bit(letter)) != 0;
  };
  constexpr std::array<CodeNumber, 6> dwelling_cycles{g(74), g(82), g(84), g(86), g(88), g(89)};
  if (words.g.has(g(4))) {
    return looks_like_milliseconds(words.has('P') ? 'P' : words.has('X') ? 'X' : 'U');
  }
  const bool cycle = std::any_of(dwelling_cycles.begin(), dwelling_cycles.end(),
                                 [&](CodeNumber code) { return words.g.has(code); });
  return cycle && looks_like_milliseconds('P');
}

}  // namespace stanok::lang
