// Actions of drilling and boring cycles: a hole per block, as moves.
//
// Symbols: the plane's third axis is the tool axis; R the level to which the tool goes at rapid, Z
// the bottom, the initial level the tool's height before the first block of the sequence. In G91 R
// counts from the initial level and Z from R. Levels, Q and P stay valid within the sequence.
// Source: T. R. Kramer, F. M. Proctor, E. Messina, "The NIST RS274NGC Interpreter - Version 3"
// (NISTIR 6556, 2000), section 3.5.16.
#include <algorithm>
#include <array>
#include <cmath>

#include "lang/actions/hole_moves.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

// Moves that one block may make; all of them are held at once.
constexpr double moves_max = 100000.0;

bool is_cycle(CodeNumber code) {
  const Code* const row = find_code('G', code);
  return row != nullptr &&
         (row->action == CodeAction::drill_hole || code == g(73) || code == g(74) || code == g(76));
}

// The cycles of lathes drill into the face, G87 to G89 into the side: along X. Source: Fanuc
// operator's manual B-64304EN-1, 5.2.
bool drills_into_side(const ActiveBlock& block, CodeNumber code) {
  return block.channel.kind == ChannelKind::lathe && code >= g(87) && code <= g(89);
}

// What the cycle does with the hole, by the number of its fellow on mills. Fanuc lathes drill in
// one go where Q is left out, and dwell at the bottom where P is given.
CodeNumber kind_of_hole(const ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycles.drilling;
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  // Haas bores in with G87 and leaves the way out to the operator. Source: Haas mill operator's
  // manual, G87.
  if (!lathe && code == g(87) && block.words.rules.is_haas()) return g(88);
  const CodeNumber kind = !drills_into_side(block, code) ? code
                          : code == g(87)                ? g(83)
                          : code == g(88)                ? g(84)
                                                         : g(85);
  const bool in_one_go =
      lathe && kind == g(83) && cycle.peck <= 0.0 && block.words.rules.is_fanuc();
  if (in_one_go) return cycle.dwell_s > 0.0 ? g(82) : g(81);
  const bool dwells = lathe && kind == g(85) && cycle.dwell_s > 0.0;
  return dwells ? g(89) : kind;
}

bool needs_dwell(CodeNumber code) {
  return code == g(82) || code == g(86) || code == g(89);
}

bool taps(CodeNumber code) {
  return code == g(74) || code == g(84);
}

// Boring from behind: the tool goes through the hole, and R is below the bottom.
bool bores_from_behind(CodeNumber kind) {
  return kind == g(87);
}

// What stops the spindle, or moves its edge away from the wall, needs one that turns.
bool needs_turning_spindle(CodeNumber kind) {
  return kind == g(76) || kind == g(86) || kind == g(87) || kind == g(88);
}

bool pecks(CodeNumber code) {
  return code == g(73) || code == g(83);
}

// Words that only the cycle of the same number on lathes has.
bool refuses_words_of_lathes(ActiveBlock& block) {
  for (const char letter : {'Q', 'I', 'D'}) {
    if (!block.has(letter)) continue;
    block.fail("E4003", {letter, -1, {}},
               std::string("nothing in this block uses `") + letter + "`", "unused word");
  }
  return block.failed();
}

// Channel axis along which the tool goes. Fails the block when the channel has none.
std::optional<AxisIndex> tool_axis(ActiveBlock& block, CodeNumber code) {
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  const Plane into = drills_into_side(block, code) ? Plane::yz : Plane::xy;
  const Plane plane = lathe ? into : block.modal.plane();
  const AxisIndex axis = block.channel_words.geometry_axis(plane_coordinates[plane].normal);
  if (axis.exists()) return axis;
  block.fail("E4036", code_word(code), "the channel lacks the tool axis of the cycle", "")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return std::nullopt;
}

// K of the Fanuc dialect; elsewhere it is the lead of tapping.
bool counts_repeats(const ActiveBlock& block) {
  return block.words.rules.is_fanuc();
}

