// Actions of straight motion, and the parts that all motions share.
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "lang/actions/actions.h"
#include "lang/orientation/great_circle.h"
#include "lang/orientation/set_up_angles.h"

namespace stanok::lang {
namespace {

// The angle equal to `programmed` by full turns that lies nearest to `position`.
double shortest_travel(double programmed, double position, double modulo) {
  const double turns = std::round((position - programmed) / modulo);
  return turns == 0.0 ? programmed : programmed + turns * modulo;
}

void check_machine_coordinates(ActiveBlock& block, CodeNumber code) {
  const WordName word{'G', g(53), {}};
  if (excluded_by_mode(block, g(53), {Exclusion::transformation})) return;
  if (block.modal.tool.length.mode == LengthMode::tip) {
    const auto mode = active_mode(block.modal, {Exclusion::tcp});
    BlockFault& fault =
        block.fail("E4040", word, "`G53` is not allowed while " + std::string(mode->name), "");
    fault.notes.push_back(mode->set_by);
    fault.help.emplace_back(mode->remedy);
  } else if (code > g(1)) {
    block.fail("E4041", word, "`G53` works only with G0 and G1", "");
  } else if (block.modal.incremental() || block.incremental != 0) {
    block.fail("E4042", word, "`G53` needs absolute programming (G90)", "")
        .notes.push_back(block.modal.origin_of(Group::distance));
  }
}

// I, J, K beside G0 and G1 are the direction of the tool at the end of the move under G43.5, and
// nothing elsewhere. A move at feed turns the tool on the great circle, in parts; rapid travel, a
// line that a chamfer or rounding cuts, and all under #orientation (axis) turn the axes evenly.
// None: the block has failed.
std::vector<TurnedPart> turn_to_vector(ActiveBlock& block, Move& move) {
  const ModalState& modal = block.modal;
  const char letter = block.has('I') ? 'I' : block.has('J') ? 'J' : 'K';
  if (modal.code(Group::length) != g(43, 5)) {
    block
        .fail("E4003", {letter, -1, {}}, std::string("nothing in this block uses `") + letter + "`",
              "unused word")
        .help.emplace_back("arcs are G2 and G3; a vector of the tool needs `G43.5`");
    return {};
  }
  if (excluded_by_mode(block, g(43, 5),
                       {Exclusion::own_rotation, Exclusion::scaling, Exclusion::mirror})) {
    return {};
  }
  const auto direction = vector_of_block(block);
  if (!direction) return {};
  const Rotation frame_B = modal.frames.base_rotation() * modal.frames.plane.rotation;
  OrientationWish wish{.word = {letter, -1, {}},
                       .name = "a tool vector under `G43.5`",
                       .purpose = "turn the tool to",
                       .said_by = Group::length,
                       .remedy = "clamp the workpiece differently, or tilt the tool less",
                       .end = "this tool vector"};
  wish.tool_B = components(frame_B.turned(vector3(*direction)));
  const bool turns_evenly = move.kind == MoveKind::rapid || block.end.corner.wanted() ||
                            modal.tool.turning == TurningWay::axis;
  std::vector<TurnedPart> parts;
  if (turns_evenly) {
    if (const auto found = reachable_angles(block, wish)) parts.push_back({1.0, *found});
  } else if (auto found = great_circle(block, wish)) {
    parts = std::move(*found);
  }
  if (parts.empty()) return {};
  const Alignment& end = parts.back().alignment;
  if ((block.programmed & end.axes) != 0) {
    block
        .fail("E4355", {letter, -1, {}},
              "the angles of the rotary axes follow from the tool vector", "a rotary axis as well")
        .help.emplace_back("leave the words of the rotary axes out");
    return {};
  }
  turn_axes(block, end, move);
  return parts;
}

// Under #orientation (vector) a line at feed with words of rotary axes leads the tool on the great
// circle, too, to the angles of the words. None: the axes move evenly, or the block has failed.
std::vector<TurnedPart> turn_to_angles(ActiveBlock& block, Move& move) {
  const ModalState& modal = block.modal;
  if (modal.tool.turning != TurningWay::vector || !leads_tip(modal.code(Group::length))) return {};
  if (move.kind == MoveKind::rapid || block.end.corner.wanted()) return {};
  const AxisSet turned = move.words & ~block.channel_words.linear_axes();
  if (turned == 0) return {};
  const AxisValues end_B = modal.frame().base_from_work(move.end);
  const auto first = static_cast<std::size_t>(std::countr_zero(turned));
  OrientationWish wish{.word = {block.channel.axes[first].word.front(), -1, {}},
                       .name = "a move on the great circle",
                       .tool_B = block.tables.spindle_axes(end_B)[2],
                       .purpose = "turn the tool to",
                       .said_by = Group::length,
                       .remedy = "interpolate the axes instead with `#orientation (axis)`",
                       .end = "these angles"};
  auto parts = great_circle(block, wish, end_B);
  if (!parts) return {};
  move.words = static_cast<AxisSet>(move.words | parts->back().alignment.axes);
  return std::move(*parts);
}

// G54.2: the move ends where the table, turned by it, will have carried the work offset. A
// coordinate that is not programmed stays what it is, so that its axis follows the table.
void end_on_carried_offset(ActiveBlock& block, Move& move) {
  if (!block.modal.frames.is_carried || move.machine_coordinates) return;
  follow_table(block, block.modal.frame().base_from_work(move.end));
  for (const AxisIndex axis : block.modal.geometry) {
    if (axis.exists() && std::abs(move.end[axis] - block.modal.position_W[axis]) > position_noise)
      move.words = static_cast<AxisSet>(move.words | axis_bit(axis));
  }
}

// G54.4: the rotary axes go where the tool leans against the workpiece as it lies.
void lean_as_it_lies(ActiveBlock& block, Move& move) {
  if (!corrects_angles(block)) return;
  const auto found = corrected_angles(block, move);
  if (!found || !turn_axes(block, found->alignment, move)) return;
  block.modal.frames.set_up_angles = {true, found->drawn_W, move.end};
}

// The parts of a move but the last one, which is what remains of `move`.
void emit_parts(ActiveBlock& block, const std::vector<TurnedPart>& parts, Move& move) {
  const Move whole = move;
  const AxisValues& start = block.modal.position_W;
  const bool inverse_time = move.feed_mode == FeedMode::inverse_time;
  double done = 0.0;
  for (const TurnedPart& turned : parts) {
    if (inverse_time) move.feed = whole.feed / (turned.part - done);
    if (&turned == &parts.back()) break;
    Move part = move;
    part.stop_at_end = false;
    // One move: also in exact stop and on an exact path the axes stand at its end alone.
    const bool is_smooth = part.path.mode == PathMode::continuous;
    if (!is_smooth) part.path = {};
    if (!is_smooth || &turned != &parts.front()) part.path.orientation_deg = part_rounding_deg;
    for (std::size_t k = 0; k < part.end.size(); ++k)
      part.end[k] = start[k] + turned.part * (whole.end[k] - start[k]);
    turn_axes(block, turned.alignment, part);
    block.queue.emit(part);
    done = turned.part;
  }
}

}  // namespace

void stop_at_block_end(ActiveBlock& block, CodeNumber) {
  block.end.stops = true;
}

void use_machine_coordinates(ActiveBlock& block, CodeNumber) {
  CodeNumber motion = block.modal.code(Group::motion);
  for (const CodeNumber code : block.words.g) {
    const Code* const row = find_code('G', code);
    if (row != nullptr && row->group == Group::motion) motion = code;
  }
  check_machine_coordinates(block, motion);
  block.machine_coordinates = true;
}

void resolve_ends(const ActiveBlock& block, Move& move) {
  const CoordinateMap& map = block.modal.map;
  const bool mapped = map.active() && !block.machine_coordinates;
  move.words = block.programmed;
  move.end = block.modal.position_W;
  move.machine_coordinates = block.machine_coordinates;
  move.stop_at_end = block.end.stops;
  const MachineReading reading = block.tables.machine_reading();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if ((block.programmed & axis_bit(i)) == 0) continue;
    const AxisDescription& axis = block.channel.axes[i];
    const double value =
        block.machine_coordinates ? block.values[i] * reading.counts(i) : block.values[i];
    const bool from_zero = (block.absolute & axis_bit(i)) != 0;
    const bool from_position = (block.incremental & axis_bit(i)) != 0;
    if (from_position || (block.modal.incremental() && !from_zero)) {
      move.end[i] += block.end.length_travel_W[i] + (mapped ? map.gain(i) * value : value);
    } else if (axis.modulo_deg > 0.0 && !block.machine_coordinates && !is_length(block, i)) {
      move.end[i] = shortest_travel(value, move.end[i], axis.modulo_deg);
    } else {
      move.end[i] = mapped ? map.to_work(i, value) : value;
    }
  }
}

