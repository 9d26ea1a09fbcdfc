// Actions of the reference points: G28 and G30 go there, G27 goes to the programmed point and wants
// it to be there, G28.1 and G30.1 store where the axes stand. G30 P99 takes a tap out of its hole,
// as on Fanuc controls (B-64304EN, rigid tapping return).
//
// The way leads at rapid over the intermediate point that the axis words give, then to the
// reference point in M, with the named axes only; without axis words all axes that take part in the
// scheme go there directly.
#include <cmath>

#include "lang/actions/actions.h"
#include "lang/feed_law/feed_law_words.h"

namespace stanok::lang {
namespace {

// What the programmed point of G27 may be off, mm or deg: less than any axis resolves, more than
// rounding of offsets.
constexpr double reference_tolerance = 1e-4;

constexpr double number_of_tap_out = 99.0;  // P

// In which the programmed point is no reading of the axes.
constexpr auto modes_of_other_points = {Exclusion::radius_compensation, Exclusion::tcp,
                                        Exclusion::transformation};

// 1 for G28, P of G30 (2 without it); fails the block when there is no such point.
std::optional<int> point_number(ActiveBlock& block, CodeNumber code) {
  if (code < g(30)) return 1;
  if (!block.has('P')) return 2;
  return block.integer('P', 2, reference_point_count);
}

AxisSet all_axes(const ActiveBlock& block) {
  const unsigned of_channel = (1U << block.channel.axes.size()) - 1U;
  return static_cast<AxisSet>(of_channel & block.tables.axes_of_scheme());
}

double distance_between(double from, double to, double modulo_deg) {
  return modulo_deg > 0.0 ? std::remainder(to - from, modulo_deg) : to - from;
}

// The machine knows where it stands.
void take_tap_out(ActiveBlock& block) {
  if (block.programmed != 0) {
    block.fail("E4003", {'P', -1, {}}, "`G30 P99` does not use axis words", "takes a tap out")
        .help.emplace_back("remove the axis words: the tap comes back to where it began");
    return;
  }
  for (const int spindle : block.channel.spindles) {
    if (spindle_turns(block, spindle)) turn_spindle(block, spindle, SpindleAction::stop);
  }
  ProgramRequest request;
  request.kind = RequestKind::tap_out;
  block.queue.emit(request);
  block.awaits_position = true;
}

void go(ActiveBlock& block, Move& move) {
  resolve_feed(block, move);
  advance_position(block, move);
  block.queue.emit(move);
}

// A point of the work frame in M; not under TCP.
AxisValues machine_from_work(const ActiveBlock& block, const AxisValues& point_W) {
  AxisValues position = block.modal.frame().base_from_work(point_W);
  const MachineReading reading = block.tables.machine_reading();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    position[i] = reading.in_machine(
        i, position[i] + length_along(block, i, block.modal.tool.length.offset_mm));
  }
  return position;
}

}  // namespace

AxisValues machine_position(const ActiveBlock& block) {
  return machine_from_work(block, block.modal.position_W);
}

void go_to_reference_point(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, modes_of_other_points)) return;
  if (code == g(30) && block.has('P') && block.value('P') == number_of_tap_out)
    return take_tap_out(block);
  const auto which = point_number(block, code);
  if (!which) return;
  if (block.programmed != 0) {
    Move over;
    resolve_ends(block, over);
    go(block, over);
  }
  Move move;
  move.words = block.programmed != 0 ? block.programmed : all_axes(block);
  move.end = block.tables.reference_point(*which);
  move.machine_coordinates = true;
  move.stop_at_end = block.end.stops;
  go(block, move);
}

// The point is checked before the axes move: a wrong one is no place to go to at rapid.
void check_reference_point(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, modes_of_other_points)) return;
  Move move;
  resolve_ends(block, move);
  const AxisValues wanted_M = block.tables.reference_point(1);
  const AxisValues end_M = machine_from_work(block, move.end);
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    const AxisDescription& axis = block.channel.axes[i];
    const double distance = distance_between(wanted_M[i], end_M[i], axis.modulo_deg);
    if (!is_programmed(block, i) || std::abs(distance) <= reference_tolerance) continue;
    block
        .fail("E4043", {'G', code, {}},
              "`G27` would leave " + axis.word + " " + law_number_text(std::abs(distance)) +
                  (axis.rotary ? " deg" : " mm") + " from its reference point",
              "not at the reference point")
        .help.push_back("correct the coordinates, the work offset or the tool length");
    return;
  }
  go(block, move);
}

void store_reference_point(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::tcp, Exclusion::transformation})) return;
  const auto which = point_number(block, code);
  if (which) block.tables.store_reference_point(*which, machine_position(block));
}

}  // namespace stanok::lang
