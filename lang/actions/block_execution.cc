#include "lang/actions/block_execution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/actions/actions.h"
#include "lang/block/macro_arguments.h"
#include "lang/block/other_controls.h"
#include "lang/feed_law/feed_law_words.h"
#include "lang/text/number.h"
#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr LetterSet always_allowed = letters_of("FST");
constexpr LetterSet arc_words = letters_of("IJKR");

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

char first_letter(LetterSet set) {
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((set & letter_bit(letter)) != 0) return letter;
  }
  return 0;
}

// The word that holds the time of G4. X and U are axis words elsewhere, F and S feed and speed:
// they are G4's only when nothing else in the block can want them.
char dwell_word(const BlockWords& words, const BlockCodes& codes) {
  if (!words.g.has(40)) return 0;
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

std::optional<BlockFault> missing_axes(const BlockCodes& codes, bool any_axis_word) {
  const Code* const user = codes.axis_user;
  if (user == nullptr || user->axes != AxisWords::required || any_axis_word) return std::nullopt;
  return fault_at("E4007", {user->letter, user->number, {}},
                  "`" + code_text(user->letter, user->number) + "` needs an axis word", "");
}

// Whether a named word may be one of an axis.
bool any_named_axis(const BlockWords& words) {
  return std::any_of(words.named.begin(), words.named.end(),
                     [](const NamedWord& word) { return !is_law_address(word.name); });
}

// Units and diameter mode set in a block hold for its own words too.
void apply_units(ActiveBlock& block, const BlockCodes& codes) {
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  if (!lathe && block.words.g.has(700)) block.set_modal(Group::units, 200);
  if (!lathe && block.words.g.has(710)) block.set_modal(Group::units, 210);
  for (int i = 0; i < codes.count; ++i) {
    const Code& row = *codes.rows[static_cast<std::size_t>(i)];
    const bool early = row.group == Group::units || row.group == Group::diameter;
    if (early && block.modal.code(row.group) != row.number) block.set_modal(row.group, row.number);
  }
}

// The motion code of a block that has one.
const Code& motion_row(const BlockCodes& codes) {
  std::size_t i = 0;
  while (codes.rows[i]->group != Group::motion) ++i;
  return *codes.rows[i];
}

// The modally active motion takes the axis words that no code of the block claims.
void add_modal_motion(ActiveBlock& block, BlockCodes& codes, LetterSet free_words) {
  if (codes.axis_user != nullptr) return;
  if (codes.has(Group::motion) && block.programmed != 0) {
    const Code& row = motion_row(codes);
    block.fail("E4012", {row.letter, row.number, {}},
               "`" + code_text(row.letter, row.number) + "` takes no axis words", "");
    return;
  }
  const CodeNumber number = block.modal.code(Group::motion);
  const bool arc = number == 20 || number == 30;
  const bool moves = block.programmed != 0 || (arc && (free_words & arc_words) != 0);
  if (!moves) return;
  const Code* const motion = find_code('G', number);
  if (motion->axes == AxisWords::unused) {
    BlockFault& fault =
        block.fail("E4012", {}, "axis words without a motion code", "no motion is active");
    fault.notes.push_back(block.modal.origin_of(Group::motion));
    return;
  }
  codes.rows[static_cast<std::size_t>(codes.count++)] = motion;
  codes.words |= motion->words;
  codes.axis_user = motion;
}

// Increments are ways to go: other codes than motions have no use for them.
void check_incremental_words(ActiveBlock& block, const BlockCodes& codes) {
  if (block.incremental == 0 || codes.axis_user == nullptr) return;
  const Code& user = *codes.axis_user;
  const bool moves = user.phase == Phase::motion || user.action == go_to_reference_point;
  if (moves) return;
  const char letter = first_letter(block.words.letters & block.channel_words.incremental_letters());
  block.fail("E4302", {letter, -1, {}},
             "`" + code_text('G', user.number) + "` cannot take the increment `" + letter + "`",
             "not here");
}

// Between G5.2 and G5.3 there are control points, nothing else.
void check_open_curve(ActiveBlock& block, const BlockCodes& codes) {
  if (!block.modal.curve.open()) return;
  for (int i = 0; i < codes.count; ++i) {
    const Code& row = *codes.rows[static_cast<std::size_t>(i)];
    if (row.action == collect_nurbs_point || row.action == end_nurbs) continue;
    BlockFault& fault =
        block.fail("E4312", {row.letter, row.number, {}},
                   "`" + code_text(row.letter, row.number) + "` inside a NURBS curve",
                   "the curve is not ended");
    fault.notes.push_back(block.modal.origin_of(Group::motion));
    fault.help.emplace_back("end the curve with `G5.3` before");
    return;
  }
}

// A word has one meaning: two codes that use the same letter need a block each. F, S and T are not
// in question, nor are axis words; functions of the machine builder share P and Q.
void check_shared_words(ActiveBlock& block, const BlockCodes& codes) {
  LetterSet taken = 0;
  for (int i = 0; i < codes.count; ++i) {
    const Code& row = *codes.rows[static_cast<std::size_t>(i)];
    if (row.action == send_machine_function) continue;
    const LetterSet wanted = row.words & block.words.letters & ~always_allowed;
    if (const LetterSet both = taken & wanted; both != 0) {
      const char letter = first_letter(both);
      block
          .fail("E4015", {letter, -1, {}},
                std::string("`") + letter + "` would be taken by two codes of the block",
                "meant for which?")
          .help.push_back("program `" + code_text(row.letter, row.number) +
                          "` in a block of its own");
      return;
    }
    taken |= wanted;
  }
}

void check_unused(ActiveBlock& block, const BlockCodes& codes) {
  LetterSet allowed = codes.words | always_allowed | block.channel_words.letters() |
                      block.channel_words.incremental_letters();
  if (block.dwell_word != 0) allowed |= letter_bit(block.dwell_word);
  const LetterSet unused = block.words.letters & ~allowed;
  if (unused != 0) {
    const BlockFault fault = unused_word(unused, &block.channel);
    block.fail(fault.code, fault.word, fault.message, fault.label).notes = fault.notes;
    return;
  }
  const bool turns_spindle = block.has('S') || names_spindle(codes);
  if (block.words.spindle_named && !turns_spindle) {
    block.fail("E4003", {}, "nothing in this block uses the spindle after `$`", "unused word");
  }
  for (const NamedWord& word : block.words.named) {
    if (block.channel_words.axis_called(word.name) >= 0) continue;
    if (spindle_of_indexed_speed(word) || is_word_of_spindle_axis(codes, word)) continue;
    if (is_law_address(word.name)) continue;
    block.fail("E4003", {0, -1, word.name}, "nothing in this block uses `" + word.name + "`",
               "unused word");
  }
}

// In the order of their phases; codes of one phase stay as written.
void sort_by_phase(BlockCodes& codes) {
  const auto first = codes.rows.begin();
  for (auto next = first; next != first + codes.count; ++next) {
    const auto later = std::upper_bound(
        first, next, *next, [](const Code* a, const Code* b) { return a->phase < b->phase; });
    std::rotate(later, next, next + 1);
  }
}

void run_actions(ActiveBlock& block, BlockCodes& codes) {
  sort_by_phase(codes);
  for (int i = block.actions_done; i < codes.count && !block.failed(); ++i) {
    const Code& row = *codes.rows[static_cast<std::size_t>(i)];
    row.action(block, row.number);
    const bool kept = (group_bit(row.group) & block.kept_groups) != 0;
    if (row.group != Group::none && !kept && block.modal.code(row.group) != row.number) {
      block.set_modal(row.group, row.number);
    }
    block.actions_done = i + 1;
    if (block.awaits_position && block.actions_done < codes.count) return;
  }
  block.awaits_position = false;
}

}  // namespace