void resolve_feed(ActiveBlock& block, Move& move) {
  if (block.law_feed == 0.0 || move.kind == MoveKind::rapid) return resolve_modal_feed(block, move);
  move.path = block.modal.path;
  move.feed_mode = block.modal.feed_mode();
  move.feed = block.law_feed;
}

void resolve_modal_feed(ActiveBlock& block, Move& move) {
  const ModalState& modal = block.modal;
  move.path = modal.path;
  move.feed_mode = modal.feed_mode();
  if (move.kind == MoveKind::rapid) return;
  const bool linear = move.kind == MoveKind::arc || modal.transformation.axis >= 0 ||
                      (move.words & block.channel_words.linear_axes()) != 0;
  const bool inverse_time = move.feed_mode == FeedMode::inverse_time;
  if (inverse_time && !block.has('F')) {
    block.fail("E4023", {}, "a motion block in G93 needs its own F", "no F")
        .notes.push_back(modal.origin_of(Group::feed_mode));
    return;
  }
  move.feed = linear && !inverse_time ? modal.feed.mm : modal.feed.programmed;
  if (!modal.feed.known || move.feed <= 0.0) {
    if (modal.feed.law.gives_feed()) {
      move.feed = modal.feed.law.feed_first;
      return;
    }
    block
        .fail("E4020", {},
              modal.feed.known ? "the feed of a motion at feed is 0" : "a motion at feed needs F",
              modal.feed.known ? "F is 0" : "no feed")
        .notes.push_back(modal.origin_of(Group::feed_mode));
  }
}

