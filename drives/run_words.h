// Drives that do not speak CiA 402, as most frequency inverters: the words of the manufacturer that
// let them run and stop, and the bits by which they say what they do.
#pragma once

#include <cstdint>
#include <optional>

#include "base/rt_safe.h"
#include "drives/cia402.h"
#include "drives/drive.h"

namespace stanok::drives {

// Holds when (word & mask) == value; a mask of 0: the drive does not say.
struct StatusPattern {
  std::uint16_t mask = 0;
  std::uint16_t value = 0;

  [[nodiscard]] bool holds(std::uint16_t word) const RT_SAFE {
    return mask != 0 && (word & mask) == value;
  }
  bool operator==(const StatusPattern&) const = default;
};

struct RunWords {
  std::uint16_t stop = 0;
  std::uint16_t run = 0;
  // Given: the direction stands in the word and the velocity register holds the magnitude.
  std::optional<std::uint16_t> run_reverse{};
  std::optional<std::uint16_t> fault_reset{};
  StatusPattern running{};
  StatusPattern fault{};

  bool operator==(const RunWords&) const = default;
};

// With a word for the reverse direction a drive without speed is stopped.
[[nodiscard]] std::uint16_t run_word(const RunWords& words, PowerRequest request, double velocity)
    RT_SAFE;

// fault, operation_enabled or ready_to_switch_on; `word_sent` counts for a drive that does not say
// whether it runs.
[[nodiscard]] DriveState state_of(const RunWords& words, std::uint16_t status_word,
                                  std::uint16_t word_sent) RT_SAFE;

[[nodiscard]] bool is_run_word(const RunWords& words, std::uint16_t word) RT_SAFE;

}  // namespace stanok::drives