BlockFault& ActiveBlock::fail(std::string_view code, WordName word, std::string message,
                              std::string label) {
  if (!fault) fault = fault_at(code, std::move(word), std::move(message), std::move(label));
  return *fault;
}

std::optional<int> ActiveBlock::integer(char letter, int smallest, int largest) {
  const double number = value(letter);
  if (is_integer(number) && number >= smallest - 0.5 && number <= largest + 0.5) {
    return static_cast<int>(std::lround(number));
  }
  fail("E4008", {letter, -1, {}},
       std::string("`") + letter + "` must be a whole number from " + std::to_string(smallest) +
           " to " + std::to_string(largest),
       "out of range");
  return std::nullopt;
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
  LetterSet allowed = codes.words | always_allowed | dwell_set | axes;
  if (!codes.has(Group::motion)) allowed |= words_of_all_motions();
  const LetterSet unused = words.letters & ~allowed;
  if (unused != 0) return unused_word(unused, channel);
  bool any_axis_word = (words.letters & axes & ~dwell_set) != 0;
  if (!words.named.empty()) {
    any_axis_word = any_axis_word || any_named_axis(words);
    if (auto fault = check_feed_law(words, codes, any_axis_word)) return fault;
  }
  return missing_axes(codes, any_axis_word);
}

