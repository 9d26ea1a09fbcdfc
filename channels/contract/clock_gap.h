// ClockGap: periods of the clock that passed without a cycle, before the one that is told of them.
#pragma once

#include <cstdint>

namespace stanok::channels {

// What the path does behind a gap. The drives went on meanwhile with their last velocity.
enum class AfterGap : std::uint8_t {
  goes_on,
  rests,    // comes to rest, and goes on by itself
  is_held,  // until an operator starts it: the drives did not go on for so long
};

struct ClockGap {
  std::int64_t periods = 0;  // 0: there was none
  AfterGap then = AfterGap::goes_on;
  std::int64_t carried = 0;  // so many cycles, from this one on, make up for periods of it
};

// In a period that is made up for, axes and spindles move on; no item of a program begins or ends.
enum class Period : std::uint8_t { present, made_up };

}  // namespace stanok::channels