// Takes R, Z, Q and P of the block over into the sequence.
void take_cycle_words(ActiveBlock& block, AxisIndex axis) {
  DrillingCycle& cycle = block.modal.cycles.drilling;
  const CoordinateMap& map = block.modal.map;
  const auto level = [&](double word, double from) {
    return block.modal.incremental() ? from + map.gain(axis) * word : map.to_work(axis, word);
  };
  if (block.has('R')) {
    // On Fanuc lathes R is a distance from the initial level, whatever G90 says.
    const bool distance = block.channel.kind == ChannelKind::lathe && block.words.rules.is_fanuc();
    cycle.retract_level = distance ? cycle.initial_level + map.gain(axis) * block.length('R')
                                   : level(block.length('R'), cycle.initial_level);
    cycle.has_retract_level = true;
  }
  if ((block.programmed & axis_bit(axis)) != 0) {
    cycle.bottom = level(block.values[axis], cycle.retract_level);
    cycle.has_bottom = true;
  }
  // On Fanuc lathes Q counts thousandths when it has no point, as in their other cycles.
  const bool counted = block.channel.kind == ChannelKind::lathe;
  const double peck = counted ? value_or_thousandths(block, 'Q') : block.value('Q');
  if (block.has('Q')) cycle.peck = peck * block.length_unit();
  const double dwell_s = value_or_thousandths(block, 'P');
  if (block.has('P') && check_dwell(block, 'P', dwell_s)) cycle.dwell_s = dwell_s;
  if (block.has('K') && !counts_repeats(block)) cycle.lead = block.length('K');
}

void check_cycle(ActiveBlock& block, CodeNumber code, CodeNumber kind) {
  const DrillingCycle& cycle = block.modal.cycles.drilling;
  const std::string name = "`" + code_text('G', code) + "`";
  if (!cycle.has_bottom || !cycle.has_retract_level) {
    block
        .fail("E4061", code_word(code), name + " needs the bottom of the hole and R",
              cycle.has_bottom ? "no R" : "no bottom")
        .help.push_back("write e.g. `" + code_text('G', code) + " Z-10 R2`");
  } else if (bores_from_behind(kind) && cycle.retract_level > cycle.bottom) {
    block
        .fail("E4062", {block.has('R') ? 'R' : '\0', -1, {}},
              name + " bores up from R to the bottom, so R lies below it", "above the bottom")
        .help.emplace_back("R is where the tool gets its edge to the wall, behind the part");
  } else if (!bores_from_behind(kind) && cycle.retract_level < cycle.bottom) {
    block.fail("E4062", {block.has('R') ? 'R' : '\0', -1, {}},
               "the level R lies below the bottom of the hole", "below the bottom");
  } else if (pecks(kind) && cycle.peck <= 0.0) {
    block.fail("E4063", code_word(code), name + " needs a positive Q, the depth of a peck", "no Q");
  } else if (needs_dwell(kind) && cycle.dwell_s < 0.0 && !block.words.rules.is_fanuc()) {
    block.fail("E4007", code_word(code), name + " needs P, the dwell at the bottom", "no P");
  } else if ((code == g(76) || bores_from_behind(kind)) && cycle.peck <= 0.0) {
    block.fail("E4063", code_word(code), name + " needs a positive Q, the distance from the edge",
               "no Q");
  } else if (needs_turning_spindle(kind) && !block.modal.spindles.any_runs) {
    block.fail("E4064", code_word(code), name + " needs a spindle that turns",
               "no M3 or M4 before");
  } else if (block.modal.feed_mode() == FeedMode::inverse_time) {
    block.fail("E4065", code_word(code), "drilling cycles have no inverse time feed", "")
        .notes.push_back(block.modal.origin_of(Group::feed_mode));
  }
}

// Holes that the block makes: L, bounded together with the pecks of each.
std::optional<int> repeats_of(ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycles.drilling;
  const double depth = cycle.retract_level - cycle.bottom;
  constexpr double moves_of_hole = 10.0;  // with what the spindle does
  const double moves = pecks(code) ? 3.0 * std::ceil(depth / cycle.peck) + 4.0 : moves_of_hole;
  if (moves > moves_max) {
    block.fail("E4063", {block.has('Q') ? 'Q' : '\0', -1, {}}, "Q makes too many pecks",
               "too small");
    return std::nullopt;
  }
  const char letter = block.has('K') && counts_repeats(block) ? 'K' : 'L';
  if (!block.has(letter)) return 1;
  return block.integer(letter, 0, static_cast<int>(moves_max / moves));
}