bool dwells_suspiciously_long(const BlockWords& words) {
  const auto looks_like_milliseconds = [&](char letter) {
    return words.has(letter) && words.value(letter) >= 100.0 &&
           (words.whole & letter_bit(letter)) != 0;
  };
  constexpr std::array<CodeNumber, 6> dwelling_cycles{740, 820, 840, 860, 880, 890};
  if (words.g.has(40)) {
    return looks_like_milliseconds(words.has('P') ? 'P' : words.has('X') ? 'X' : 'U');
  }
  const bool cycle = std::any_of(dwelling_cycles.begin(), dwelling_cycles.end(),
                                 [&](CodeNumber code) { return words.g.has(code); });
  return cycle && looks_like_milliseconds('P');
}

void execute_block(ActiveBlock& block) {
  BlockCodes codes;
  if (auto fault =
          resolve_codes(block.words, &block.channel.kind, block.channel_words.dialect(), codes)) {
    block.fault = std::move(fault);
    return;
  }
  if (auto fault = check_master(block.words, block.channel)) {
    block.fault = std::move(fault);
    return;
  }
  block.dwell_word = dwell_word(block.words, codes);
  refuse_while_compensated(block, codes);
  if (block.failed()) return;
  apply_units(block, codes);
  collect_axis_words(block);
  collect_incremental_words(block, codes);
  refuse_axes_that_are_spindles(block);
  if (block.failed()) return;
  if (auto fault = missing_axes(codes, block.programmed != 0)) {
    block.fault = std::move(fault);
    return;
  }
  if (auto fault = other_meaning(
          {block.words, codes, block.channel.kind, block.programmed != 0, &block.modal})) {
    block.fault = std::move(fault);
    return;
  }
  add_modal_motion(block, codes, block.words.letters & ~codes.words);
  if (block.failed()) return;
  if (auto fault = check_feed_law(block.words, codes, block.programmed != 0)) {
    block.fault = std::move(fault);
    return;
  }
  check_unused(block, codes);
  check_shared_words(block, codes);
  check_incremental_words(block, codes);
  check_open_curve(block, codes);
  if (block.failed()) return;
  add_feed_speed_tool(block, codes);
  run_actions(block, codes);
}

bool execute_simple_move(ActiveBlock& block, Move& move) {
  const BlockWords& words = block.words;
  CodeNumber motion = block.modal.code(Group::motion);
  if (words.m.count != 0 || words.g.count > 1) return false;
  if (motion == 52) return false;  // inside a NURBS curve
  if (words.g.count == 1) motion = words.g.numbers[0];
  if (motion != 0 && motion != 10) return false;
  const LetterSet axes = words.letters & block.channel_words.letters();
  if (axes == 0 || (words.letters & ~(axes | letter_bit('F'))) != 0) return false;
  if (words.has('F')) {
    if (words.value('F') <= 0.0 || block.modal.feed_law.kind != FeedLaw::Kind::off) return false;
    set_feed(block);
  } else if (motion == 10 && (!block.modal.feed_known || block.modal.feed_programmed <= 0.0)) {
    return false;
  }
  collect_axis_words(block);
  refuse_axes_that_are_spindles(block);
  if (block.failed()) return false;
  move = {};
  move.kind = motion == 0 ? MoveKind::rapid : MoveKind::line;
  resolve_ends(block, move);
  resolve_modal_feed(block, move);
  if (block.failed()) return false;
  advance_position(block, move);
  if (block.modal.code(Group::motion) != motion) block.set_modal(Group::motion, motion);
  return true;
}

}  // namespace stanok::lang
