// Actions of drilling and boring cycles: a hole per block, as moves.
//
// Symbols: the plane's third axis is the tool axis; R the level to which the tool goes at rapid, Z
// the bottom, the initial level the tool's height before the first block of the sequence. In G91 R
// counts from the initial level and Z from R. Levels, Q and P stay valid within the sequence.
// Source: T. R. Kramer, F. M. Proctor, E. Messina, "The NIST RS274NGC Interpreter - Version 3"
// (NISTIR 6556, 2000), section 3.5.16; the lift of 0.254 mm is theirs, too.
#include <algorithm>
#include <array>
#include <cmath>

#include "lang/actions.h"

namespace stanok::lang {
namespace {

// How far G73 lifts to break the chip, and G83 stays off the last depth when it comes back.
constexpr double peck_lift_mm = 0.254;

// Moves that one block may make; all of them are held at once.
constexpr double moves_max = 100000.0;

WordName code_word(CodeNumber code) {
  return {'G', code, {}};
}

bool is_cycle(CodeNumber code) {
  const Code* const row = find_code('G', code);
  return row != nullptr && row->action == drill_hole;
}

bool needs_dwell(CodeNumber code) {
  return code == 820 || code == 860 || code == 890;
}

bool pecks(CodeNumber code) {
  return code == 730 || code == 830;
}

// Channel axis along which the tool goes; fails the block when the channel has none.
std::optional<std::size_t> tool_axis(ActiveBlock& block, CodeNumber code) {
  static constexpr std::array<std::size_t, 3> third{2, 1, 0};
  const int axis =
      block.channel_words.geometry_axis(third[static_cast<std::size_t>(block.modal.plane())]);
  if (axis >= 0) return static_cast<std::size_t>(axis);
  block.fail("E4036", code_word(code), "the channel lacks the tool axis of the cycle", "")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return std::nullopt;
}

// Takes R, Z, Q and P of the block over into the sequence.
void take_cycle_words(ActiveBlock& block, std::size_t axis) {
  DrillingCycle& cycle = block.modal.cycle;
  const CoordinateMap& map = block.modal.map;
  const auto level = [&](double word, double from) {
    return block.modal.incremental() ? from + map.gain(axis) * word : map.to_work(axis, word);
  };
  if (block.has('R')) {
    cycle.retract_level = level(block.length('R'), cycle.initial_level);
    cycle.has_retract_level = true;
  }
  if ((block.programmed & axis_bit(axis)) != 0) {
    cycle.bottom = level(block.values[axis], cycle.retract_level);
    cycle.has_bottom = true;
  }
  if (block.has('Q')) cycle.peck = block.length('Q');
  if (block.has('P')) cycle.dwell_s = block.value('P');
}

void check_cycle(ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycle;
  const std::string name = "`" + code_text('G', code) + "`";
  if (!cycle.has_bottom || !cycle.has_retract_level) {
    block.fail("E4061", code_word(code), name + " needs the bottom of the hole and R",
               cycle.has_bottom ? "no R" : "no bottom");
  } else if (cycle.retract_level < cycle.bottom) {
    block.fail("E4062", {block.has('R') ? 'R' : '\0', -1, {}},
               "the level R lies below the bottom of the hole", "below the bottom");
  } else if (pecks(code) && cycle.peck <= 0.0) {
    block.fail("E4063", code_word(code), name + " needs a positive Q, the depth of a peck", "no Q");
  } else if (needs_dwell(code) && cycle.dwell_s < 0.0) {
    block.fail("E4007", code_word(code), name + " needs P, the dwell at the bottom", "no P");
  } else if (code == 860 && !block.modal.spindle_running) {
    block.fail("E4064", code_word(code), name + " while the spindle stands", "no M3 or M4 before");
  } else if (block.modal.feed_mode() == FeedMode::inverse_time) {
    block.fail("E4065", code_word(code), "drilling cycles have no inverse time feed", "")
        .notes.push_back(block.modal.origin_of(Group::feed_mode));
  }
}

// Holes that the block makes: L, bounded together with the pecks of each.
std::optional<int> repeats_of(ActiveBlock& block, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycle;
  const double depth = cycle.retract_level - cycle.bottom;
  const double moves = pecks(code) ? 3.0 * std::ceil(depth / cycle.peck) + 4.0 : 6.0;
  if (moves > moves_max) {
    block.fail("E4063", {block.has('Q') ? 'Q' : '\0', -1, {}}, "Q makes too many pecks",
               "too small");
    return std::nullopt;
  }
  if (!block.has('L')) return 1;
  return block.integer('L', 0, static_cast<int>(moves_max / moves));
}

// Moves of one hole along the tool axis.
class Hole {
 public:
  Hole(ActiveBlock& block, std::size_t axis) : block_(block), axis_(axis) {}

