// Action of probing, G38.2 to G38.5 and G31, which is G38.3 for one block: a line that ends where
// the probe changes. The program waits for what was found, which BlockRunner keeps for $probe and
// #5061.
#include <algorithm>
#include <cmath>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

// Shortest travel in which a probe can change, mm or deg.
constexpr double probing_travel_min = 0.01;

double longest_travel(const AxisValues& from, const AxisValues& to) {
  double way = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) way = std::max(way, std::abs(to[i] - from[i]));
  return way;
}

}  // namespace

void probe(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::inverse_time})) {
    return;
  }
  if (code == g(31) && block.has('P')) {
    // P2 to P4 are further inputs of other controls, and their multi-step skip.
    const auto input = block.integer('P', 1, 4);
    if (!input) return;
    if (*input != 1) {
      block.fail("E4008", {'P', -1, {}}, "there is one probe, P1", "no such input");
      return;
    }
  }
  ProbeMove move;
  move.line.kind = MoveKind::line;
  move.until_contact = code == g(31) || code == g(38, 2) || code == g(38, 3);
  move.alarm_when_missed = code == g(38, 2) || code == g(38, 4);
  resolve_ends(block, move.line);
  if (longest_travel(block.modal.position_W, move.line.end) < probing_travel_min) {
    block.fail("E4321", {'G', code, {}}, "a probing move needs a length",
               "the end is where the axes stand");
    return;
  }
  resolve_feed(block, move.line);
  if (block.failed()) return;
  advance_position(block, move.line);
  block.queue.emit(move);
  Request result;
  result.kind = RequestKind::probe_result;
  result.statement = move.alarm_when_missed;
  block.queue.emit(result);
}

}  // namespace stanok::lang
