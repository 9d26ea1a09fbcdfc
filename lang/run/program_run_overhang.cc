// #tool_overhang: checked at once, in force when the axes stand.
#include <cmath>

#include "lang/run/program_run.h"

namespace stanok::lang {

// The arguments are on the stack: nothing, the value, or value and axis.
std::optional<ToolOverhang> ProgramRun::overhang_of(const Instruction& instruction) {
  ToolOverhang overhang;
  if (instruction.count == 0) return overhang;
  overhang.axis = channel_words_.geometry_axis(0);
  if (instruction.count == 2) overhang.axis = static_cast<int>(std::lround(pop_number()));
  overhang.value_mm = pop_number() * (modal_.inches() ? mm_per_inch : 1.0);
  const bool is_linear =
      overhang.axis >= 0 && !channel_.axes[static_cast<std::size_t>(overhang.axis)].rotary;
  if (is_linear) return overhang;
  fail("E4306", "a tool overhang needs a linear axis of the channel", "no such axis");
  return std::nullopt;
}

void ProgramRun::ask_overhang(const Instruction& instruction) {
  const auto overhang = overhang_of(instruction);
  if (!overhang) return;
  if (modal_.tool_active == 0) {
    return fail("E5012", "the overhang of a tool while none is active", "no tool");
  }
  pending_overhang_ = *overhang;
  ask(Request{}, AnswerUse::overhang);
}

void ProgramRun::finish_overhang() {
  queue_.set_origin({frames_.back().file, span().line}, block_);
  ActiveBlock block(words_, around_, span().line);
  set_overhang(block, pending_overhang_);
}

}  // namespace stanok::lang
