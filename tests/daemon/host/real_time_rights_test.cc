// Real-time rights: who inherits them, and who is left as before.
#include "daemon/host/real_time_rights.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <thread>

namespace stanok::daemon {
namespace {

struct Scheduling {
  int policy = 0;
  int priority = 0;

  static Scheduling of_this_thread() {
    Scheduling scheduling;
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &scheduling.policy, &parameters);
    scheduling.priority = parameters.sched_priority;
    return scheduling;
  }
  friend bool operator==(const Scheduling&, const Scheduling&) = default;
};

TEST(FifoForNewThreads, IsInheritedByThreadsStartedMeanwhileAndLeavesTheCallerAsBefore) {
  const Scheduling before = Scheduling::of_this_thread();
  Scheduling inherited;
  bool granted = false;
  {
    const FifoForNewThreads fifo(2);
    granted = Scheduling::of_this_thread().policy == SCHED_FIFO;
    std::thread([&] { inherited = Scheduling::of_this_thread(); }).join();
  }
  EXPECT_EQ(Scheduling::of_this_thread(), before);
  if (!granted) GTEST_SKIP() << "this system grants no FIFO scheduling";
  EXPECT_EQ(inherited, (Scheduling{SCHED_FIFO, 2}));
}

}  // namespace
}  // namespace stanok::daemon
