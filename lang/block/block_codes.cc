#include "lang/block/block_codes.h"

#include <algorithm>

#include "lang/words/dialect_codes.h"
#include "lang/words/unsupported_word.h"

namespace stanok::lang {
namespace {

// Names are written for faults alone: this is done for each code of each block.
std::optional<BlockFault> unavailable(const Code& code, ChannelKind kind) {
  const auto name = [&code] { return code_text(code.letter, code.number); };
  const WordName word{code.letter, code.number, {}};
  if (kind == ChannelKind::master && code.availability != Availability::everywhere) {
    return fault_at("E4009", word, "`" + name() + "` on a master channel",
                    "a master channel has no axes and no spindle");
  }
  if (kind == ChannelKind::lathe && code.availability == Availability::mill_only) {
    return fault_at("E4009", word, "`" + name() + "` does not exist on a lathe channel", "");
  }
  if (kind != ChannelKind::lathe && code.availability == Availability::lathe_only) {
    return fault_at("E4009", word, "`" + name() + "` exists on lathe channels only", "");
  }
  return std::nullopt;
}

// G80 beside G0 to G3 is customary and says nothing more: they end a cycle as well. True when `row`
// is such a G80; one that came before is taken out.
bool only_ends_cycle(BlockCodes& codes, const Code& row) {
  constexpr CodeNumber end_of_cycle = g(80);
  constexpr CodeNumber last_plain_motion = g(3);
  for (const Code** place = codes.begin(); place != codes.end(); ++place) {
    if ((*place)->group != Group::motion || row.group != Group::motion) continue;
    if (row.number == end_of_cycle) return (*place)->number <= last_plain_motion;
    if ((*place)->number != end_of_cycle || row.number > last_plain_motion) return false;
    std::copy(place + 1, codes.end(), place);
    --codes.count;
    codes.groups &= ~group_bit(Group::motion);
    return false;
  }
  return false;
}

std::optional<BlockFault> add_row_of_code(BlockCodes& codes, char letter, CodeNumber number,
                                          const BlockWords& words, const ChannelKind* kind,
                                          const ChannelDialect& dialect) {
  if (number == code_computed_later) return std::nullopt;
  // What the machine file says of a code goes before what a dialect has.
  const Code* row = dialect.output(letter, number);
  if (row == nullptr) row = code_of_dialect(letter, number, words, kind);
  if (row == nullptr && !(words.rules.is_fanuc() && is_left_to_builders(letter, number)))
    row = find_code(letter, number);
  const auto name = [letter, number] { return code_text(letter, number); };
  const WordName word{letter, number, {}};
  if (row == nullptr) {
    BlockFault fault =
        fault_at("E4004", word, "unknown code `" + name() + "`", "there is no such code");
    fault.help.push_back("define a code of the machine builder in the machine file: " + name() +
                         " = \"cycles/name.nc\"" +
                         (letter == 'M' ? ", \"output 4 on\", \"before\" or \"after\"" : "") +
                         " in [channel.codes]");
    return fault;
  }
  if (row->action == CodeAction::unsupported) {
    BlockFault fault = fault_at("E2090", word, "`" + name() + "` is not supported in this release",
                                std::string(row->title));
    if (const UnsupportedWord* unsupported = find_unsupported_word(name()))
      fault.help.emplace_back(unsupported->instead);
    return fault;
  }
  if (kind != nullptr) {
    if (auto fault = unavailable(*row, *kind)) return fault;
  }
  if (only_ends_cycle(codes, *row)) return std::nullopt;
  if ((codes.groups & row->groups) != 0) {
    for (const Code* const other : codes) {
      if ((other->groups & row->groups) == 0) continue;
      return fault_at(
          "E4002", word,
          "`" + code_text(other->letter, other->number) + "` and `" + name() + "` in one block",
          "both belong to the same modal group");
    }
  }
  codes.add(row);
  codes.groups |= row->groups;
  codes.words |= words_of_code(*row, kind, words.rules);
  return std::nullopt;
}

// In the Fanuc dialect a motion code beside G28, G30, G92 and their like is active for the blocks
// to come only: `G0 G28 Z0`. True when `row` leaves the axis words to the code that has them, or
// takes them from the motion code that had them.
bool rests_beside(BlockCodes& codes, const Code& row) {
  const Code& user = *codes.axis_user;
  const bool user_moves = user.group == Group::motion;
  const bool row_moves = row.group == Group::motion;
  const Code& motion = user_moves ? user : row;
  if (user_moves == row_moves || motion.action != CodeAction::move_straight) return false;
  codes.resting_motion = &motion;
  if (user_moves) codes.axis_user = &row;
  return true;
}

// Rule: the axis words of a block belong to one code.
std::optional<BlockFault> find_axis_user(BlockCodes& codes, const TextRules& rules) {
  for (const Code* const row : codes) {
    if (row->axes == AxisWords::unused) continue;
    if (codes.axis_user != nullptr && rules.is_fanuc() && rests_beside(codes, *row)) continue;
    if (codes.axis_user != nullptr) {
      return fault_at("E4006", {row->letter, row->number, {}},
                      "`" + code_text(codes.axis_user->letter, codes.axis_user->number) +
                          "` and `" + code_text(row->letter, row->number) +
                          "` both use the axis words",
                      "only one code of a block can have them");
    }
    codes.axis_user = row;
  }
  return std::nullopt;
}

// The cycles of holes. In the dialect of Fanuc each may say P and Q, which stay for the cycles to
// come: drilling data are modal until G80 (operator's manual B-63944EN, 13.1).
bool drills(CodeNumber code) {
  return code == g(73) || code == g(74) || code == g(76) || (code >= g(81) && code <= g(89));
}

// I and J are the way off the wall; G87 of Haas is bored out by hand.
bool drills_with_shift(CodeNumber code, const TextRules& rules) {
  return code == g(76) || (code == g(87) && !rules.is_haas());
}

// Pecks that become less, the speed of the way out of a tap, the way off the wall. Source: Haas
// mill operator's manual, G73, G76, G77, G83, G84.
LetterSet words_of_haas(CodeNumber code) {
  switch (code) {
    case g(73):
    case g(83):
      return letters_of("IJK");
    case g(74):
    case g(84):
      return letters_of("J");
    case g(77):
      return letters_of("IJLPQ");
    default:
      return 0;
  }
}

LetterSet words_on_lathes(CodeNumber code, const TextRules& rules) {
  LetterSet words = 0;
  if (rules.is_fanuc() && (code == g(77) || code == g(78))) words |= letters_of("I");
  if (rules.is_fanuc() && code == g(78)) words |= letters_of("Q");
  if (rules.is_fanuc() && code == g(79)) words |= letters_of("K");
  if (rules.is_haas() && code == g(73)) words |= letters_of("ID");
  if (code == g(70)) words |= rules.is_haas() ? letters_of("UWD") : letters_of("UW");
  if (code == g(73)) words |= letters_of("PUW");
  if (code == g(76)) words |= letters_of("AD");
  if (code == g(83) || code == g(85)) words |= letters_of("P");
  return words;
}

}  // namespace

LetterSet words_of_code(const Code& code, const ChannelKind* kind, const TextRules& rules) {
  LetterSet words = code.words;
  if (code.letter != 'G') return words;
  const bool on_lathe = kind != nullptr && *kind == ChannelKind::lathe;
  if (rules.is_fanuc() && drills(code.number)) words |= letters_of("PQ");
  if (rules.is_haas()) words |= words_of_haas(code.number);
  if (rules.is_linuxcnc() && code.number == g(64)) words |= letters_of("R");
  if (rules.is_fanuc() && !on_lathe && drills_with_shift(code.number, rules))
    words |= letters_of("IJ");
  if (on_lathe) words |= words_on_lathes(code.number, rules);
  return words;
}

std::optional<BlockFault> resolve_codes(const BlockWords& words, const ChannelKind* kind,
                                        const ChannelDialect& dialect, BlockCodes& codes) {
  for (const CodeNumber number : words.g) {
    if (auto fault = add_row_of_code(codes, 'G', number, words, kind, dialect)) return fault;
  }
  for (const CodeNumber number : words.m) {
    if (auto fault = add_row_of_code(codes, 'M', number, words, kind, dialect)) return fault;
  }
  return find_axis_user(codes, words.rules);
}

const Code* motion_of(const BlockCodes& codes) {
  const auto* const found = std::find_if(
      codes.begin(), codes.end(), [](const Code* row) { return row->group == Group::motion; });
  return found == codes.end() ? nullptr : *found;
}

}  // namespace stanok::lang