  void rapid(double level) { go(MoveKind::rapid, level); }
  void feed(double level) { go(MoveKind::line, level); }
  void dwell() { block_.queue.emit(Dwell{block_.modal.cycle.dwell_s}); }

  // Over the hole: up to R first when the tool is below it.
  void approach(const Move& positioning) {
    const DrillingCycle& cycle = block_.modal.cycle;
    if (block_.modal.position_W[axis_] < cycle.retract_level) rapid(cycle.retract_level);
    if (positioning.words != 0) {
      Move move = positioning;
      move.end[axis_] = block_.modal.position_W[axis_];
      advance_position(block_, move);
      block_.queue.emit(move);
    }
    if (block_.modal.position_W[axis_] > cycle.retract_level) rapid(cycle.retract_level);
  }

  void peck(CodeNumber code) {
    const DrillingCycle& cycle = block_.modal.cycle;
    double depth = cycle.retract_level;
    while (!block_.failed()) {
      depth = std::max(depth - cycle.peck, cycle.bottom);
      feed(depth);
      if (depth <= cycle.bottom) return;
      if (code == 730) {
        rapid(depth + peck_lift_mm);
      } else {
        rapid(cycle.retract_level);
        rapid(std::min(depth + peck_lift_mm, cycle.retract_level));
      }
    }
  }

  void retract() {
    const DrillingCycle& cycle = block_.modal.cycle;
    const bool to_initial = block_.modal.code(Group::return_level) == 980;
    const double level =
        to_initial ? std::max(cycle.initial_level, cycle.retract_level) : cycle.retract_level;
    if (level != block_.modal.position_W[axis_]) rapid(level);
  }

 private:
  void go(MoveKind kind, double level) {
    Move move;
    move.kind = kind;
    move.words = axis_bit(axis_);
    move.end = block_.modal.position_W;
    move.end[axis_] = level;
    move.stop_at_end = block_.stop_at_end;
    resolve_feed(block_, move);
    if (block_.failed()) return;
    advance_position(block_, move);
    block_.queue.emit(move);
  }

  ActiveBlock& block_;
  std::size_t axis_;
};

void bore_out(ActiveBlock& block, Hole& hole, CodeNumber code) {
  const DrillingCycle& cycle = block.modal.cycle;
  if (needs_dwell(code)) hole.dwell();
  if (code == 850 || code == 890) hole.feed(cycle.retract_level);
  if (code != 860) return hole.retract();
  const bool clockwise = block.modal.code(Group::spindle) == 30;
  SpindleCommand spindle;
  block.queue.emit(spindle);
  hole.retract();
  spindle.action = clockwise ? SpindleAction::clockwise : SpindleAction::counter_clockwise;
  spindle.speed_rev_per_min = block.modal.speed_rev_per_min;
  block.queue.emit(spindle);
}

}  // namespace

void drill_hole(ActiveBlock& block, CodeNumber code) {
  const auto axis = tool_axis(block, code);
  if (!axis) return;
  DrillingCycle& cycle = block.modal.cycle;
  if (!is_cycle(block.modal.code(Group::motion))) {
    cycle = {};
    cycle.initial_level = block.modal.position_W[*axis];
  }
  if (block.programmed == 0) return;
  take_cycle_words(block, *axis);
  check_cycle(block, code);
  if (block.failed()) return;
  const auto repeats = repeats_of(block, code);
  if (!repeats) return;
  Hole hole(block, *axis);
  for (int i = 0; i < *repeats && !block.failed(); ++i) {
    Move positioning;
    resolve_ends(block, positioning);
    positioning.words = static_cast<AxisSet>(positioning.words & ~axis_bit(*axis));
    resolve_feed(block, positioning);
    hole.approach(positioning);
    if (pecks(code)) {
      hole.peck(code);
    } else {
      hole.feed(cycle.bottom);
    }
    if (!block.failed()) bore_out(block, hole, code);
  }
}

}  // namespace stanok::lang
