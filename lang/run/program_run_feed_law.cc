// #feedlaw (off) and #feedlaw (curve, ways, feeds, speeds); the other laws are blocks.
#include <utility>
#include <vector>

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
  std::array<std::vector<double>, 3> numbers;
  for (std::size_t i = 0; i < instruction.count; ++i) {
    for (const Value& element : arrays[i].object->elements) numbers[i].push_back(element.number);
  }
  const bool has_speeds = !numbers[2].empty();
  auto law = read_feed_curve(law_surroundings(block), {numbers[0], numbers[1], numbers[2]});
  if (!law) return fail_block(std::move(law).error(), span(), {});
  const bool allowed = allows_feed_law(block, {}) &&
                       (!has_speeds || spindle_takes_law(block, {}, "speeds of a curve"));
  if (!allowed) return fail_block(std::move(*block.fault), span(), {});
  set_feed_law(block, std::move(*law));
}

}  // namespace stanok::lang
