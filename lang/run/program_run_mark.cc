// Marks: where channels wait for each other, and flags that they show each other.
#include <cmath>
#include <utility>

#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {

std::optional<int> ProgramRun::mark_of(double number) {
  if (is_integer(number) && number >= 0.0 && number <= mark_max) {
    return static_cast<int>(std::lround(number));
  }
  fail("E6023", "marks are the whole numbers 0 to 199", "no mark");
  return std::nullopt;
}

// mark_wait asks the channel; the others travel in the queue. mark_clear is a sync point besides.
void ProgramRun::take_mark(const Instruction& instruction) {
  const Builtin& builtin = builtins()[instruction.operand];
  const std::size_t first = stack_.size() - instruction.count;
  const auto id = mark_of(stack_[first].number);
  if (!id) return;
  std::uint32_t channels = std::uint32_t{1} << channel_.id;
  for (std::size_t i = first + 1; i < stack_.size(); ++i) {
    const auto channel = channel_of(stack_[i].number, false);
    if (!channel) return;
    channels |= std::uint32_t{1} << *channel;
  }
  stack_.resize(first);
  if (builtin.effect == Effect::mark_wait) {
    Request request;
    request.kind = RequestKind::mark_wait;
    request.number = *id;
    request.channels = channels;
    return ask(std::move(request), AnswerUse::position_only);
  }
  queue_.set_origin({frames_.back().file, span().line}, block_);
  queue_.emit(MarkCommand{builtin.mark, *id, channels});
  if (builtin.mark == MarkCommand::Kind::clear) ask({}, AnswerUse::position_only);
}

}  // namespace stanok::lang
