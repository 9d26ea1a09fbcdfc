// #feedlaw (off) and #feedlaw (curve, ways, feeds, speeds); the other laws are blocks.
#include <utility>

#include "lang/feed_law/feed_law_curve.h"
#include "lang/run/program_run.h"

namespace stanok::lang {

// The arrays are on the stack: none, two or three.
void ProgramRun::take_feed_law_directive(const Instruction& instruction) {
  queue_.set_origin({frames_.back().file, span().line}, block_);
  ActiveBlock block(words_, around_, span().line);
  if (instruction.count == 0) return end_feed_law(block);
  std::array<Value, 3> arrays;
  for (std::size_t i = instruction.count; i-- > 0;) {
    arrays[i] = pop();
    if (arrays[i].object->columns != 0) {
      return fail("E3004", "the arrays of a curve have one dimension, this has two", "two");
    }
  }
  const auto elements = [&](std::size_t i) {
    const bool given = arrays[i].object != nullptr;
    return given ? std::span<const Value>(arrays[i].object->elements) : std::span<const Value>();
  };
  auto law = read_feed_curve(block, {elements(0), elements(1), elements(2)});
  if (!law) return fail_block(std::move(*block.fault), span(), {});
  set_feed_law(block, std::move(*law));
}

}  // namespace stanok::lang
