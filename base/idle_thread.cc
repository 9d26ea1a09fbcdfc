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

void set_class(pthread_t thread, int policy) {
  const sched_param none{};
  static_cast<void>(pthread_setschedparam(thread, policy, &none));
}

}  // namespace

// Whichever comes last of its own change and that of who ends it, it has the usual class in the
// end.
void run_when_idle(const std::stop_token& stop) {
  if (may_starve) return;
  set_class(pthread_self(), SCHED_IDLE);
  if (stop.stop_requested()) set_class(pthread_self(), SCHED_OTHER);
}

IdleWork::~IdleWork() {
  set_class(pthread_self(), SCHED_OTHER);
}

void end_idle_thread(std::jthread& thread) {
  if (!thread.joinable()) return;
  thread.request_stop();
  set_class(thread.native_handle(), SCHED_OTHER);
  thread.join();
}

}  // namespace stanok
