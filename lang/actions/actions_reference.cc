// Actions of the reference points: G28 and G30 go there, G28.1 and G30.1 store where the axes
// stand.
//
// The way leads at rapid over the intermediate point that the axis words give, then to the
// reference point in M, with the named axes only; without axis words all axes that take part in the
// scheme go there directly.
#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

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

void go(ActiveBlock& block, Move& move) {
  resolve_feed(block, move);
  advance_position(block, move);
  block.queue.emit(move);
}

}  // namespace

AxisValues machine_position(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  AxisValues position = modal.frame().base_from_work(modal.position_W);
  const AxisValues zero = block.tables.scheme_zero();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    position[i] += zero[i] + length_along(block, block.channel.axes[i]);
  }
  return position;
}

void go_to_reference_point(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(
          block, code,
          {Exclusion::radius_compensation, Exclusion::tcp, Exclusion::transformation})) {
    return;
  }
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
  move.stop_at_end = block.stop_at_end;
  go(block, move);
}

void store_reference_point(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::tcp, Exclusion::transformation})) return;
  const auto which = point_number(block, code);
  if (which) block.tables.store_reference_point(*which, machine_position(block));
}

}  // namespace stanok::lang
