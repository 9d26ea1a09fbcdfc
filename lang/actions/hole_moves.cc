#include "lang/actions/hole_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::lang {
namespace {

// How far G73 lifts to break the chip, and G83 stays off the last depth when it comes back; as in
// the NIST interpreter.
constexpr double peck_lift_mm = 0.254;

// Shorter moves (mm) are rounding of sine and cosine.
constexpr double move_min_mm = 1e-9;

SpindleAction reversed(SpindleAction turning) {
  return turning == SpindleAction::clockwise ? SpindleAction::counter_clockwise
                                             : SpindleAction::clockwise;
}

SpindleAction turning_of(const ModalState& modal) {
  return modal.code(Group::spindle) == m(4) ? SpindleAction::counter_clockwise
                                            : SpindleAction::clockwise;
}

// K is the lead, on Fanuc controls a number of holes: what F of the same block contradicts, and
// what can be no lead, is refused.
bool is_lead(ActiveBlock& block, double speed) {
  if (!block.has('K') || block.words.rules.is_fanuc()) return true;
  constexpr double tolerance = 0.01;  // of a feed that was rounded
  const double lead = block.length('K');
  const bool by_turn = block.modal.feed_mode() == FeedMode::per_revolution;
  const double by_feed = by_turn ? block.modal.feed.mm : block.modal.feed.mm / speed;
  const bool contradicted = block.has('F') && std::abs(by_feed - lead) > tolerance * std::abs(lead);
  if (lead > 0.0 && !contradicted) return true;
  BlockFault& fault =
      block.fail("E4016", {'K', -1, {}},
                 lead > 0.0 ? "`K`, the lead of the tap, and F contradict each other"
                            : "`K`, the lead of the tap, must be positive",
                 "the meaning is not clear");
  fault.notes.push_back({"on Fanuc controls K is the number of holes; here it is L", {}});
  fault.help.emplace_back("keep K, the lead, or F, lead times speed");
  return false;
}

// Lead of the tap: K, else F of G95, else F of G94 by the speed of the spindle.
double lead_of_tap(ActiveBlock& block, int spindle, CodeNumber code) {
  const ModalState& modal = block.modal;
  const double speed = speed_of_spindle(block, spindle);
  if (speed <= 0.0) {
    block.fail("E4064", {'G', code, {}}, "tapping needs a spindle speed", "no S before")
        .help.push_back("program S first, e.g. `S300 M3`");
    return 0.0;
  }
  if (!is_lead(block, speed)) return 0.0;
  double lead = modal.cycles.drilling.lead;
  if (lead <= 0.0 && modal.feed.known) {
    lead = modal.feed_mode() == FeedMode::per_revolution ? modal.feed.mm : modal.feed.mm / speed;
  }
  if (lead <= 0.0) {
    block.fail("E4066", {'G', code, {}}, "tapping needs a lead", "no F and no K")
        .help.push_back("add the lead, e.g. `K1.5`, or F = lead times speed");
  }
  return lead;
}

}  // namespace

void HoleMoves::go(Move move, double level) {
  move.words = axis_bit(axis_);
  move.end = block_.modal.position_W;
  move.end[axis_] = level;
  move.stop_at_end = block_.end.stops;
  move.path = block_.modal.path;
  advance_position(block_, move);
  block_.queue.emit(move);
}

void HoleMoves::rapid(double level) {
  Move move;
  resolve_feed(block_, move);
  go(move, level);
}

void HoleMoves::feed(double level) {
  Move move;
  move.kind = MoveKind::line;
  move.words = axis_bit(axis_);
  resolve_feed(block_, move);
  if (!block_.failed()) go(move, level);
}

void HoleMoves::dwell() {
  if (block_.modal.cycles.drilling.dwell_s >= 0.0)
    block_.queue.emit(Dwell{block_.modal.cycles.drilling.dwell_s});
}

void HoleMoves::approach(const Move& positioning) {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  if (block_.modal.position_W[axis_] < cycle.retract_level) rapid(cycle.retract_level);
  go_over(positioning);
  if (block_.modal.position_W[axis_] > cycle.retract_level) rapid(cycle.retract_level);
}

void HoleMoves::go_over(const Move& positioning) {
  if (positioning.words == 0) return;
  Move move = positioning;
  move.end[axis_] = block_.modal.position_W[axis_];
  advance_position(block_, move);
  block_.queue.emit(move);
}

