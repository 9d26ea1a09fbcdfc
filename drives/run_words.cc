// Choice among the words of a drive, and the reading of its bits.
#include "drives/run_words.h"

namespace stanok::drives {

std::uint16_t run_word(const RunWords& words, PowerRequest request, double velocity) RT_SAFE {
  if (request == PowerRequest::reset_fault) return words.fault_reset.value_or(words.stop);
  if (request != PowerRequest::on) return words.stop;
  if (!words.run_reverse) return words.run;
  if (velocity == 0.0) return words.stop;
  return velocity < 0.0 ? *words.run_reverse : words.run;
}

DriveState state_of(const RunWords& words, std::uint16_t status_word, std::uint16_t word_sent)
    RT_SAFE {
  if (words.fault.holds(status_word)) return DriveState::fault;
  const bool runs =
      words.running.mask != 0 ? words.running.holds(status_word) : is_run_word(words, word_sent);
  return runs ? DriveState::operation_enabled : DriveState::ready_to_switch_on;
}

bool is_run_word(const RunWords& words, std::uint16_t word) RT_SAFE {
  return word == words.run || word == words.run_reverse;
}

}  // namespace stanok::drives
