// Actions of drilling and boring cycles: a hole per block, as moves.
//
// Symbols: the plane's third axis is the tool axis; R the level to which the tool goes at rapid, Z
// the bottom, the initial level the tool's height before the first block of the sequence. In G91 R
// counts from the initial level and Z from R. Levels, Q and P stay valid within the sequence; of R
// and Z in LinuxCNC not the level but the number, which has the meaning of G90 or G91 of each
// block. Source: T. R. Kramer, F. M. Proctor, E. Messina, "The NIST RS274NGC Interpreter - Version
// 3" (NISTIR 6556, 2000), section 3.5.16.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "lang/actions/hole_moves.h"
#include "lang/block/other_controls.h"

namespace stanok::lang {
namespace {

// Moves that one block may make; all of them are held at once.
constexpr double moves_max = 100000.0;

bool is_cycle(const ActiveBlock& block, CodeNumber code) {
  const Code* const row = find_code('G', code);
  if (row == nullptr) return false;
  const bool of_mills = code == g(73) || code == g(74) || code == g(76) || code == g(77);
  return row->action == CodeAction::drill_hole ||
         (of_mills && block.channel.kind != ChannelKind::lathe);
}

// The cycles of lathes drill into the face, G87 to G89 into the side: along X. Source: Fanuc
// operator's manual B-64304EN-1, 5.2. Those of Haas are all along Z (lathe operator's manual, G81
// to G89), and so are those of LinuxCNC.
bool drills_into_side(const ActiveBlock& block, CodeNumber code) {
  const TextRules& rules = block.words.rules;
  return block.channel.kind == ChannelKind::lathe && !rules.is_haas() && !rules.is_linuxcnc() &&
         code >= g(87) && code <= g(89);
}

// What the cycle does with the hole, by the number of its fellow on mills. Fanuc lathes drill in
// one go where Q is left out, and dwell at the bottom where P is given.
CodeNumber kind_of_hole(const ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycles.drilling;
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  // Haas bores in with G87 and leaves the way out to the operator; G77 bores from behind, G184 taps
  // to the left. Source: Haas operator's manuals.
  if (code == g(184)) return g(74);
  if (block.words.rules.is_haas()) return code == g(87) ? g(88) : code == g(77) ? g(87) : code;
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

// K of Fanuc; elsewhere it is the lead of tapping, and the smallest peck of Haas.
bool counts_repeats(const ActiveBlock& block) {
  return block.words.rules.is_fanuc() && !block.words.rules.is_haas();
}

// I J K of Haas with G73 and G83. Source: Haas mill operator's manual.
void take_variable_pecks(ActiveBlock& block, CodeNumber code) {
  if (!block.words.rules.is_haas() || !pecks(code)) return;
  VariablePecks& pecks = block.modal.cycles.drilling.variable;
  if (block.has('I')) pecks.first = block.length('I');
  if (block.has('J')) pecks.less = block.length('J');
  if (block.has('K')) pecks.last = block.length('K');
  const char wrong = pecks.first < 0.0  ? 'I'
                     : pecks.less < 0.0 ? 'J'
                     : pecks.last < 0.0 ? 'K'
                                        : '\0';
  if (wrong != '\0')
    block.fail("E4063", {wrong, -1, {}}, "the depth of a peck must be positive", "negative");
}

// J of Haas with G84 and G74: how many times as fast the tap comes out.
void take_return_factor(ActiveBlock& block, CodeNumber kind) {
  if (!block.words.rules.is_haas() || !taps(kind) || !block.has('J')) return;
  constexpr int factor_max = 9;
  if (const auto factor = block.integer('J', 1, factor_max))
    block.modal.cycles.drilling.return_factor = *factor;
}

// I J of G76 and G87 in G17: the way off the wall, which the dialects of Fanuc have beside Q.
void take_shift(ActiveBlock& block, CodeNumber kind) {
  const bool bores = kind == g(76) || kind == g(87);
  if (!block.words.rules.is_fanuc() || !bores || (!block.has('I') && !block.has('J'))) return;
  if (block.modal.plane() != Plane::xy) {
    block
        .fail("E4003", {block.has('I') ? 'I' : 'J', -1, {}},
              "the retract from the wall by I and J needs plane G17", "another plane")
        .notes.push_back(block.modal.origin_of(Group::plane));
    return;
  }
  const auto way = [&](char letter, std::size_t coordinate) {
    const double gain = block.modal.map.gain(block.channel_words.geometry_axis(coordinate));
    return block.has(letter) ? gain * block.length(letter) : 0.0;
  };
  block.modal.cycles.drilling.shift = {true, way('I', 0), way('J', 1)};
}

// Takes R and Z of the block over into the sequence.
void take_levels(ActiveBlock& block, AxisIndex axis) {
  DrillingCycle& cycle = block.modal.cycles.drilling;
  const CoordinateMap& map = block.modal.map;
  // Scaling leaves the levels of Haas as they are: Haas mill operator's manual, G51.
  const bool is_scaled = !block.words.rules.is_haas();
  const auto level = [&](double word, double from) {
    if (!block.modal.incremental())
      return is_scaled ? map.to_work(axis, word) : map.mirrored(axis, word);
    const double gain =
        is_scaled ? map.gain(axis) : map.mirrored(axis, 1.0) - map.mirrored(axis, 0.0);
    return from + gain * word;
  };
  if (block.has('R')) {
    cycle.retract_word = block.length('R');
    cycle.has_retract_level = true;
  }
  if ((block.programmed & axis_bit(axis)) != 0) {
    cycle.bottom_word = block.values[axis];
    cycle.has_bottom = true;
  }
  const bool numbers_stay = block.words.rules.is_linuxcnc();
  if (block.has('R') || (numbers_stay && cycle.has_retract_level)) {
    // On Fanuc lathes R is a distance from the initial level, whatever G90 says; on those of Haas
    // it is a position.
    const bool distance = block.channel.kind == ChannelKind::lathe &&
                          block.words.rules.is_fanuc() && !block.words.rules.is_haas();
    cycle.retract_level = distance ? cycle.initial_level + map.gain(axis) * cycle.retract_word
                                   : level(cycle.retract_word, cycle.initial_level);
  }
  if ((block.programmed & axis_bit(axis)) != 0 || (numbers_stay && cycle.has_bottom))
    cycle.bottom = level(cycle.bottom_word, cycle.retract_level);
}

// Takes R, Z, Q and P of the block over into the sequence.
void take_cycle_words(ActiveBlock& block, AxisIndex axis) {
  take_levels(block, axis);
  DrillingCycle& cycle = block.modal.cycles.drilling;
  // On Fanuc lathes Q counts thousandths when it has no point, as in their other cycles.
  const bool counted = block.channel.kind == ChannelKind::lathe;
  const double peck = counted ? value_or_thousandths(block, 'Q') : block.value('Q');
  if (block.has('Q')) cycle.peck = peck * block.length_unit();
  const double dwell_s = value_or_thousandths(block, 'P');
  if (block.has('P') && check_dwell(block, 'P', dwell_s)) cycle.dwell_s = dwell_s;
  if (block.has('K') && !counts_repeats(block)) cycle.lead = block.length('K');
}

// Haas: without R the level is where the tool stands before the cycle.
void take_initial_level_for_r(ActiveBlock& block, CodeNumber kind) {
  DrillingCycle& cycle = block.modal.cycles.drilling;
  if (cycle.has_retract_level || !block.words.rules.is_haas() || bores_from_behind(kind)) return;
  cycle.retract_level = cycle.initial_level;
  cycle.has_retract_level = true;
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
              name + " bores upwards from R to the bottom, so R must be below the bottom",
              "above the bottom")
        .help.emplace_back(
            "R is the level below the part where the tool moves its edge to the wall");
  } else if (!bores_from_behind(kind) && cycle.retract_level < cycle.bottom) {
    block.fail("E4062", {block.has('R') ? 'R' : '\0', -1, {}},
               "level R is below the bottom of the hole", "below the bottom");
  } else if (pecks(kind) && cycle.variable.first > 0.0 && cycle.variable.last <= 0.0) {
    block.fail("E4063", code_word(code), name + " needs K, the smallest peck, in addition to I",
               "no K");
  } else if (pecks(kind) && cycle.peck <= 0.0 && cycle.variable.first <= 0.0) {
    block.fail("E4063", code_word(code), name + " needs a positive Q, the depth of a peck", "no Q");
  } else if (needs_dwell(kind) && cycle.dwell_s < 0.0 && !block.words.rules.is_fanuc()) {
    block.fail("E4007", code_word(code), name + " needs P, the dwell at the bottom", "no P");
  } else if ((code == g(76) || bores_from_behind(kind)) && cycle.peck <= 0.0 &&
             !cycle.shift.is_given) {
    block.fail("E4063", code_word(code), name + " needs a positive Q, the distance from the edge",
               "no Q");
  } else if (needs_turning_spindle(kind) && !block.modal.spindles.any_runs) {
    block.fail("E4064", code_word(code), name + " needs a spindle that turns",
               "no M3 or M4 before this");
  } else if (block.modal.feed_mode() == FeedMode::inverse_time) {
    block.fail("E4065", code_word(code), "drilling cycles cannot use inverse time feed", "")
        .notes.push_back(block.modal.origin_of(Group::feed_mode));
  }
}

// How many moves a hole may have at most; nothing, with the block failed: more than there may be.
std::optional<double> move_count_of_hole(ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycles.drilling;
  const double depth = cycle.retract_level - cycle.bottom;
  constexpr double moves_of_hole = 10.0;  // with what the spindle does
  const double peck =
      cycle.variable.first > 0.0 ? std::min(cycle.variable.first, cycle.variable.last) : cycle.peck;
  const double moves = pecks(code) ? 5.0 * std::ceil(depth / peck) + 4.0 : moves_of_hole;
  if (moves > moves_max) {
    block.fail("E4063", {block.has('Q') ? 'Q' : '\0', -1, {}}, "Q results in too many pecks",
               "too small");
    return std::nullopt;
  }
  return moves;
}

// Holes that the block makes: L, bounded together with the pecks of each.
std::optional<int> repeats_of(ActiveBlock& block, CodeNumber code) {
  const auto moves = move_count_of_hole(block, code);
  if (!moves) return std::nullopt;
  const char letter = block.has('K') && counts_repeats(block) ? 'K' : 'L';
  if (!block.has(letter)) return 1;
  return block.integer(letter, 0, static_cast<int>(moves_max / *moves));
}

bool holes_of_pattern_fit(ActiveBlock& block, CodeNumber kind, int holes) {
  const auto moves = move_count_of_hole(block, kind);
  if (!moves) return false;
  if (holes * *moves <= moves_max) return true;
  block.fail("E4063", {'L', -1, {}}, "the holes have too many pecks", "too many");
  return false;
}

// Of the words of G76 some belong to the thread cycle of lathe channels.
bool uses_its_words(ActiveBlock& block, CodeNumber code) {
  const bool peck_by_k = block.words.rules.is_haas() && pecks(code);
  if (block.has('K') && !taps(code) && code != g(76) && !counts_repeats(block) && !peck_by_k) {
    block.fail("E4003", {'K', -1, {}}, "nothing in this block uses `K`", "unused word")
        .help.emplace_back("give the number of repeats with `L`; only the dialect fanuc uses K");
    return false;
  }
  if (code != g(76)) return true;
  const bool shifts = block.words.rules.is_fanuc();
  for (const char letter : {'E', 'H', 'I', 'J', 'K'}) {
    if (!block.has(letter) || (letter == 'K' && counts_repeats(block))) continue;
    if (shifts && (letter == 'I' || letter == 'J')) continue;
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

void go_to_hole(ActiveBlock& block, HoleMoves& hole, CodeNumber kind) {
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

// Holes of a pattern, about or from where the tool stood at its beginning: the way to the k-th one,
// in the coordinates of the program.
struct HolePattern {
  CodeNumber code = 0;
  double size_mm = 0.0;  // radius of the circle, or way from hole to hole
  double angle_deg = 0.0;
  double step_deg = 0.0;
  int holes = 0;
};

void place_in_pattern(ActiveBlock& block, HoleMoves& hole, CodeNumber kind,
                      const HolePattern& pattern, int k) {
  const double angle = (pattern.angle_deg + k * pattern.step_deg) * std::numbers::pi / 180.0;
  const double away = pattern.code == g(72) ? k * pattern.size_mm : pattern.size_mm;
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  Move move;
  move.end = block.modal.position_W;
  const std::pair<std::size_t, double> ways[] = {{plane.first, away * std::cos(angle)},
                                                 {plane.second, away * std::sin(angle)}};
  for (const auto& [coordinate, way] : ways) {
    const AxisIndex axis = block.channel_words.geometry_axis(coordinate);
    move.end[axis] =
        block.modal.cycles.drilling.pattern_centre[axis] + block.modal.map.gain(axis) * way;
    move.words = static_cast<AxisSet>(move.words | axis_bit(axis));
  }
  move.stop_at_end = block.end.stops;
  resolve_feed(block, move);
  if (bores_from_behind(kind)) {
    hole.go_over(move);
  } else {
    hole.approach(move);
  }
}

void make_holes(ActiveBlock& block, HoleMoves& hole, CodeNumber kind, int repeats,
                const HolePattern* pattern = nullptr) {
  const bool by_hand = kind == g(88);
  for (int i = static_cast<int>(block.done.parts / 2); i < repeats && !block.failed();) {
    const bool goes_out = by_hand && block.done.parts % 2 == 1;
    if (!goes_out) {
      if (i > 0 && pattern == nullptr) repeat_polar_words(block);
      if (pattern != nullptr) {
        place_in_pattern(block, hole, kind, *pattern, i);
      } else {
        go_to_hole(block, hole, kind);
      }
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

constexpr int holes_max = 1000;

std::optional<HolePattern> read_pattern(ActiveBlock& block, CodeNumber code) {
  const std::string name = "`" + code_text('G', code) + "`";
  const auto refuse = [&](char letter, const std::string& why) {
    block.fail(block.has(letter) ? "E4008" : "E4007",
               block.has(letter) ? WordName{letter, -1, {}} : code_word(code),
               name + " needs " + why,
               block.has(letter) ? "out of range" : std::string("no ") + letter);
    return std::nullopt;
  };
  const bool line = code == g(72);
  HolePattern pattern;
  pattern.code = code;
  if (!block.has('I') || block.value('I') <= 0.0) {
    return refuse('I', line ? "I, the distance from hole to hole, above zero"
                            : "I, the radius of the circle, above zero");
  }
  if (!block.has('L')) return refuse('L', "L, the number of holes");
  const auto holes = block.integer('L', 1, holes_max);
  if (!holes) return std::nullopt;
  if (code == g(71) && !block.has('K')) return refuse('K', "K, the angle from hole to hole");
  pattern.size_mm = block.length('I');
  pattern.angle_deg = block.has('J') ? block.value('J') : 0.0;
  pattern.holes = *holes;
  if (code == g(70)) pattern.step_deg = 360.0 / *holes;
  if (code == g(71)) pattern.step_deg = block.value('K');
  return pattern;
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
  if (is_begun && !is_cycle(block, block.modal.code(Group::motion))) {
    cycle = {};
    block.modal.cycles.motion_before = block.modal.code(Group::motion);
    cycle.initial_level = block.modal.position_W[*axis] + block.end.length_travel_W[*axis];
  }
  if (block.programmed == 0) return;
  if (is_begun) take_cycle_words(block, *axis);
  const CodeNumber kind = kind_of_hole(block, code);
  take_variable_pecks(block, kind);
  take_return_factor(block, kind);
  take_shift(block, kind);
  take_initial_level_for_r(block, kind);
  check_cycle(block, code, kind);
  if (block.failed()) return;
  const auto repeats = repeats_of(block, kind);
  if (!repeats) return;
  HoleMoves hole(block, *axis);
  make_holes(block, hole, kind, *repeats);
}

// G70 a circle, G71 an arc, G72 a line of holes, with the cycle that is active: the centre, or the
// first hole of a line, is where the tool stands. Source: Haas mill operator's manual.
void drill_pattern(ActiveBlock& block, CodeNumber code) {
  const CodeNumber cycle_code = block.modal.code(Group::motion);
  if (!is_cycle(block, cycle_code)) {
    block
        .fail("E4061", code_word(code),
              "`" + code_text('G', code) + "` needs an active drilling cycle", "no cycle")
        .help.emplace_back("program the cycle first, with L0, e.g. `G81 Z-10 R2 F100 L0`");
    return;
  }
  const auto axis = tool_axis(block, code);
  const auto pattern = read_pattern(block, code);
  if (!axis || !pattern) return;
  const CodeNumber kind = kind_of_hole(block, cycle_code);
  check_cycle(block, cycle_code, kind);
  if (block.failed() || !holes_of_pattern_fit(block, kind, pattern->holes)) return;
  if (block.done.parts == 0) block.modal.cycles.drilling.pattern_centre = block.modal.position_W;
  HoleMoves hole(block, *axis);
  make_holes(block, hole, kind, pattern->holes, &*pattern);
}

}  // namespace stanok::lang