void HoleMoves::retract() {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  const bool to_initial = block_.modal.code(Group::return_level) == g(98);
  const double level =
      to_initial ? std::max(cycle.initial_level, cycle.retract_level) : cycle.retract_level;
  if (level != block_.modal.position_W[axis_]) rapid(level);
}

// The n-th peck.
double HoleMoves::peck_depth(int n) const {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  if (cycle.variable.first <= 0.0) return cycle.peck;
  return std::max(cycle.variable.first - n * cycle.variable.less, cycle.variable.last);
}

void HoleMoves::peck(CodeNumber code) {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  // K beside Q: the depth after which G73 of Haas brings the chips out.
  const bool clears = code == g(73) && cycle.variable.first <= 0.0 && cycle.variable.last > 0.0;
  double depth = cycle.retract_level;
  double cleared = depth;
  for (int n = 0; !block_.failed(); ++n) {
    depth -= peck_depth(n);
    // A rest that rounding leaves is no peck.
    if (depth < cycle.bottom + move_min_mm) depth = cycle.bottom;
    feed(depth);
    if (depth <= cycle.bottom) {
      const bool dwells =
          block_.words.rules.is_fanuc() || block_.channel.kind == ChannelKind::lathe;
      if (dwells) dwell();
      return retract();
    }
    const bool is_full = clears && cleared - depth > cycle.variable.last - move_min_mm;
    if (code == g(73) && !is_full) {
      rapid(depth + peck_lift_mm);
    } else {
      rapid(cycle.retract_level);
      rapid(std::min(depth + peck_lift_mm, cycle.retract_level));
      cleared = depth;
    }
  }
}

void HoleMoves::bore_out(CodeNumber code) {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  feed(cycle.bottom);
  if (block_.failed()) return;
  if (code == g(82) || code == g(86) || code == g(89)) dwell();
  if (code == g(85) || code == g(89)) feed(cycle.retract_level);
  if (code != g(86)) return retract();
  block_.queue.emit(SpindleCommand{});
  retract();
  turn_again();
}

void HoleMoves::tap(CodeNumber code) {
  const auto spindle = named_spindle(block_);
  if (!spindle) return;
  const double lead_mm = lead_of_tap(block_, *spindle, code);
  if (block_.failed()) return;
  const SpindleAction turning =
      code == g(84) ? SpindleAction::clockwise : SpindleAction::counter_clockwise;
  if (!spindle_turns(block_, *spindle) || turning_of(block_.modal) != turning) {
    turn_spindle(block_, *spindle, turning);
    block_.set_modal(Group::spindle, code == g(84) ? m(3) : m(4));
  }
  if (spindle_has_position(block_, *spindle)) {
    tap_rigidly(*spindle, lead_mm);
  } else {
    tap_with_floating_chuck(*spindle, turning, lead_mm);
  }
  retract();
}

// The channel reverses the spindle at the bottom and comes back to where the move begins.
void HoleMoves::tap_rigidly(int spindle, double lead_mm) {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  SynchronousMove move;
  move.kind = SynchronousMove::Kind::rigid_tap;
  move.line.kind = MoveKind::line;
  move.line.words = axis_bit(axis_);
  move.line.end = block_.modal.position_W;
  move.line.end[axis_] = cycle.bottom;
  move.line.path = block_.modal.path;
  move.spindle = spindle;
  move.lead_mm_per_rev = lead_mm;
  move.return_speed_factor = cycle.return_factor;
  move.dwell_s = std::max(cycle.dwell_s, 0.0);
  block_.queue.emit(move);
}

// The chuck takes up what feed and spindle differ by; overrides would make that too much.
void HoleMoves::tap_with_floating_chuck(int spindle, SpindleAction turning, double lead_mm) {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  const double speed = speed_of_spindle(block_, spindle);
  Move move;
  move.kind = MoveKind::line;
  move.is_tap = true;
  move.feed_mode = block_.modal.feed_mode();
  move.feed = move.feed_mode == FeedMode::per_revolution ? lead_mm : lead_mm * speed;
  SpindleCommand command{
      .spindle = spindle, .action = reversed(turning), .speed_rev_per_min = speed};
  OverrideControl off = override_control_of(block_.modal);
  off.feed_enabled = false;
  off.spindle_enabled = false;
  block_.queue.emit(off);
  go(move, cycle.bottom);
  if (cycle.dwell_s > 0.0) dwell();
  command.speed_rev_per_min = speed * cycle.return_factor;
  block_.queue.emit(command);
  if (move.feed_mode != FeedMode::per_revolution) move.feed *= cycle.return_factor;
  go(move, cycle.retract_level);
  command.speed_rev_per_min = speed;
  command.action = turning;
  block_.queue.emit(command);
  block_.queue.emit(override_control_of(block_.modal));
}

