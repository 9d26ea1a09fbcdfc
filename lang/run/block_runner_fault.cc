// Behind a faulty block: what its words say is taken over as far as it is clear, so that one fault
// does not draw others after it.
#include <algorithm>

#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/run/block_runner.h"

namespace stanok::lang {
namespace {

constexpr bool is_straight_or_arc(CodeNumber motion) {
  return motion == g(0) || motion == g(1) || motion == g(2) || motion == g(3);
}

// Codes of the block other than motions that use its axis words leave its end open.
bool is_plain_motion(const ActiveBlock& block) {
  for (const CodeNumber number : block.words.g) {
    const Code* const code = find_code('G', number);
    if (code == nullptr || (code->group != Group::motion && code->axes != AxisWords::unused) ||
        code->group == Group::none)
      return false;
  }
  return is_straight_or_arc(block.modal.code(Group::motion));
}

void adopt_motion(ActiveBlock& block) {
  for (const CodeNumber number : block.words.g) {
    const Code* const code = find_code('G', number);
    if (code != nullptr && code->group == Group::motion) block.set_modal(Group::motion, number);
  }
}

// A feed that was missing is asked for once.
void adopt_feed(ActiveBlock& block) {
  if (block.words.has('F') && block.words.value('F') > 0.0) return set_feed(block);
  constexpr double any_feed = 100.0;
  ModalState& modal = block.modal;
  if (modal.feed.known && modal.feed.programmed > 0.0) return;
  modal.feed.known = true;
  modal.feed.programmed = any_feed;
  modal.feed.mm = any_feed;
}

}  // namespace

Passed BlockRunner::pass_fault() {
  const std::uint32_t line = run_.faulty_line();
  if (!run_.failed() || line == 0 || compensating()) return Passed::no;
  ActiveBlock block = state_.block_at(line);
  state_.begin_commands({vm_.frame().file, line});
  has_rest_ = false;
  run_.begin();
  const Passed passed = adopt_words(block);
  run_.forget_error();
  return passed;
}

Passed BlockRunner::adopt_words(ActiveBlock& block) {
  adopt_motion(block);
  if (run_.error().code == "E4020" || block.words.has('F')) adopt_feed(block);
  const LetterSet axes = block.words.letters & block.channel_words.letters();
  const bool has_named_axes = !block.words.named.empty();
  if (axes == 0 && !has_named_axes) return Passed::known_position;
  if (!is_plain_motion(block) || has_named_axes) return Passed::unknown_position;
  collect_axis_words(block);
  if (block.failed()) return Passed::unknown_position;
  Move move;
  move.kind = MoveKind::rapid;
  resolve_ends(block, move);
  if (block.failed()) return Passed::unknown_position;
  advance_position(block, move);
  state_.queue.emit(move);
  return Passed::known_position;
}

}  // namespace stanok::lang
