// STANOK_ASSERT: a claim about our own code that is checked in every build, release included.
//
// A broken claim throws BrokenClaim. Whoever owns the thread says what that means: a preparation
// turns it into an alarm of its channel, whose axes stop along the path; the daemon's other threads
// end the daemon in order. What the cycle reaches makes no claims: it guards the setpoints instead
// (channels/axes/setpoint_guard.h).
#pragma once

#include <stdexcept>

namespace stanok {

// "motion/look_ahead/look_ahead.cc:53: broken claim: segment.length > 0.0": what a report about it
// should name.
class BrokenClaim : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void assertion_failed(const char* claim, const char* file, int line);

}  // namespace stanok

#define STANOK_ASSERT(claim) \
  ((claim) ? static_cast<void>(0) : ::stanok::assertion_failed(#claim, __FILE__, __LINE__))
