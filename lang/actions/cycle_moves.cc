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

void CycleMoves::follow_spindle(TurningPoint end, double lead_mm, int spindle,
                                double start_angle_deg, ThreadPart part) {
  const TurningPoint start = position();
  const double x = std::abs(end.x - start.x);
  const double z = std::abs(end.z - start.z);
  SynchronousMove move;
  move.line = move_to(MoveKind::line, end);
  if (move.line.words == 0 || block_.failed()) return;
  move.line.path = block_.modal.path;
  move.spindle = spindle;
  move.start_angle_deg = start_angle_deg;
  move.runs_out = part == ThreadPart::run_out;
  move.lead_mm_per_rev = lead_mm * std::hypot(x, z) / std::max(x, z);
  advance_position(block_, move.line);
  block_.queue.emit(move);
}

// Source: Haas lathe operator's manual, M23 (in force at power-up), settings 95 and 96 as
// delivered.
void CycleMoves::thread_and_out(TurningPoint end, double clear_x, double lead_mm, int spindle,
                                double start_angle_deg) {
  const TurningPoint start = position();
  const double way = end.z - start.z;
  if (block_.words.rules.is_haas() && block_.modal.switches.thread_chamfer && way != 0.0) {
    const double chamfer = std::min(lead_mm, std::abs(way));
    const double x = end.x - (end.x - start.x) * chamfer / std::abs(way);
    const double rise = std::min(chamfer, std::abs(clear_x - x));
    thread({x, end.z - std::copysign(chamfer, way)}, lead_mm, spindle, start_angle_deg);
    end = {x + std::copysign(rise, clear_x - x), end.z - std::copysign(chamfer - rise, way)};
    run_out(end, lead_mm, spindle, start_angle_deg);
  } else {
    thread(end, lead_mm, spindle, start_angle_deg);
  }
  rapid({clear_x, end.z});
}

void fail_contour(ActiveBlock& block, CodeNumber code, const std::string& why) {
  block.fail("E4068", {'G', code, {}}, "the contour cannot be used: " + why, "");
}

std::vector<PlaneMove> plane_moves(ActiveBlock& block, CodeNumber code,
                                   const ContourCommands& made) {
  const AxisIndex x = block.channel_words.geometry_axis(0);
  const AxisIndex z = block.channel_words.geometry_axis(2);
  std::vector<PlaneMove> moves;
  for (const Command& command : made.commands) {
    const Move* const move = move_of(command.payload);
    if (move == nullptr) continue;
    const bool arc = move->kind == MoveKind::arc;
    if (!std::holds_alternative<Move>(command.payload) || move->machine_coordinates ||
        (arc && (move->plane != Plane::zx || move->turns != 1))) {
      fail_contour(block, code,
                   "only G0, G1 and arcs in ZX may be in it, see line " +
                       std::to_string(command.origin.line));
      return {};
    }
    PlaneMove next{
        {move->end[x], move->end[z]}, arc, {}, move->counter_clockwise, command.origin.line,
        move->kind == MoveKind::rapid};
    if (arc) next.centre = {move->centre[1], move->centre[0]};
    moves.push_back(next);
  }
  if (made.problem.empty()) return moves;
  fail_contour(block, code, made.problem);
  return {};
}

Roughing::Roughing(CycleMoves& moves, const TurnedContour& contour,
                   const RoughingSettings& settings)
    : moves_(moves),
      contour_(contour),
      settings_(settings),
      clear_(std::min(contour.shallowest(), 0.0)) {}

void Roughing::cut_levels(PassChoice choice) {
  along_ = std::min(contour_.first_point().along, 0.0);
  rapid({0.0, along_});
  const double deepest = contour_.deepest();
  double above = 0.0;
  // A rest that rounding leaves is no level.
  for (int n = 1; n * settings_.depth < deepest - 1e-9; ++n) {
    const double depth = n * settings_.depth;
    for (const TurnedStretch& stretch : contour_.stretches(depth)) {
      if (choice == PassChoice::all || !stretch.from_start) cut(stretch, depth, above);
    }
    above = depth;
  }
}

void Roughing::follow(const std::vector<PlaneMove>& moves, TurningPoint allowance,
                      EndOfRoughing end_of_cycle) {
  const TurnedPoint first = contour_.first_point();
  rapid({lifted_, along_});
  rapid({first.depth, along_});
  feed(first);
  for (std::size_t k = 1; k < moves.size(); ++k) {
    const TurningPoint end{moves[k].end.x + allowance.x, moves[k].end.z + allowance.z};
    if (moves[k].arc) {
      const TurningPoint& centre = moves[k].centre;
      moves_.arc(
          {end, {centre.x + allowance.x, centre.z + allowance.z}, moves[k].counter_clockwise});
    } else {
      moves_.feed(end);
    }
  }
  const TurningPoint end = moves.back().end;
  along_ = contour_.turned({end.x + allowance.x, end.z + allowance.z}).along;
  if (end_of_cycle == EndOfRoughing::over_its_end) return feed({clear_, along_});
  rapid({clear_, along_});
  rapid({clear_, 0.0});
  rapid({0.0, 0.0});
}

void Roughing::cut(const TurnedStretch& stretch, double depth, double above) {
  const double begin = std::min(contour_.first_point().along, 0.0);
  const double lifted = std::max(depth - settings_.retract, 0.0);
  if (stretch.from_start) {
    rapid({lifted_, along_});
    rapid({depth, stretch.begin});
  } else {
    // Behind a shoulder: over it, and down where the level above is cut already.
    rapid({clear_, along_});
    rapid({clear_, stretch.begin});
    rapid({above, stretch.begin});
    feed({depth, stretch.begin});
  }
  feed({depth, stretch.end});
  const double back = std::min(settings_.retract, stretch.end - stretch.begin);
  feed({lifted, stretch.end - back});
  lifted_ = stretch.from_start ? lifted : clear_;
  rapid({lifted_, stretch.end - back});
  rapid({lifted_, begin});
  along_ = begin;
}

}  // namespace stanok::lang
