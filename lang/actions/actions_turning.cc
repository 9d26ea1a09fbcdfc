// Actions of the single cycles of turning: G77 turning, G78 threading, G79 facing.
//
// From the start point and back to it: one cut to X Z. R is the taper, a radius: how far the cut
// begins from X (G77, G78) or Z (G79). X, Z, R and the lead of G78 stay valid until another motion
// code; Q, the angle of the spindle where a thread begins, does not.
#include "lang/actions/cycle_moves.h"

namespace stanok::lang {
namespace {

void take_turning_words(ActiveBlock& block, const CycleMoves& moves, CodeNumber code) {
  TurningCycle& cycle = block.modal.cycles.turning;
  if (block.modal.code(Group::motion) != code) cycle = {};
  const TurningPoint end = moves.programmed_end();
  if (moves.names_x()) cycle.x = end.x;
  if (moves.names_z()) cycle.z = end.z;
  cycle.has_x = cycle.has_x || moves.names_x();
  cycle.has_z = cycle.has_z || moves.names_z();
  // I and K say the taper on older Fanuc controls, and on those of Haas.
  const char older = code == g(79) ? 'K' : 'I';
  if (block.has('R')) cycle.taper = block.length('R');
  if (block.has(older)) cycle.taper = block.length(older);
  if (code == g(78) && block.has('F')) cycle.lead = block.length('F');
}

void check_turning(ActiveBlock& block, CodeNumber code) {
  const TurningCycle& cycle = block.modal.cycles.turning;
  const std::string name = "`" + code_text('G', code) + "`";
  const char older = code == g(79) ? 'K' : 'I';
  if (block.has('R') && block.has(older)) {
    block.fail("E4015", {older, -1, {}}, name + " has its taper twice", "beside R");
  } else if (!cycle.has_x || !cycle.has_z) {
    block.fail("E4007", {'G', code, {}}, name + " needs X and Z", cycle.has_x ? "no Z" : "no X");
  } else if (code == g(78) && cycle.lead <= 0.0) {
    block
        .fail("E4066", {block.has('F') ? 'F' : 'G', block.has('F') ? -1 : code, {}},
              name + " needs a positive lead", "no lead")
        .help.push_back("add the lead per revolution, e.g. `F1.5`");
  }
}

// Without axis words the cycle is only chosen, as in `G90 G54` of code system A.
bool only_chooses_cycle(ActiveBlock& block, CodeNumber code) {
  if (block.programmed != 0 || !block.words.rules.is_fanuc()) return false;
  if (block.modal.code(Group::motion) != code) block.modal.cycles.turning = {};
  return true;
}

}  // namespace

void turn_once(ActiveBlock& block, CodeNumber code) {
  if (block.channel.kind != ChannelKind::lathe) return drill_hole(block, code);
  if (only_chooses_cycle(block, code)) return;
  auto moves = CycleMoves::of(block, code);
  if (!moves) return;
  const auto spindle = named_spindle(block);
  if (!spindle) return;
  take_turning_words(block, *moves, code);
  check_turning(block, code);
  if (code == g(78)) check_spindle_turns(block, *spindle, code);
  const double start_angle_deg = code == g(78) ? thread_start_angle_deg(block) : 0.0;
  if (block.failed()) return;
  const TurningCycle& cycle = block.modal.cycles.turning;
  const TurningPoint start = moves->position();
  if (code == g(79)) {
    moves->rapid({start.x, cycle.z + cycle.taper});
    moves->feed({cycle.x, cycle.z});
    moves->feed({cycle.x, start.z});
    moves->rapid(start);
    return;
  }
  moves->rapid({cycle.x + cycle.taper, start.z});
  if (code == g(78)) {
    moves->thread_and_out({cycle.x, cycle.z}, start.x, cycle.lead, *spindle, start_angle_deg);
  } else {
    moves->feed({cycle.x, cycle.z});
    moves->feed({start.x, cycle.z});
  }
  moves->rapid(start);
}

}  // namespace stanok::lang
