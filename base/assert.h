// STANOK_ASSERT: a claim about our own code that is checked in every build, release included.
//
// Outside the real-time cycle a broken claim aborts the process. The cycle's own answer to one is
// to stop sending set-points; the drives' watchdogs then stop the axes.
#pragma once

namespace stanok {

// Prints the claim and its place to stderr and aborts.
[[noreturn]] void assertion_failed(const char* claim, const char* file, int line) noexcept;

}  // namespace stanok

#define STANOK_ASSERT(claim) \
  ((claim) ? static_cast<void>(0) : ::stanok::assertion_failed(#claim, __FILE__, __LINE__))