// Of the words of G76 some belong to the thread cycle of lathe channels.
bool uses_its_words(ActiveBlock& block, CodeNumber code) {
  if (block.has('K') && !taps(code) && code != g(76) && !counts_repeats(block)) {
    block.fail("E4003", {'K', -1, {}}, "nothing in this block uses `K`", "unused word")
        .help.emplace_back("repeats are `L`; K counts them in the dialect fanuc");
    return false;
  }
  if (code != g(76)) return true;
  for (const char letter : {'E', 'H', 'I', 'J', 'K'}) {
    if (!block.has(letter) || (letter == 'K' && counts_repeats(block))) continue;
    block.fail("E4003", {letter, -1, {}},
               std::string("`G76` does not use `") + letter + "` on this channel", "unused word");
    return false;
  }
  return true;
}

void make_hole(HoleMoves& hole, CodeNumber code) {
  if (pecks(code)) {
    hole.peck(code);
  } else if (taps(code)) {
    hole.tap(code);
  } else if (code == g(76)) {
    hole.bore_finely();
  } else if (bores_from_behind(code)) {
    hole.bore_from_behind();
  } else {
    hole.bore_out(code);
  }
}

void position(ActiveBlock& block, HoleMoves& hole, CodeNumber kind) {
  Move positioning;
  resolve_ends(block, positioning);
  positioning.words = static_cast<AxisSet>(positioning.words & ~axis_bit(hole.axis()));
  resolve_feed(block, positioning);
  if (bores_from_behind(kind)) {
    hole.go_over(positioning);
  } else {
    hole.approach(positioning);
  }
}

// G88 has two parts for each hole: into it, and out of it when the operator has started again.
// `false`: the rest comes then.
bool bore_by_hand(ActiveBlock& block, HoleMoves& hole) {
  const bool goes_out = block.done.parts % 2 == 1;
  ++block.done.parts;
  if (goes_out) {
    hole.go_on_behind_hand();
    return true;
  }
  hole.bore_up_to_hand();
  block.awaits_position = true;
  --block.done.actions;
  return false;
}

void make_holes(ActiveBlock& block, HoleMoves& hole, CodeNumber kind, int repeats) {
  const bool by_hand = kind == g(88);
  for (int i = static_cast<int>(block.done.parts / 2); i < repeats && !block.failed();) {
    const bool goes_out = by_hand && block.done.parts % 2 == 1;
    if (!goes_out) {
      if (i > 0) repeat_polar_words(block);
      position(block, hole, kind);
      if (block.failed()) return;
    }
    if (!by_hand) {
      make_hole(hole, kind);
    } else if (!bore_by_hand(block, hole)) {
      return;
    }
    if (!by_hand || goes_out) ++i;
  }
}

}  // namespace

void bore_or_thread(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind == ChannelKind::lathe) return cut_thread_in_passes(block, code);
  drill_hole(block, code);
}

void drill_hole(ActiveBlock& block, CodeNumber code) {
  const auto axis = tool_axis(block, code);
  if (!axis || !uses_its_words(block, code)) return;
  if (code == g(74) && refuses_words_of_lathes(block)) return;
  DrillingCycle& cycle = block.modal.cycles.drilling;
  const bool is_begun = block.done.parts == 0;  // and not gone on with
  if (is_begun && !is_cycle(block.modal.code(Group::motion))) {
    cycle = {};
    block.modal.cycles.motion_before = block.modal.code(Group::motion);
    cycle.initial_level = block.modal.position_W[*axis];
  }
  if (block.programmed == 0) return;
  if (is_begun) take_cycle_words(block, *axis);
  const CodeNumber kind = kind_of_hole(block, code);
  check_cycle(block, code, kind);
  if (block.failed()) return;
  const auto repeats = repeats_of(block, kind);
  if (!repeats) return;
  HoleMoves hole(block, *axis);
  make_holes(block, hole, kind, *repeats);
}

}  // namespace stanok::lang
