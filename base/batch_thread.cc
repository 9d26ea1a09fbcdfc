#include "base/batch_thread.h"

#include <pthread.h>
#include <sched.h>

namespace stanok {
namespace {

void set_class(pthread_t thread, int policy) {
  const sched_param none{};
  static_cast<void>(pthread_setschedparam(thread, policy, &none));
}

}  // namespace

// Whichever comes last of its own change and that of who ends it, it has the usual class in the
// end.
void run_as_batch(const std::stop_token& stop) {
  set_class(pthread_self(), SCHED_BATCH);
  if (stop.stop_requested()) set_class(pthread_self(), SCHED_OTHER);
}

BatchWork::~BatchWork() {
  set_class(pthread_self(), SCHED_OTHER);
}

void end_batch_thread(std::jthread& thread) {
  if (!thread.joinable()) return;
  thread.request_stop();
  set_class(thread.native_handle(), SCHED_OTHER);
  thread.join();
}

}  // namespace stanok