void advance_position(ActiveBlock& block, const Move& move) {
  if (!move.machine_coordinates) {
    block.modal.position_W = move.end;
    return;
  }
  const MachineReading reading = block.tables.machine_reading();
  AxisValues position_B = block.modal.frame().base_from_work(block.modal.position_W);
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if ((move.words & axis_bit(i)) == 0) continue;
    position_B[i] =
        reading.in_base(i, move.end[i]) - length_along(block, i, block.modal.tool.length.offset_mm);
  }
  block.modal.adopt_position(position_B);
}

void move_straight(ActiveBlock& block, CodeNumber code) {
  const bool has_vector = (block.words.letters & vector_letters & ~block.end.plain_corners) != 0;
  if (block.programmed == 0 && !has_vector) return;
  Move move;
  move.kind = code == g(0) ? MoveKind::rapid : MoveKind::line;
  resolve_ends(block, move);
  end_on_carried_offset(block, move);
  if (!has_vector) lean_as_it_lies(block, move);
  std::vector<TurnedPart> parts =
      has_vector ? turn_to_vector(block, move) : turn_to_angles(block, move);
  if (block.failed()) return;
  resolve_feed(block, move);
  if (block.failed()) return;
  emit_parts(block, parts, move);
  advance_position(block, move);
  if (has_vector) note_turned_tool(block);
  block.queue.emit(move);
}

}  // namespace stanok::lang