// Rapid by a vector in the plane.
void HoleMoves::shift(double first, double second) {
  const PlaneCoordinates& plane = plane_coordinates[block_.modal.plane()];
  const std::pair<std::size_t, double> ways[] = {{plane.first, first}, {plane.second, second}};
  Move move;
  move.end = block_.modal.position_W;
  move.path = block_.modal.path;
  for (const auto& [coordinate, way] : ways) {
    const AxisIndex axis = block_.channel_words.geometry_axis(coordinate);
    if (!axis.exists() || std::abs(way) < move_min_mm) continue;
    move.end[axis] += way;
    move.words = static_cast<AxisSet>(move.words | axis_bit(axis));
  }
  advance_position(block_, move);
  block_.queue.emit(move);
}

// The spindle stops at the angle of the last M19.
void HoleMoves::orient() {
  const ModalSpindles& spindles = block_.modal.spindles;
  block_.queue.emit(SpindleCommand{.action = SpindleAction::orient,
                                   .speed_rev_per_min = spindles.speed_rev_per_min,
                                   .angle_deg = spindles.orient_angle_deg});
}

void HoleMoves::turn_again() {
  block_.queue.emit(SpindleCommand{.action = turning_of(block_.modal),
                                   .speed_rev_per_min = block_.modal.spindles.speed_rev_per_min});
}

// By I and J, or by Q away from the edge of the tool: at angle 0 the edge points along the first
// axis of the plane, angles run to the second one.
void HoleMoves::shift_off_wall() {
  const HoleShift& given = block_.modal.cycles.drilling.shift;
  if (given.is_given) return shift(given.first, given.second);
  const double angle = block_.modal.spindles.orient_angle_deg * std::numbers::pi / 180.0;
  const double distance = block_.modal.cycles.drilling.peck;
  shift(-distance * std::cos(angle), -distance * std::sin(angle));
}

// At the height where the tool is, to the bit over the hole.
void HoleMoves::shift_to(const AxisValues& over_hole) {
  Move back;
  back.end = over_hole;
  back.end[axis_] = block_.modal.position_W[axis_];
  back.path = block_.modal.path;
  for (std::size_t k = 0; k < back.end.size(); ++k) {
    if (back.end[k] != block_.modal.position_W[k])
      back.words = static_cast<AxisSet>(back.words | axis_bit(k));
  }
  if (back.words == 0) return;
  advance_position(block_, back);
  block_.queue.emit(back);
}

void HoleMoves::bore_finely() {
  feed(block_.modal.cycles.drilling.bottom);
  if (block_.failed()) return;
  if (block_.modal.cycles.drilling.dwell_s > 0.0) dwell();
  orient();
  const AxisValues over_hole = block_.modal.position_W;
  shift_off_wall();
  retract();
  shift_to(over_hole);
  turn_again();
}

// Always back to the initial level: R lies behind the part. Source: Fanuc operator's manual
// B-64304EN-2, "Back boring cycle (G87)".
void HoleMoves::bore_from_behind() {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  const AxisValues over_hole = block_.modal.position_W;
  orient();
  shift_off_wall();
  rapid(cycle.retract_level);
  shift_to(over_hole);
  turn_again();
  feed(cycle.bottom);
  if (block_.failed()) return;
  if (cycle.dwell_s > 0.0) dwell();
  orient();
  shift_off_wall();
  rapid(cycle.initial_level);
  shift_to(over_hole);
  turn_again();
}

void HoleMoves::bore_up_to_hand() {
  feed(block_.modal.cycles.drilling.bottom);
  if (block_.failed()) return;
  dwell();
  block_.modal.cycles.drilling.hole = block_.modal.position_W;
  block_.queue.emit(SpindleCommand{});
  block_.queue.emit(ProgramStop{StopKind::program_stop});
  block_.queue.emit(ProgramRequest{});
}

void HoleMoves::go_on_behind_hand() {
  const DrillingCycle& cycle = block_.modal.cycles.drilling;
  if (block_.modal.position_W[axis_] < cycle.retract_level) rapid(cycle.retract_level);
  shift_to(cycle.hole);
  turn_again();
  retract();
}

}  // namespace stanok::lang
