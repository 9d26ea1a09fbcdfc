// ReadingBounds: how much of a log is read, for those who read beside a machine at work.
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include "jobs/dry_run/dry_run.h"

namespace stanok::jobs {

struct ReadingBounds {
  // Cycles of the channel, which take memory.
  std::size_t rows_max = std::numeric_limits<std::size_t>::max();
  // Asked with every cycle.
  GivesUp gives_up = [] { return false; };

  // Throws std::runtime_error where a reading that has so many rows is not to go on.
  void check(std::size_t rows) const {
    if (rows >= rows_max)
      throw std::runtime_error("the log has more than " + std::to_string(rows_max) +
                               " cycles; a longer one is read by `stanok process identify`");
    if (gives_up()) throw std::runtime_error("the log was not read to its end");
  }
};

}  // namespace stanok::jobs
