#include "base/idle_thread.h"

#include <pthread.h>
#include <sched.h>

namespace stanok {
namespace {

// Sanitizers make a thread so slow that, with nothing but what others leave of a busy computer, it
// may need minutes to begin, to end or to do its work, and who joins it waits.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool may_starve = true;
#elif defined(__has_feature)
constexpr bool may_starve = __has_feature(thread_sanitizer) || __has_feature(address_sanitizer);
#else
constexpr bool may_starve = false;
#endif

}  // namespace

void run_when_idle() {
  if (may_starve) return;
  const sched_param none{};
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_IDLE, &none));
}

}  // namespace stanok
