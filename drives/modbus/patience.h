// How long one partner on the bus may take to answer before it is asked again: learned from its
// answers.
//
// Three times its slowest recent answer, between a fortieth and a third of the time-out of the
// bus: a lost request costs little, and within one time-out there are so many tries that losses of
// one request in five do not end contact. Every fourth try in a row waits longer, so that a partner
// that has become slow is heard and its slowness learned. Belongs to the bus thread.
#pragma once

#include <chrono>

namespace stanok::drives {

class Patience {
 public:
  explicit Patience(std::chrono::nanoseconds timeout) : timeout_(timeout) {}

  [[nodiscard]] std::chrono::nanoseconds for_next_answer() const;
  // A try that fails is repeated no sooner than this after it began.
  [[nodiscard]] std::chrono::nanoseconds between_tries() const;

  void note_answer(std::chrono::nanoseconds round_trip);
  void note_silence() { ++silences_; }

 private:
  std::chrono::nanoseconds timeout_;
  std::chrono::nanoseconds slowest_{0};  // 0: it has never answered
  int silences_ = 0;                     // since the last answer
};

}  // namespace stanok::drives
