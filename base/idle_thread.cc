#include "base/idle_thread.h"

#include <pthread.h>
#include <sched.h>

namespace stanok {

void run_when_idle() {
  const sched_param none{};
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_IDLE, &none));
}

}  // namespace stanok
