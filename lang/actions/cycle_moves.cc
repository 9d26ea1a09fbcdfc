#include "lang/actions/cycle_moves.h"

#include <algorithm>
#include <cmath>

namespace stanok::lang {

std::optional<CycleMoves> CycleMoves::of(ActiveBlock& block, CodeNumber code) {
  const AxisIndex x = block.channel_words.geometry_axis(0);
  const AxisIndex z = block.channel_words.geometry_axis(2);
  if (!x.exists() || !z.exists()) {
    block.fail("E4036", {'G', code, {}}, "the channel lacks X or Z for a turning cycle", "");
    return std::nullopt;
  }
  if ((block.programmed & ~(axis_bit(x) | axis_bit(z))) != 0) {
    block.fail("E4003", {'G', code, {}}, "turning cycles move X and Z only", "another axis");
    return std::nullopt;
  }
  return CycleMoves(block, x, z);
}

TurningPoint CycleMoves::position() const {
  return {block_.modal.position_W[x_], block_.modal.position_W[z_]};
}

TurningPoint CycleMoves::programmed_end() const {
  Move move;
  resolve_ends(block_, move);
  return {move.end[x_], move.end[z_]};
}

bool CycleMoves::names_x() const {
  return (block_.programmed & axis_bit(x_)) != 0;
}

bool CycleMoves::names_z() const {
  return (block_.programmed & axis_bit(z_)) != 0;
}

Move CycleMoves::move_to(MoveKind kind, TurningPoint end) const {
  const AxisValues& position = block_.modal.position_W;
  Move move;
  move.kind = kind;
  move.end = position;
  move.end[x_] = end.x;
  move.end[z_] = end.z;
  if (end.x != position[x_]) move.words = static_cast<AxisSet>(move.words | axis_bit(x_));
  if (end.z != position[z_]) move.words = static_cast<AxisSet>(move.words | axis_bit(z_));
  return move;
}

void CycleMoves::go(MoveKind kind, TurningPoint end) {
  Move move = move_to(kind, end);
  if (move.words == 0 || block_.failed()) return;
  move.stop_at_end = block_.end.stops;
  resolve_feed(block_, move);
  if (block_.failed()) return;
  advance_position(block_, move);
  block_.queue.emit(move);
}

void CycleMoves::arc(const TurningArc& arc) {
  Move move = move_to(MoveKind::arc, arc.end);
  move.words = static_cast<AxisSet>(axis_bit(x_) | axis_bit(z_));
  move.plane = Plane::zx;
  move.centre = {arc.centre.z, arc.centre.x};
  move.counter_clockwise = arc.counter_clockwise;
  resolve_feed(block_, move);
  if (block_.failed()) return;
  advance_position(block_, move);
  block_.queue.emit(move);
}

void CycleMoves::thread(TurningPoint end, double lead_mm, int spindle, double start_angle_deg) {
  const TurningPoint start = position();
  const double x = std::abs(end.x - start.x);
  const double z = std::abs(end.z - start.z);
  SynchronousMove move;
  move.line = move_to(MoveKind::line, end);
  if (move.line.words == 0 || block_.failed()) return;
  move.line.path = block_.modal.path;
  move.spindle = spindle;
  move.start_angle_deg = start_angle_deg;
  move.lead_mm_per_rev = lead_mm * std::hypot(x, z) / std::max(x, z);
  advance_position(block_, move.line);
  block_.queue.emit(move);
}

}  // namespace stanok::lang
